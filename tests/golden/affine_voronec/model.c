/*
 * affine_voronec.c: affine_voronec, emitted by nhc 0.1.0 (nhc:17dc1fd986aa4e85)
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
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int affine_voronec_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
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

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int affine_voronec_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : AFFINE_VORONEC_NOT_FINITE;
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
static int affine_voronec_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = AFFINE_VORONEC_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[AFFINE_VORONEC_NY];
        double slope[AFFINE_VORONEC_NY];
        for (size_t k = 0; k < AFFINE_VORONEC_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
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

/* makes a NaN of each lane whose bits are set */
static inline affine_voronec_lanes affine_voronec_mark(affine_voronec_lanes value, affine_voronec_bits bad)
{
    return (affine_voronec_lanes)((affine_voronec_bits)value | bad);
}

static inline affine_voronec_lanes affine_voronec_size(affine_voronec_lanes x)
{
    return (affine_voronec_lanes)((affine_voronec_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
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

/* the last states, fewer than there are lanes; the other lanes repeat the last one */
static inline void affine_voronec_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < AFFINE_VORONEC_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < AFFINE_VORONEC_NY; ++k) {
            state[k * AFFINE_VORONEC_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void affine_voronec_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < AFFINE_VORONEC_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * AFFINE_VORONEC_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void affine_voronec_turn_lanes(affine_voronec_lanes x, affine_voronec_lanes *far,
    affine_voronec_lanes *sine, affine_voronec_lanes *cosine)
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

int affine_voronec_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double c_z = cos(z);
    const double s_z = sin(z);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* from the state */
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
    const double z28 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24)) + (0.4 - 0.8 * (s_t * s_t)
        + (0.3 + 0.5 * y_dot) * (z26 + z27));
    const double z29 = 0.3 * (z7 * z28) - (0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t))));
    const double z30 = z22 * (0.1 * t - z23 + z2 * (z25 - (2.0 * z26 - z27))) - (x_dot * (0.1 + 0.2 * (z1 *
        c_t)) + z29);
    const double z31 = c_z * y_dot * y_dot;
    const double z32 = z * x_dot * x_dot;
    const double z33 = x_dot * z24;
    const double z34 = x + t * x_dot;
    const double z35 = 3.0 * z - (z4 - 0.05 * z22);
    const double z36 = x_dot * (z23 + z2 * (2.0 * z27 - z25)) + (z11 * z28 + 0.2 * (z10 * c_t * z22));
    const double z37 = z2 * (0.5 * z31 + (z32 - 0.3 * z33)) - (0.1 * z34 - (0.2 * z9 - (0.3 * y_dot + z35) -
        z36));
    const double z38 = z30 + z6 * z37;
    const double z39 = z2 * (0.25 * z31 + (0.5 * z32 - 0.15 * z33)) - (0.05 * z34 - (0.1 * z9 - 0.5 * z35 -
        0.5 * z36));
    const double z40 = 0.15 * z21 - (0.6 * z22 - (2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17 * z38)));
    const double z41 = (z14 * z39 - (y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22)) + z40)) / z20;
    /* (I.1.2) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z22; /* z' */
    /* (I.4.9) 11:4 */
    dydt[3] = z16 * z38 + 0.5 * (z17 * z41); /* x'' */
    dydt[4] = -z41; /* y'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[3] + dydt[4]) <= DBL_MAX && fabs(-z20) > 1e-13 * z19)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return affine_voronec_refuse(fabs(z13), 0.0, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(-z20) > 1e-13 * z19)) {
            return affine_voronec_refuse(fabs(-z20), 1e-13 * z19, AFFINE_VORONEC_SINGULAR_2);
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

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* from the state */
    const double z1 = x * z;
    const double z2 = 0.3 * z1 + (x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)) + 0.4 * (c_t
        * s_t);
    /* (I.1.2) */
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

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* from the state */
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
    const double z24 = z2 * z22;
    const double z25 = s_z * z22;
    const double z26 = c_z * c_t;
    const double z27 = 0.3 * (z24 * z25 - 0.2 * (z22 * z26)) - x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z24));
    const double z28 = z * x_dot + x * z22;
    const double z29 = y_dot * z28;
    const double z30 = 0.4 * (c_t * c_t - s_t * s_t) + (x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 *
        z25)) + 0.3 * z28);
    const double z31 = 0.5 * z29 + z30;
    const double z32 = x_dot * z25;
    const double z33 = (2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t)) * z22 - 0.3 * (z2 * z32 - 0.2 * (x_dot *
        z26));
    const double z34 = z33 + z10 * z31;
    const double z35 = 3.0 * z - (z4 - 0.05 * z22);
    const double z36 = z * x_dot * x_dot;
    const double z37 = c_z * y_dot * y_dot;
    const double z38 = 0.5 * (2.0 * (x * (z22 * z22)) + (2.0 * (z6 * z36) + z6 * z37)) - 0.3 * (z6 * z32);
    const double z39 = x + 0.1 * x_dot + z6 * z35 - (0.2 * (2.0 * z13 + z8 * z6) + z2 * z38);
    const double z40 = z23 - (z27 - 0.3 * (z7 * z31) - z6 * z34) + z39;
    const double z41 = 0.3 * z22;
    const double z42 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z13 * z20) - z41) + 0.5 * (z13 * z34);
    const double z43 = 0.1 * (z8 * z13) + z2 * (0.5 * (z13 * z36 + 0.5 * (z13 * z37)) - 0.15 * (z13 * z32));
    const double z44 = y_dot * (0.2 * (z17 * c_t) + c_z * z24) + z42 + (2.0 * y_2 + (0.2 * y_dot - z41) + 0.5
        * (z13 * z35) - z43);
    const double z45 = (z44 - 0.5 * (z16 * z40)) / z19;
    const double z46 = z15 * z40 + 0.5 * (z16 * z45);
    /* (I.4.9) */
    qddot[0] = -z46; /* x'' */
    qddot[1] = z45; /* y'' */
    qddot[2] = z30 - (z6 * z46 - 0.5 * (z29 + z13 * z45)); /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[2]) <= DBL_MAX && fabs(-z19) > 1e-13 * z18)) {
        /* the mass matrix is singular */
        if (!(fabs(z12) > 0.0)) {
            return affine_voronec_refuse(fabs(z12), 0.0, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(-z19) > 1e-13 * z18)) {
            return affine_voronec_refuse(fabs(-z19), 1e-13 * z18, AFFINE_VORONEC_SINGULAR_2);
        }
        return affine_voronec_finish(3, qddot);
    }
    return AFFINE_VORONEC_OK;
}

