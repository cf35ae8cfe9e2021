/*
 * affine_voronec.c: affine_voronec, emitted by nhc 0.1.0 (nhc:d2955f269cd1409a)
 * A particle with everything at once; affine constraint, time, T of degrees 2, 1 and 0, drag, a driving
 *     force.
 * Source: affine_voronec.yaml
 * Equations of motion: voronec (I.4.9)
 * Why: dependent velocities of the spec
 * affine_voronec.h says what each function does.
 */
#include "affine_voronec.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const affine_voronec_coordinate_names[] = {
    "x",
    "y",
    "z"
};
const char *const affine_voronec_state_names[] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const affine_voronec_parameter_names[] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double affine_voronec_parameter_defaults[] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define AFFINE_VORONEC_SLOW __attribute__((cold, optimize("O1")))
#else
#define AFFINE_VORONEC_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* it is seldom called, and would cost its callers registers */
#endif
static int affine_voronec_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return AFFINE_VORONEC_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return AFFINE_VORONEC_NOT_FINITE;
        }
    }
    return AFFINE_VORONEC_OK;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef AFFINE_VORONEC_LANES
#if !defined(__GNUC__)
#define AFFINE_VORONEC_LANES 1
#elif defined(__AVX512F__)
#define AFFINE_VORONEC_LANES 8
#elif defined(__AVX__)
#define AFFINE_VORONEC_LANES 4
#else
#define AFFINE_VORONEC_LANES 2
#endif
#endif
#if AFFINE_VORONEC_LANES > 1
typedef double affine_voronec_lanes __attribute__((vector_size(8 * AFFINE_VORONEC_LANES)));
#else
typedef double affine_voronec_lanes;
#endif

#if AFFINE_VORONEC_LANES >= 2
static inline affine_voronec_lanes affine_voronec_get(const double *from)
{
    affine_voronec_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void affine_voronec_put(double *to, affine_voronec_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int affine_voronec_one_by_one(size_t count, size_t first, size_t number, const double *t, const double *y, const double *p, double *dydt)
{
    int status = AFFINE_VORONEC_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[AFFINE_VORONEC_NY];
        double slope[AFFINE_VORONEC_NY];
        for (size_t k = 0; k < AFFINE_VORONEC_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = NAN;
        }
        const int one = affine_voronec_rhs(t[i], state, p, slope);
        status = status == AFFINE_VORONEC_OK ? one : status;
        for (size_t k = 0; k < AFFINE_VORONEC_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if AFFINE_VORONEC_LANES >= 2
#define AFFINE_VORONEC_SPREAD(x) ((x) - (affine_voronec_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long affine_voronec_bits __attribute__((vector_size(8 * AFFINE_VORONEC_LANES)));

/* all bits where value is not above bound, or is no number */
static inline affine_voronec_bits affine_voronec_misses(affine_voronec_lanes value, affine_voronec_lanes bound)
{
    return ~(affine_voronec_bits)(value > bound);
}

/* no number where a bit is set */
static inline affine_voronec_lanes affine_voronec_mark(affine_voronec_lanes value, affine_voronec_bits bad)
{
    return (affine_voronec_lanes)((affine_voronec_bits)value | bad);
}

static inline affine_voronec_lanes affine_voronec_size(affine_voronec_lanes x)
{
    return (affine_voronec_lanes)((affine_voronec_bits)x & 0x7fffffffffffffffULL);
}
/* whether none of the states must be asked again: no singular block, no infinity, no angle anywhere near 1e5 */
static inline int affine_voronec_is_good(int count, const double *check)
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
static inline void affine_voronec_fill(size_t left, size_t count, const double *t, const double *y, double *time, double *state)
{
    for (size_t l = 0; l < AFFINE_VORONEC_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < AFFINE_VORONEC_NY; ++k) {
            state[k * AFFINE_VORONEC_LANES + l] = y[k * count + i];
        }
    }
}

static inline void affine_voronec_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < AFFINE_VORONEC_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * AFFINE_VORONEC_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void affine_voronec_turn_lanes(affine_voronec_lanes x, affine_voronec_lanes *far, affine_voronec_lanes *sine, affine_voronec_lanes *cosine)
{
    double angle[AFFINE_VORONEC_LANES];
    double up[AFFINE_VORONEC_LANES];
    double along[AFFINE_VORONEC_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < AFFINE_VORONEC_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int affine_voronec_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double c_z = cos(z);
    const double s_z = sin(z);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = 0.3 * z7;
    const double z9 = x * x;
    const double z10 = 1.0 + z9;
    const double z11 = z10 * z2;
    const double z12 = z8 + z6 * z11;
    const double z13 = z1 * z2 + z6 * (z8 + z12);
    const double z14 = x * z;
    const double z15 = z14 * z12;
    const double z16 = 1.0 / z13;
    const double z17 = z15 * z16;
    const double z18 = 2.0 + s_z;
    const double z19 = z18 * z2 + 0.25 * (z11 * (z14 * z14));
    const double z20 = 0.25 * (z15 * z17) - z19;
    const double z21 = y_dot * z14;
    const double z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t);
    const double z23 = 0.06 * (c_z * c_t);
    const double z24 = s_z * z22;
    const double z25 = 0.3 * z24;
    const double z26 = z * x_dot;
    const double z27 = x * z22;
    const double z28 = z2 * x_dot * x_dot;
    const double z29 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24)) + (0.4 - 0.8 * (s_t * s_t)
        + (z26 + z27) * (0.3 + 0.5 * y_dot));
    const double z30 = 0.3 * (z7 * z29) - (0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t))));
    const double z31 = z22 * (0.1 * t - z23 + z2 * (z25 - (2.0 * z26 - z27))) - (x_dot * (0.1 + 0.2 * (z1 *
        c_t)) + (z * z6 * (3.0 - z28) + z30));
    const double z32 = c_z * y_dot * y_dot;
    const double z33 = x_dot * z24;
    const double z34 = x + t * x_dot;
    const double z35 = z4 - 0.05 * z22;
    const double z36 = x_dot * (z23 + z2 * (2.0 * z27 - z25)) + (z11 * z29 + 0.2 * (z10 * c_t * z22));
    const double z37 = z2 * (0.5 * z32 - 0.3 * z33) - (0.1 * z34 - (z35 - (0.3 * y_dot - 0.2 * z9) - z36));
    const double z38 = z31 + z6 * z37;
    const double z39 = z2 * (0.25 * z32 - 0.15 * z33) - (0.05 * z34 - (0.1 * z9 + 0.5 * z35 - 0.5 * z36));
    const double z40 = 0.15 * z21 - (0.6 * z22 - (2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17 * z38)));
    const double z41 = y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22)) + (z * z14 * (1.5 - 0.5 * z28) + z40);
    const double z42 = (z14 * z39 - z41) / z20;
    /* (I.4.9) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z22; /* z' */
    /* (I.4.9) 11:4 */
    dydt[3] = z16 * z38 + 0.5 * (z17 * z42); /* x'' */
    dydt[4] = -z42; /* y'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[3] + dydt[4]) <= DBL_MAX && fabs(-z20) > 1e-14 * z19)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(-z20) > 1e-14 * z19)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        return affine_voronec_finish(5, dydt);
    }
    return AFFINE_VORONEC_OK;
}

int affine_voronec_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = x * z;
    const double z2 = 0.3 * z1 + (x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)) + 0.4 * (c_t
        * s_t);
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = z2; /* z' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2]) <= DBL_MAX)) {
        return affine_voronec_finish(3, qdot);
    }
    return AFFINE_VORONEC_OK;
}

AFFINE_VORONEC_SLOW
int affine_voronec_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double c_z = cos(z);
    const double s_z = sin(z);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = x * x;
    const double z9 = 1.0 + z8;
    const double z10 = z9 * z2;
    const double z11 = 0.3 * z7 + z6 * z10;
    const double z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11;
    const double z13 = x * z;
    const double z14 = z13 * z11;
    const double z15 = 1.0 / z12;
    const double z16 = z14 * z15;
    const double z17 = 2.0 + s_z;
    const double z18 = z17 * z2 + 0.25 * (z10 * (z13 * z13));
    const double z19 = 0.25 * (z14 * z16) - z18;
    const double z20 = x + t * x_dot;
    const double z21 = y_dot * z13;
    const double z22 = 0.3 * z13 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t);
    const double z23 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z20) + (0.3 * (y_dot * z6) - 0.1 * (t *
        z22));
    const double z24 = 0.4 * (c_t * c_t - s_t * s_t);
    const double z25 = z * x_dot + x * z22;
    const double z26 = 0.3 * z25;
    const double z27 = s_z * z22;
    const double z28 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z27));
    const double z29 = y_dot * z25;
    const double z30 = z24 + (z26 + (z28 + 0.5 * z29));
    const double z31 = z2 * z22;
    const double z32 = c_z * c_t;
    const double z33 = 0.3 * (z31 * z27 - 0.2 * (z22 * z32)) - x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z31));
    const double z34 = x_dot * z27;
    const double z35 = 0.3 * (z2 * z34 - 0.2 * (x_dot * z32)) - z22 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot *
        z2)));
    const double z36 = z10 * z30 - z35;
    const double z37 = z4 - 0.05 * z22;
    const double z38 = z * z6;
    const double z39 = x_dot * x_dot;
    const double z40 = c_z * y_dot * y_dot;
    const double z41 = 0.5 * (2.0 * (x * (z22 * z22)) + (2.0 * (z39 * z38) + z6 * z40)) - 0.3 * (z6 * z34);
    const double z42 = 0.5 * (2.0 * x + 6.0 * z38) - (0.2 * (2.0 * z13 + z8 * z6) + z2 * z41);
    const double z43 = z23 + (0.3 * (z7 * z30) - z33 + z6 * z36) + (0.1 * x_dot - z6 * z37 + z42);
    const double z44 = 0.3 * z22;
    const double z45 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z13 * z20) - z44) + 0.5 * (z13 * z36);
    const double z46 = z * z13;
    const double z47 = 0.1 * (z8 * z13) + z2 * (0.5 * (z39 * z46 + 0.5 * (z13 * z40)) - 0.15 * (z13 * z34));
    const double z48 = 0.2 * y_dot - z44 - 0.5 * (z13 * z37) + (0.5 * (4.0 * y_2 + 3.0 * z46) - z47);
    const double z49 = (y_dot * (0.2 * (z17 * c_t) + c_z * z31) + z45 + z48 - 0.5 * (z16 * z43)) / z19;
    const double z50 = z15 * z43 + 0.5 * (z16 * z49);
    /* (I.4.9) */
    qddot[0] = -z50; /* x'' */
    qddot[1] = z49; /* y'' */
    qddot[2] = z24 + (z26 + (z28 - z6 * z50 + 0.5 * (z29 + z13 * z49))); /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[2]) <= DBL_MAX && fabs(-z19) > 1e-14 * z18)) {
        /* the mass matrix is singular */
        if (!(fabs(z12) > 0.0)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(-z19) > 1e-14 * z18)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        return affine_voronec_finish(3, qddot);
    }
    return AFFINE_VORONEC_OK;
}