int affine_voronec_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the state */
    const double x = q[0];
    y[0] = x;
    const double y_2 = q[1];
    y[1] = y_2;
    const double z = q[2];
    y[2] = z;
    const double x_dot = qdot[0];
    y[3] = x_dot;
    const double y_dot = qdot[1];
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

    /* what else is read */
    const double x = q[0];
    const double y = q[1];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];

    /* from the state */
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

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* from the state */
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
    const double z23 = 3.0 * z - (z4 - 0.05 * z22);
    const double z24 = z * x_dot * x_dot;
    const double z25 = c_z * y_dot * y_dot;
    const double z26 = s_z * z22;
    const double z27 = x_dot * z26;
    const double z28 = 0.5 * (2.0 * (x * (z22 * z22)) + (2.0 * (z6 * z24) + z6 * z25)) - 0.3 * (z6 * z27);
    const double z29 = x + 0.1 * x_dot + z6 * z23 - (0.2 * (2.0 * z14 + z8 * z6) + z2 * z28);
    const double z30 = x + t * x_dot;
    const double z31 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z30) + (0.3 * (y_dot * z6) - 0.1 * (t *
        z22));
    const double z32 = z * x_dot + x * z22;
    const double z33 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z26)) + 0.5 * (y_dot * z32);
    const double z34 = 0.4 * (c_t * c_t - s_t * s_t) + (0.3 * z32 + z33);
    const double z35 = z2 * z22;
    const double z36 = c_z * c_t;
    const double z37 = 0.3 * (z35 * z26 - 0.2 * (z22 * z36)) - x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z35));
    const double z38 = (2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t)) * z22 - 0.3 * (z2 * z27 - 0.2 * (x_dot *
        z36));
    const double z39 = z10 * z34 + z38;
    const double z40 = z29 + (z31 + (0.3 * (z7 * z34) - z37 + z6 * z39));
    const double z41 = 0.3 * z22;
    const double z42 = 0.1 * (z8 * z14) + z2 * (0.5 * (z14 * z24 + 0.5 * (z14 * z25)) - 0.15 * (z14 * z27));
    const double z43 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z14 * z30) - z41) + 0.5 * (z14 * z39);
    const double z44 = 2.0 * y_2 + (0.2 * y_dot - z41) + 0.5 * (z14 * z23) - z42 + (y_dot * (0.2 * (z13 *
        c_t) + c_z * z35) + z43);
    const double z45 = (z44 - 0.5 * (z19 * z40)) / z20;
    const double z46 = z23 - (0.2 * z8 + z2 * (0.5 * (2.0 * z24 + z25) - 0.3 * z27)) + (0.3 * y_dot + 0.1 *
        z30 + z39);
    /* (I.4.1) 18:5 */
    /* reaction of contact: Q_i gains lambda_1 a_1i */
    lambda[0] = z46 - (z11 * (z18 * z40 - 0.5 * (z19 * z45)) + 0.5 * (z15 * z45));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(z20) > 1e-13 * z16)) {
        /* the mass matrix is singular */
        if (!(fabs(z12) > 0.0)) {
            return affine_voronec_refuse(fabs(z12), 0.0, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z20) > 1e-13 * z16)) {
            return affine_voronec_refuse(fabs(z20), 1e-13 * z16, AFFINE_VORONEC_SINGULAR_2);
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

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* from the state */
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

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* from the state */
    const double z1 = 1.0 + z * z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = z6 * z7;
    const double z9 = x * x;
    const double z10 = 1.0 + z9;
    const double z11 = z10 * z2;
    const double z12 = 0.3 * z7 + z6 * z11;
    const double z13 = z1 * z2 + 0.3 * z8 + z6 * z12;
    const double z14 = 2.0 + s_z;
    const double z15 = x * z;
    const double z16 = z15 * z11;
    const double z17 = z14 * z2 + 0.25 * (z15 * z16);
    const double z18 = z15 * z12;
    const double z19 = 1.0 / z13;
    const double z20 = z18 * z19;
    const double z21 = z17 - 0.25 * (z18 * z20);
    const double z22 = 0.3 + 0.5 * y_dot;
    const double z23 = x_dot * z5;
    const double z24 = y_dot * z15;
    const double z25 = 0.3 * z15 + (x_dot * z6 + 0.5 * z24) + 0.4 * (c_t * s_t);
    const double z26 = z6 * z25;
    const double z27 = z * x_dot + x * z25;
    const double z28 = s_z * z25;
    const double z29 = 0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z28);
    const double z30 = 0.4 * (c_t * c_t - s_t * s_t) + (0.3 * z27 + (x_dot * z29 + 0.5 * (y_dot * z27)));
    const double z31 = y_dot * c_t;
    const double z32 = x + t * x_dot;
    const double z33 = 0.4 * (z31 - y_2 * s_t) + 0.1 * (z6 * z32) + (0.3 * (y_dot * z6) - 0.1 * (t * z25));
    const double z34 = z2 * z25;
    const double z35 = c_t * z25;
    const double z36 = 0.2 * (z1 * c_t) + 2.0 * (z * z34);
    const double z37 = x_dot * c_t;
    const double z38 = x_dot * z2;
    const double z39 = z28 * z38;
    const double z40 = 0.2 * (z10 * c_t) + 2.0 * (x * z38);
    const double z41 = z11 * z30 + (0.3 * (0.2 * (c_z * z37) - z39) + z25 * z40);
    const double z42 = 0.3 * (z7 * z30) - (0.3 * (z34 * z28 - 0.2 * (c_z * z35)) - x_dot * z36) + z6 * z41;
    const double z43 = 3.0 * z - (z4 - 0.05 * z25);
    const double z44 = s_z * z6;
    const double z45 = x_dot * z44;
    const double z46 = z25 * z25;
    const double z47 = x_dot * x_dot;
    const double z48 = z * z6;
    const double z49 = y_dot * y_dot;
    const double z50 = 0.3 * (z45 * z25) - 0.5 * (2.0 * (x * z46) + (2.0 * (z47 * z48) + z6 * (z49 * c_z)));
    const double z51 = x + 0.1 * x_dot + z6 * z43 - (0.2 * (2.0 * z15 + z9 * z6) - z2 * z50);
    const double z52 = z33 + z42 + z51;
    const double z53 = 1.0 / z21;
    const double z54 = 0.3 * z25;
    const double z55 = z * z15;
    const double z56 = c_z * z15;
    const double z57 = s_z * z15;
    const double z58 = x_dot * z57;
    const double z59 = 0.1 * (z9 * z15) + z2 * (0.5 * (z47 * z55 + 0.5 * (z49 * z56)) - 0.15 * (z58 * z25));
    const double z60 = 0.2 * (z14 * c_t) + c_z * z34;
    const double z61 = y_dot * z60 + (0.15 * z24 - 0.4 * z37 + (0.05 * (z15 * z32) - z54) + 0.5 * (z15 *
        z41));
    const double z62 = 2.0 * y_2 + (0.2 * y_dot - z54) + 0.5 * (z15 * z43) - z59 + z61 - 0.5 * (z20 * z52);
    const double z63 = z53 * z62;
    const double z64 = z19 * z52 - 0.5 * (z20 * z63);
    const double z65 = z6 * z64;
    const double z66 = z15 * z63;
    const double z67 = z65 + 0.5 * z66;
    const double z68 = z30 - z67;
    const double z69 = 0.3 * z12 + 0.5 * (y_dot * z12);
    const double z70 = x_dot * z34;
    const double z71 = z6 * z70;
    const double z72 = z6 * z40 - (0.1 * t - (0.05 * z6 + 0.3 * (z2 * z45) - 2.0 * (x * z34)));
    const double z73 = x_dot * z12;
    const double z74 = z5 * z73;
    const double z75 = y_2 * z74 + 0.3 * (z34 + z6 * z38);
    const double z76 = 0.3 * (z2 * z28) - (2.0 * (z * z38) + (0.06 * (c_z * c_t) + z72) - s_z * z75);
    const double z77 = x * z69 - z76;
    const double z78 = 0.5 * (y_dot * z77) + (0.3 * z77 - (0.4 + 0.5 * (z12 * z63)));
    const double z79 = 2.0 * (x * (0.2 * z6 - (0.2 * (c_t * z26) + z2 * z6 * z68))) - (z25 * z69 + (2.0 * z71
        + (0.1 * z6 + (1.0 - z2 * z46))) + z * z78);
    const double z80 = z15 * z25;
    const double z81 = z15 * z64;
    const double z82 = 0.1 * (c_t * z80) + z2 * (0.5 * (z15 * z30) - (0.25 * (z15 * z66) + 0.5 * (z6 * z81)));
    const double z83 = 0.15 * z16 + 0.25 * (y_dot * z16);
    const double z84 = y_dot * z2;
    const double z85 = x_dot * z16;
    const double z86 = z5 * z85;
    const double z87 = 0.5 * (y_2 * z86) + 0.15 * (z15 * z38);
    const double z88 = c_z * z84 - (0.6 - (0.025 * z15 + 0.15 * (z2 * z58)) - 0.5 * (z15 * z40)) - s_z * z87;
    const double z89 = x * z83 + z88;
    const double z90 = 0.15 + 0.5 * z89;
    const double z91 = z12 * z64;
    const double z92 = z47 * z2;
    const double z93 = z * z92;
    const double z94 = 0.25 * (z16 * z63);
    const double z95 = z49 * z2;
    const double z96 = c_z * z95;
    const double z97 = z94 + (z94 - (0.05 * z32 + (0.5 * z41 - (0.25 * z96 + (0.1 * z9 - 0.15 * z39)))));
    const double z98 = y_dot * z90 + (0.3 * z89 - (0.5 * z91 - (0.5 * z43 - (0.5 * z93 + z97))));
    const double z99 = 2.0 * (x * (0.1 * z15 - z82)) - (z25 * z83 + z15 * (0.05 + z70) + z * z98);
    const double z100 = z53 * (z99 - 0.5 * (z20 * z79));
    const double z101 = 0.1 * z32 + (0.3 * y_dot + (z41 - (z93 + (0.5 * z96 + (0.2 * z9 - z43 - 0.3 *
        z39)))));
    const double z102 = 0.1 * (c_t * z73) + z5 * (x_dot * z77 - (0.3 * (z7 * z64) + (z11 * z67 + (z91 -
        z101))));
    const double z103 = 0.4 * s_t + z28 * z74 - c_z * z102;
    const double z104 = 0.05 * (c_t * z85) + z5 * (x_dot * z89 - 0.5 * (z11 * z81));
    const double z105 = z53 * (2.0 - 0.5 * (z28 * z86) + c_z * z104 + 0.5 * (z20 * z103));
    const double z106 = c_t * z6;
    const double z107 = y_dot * z74 + (0.06 * z35 - 0.5 * (z6 * z95)) - 0.3 * (z2 * (z65 - z68)) + y_2 * z102;
    const double z108 = x_dot * z69 + (2.0 * z70 + z6 * (3.0 - z92)) + x * z78 - s_z * (0.06 * (x_dot * z106)
        + z107);
    const double z109 = 2.0 * (z * (0.2 * z37 - z2 * z64)) + (c_z * (0.3 * z71 - z25 * z75) + z108);
    const double z110 = c_t * z15;
    const double z111 = 0.5 * (y_dot * z86) - (0.25 * (z15 * z95) - z25 * z84) - 0.15 * (z2 * z81) + y_2 *
        z104;
    const double z112 = s_z * (0.03 * (x_dot * z110) + z111) - (1.5 * z15 - 0.5 * (z15 * z92) + x_dot * z83 +
        x * z98);
    const double z113 = c_z * (0.15 * (z15 * z70) - z25 * z87 + (0.2 * z31 - z2 * z63)) - z112 - 0.5 * (z20 *
        z109);
    const double z114 = z53 * z113;
    const double z115 = x * z2;
    const double z116 = 0.3 * (z44 * z34);
    const double z117 = z12 * z29 + (z * z69 + (2.0 * (z115 * z26) - (z116 - (z36 + (0.1 * (t * z6) +
        z116)))));
    const double z118 = 2.0 * (z48 * z38) - (0.06 * (c_z * z106) + (z6 * z77 + (0.1 + z117)));
    const double z119 = 0.15 * (z57 * z34);
    const double z120 = 0.4 * c_t;
    const double z121 = 0.5 * (z16 * z29) + (z * z83 - (z119 - (0.05 * (t * z15) - (z120 - z119)) - z115 *
        z80));
    const double z122 = z53 * (z55 * z38 - (0.03 * (c_z * z110) + (z6 * z89 + z121)) - 0.5 * (z20 * z118));
    const double z123 = y_dot * z8 - (c_z * z74 + (z120 + 0.3 * z6 + 0.5 * (z12 * z27)) + 0.5 * (z15 * z77));
    const double z124 = 0.5 * (z56 * z84) - (z15 * z90 + (0.2 + (0.5 * (c_z * z86) + (z60 + 0.25 * (z16 *
        z27)))));
    const double z125 = z53 * (z124 - 0.5 * (z20 * z123));
    /* (I.4.9) */
    J[3] = 1.0;
    J[9] = 1.0;
    J[10] = z * z22;
    J[11] = c_z * z23;
    J[12] = x * z22 - y_2 * s_z * z23;
    J[13] = z6;
    J[14] = 0.5 * z15;
    J[15] = z19 * z79 - 0.5 * (z20 * z100);
    J[16] = z19 * z103 + 0.5 * (z20 * z105);
    J[17] = 0.5 * (z20 * z114) - z19 * z109;
    J[18] = z19 * z118 - 0.5 * (z20 * z122);
    J[19] = z19 * z123 - 0.5 * (z20 * z125);
    J[20] = z100;
    J[21] = -z105;
    J[22] = -z114;
    J[23] = z122;
    J[24] = z125;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[10] + J[12] + J[14] + J[15] + J[16] + J[17] + J[18] + J[19] + J[21] + J[22]) <= DBL_MAX
        && fabs(z21) > 1e-13 * z17)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return affine_voronec_refuse(fabs(z13), 0.0, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z21) > 1e-13 * z17)) {
            return affine_voronec_refuse(fabs(z21), 1e-13 * z17, AFFINE_VORONEC_SINGULAR_2);
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
static __attribute__((noinline)) void affine_voronec_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
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
    bad |= affine_voronec_misses(affine_voronec_size(AFFINE_VORONEC_SPREAD(-z20)), 1e-13 * z19);
    const affine_voronec_lanes z21 = y_dot * z14;
    const affine_voronec_lanes c_t = cosine1;
    const affine_voronec_lanes z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t);
    const affine_voronec_lanes z23 = 0.06 * (c_z * c_t);
    const affine_voronec_lanes z24 = s_z * z22;
    const affine_voronec_lanes z25 = 0.3 * z24;
    const affine_voronec_lanes z26 = z * x_dot;
    const affine_voronec_lanes z27 = x * z22;
    const affine_voronec_lanes z28 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24)) + (0.4 - 0.8
        * (s_t * s_t) + (0.3 + 0.5 * y_dot) * (z26 + z27));
    const affine_voronec_lanes z29 = 0.3 * (z7 * z28) - (0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 *
        s_t))));
    const affine_voronec_lanes z30 = z22 * (0.1 * t_ - z23 + z2 * (z25 - (2.0 * z26 - z27))) - (x_dot * (0.1
        + 0.2 * (z1 * c_t)) + z29);
    const affine_voronec_lanes z31 = c_z * y_dot * y_dot;
    const affine_voronec_lanes z32 = z * x_dot * x_dot;
    const affine_voronec_lanes z33 = x_dot * z24;
    const affine_voronec_lanes z34 = x + t_ * x_dot;
    const affine_voronec_lanes z35 = 3.0 * z - (z4 - 0.05 * z22);
    const affine_voronec_lanes z36 = x_dot * (z23 + z2 * (2.0 * z27 - z25)) + (z11 * z28 + 0.2 * (z10 * c_t *
        z22));
    const affine_voronec_lanes z37 = z2 * (0.5 * z31 + (z32 - 0.3 * z33)) - (0.1 * z34 - (0.2 * z9 - (0.3 *
        y_dot + z35) - z36));
    const affine_voronec_lanes z38 = z30 + z6 * z37;
    const affine_voronec_lanes z39 = z2 * (0.25 * z31 + (0.5 * z32 - 0.15 * z33)) - (0.05 * z34 - (0.1 * z9 -
        0.5 * z35 - 0.5 * z36));
    const affine_voronec_lanes z40 = 0.15 * z21 - (0.6 * z22 - (2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17
        * z38)));
    const affine_voronec_lanes z41 = (z14 * z39 - (y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22)) + z40)) /
        z20;
    /* (I.1.2) */
    const affine_voronec_lanes slope1 = x_dot;
    affine_voronec_put(dydt, slope1);
    const affine_voronec_lanes slope2 = y_dot;
    affine_voronec_put(dydt + 1 * stride, slope2);
    const affine_voronec_lanes slope3 = z22;
    affine_voronec_put(dydt + 2 * stride, slope3);
    /* (I.4.9) 11:4 */
    const affine_voronec_lanes slope4 = z16 * z38 + 0.5 * (z17 * z41);
    sum += slope4;
    affine_voronec_put(dydt + 3 * stride, slope4);
    const affine_voronec_lanes slope5 = -z41;
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

int affine_voronec_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
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