int affine_voronec_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0];
    const double y_2 = q[1];
    const double z = q[2];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = x_dot;
    y[4] = y_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4]) <= DBL_MAX)) {
        return affine_voronec_finish(5, y);
    }
    return AFFINE_VORONEC_OK;
}

int affine_voronec_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)p;
    const double z = q[2];

    /* sines and cosines */
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double x = q[0];
    const double y = q[1];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];

    /* state */
    const double z1 = x * z;
    const double z2 = 0.3 * z1 + (x_dot * (y * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)) + 0.4 * (c_t *
        s_t);
    /* (I.1.1) 18:5 */
    r[0] = z_dot - z2; /* contact = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return affine_voronec_finish(1, r);
    }
    return AFFINE_VORONEC_OK;
}

AFFINE_VORONEC_SLOW
int affine_voronec_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double c_z = cos(z);
    const double s_z = sin(z);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = x * x;
    const double z9 = 1.0 + z8;
    const double z10 = z9 * z2;
    const double z11 = 0.3 * z7 + z6 * z10;
    const double z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11;
    const double z13 = 2.0 + s_z;
    const double z14 = x * z;
    const double z15 = z14 * z10;
    const double z16 = z13 * z2 + 0.25 * (z14 * z15);
    const double z17 = z14 * z11;
    const double z18 = 1.0 / z12;
    const double z19 = z17 * z18;
    const double z20 = z16 - 0.25 * (z17 * z19);
    const double z21 = y_dot * z14;
    const double z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t);
    const double z23 = z * x_dot + x * z22;
    const double z24 = s_z * z22;
    const double z25 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24)) + 0.5 * (y_dot * z23);
    const double z26 = 0.4 * (c_t * c_t - s_t * s_t) + (0.3 * z23 + z25);
    const double z27 = x_dot * z24;
    const double z28 = c_z * c_t;
    const double z29 = 0.3 * (z2 * z27 - 0.2 * (x_dot * z28)) - z22 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot *
        z2)));
    const double z30 = z10 * z26 - z29;
    const double z31 = x + t * x_dot;
    const double z32 = z4 - 0.05 * z22;
    const double z33 = x_dot * x_dot;
    const double z34 = c_z * y_dot * y_dot;
    const double z35 = 3.0 * z - (0.2 * z8 + z2 * (0.5 * (2.0 * (z * z33) + z34) - 0.3 * z27));
    const double z36 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z31) + (0.3 * (y_dot * z6) - 0.1 * (t *
        z22));
    const double z37 = z2 * z22;
    const double z38 = 0.3 * (z37 * z24 - 0.2 * (z22 * z28)) - x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z37));
    const double z39 = z * z6;
    const double z40 = 0.5 * (2.0 * (x * (z22 * z22)) + (2.0 * (z33 * z39) + z6 * z34)) - 0.3 * (z6 * z27);
    const double z41 = 0.5 * (2.0 * x + 6.0 * z39) - (0.2 * (2.0 * z14 + z8 * z6) + z2 * z40);
    const double z42 = z36 + (0.3 * (z7 * z26) - z38 + z6 * z30) + (0.1 * x_dot - z6 * z32 + z41);
    const double z43 = 0.3 * z22;
    const double z44 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z14 * z31) - z43) + 0.5 * (z14 * z30);
    const double z45 = z * z14;
    const double z46 = 0.1 * (z8 * z14) + z2 * (0.5 * (z33 * z45 + 0.5 * (z14 * z34)) - 0.15 * (z14 * z27));
    const double z47 = 0.2 * y_dot - z43 - 0.5 * (z14 * z32) + (0.5 * (4.0 * y_2 + 3.0 * z45) - z46);
    const double z48 = (y_dot * (0.2 * (z13 * c_t) + c_z * z37) + z44 + z47 - 0.5 * (z19 * z42)) / z20;
    const double z49 = z30 + (0.3 * y_dot + 0.1 * z31) - (z32 - z35) - (z11 * (z18 * z42 - 0.5 * (z19 * z48))
        + 0.5 * (z15 * z48));
    /* (I.4.1) 18:5 */
    lambda[0] = z49; /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(z20) > 1e-14 * z16)) {
        /* the mass matrix is singular */
        if (!(fabs(z12) > 0.0)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z20) > 1e-14 * z16)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        return affine_voronec_finish(1, lambda);
    }
    return AFFINE_VORONEC_OK;
}

double affine_voronec_energy(double t, const double *y, const double *p)
{
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double c_t = cos(t);
    const double s_t = sin(t);
    const double c_z = cos(z);
    const double s_z = sin(z);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = z * z;
    const double z2 = x * x;
    const double z3 = y_2 * x_dot;
    const double z4 = x * z;
    const double z5 = 0.4 * (c_t * s_t) + (0.3 * z4 + (0.5 * (y_dot * z4) + (1.0 + 0.1 * s_t) * (c_z * z3)));
    const double z6 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot) + (1.0 + z2) * (z5 * z5);
    const double z7 = 0.4 * (z3 * c_t) - 0.3 * (z * y_dot) + 0.1 * (t * x * z5) + (1.0 + 0.2 * s_t) * (0.5 *
        z6 + 0.3 * (x_dot * c_z * z5));
    return 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2))) + (0.2 * (z * z2) + z7);
}

AFFINE_VORONEC_SLOW
int affine_voronec_jacobian(double t, const double *y, const double *p, double *J)
{
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double c_z = cos(z);
    const double s_z = sin(z);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = x * x;
    const double z9 = 1.0 + z8;
    const double z10 = z9 * z2;
    const double z11 = 0.3 * z7 + z6 * z10;
    const double z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11;
    const double z13 = 2.0 + s_z;
    const double z14 = x * z;
    const double z15 = z14 * z10;
    const double z16 = z13 * z2 + 0.25 * (z14 * z15);
    const double z17 = z14 * z11;
    const double z18 = 1.0 / z12;
    const double z19 = z17 * z18;
    const double z20 = z16 - 0.25 * (z17 * z19);
    const double z21 = 0.3 + 0.5 * y_dot;
    const double z22 = x_dot * z5;
    const double z23 = y_dot * z14;
    const double z24 = 0.3 * z14 + (x_dot * z6 + 0.5 * z23) + 0.4 * (c_t * s_t);
    const double z25 = z24 * z24;
    const double z26 = z6 * z24;
    const double z27 = z2 * z26;
    const double z28 = 0.3 * z11 + 0.5 * (y_dot * z11);
    const double z29 = s_z * z24;
    const double z30 = x_dot * z11;
    const double z31 = z5 * z30;
    const double z32 = z2 * z24;
    const double z33 = z2 * z6;
    const double z34 = y_2 * z31 + 0.3 * (z32 + x_dot * z33);
    const double z35 = x_dot * z2;
    const double z36 = 0.2 * (z9 * c_t) + 2.0 * (x * z35);
    const double z37 = s_z * z6;
    const double z38 = x_dot * z37;
    const double z39 = z6 * z36 - (0.1 * t - (0.05 * z6 + (0.3 * (z2 * z38) - 2.0 * (x * z32))));
    const double z40 = 0.3 * (z2 * z29) + (s_z * z34 - (2.0 * (z * z35) + (0.06 * (c_z * c_t) + z39)));
    const double z41 = x * z28 - z40;
    const double z42 = 1.0 / z20;
    const double z43 = 0.3 * z24;
    const double z44 = z4 - 0.05 * z24;
    const double z45 = z * z14;
    const double z46 = x_dot * x_dot;
    const double z47 = y_dot * y_dot;
    const double z48 = c_z * z14;
    const double z49 = s_z * z14;
    const double z50 = x_dot * z49;
    const double z51 = 0.1 * (z8 * z14) + z2 * (0.5 * (z46 * z45 + 0.5 * (z47 * z48)) - 0.15 * (z50 * z24));
    const double z52 = 0.2 * y_dot - z43 - 0.5 * (z14 * z44) + (0.5 * (4.0 * y_2 + 3.0 * z45) - z51);
    const double z53 = 0.2 * (z13 * c_t) + c_z * z32;
    const double z54 = x_dot * c_t;
    const double z55 = x + t * x_dot;
    const double z56 = z * x_dot + x * z24;
    const double z57 = 0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z29);
    const double z58 = 0.4 * (c_t * c_t - s_t * s_t) + (0.3 * z56 + (x_dot * z57 + 0.5 * (y_dot * z56)));
    const double z59 = z10 * z58 + (z24 * z36 + 0.3 * (0.2 * (c_z * z54) - z29 * z35));
    const double z60 = y_dot * z53 + (0.15 * z23 - 0.4 * z54 + (0.05 * (z14 * z55) - z43) + 0.5 * (z14 *
        z59));
    const double z61 = z * z6;
    const double z62 = c_z * z6;
    const double z63 = 0.5 * (2.0 * (z46 * z61) + z47 * z62 + 2.0 * (x * z25)) - 0.3 * (z38 * z24);
    const double z64 = 0.5 * (2.0 * x + 6.0 * z61) - (0.2 * (2.0 * z14 + z8 * z6) + z2 * z63);
    const double z65 = y_dot * c_t;
    const double z66 = 0.4 * (z65 - y_2 * s_t) + 0.1 * (z6 * z55) + (0.3 * (y_dot * z6) - 0.1 * (t * z24));
    const double z67 = c_t * z24;
    const double z68 = 0.2 * (z1 * c_t) + 2.0 * (z * z32);
    const double z69 = 0.3 * (z7 * z58) - (0.3 * (z32 * z29 - 0.2 * (c_z * z67)) - x_dot * z68) + z6 * z59;
    const double z70 = 0.1 * x_dot - z6 * z44 + z64 + (z66 + z69);
    const double z71 = z42 * (z52 + z60 - 0.5 * (z19 * z70));
    const double z72 = 0.5 * (y_dot * z41) + (0.3 * z41 - (0.4 + 0.5 * (z11 * z71)));
    const double z73 = 1.0 + (0.1 * z6 - z2 * z25 + 2.0 * (x_dot * z27)) + z24 * z28 + z * z72;
    const double z74 = z18 * z70 - 0.5 * (z19 * z71);
    const double z75 = z6 * z74;
    const double z76 = z14 * z71;
    const double z77 = z75 + 0.5 * z76;
    const double z78 = z73 - 2.0 * (x * (0.2 * z6 - (0.2 * (c_t * z26) + z33 * (z58 - z77))));
    const double z79 = z14 * z24;
    const double z80 = z2 * z79;
    const double z81 = 0.15 * z15 + 0.25 * (y_dot * z15);
    const double z82 = z2 * z14;
    const double z83 = x_dot * z15;
    const double z84 = z5 * z83;
    const double z85 = 0.15 * (x_dot * z82) + 0.5 * (y_2 * z84);
    const double z86 = y_dot * z2;
    const double z87 = s_z * z85 - (c_z * z86 - (0.6 - (0.025 * z14 + 0.15 * (z2 * z50)) - 0.5 * (z14 *
        z36)));
    const double z88 = x * z81 - z87;
    const double z89 = 0.15 + 0.5 * z88;
    const double z90 = z11 * z74;
    const double z91 = z46 * z2;
    const double z92 = 1.5 - 0.5 * z91;
    const double z93 = z47 * z2;
    const double z94 = c_z * z93;
    const double z95 = x_dot * z32;
    const double z96 = s_z * z95;
    const double z97 = 0.5 * z44 - (z * z92 - (0.25 * z94 + (0.1 * z8 - 0.15 * z96))) - 0.5 * z59;
    const double z98 = 0.3 * z88 - (0.5 * z90 - (0.05 * z55 - z97 - 0.25 * (z15 * z71) - 0.25 * (z10 * z76)));
    const double z99 = y_dot * z89 + z98;
    const double z100 = z14 * z74;
    const double z101 = 0.1 * (c_t * z79) + z2 * (0.5 * (z14 * z58) - (0.25 * (z14 * z76) + 0.5 * (z6 *
        z100)));
    const double z102 = 0.05 * z14 + x_dot * z80 + z24 * z81 + z * z99 - 2.0 * (x * (0.1 * z14 - z101));
    const double z103 = z42 * (z102 - 0.5 * (z19 * z78));
    const double z104 = 3.0 - z91;
    const double z105 = 0.3 * y_dot - (z44 - (z * z104 - (0.5 * z94 + (0.2 * z8 - 0.3 * z96))) - z59);
    const double z106 = z5 * (x_dot * z41 - (z90 - (0.1 * z55 + z105) + z10 * z77 + 0.3 * (z7 * z74)));
    const double z107 = 0.1 * (c_t * z30) + z106;
    const double z108 = 0.4 * s_t + z29 * z31 - c_z * z107;
    const double z109 = 0.05 * (c_t * z83) + z5 * (x_dot * z88 - 0.5 * (z10 * z100));
    const double z110 = z42 * (2.0 - 0.5 * (z29 * z84) + c_z * z109 + 0.5 * (z19 * z108));
    const double z111 = c_t * z6;
    const double z112 = y_dot * z31 + (0.06 * z67 - 0.5 * (z6 * z93)) - 0.3 * (z2 * (z77 - (z58 - z75)));
    const double z113 = x_dot * z28 + (z6 * z104 + 2.0 * (z24 * z35)) + x * z72 - s_z * (0.06 * (x_dot *
        z111) + (z112 + y_2 * z107));
    const double z114 = c_z * (0.3 * (z6 * z95) - z24 * z34) + z113 + 2.0 * (z * (0.2 * z54 - z2 * z74));
    const double z115 = c_t * z14;
    const double z116 = 0.5 * (y_dot * z84) - (0.25 * (z14 * z93) - z24 * z86) - 0.15 * (z2 * z100) + y_2 *
        z109;
    const double z117 = z14 * z92 + x_dot * z81 + x * z99 - s_z * (0.03 * (x_dot * z115) + z116) + c_z *
        (0.15 * (z14 * z95) - z24 * z85 + (0.2 * z65 - z2 * z71));
    const double z118 = z42 * (z117 - 0.5 * (z19 * z114));
    const double z119 = 2.0 * (x * z27) - (0.3 * (z29 * z33) - (z68 + (0.1 * (t * z6) + 0.3 * (z37 * z32))));
    const double z120 = 2.0 * (z61 * z35) - (0.06 * (c_z * z111) + (0.1 + (z11 * z57 + (z * z28 + z119)) + z6
        * z41));
    const double z121 = 0.4 * c_t;
    const double z122 = 0.05 * (t * z14) - (z121 - 0.15 * (z49 * z32)) - 0.15 * (z29 * z82) + x * z80;
    const double z123 = z45 * z35 - (0.03 * (c_z * z115) + (z * z81 + z122 + 0.5 * (z15 * z57) + z6 * z88));
    const double z124 = z42 * (z123 - 0.5 * (z19 * z120));
    const double z125 = z62 * z86 - (c_z * z31 + (z121 + 0.3 * z6 + 0.5 * (z11 * z56)) + 0.5 * (z14 * z41));
    const double z126 = 0.5 * (y_dot * (z2 * z48)) - (z14 * z89 + (0.2 + (0.5 * (c_z * z84) + (z53 + 0.25 *
        (z15 * z56)))));
    const double z127 = z42 * (z126 - 0.5 * (z19 * z125));
    /* (I.4.9) */
    J[3] = 1.0;
    J[9] = 1.0;
    J[10] = z * z21;
    J[11] = c_z * z22;
    J[12] = x * z21 - y_2 * s_z * z22;
    J[13] = z6;
    J[14] = 0.5 * z14;
    J[15] = 0.5 * (z19 * z103) - z18 * z78;
    J[16] = z18 * z108 + 0.5 * (z19 * z110);
    J[17] = 0.5 * (z19 * z118) - z18 * z114;
    J[18] = z18 * z120 - 0.5 * (z19 * z124);
    J[19] = z18 * z125 - 0.5 * (z19 * z127);
    J[20] = -z103;
    J[21] = -z110;
    J[22] = -z118;
    J[23] = z124;
    J[24] = z127;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[10] + J[12] + J[14] + J[15] + J[16] + J[17] + J[18] + J[19] + J[20] + J[21] + J[22]) <=
        DBL_MAX
        && fabs(z20) > 1e-14 * z16)) {
        /* the mass matrix is singular */
        if (!(fabs(z12) > 0.0)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z20) > 1e-14 * z16)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        return affine_voronec_finish(25, J);
    }
    return AFFINE_VORONEC_OK;
}

int affine_voronec_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return AFFINE_VORONEC_OK;
}

#if AFFINE_VORONEC_LANES >= 2
static __attribute__((noinline)) void affine_voronec_rhs_lanes(const double *fixed, size_t stride, const
    double *t, const double *y, double *restrict dydt, double *check)
{
    (void)fixed;
    affine_voronec_lanes far = {0}; /* the squares of the angles */
    affine_voronec_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    affine_voronec_bits bad = {0}; /* singular blocks */
    const affine_voronec_lanes t_ = affine_voronec_get(t);
    const affine_voronec_lanes x = affine_voronec_get(y);
    const affine_voronec_lanes y_2 = affine_voronec_get(y + 1 * stride);
    const affine_voronec_lanes z = affine_voronec_get(y + 2 * stride);
    const affine_voronec_lanes x_dot = affine_voronec_get(y + 3 * stride);
    const affine_voronec_lanes y_dot = affine_voronec_get(y + 4 * stride);
    const affine_voronec_lanes z1 = 1.0 + z * z;
    affine_voronec_lanes sine1, cosine1;
    affine_voronec_turn_lanes(AFFINE_VORONEC_SPREAD(t_), &far, &sine1, &cosine1);
    const affine_voronec_lanes s_t = sine1;
    const affine_voronec_lanes z2 = 1.0 + 0.2 * s_t;
    affine_voronec_lanes sine2, cosine2;
    affine_voronec_turn_lanes(AFFINE_VORONEC_SPREAD(z), &far, &sine2, &cosine2);
    const affine_voronec_lanes c_z = cosine2;
    const affine_voronec_lanes z3 = y_2 * c_z;
    const affine_voronec_lanes z4 = 0.1 * s_t;
    const affine_voronec_lanes z5 = 1.0 + z4;
    const affine_voronec_lanes z6 = z3 * z5;
    const affine_voronec_lanes z7 = c_z * z2;
    const affine_voronec_lanes z8 = 0.3 * z7;
    const affine_voronec_lanes z9 = x * x;
    const affine_voronec_lanes z10 = 1.0 + z9;
    const affine_voronec_lanes z11 = z10 * z2;
    const affine_voronec_lanes z12 = z8 + z6 * z11;
    const affine_voronec_lanes z13 = z1 * z2 + z6 * (z8 + z12);
    const affine_voronec_lanes z14 = x * z;
    const affine_voronec_lanes z15 = z14 * z12;
    const affine_voronec_lanes z16 = 1.0 / z13;
    const affine_voronec_lanes z17 = z15 * z16;
    const affine_voronec_lanes s_z = sine2;
    const affine_voronec_lanes z18 = 2.0 + s_z;
    const affine_voronec_lanes z19 = z18 * z2 + 0.25 * (z11 * (z14 * z14));
    const affine_voronec_lanes z20 = 0.25 * (z15 * z17) - z19;
    /* the mass matrix is singular */
    bad |= affine_voronec_misses(affine_voronec_size(AFFINE_VORONEC_SPREAD(-z20)), 1e-14 * z19);
    const affine_voronec_lanes z21 = y_dot * z14;
    const affine_voronec_lanes c_t = cosine1;
    const affine_voronec_lanes z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t);
    const affine_voronec_lanes z23 = 0.06 * (c_z * c_t);
    const affine_voronec_lanes z24 = s_z * z22;
    const affine_voronec_lanes z25 = 0.3 * z24;
    const affine_voronec_lanes z26 = z * x_dot;
    const affine_voronec_lanes z27 = x * z22;
    const affine_voronec_lanes z28 = z2 * x_dot * x_dot;
    const affine_voronec_lanes z29 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24)) + (0.4 - 0.8
        * (s_t * s_t) + (z26 + z27) * (0.3 + 0.5 * y_dot));
    const affine_voronec_lanes z30 = 0.3 * (z7 * z29) - (0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 *
        s_t))));
    const affine_voronec_lanes z31 = z22 * (0.1 * t_ - z23 + z2 * (z25 - (2.0 * z26 - z27))) - (x_dot * (0.1
        + 0.2 * (z1 * c_t)) + (z * z6 * (3.0 - z28) + z30));
    const affine_voronec_lanes z32 = c_z * y_dot * y_dot;
    const affine_voronec_lanes z33 = x_dot * z24;
    const affine_voronec_lanes z34 = x + t_ * x_dot;
    const affine_voronec_lanes z35 = z4 - 0.05 * z22;
    const affine_voronec_lanes z36 = x_dot * (z23 + z2 * (2.0 * z27 - z25)) + (z11 * z29 + 0.2 * (z10 * c_t *
        z22));
    const affine_voronec_lanes z37 = z2 * (0.5 * z32 - 0.3 * z33) - (0.1 * z34 - (z35 - (0.3 * y_dot - 0.2 *
        z9) - z36));
    const affine_voronec_lanes z38 = z31 + z6 * z37;
    const affine_voronec_lanes z39 = z2 * (0.25 * z32 - 0.15 * z33) - (0.05 * z34 - (0.1 * z9 + 0.5 * z35 -
        0.5 * z36));
    const affine_voronec_lanes z40 = 0.15 * z21 - (0.6 * z22 - (2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17
        * z38)));
    const affine_voronec_lanes z41 = y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22)) + (z * z14 * (1.5 - 0.5 *
        z28) + z40);
    const affine_voronec_lanes z42 = (z14 * z39 - z41) / z20;
    /* (I.4.9) */
    const affine_voronec_lanes slope1 = x_dot;
    affine_voronec_put(dydt, slope1);
    const affine_voronec_lanes slope2 = y_dot;
    affine_voronec_put(dydt + 1 * stride, slope2);
    const affine_voronec_lanes slope3 = z22;
    affine_voronec_put(dydt + 2 * stride, slope3);
    /* (I.4.9) 11:4 */
    const affine_voronec_lanes slope4 = z16 * z38 + 0.5 * (z17 * z42);
    sum += slope4;
    affine_voronec_put(dydt + 3 * stride, slope4);
    const affine_voronec_lanes slope5 = -z42;
    sum += slope5;
    affine_voronec_put(dydt + 4 * stride, slope5);
    affine_voronec_put(check, affine_voronec_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void affine_voronec_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[AFFINE_VORONEC_LANES];
    double state[5 * AFFINE_VORONEC_LANES];
    double slope[5 * AFFINE_VORONEC_LANES];
    affine_voronec_fill(left, count, t, y, time, state);
    affine_voronec_rhs_lanes(fixed, AFFINE_VORONEC_LANES, time, state, slope, check);
    affine_voronec_pour(left, count, slope, dydt);
}
#endif

int affine_voronec_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
#if AFFINE_VORONEC_LANES >= 2
    const double *fixed = p;
    double check[1 * AFFINE_VORONEC_LANES];
    int status = AFFINE_VORONEC_OK;
    for (size_t i = 0; i < count; i += AFFINE_VORONEC_LANES) {
        const size_t left = count - i < AFFINE_VORONEC_LANES ? count - i : AFFINE_VORONEC_LANES;
        if (left == AFFINE_VORONEC_LANES) {
            affine_voronec_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            affine_voronec_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!affine_voronec_is_good(1 * AFFINE_VORONEC_LANES, check)) {
            const int one = affine_voronec_one_by_one(count, i, left, t, y, p, dydt);
            status = status == AFFINE_VORONEC_OK ? one : status;
        }
    }
    return status;
#else
    return affine_voronec_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
