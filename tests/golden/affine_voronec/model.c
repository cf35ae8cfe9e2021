/*
 * affine_voronec.c: affine_voronec, emitted by nhc 0.1.0 (nhc:a87fdbd634deda0f)
 * A particle with everything at once; affine constraint, time, T of degrees 2, 1 and 0, drag, a driving
 *     force.
 * Equations of motion: voronec (I.4.9)
 * Why: dependent velocities of the spec; Caplygin's equations do not apply: T contains the dependent
 *     coordinate `z`
 * affine_voronec.h says what each function does.
 */
#include "affine_voronec.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const affine_voronec_coordinate_names[AFFINE_VORONEC_NQ] = {
    "x",
    "y",
    "z"
};
const char *const affine_voronec_state_names[AFFINE_VORONEC_NY] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const affine_voronec_parameter_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const affine_voronec_constraint_names[AFFINE_VORONEC_NC] = {
    "contact"
};
const char *const affine_voronec_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double affine_voronec_parameter_defaults[1] = {
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
    const double s_z = sin(z);
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double c_t = cos(t);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = 2.0 + s_z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = x * z;
    const double z4 = x * x;
    const double z5 = 1.0 + z4;
    const double z6 = z5 * z2;
    const double z7 = z3 * z6;
    const double z8 = z1 * z2 + 0.25 * (z3 * z7);
    const double z9 = y_2 * c_z;
    const double z10 = 0.1 * s_t;
    const double z11 = 1.0 + z10;
    const double z12 = z9 * z11;
    const double z13 = c_z * z2;
    const double z14 = 1.0 + z * z;
    const double z15 = z14 * z2;
    const double z16 = 0.15 * (z3 * z13) + 0.5 * (z12 * z7);
    const double z17 = 1.0 / z8;
    const double z18 = z16 * z17;
    const double z19 = z12 * (0.6 * z13 + z12 * z6) + (z15 - z16 * z18);
    const double z20 = 0.3 + 0.5 * y_dot;
    const double z21 = z3 * z20 + (x_dot * z12 + 0.4 * (c_t * s_t));
    const double z22 = 0.1 * t;
    const double z23 = 0.06 * (c_z * c_t);
    const double z24 = z * x_dot;
    const double z25 = x * z21;
    const double z26 = s_z * z21;
    const double z27 = z2 * z21;
    const double z28 = x_dot * (z2 * (z24 - (2.0 * z25 - 0.3 * z26)) - (z22 + (z23 + 0.3 * (s_z * z27))));
    const double z29 = y_dot * c_z;
    const double z30 = x_dot * (0.1 * (c_t * z9) + z11 * (z29 - y_2 * z26)) + (0.4 - 0.8 * (s_t * s_t) + z20
        * (z24 + z25));
    const double z31 = z21 * (0.05 + 0.2 * (z5 * c_t)) - (0.2 * z4 + (z10 - (0.1 * x + 3.0 * z + z6 * z30)));
    const double z32 = z28 - (y_dot * (0.3 - 0.5 * (z2 * z29)) + z31);
    const double z33 = 0.6 * z21 - (2.0 * y_2 - 0.4 * (x_dot * c_t)) + 0.5 * (z3 * z32) - y_dot * (0.2 * (z1
        * c_t) + (0.2 + c_z * z27));
    const double z34 = 0.3 * (z27 * z26) - (z18 * z33 + (0.4 * (y_dot * c_t - y_2 * s_t) + 0.3 * (z13 *
        z30)));
    const double z35 = x * (1.0 - 0.4 * z) + (x_dot * (0.1 + 0.2 * (z14 * c_t)) - (z12 * z32 + z34));
    const double z36 = (z21 * (z22 - z23 - z2 * (2.0 * z24 - z25)) - z35) / z19;
    /* (I.1.2) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z21; /* z' */
    /* (I.4.9) 11:4 */
    dydt[3] = z36; /* x'' */
    dydt[4] = z17 * z33 - z18 * z36; /* y'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[4]) <= DBL_MAX
        && fabs(z8) > 1e-13 * z8
        && fabs(z19) > 1e-13 * (z15 + z6 * (z12 * z12)))) {
        /* the mass matrix is singular, if z8 is nearly 0 */
        if (!(fabs(z8) > 1e-13 * z8)) {
            return affine_voronec_refuse(fabs(z8), 1e-13 * z8, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular, if z19 is nearly 0 */
        if (!(fabs(z19) > 1e-13 * (z15 + z6 * (z12 * z12)))) {
            return affine_voronec_refuse(fabs(z19), 1e-13 * (z15 + z6 * (z12 * z12)),
                AFFINE_VORONEC_SINGULAR_2);
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
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

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
    const double s_z = sin(z);
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double c_t = cos(t);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = 2.0 + s_z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = x * z;
    const double z4 = x * x;
    const double z5 = 1.0 + z4;
    const double z6 = z5 * z2;
    const double z7 = z3 * z6;
    const double z8 = z1 * z2 + 0.25 * (z3 * z7);
    const double z9 = 1.0 + z * z;
    const double z10 = y_2 * c_z;
    const double z11 = 0.1 * s_t;
    const double z12 = 1.0 + z11;
    const double z13 = z10 * z12;
    const double z14 = z9 * z2 + z6 * (z13 * z13);
    const double z15 = c_z * z2;
    const double z16 = 0.15 * (z3 * z15) + 0.5 * (z13 * z7);
    const double z17 = 1.0 / z8;
    const double z18 = z16 * z17;
    const double z19 = z14 + (0.6 * (z13 * z15) - z16 * z18);
    const double z20 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3)) + 0.4 * (c_t * s_t);
    const double z21 = s_z * z20;
    const double z22 = x_dot * z2;
    const double z23 = z21 * z22;
    const double z24 = x_dot * c_t;
    const double z25 = z * x_dot + x * z20;
    const double z26 = y_dot * z25;
    const double z27 = 0.4 * (c_t * c_t - s_t * s_t) + (x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2
        * z21)) + 0.3 * z25);
    const double z28 = 0.5 * z26 + z27;
    const double z29 = 0.06 * (c_z * z24) + z20 * (0.2 * (z5 * c_t) + 2.0 * (x * z22)) + z6 * z28;
    const double z30 = 0.3 * z23 - z29;
    const double z31 = z * z2;
    const double z32 = 0.3 * (z2 * z20 * z21) + (0.1 * (t * z20) - x_dot * (0.2 * (z9 * c_t) + 2.0 * (z31 *
        z20)));
    const double z33 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - (0.1 * x_dot + (x + (0.4 * (y_dot *
        c_t - y_2 * s_t) - z32)));
    const double z34 = 3.0 * z - (z11 - 0.05 * z20) - (0.2 * z4 + 0.5 * (y_dot * y_dot * z15) + x_dot * x_dot
        * z31);
    const double z35 = z34 + (0.1 * (x + t * x_dot) + 0.3 * (y_dot + z23));
    const double z36 = z13 * z30 - (c_z * (0.06 * (c_t * z20) + 0.3 * (z2 * z28)) - (z33 - z13 * z35));
    const double z37 = 0.3 * z20;
    const double z38 = z37 + (z37 - (0.2 * y_dot + (2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20))));
    const double z39 = 0.5 * (z3 * z30) + (0.4 * z24 + z38 - 0.5 * (z3 * z35));
    const double z40 = (z36 - z18 * z39) / z19;
    const double z41 = z18 * z40 - z17 * z39;
    /* (I.4.9) */
    qddot[0] = z40; /* x'' */
    qddot[1] = -z41; /* y'' */
    qddot[2] = z27 + (z13 * z40 + 0.5 * (z26 - z3 * z41)); /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[2]) <= DBL_MAX && fabs(z8) > 1e-13 * z8 && fabs(z19) > 1e-13 * z14)) {
        /* the mass matrix is singular, if z8 is nearly 0 */
        if (!(fabs(z8) > 1e-13 * z8)) {
            return affine_voronec_refuse(fabs(z8), 1e-13 * z8, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular, if z19 is nearly 0 */
        if (!(fabs(z19) > 1e-13 * z14)) {
            return affine_voronec_refuse(fabs(z19), 1e-13 * z14, AFFINE_VORONEC_SINGULAR_2);
        }
        return affine_voronec_finish(3, qddot);
    }
    return AFFINE_VORONEC_OK;
}

int affine_voronec_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0];
    y[0] = x;
    const double y_2 = q[1]; /* y */
    y[1] = y_2;
    const double z = q[2];
    y[2] = z;
    const double x_dot = qdot[0]; /* x' */
    y[3] = x_dot;
    const double y_dot = qdot[1]; /* y' */
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
    const double x_dot = qdot[0]; /* x' */
    const double y_dot = qdot[1]; /* y' */
    const double z_dot = qdot[2]; /* z' */

    /* from the coordinates and velocities */
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
    const double s_z = sin(z);
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double c_t = cos(t);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = 2.0 + s_z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = x * z;
    const double z4 = x * x;
    const double z5 = 1.0 + z4;
    const double z6 = z5 * z2;
    const double z7 = z3 * z6;
    const double z8 = z1 * z2 + 0.25 * (z3 * z7);
    const double z9 = 1.0 + z * z;
    const double z10 = y_2 * c_z;
    const double z11 = 0.1 * s_t;
    const double z12 = 1.0 + z11;
    const double z13 = z10 * z12;
    const double z14 = z9 * z2 + z6 * (z13 * z13);
    const double z15 = c_z * z2;
    const double z16 = 0.15 * (z3 * z15) + 0.5 * (z13 * z7);
    const double z17 = 1.0 / z8;
    const double z18 = z16 * z17;
    const double z19 = z14 + (0.6 * (z13 * z15) - z16 * z18);
    const double z20 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3)) + 0.4 * (c_t * s_t);
    const double z21 = z * z2;
    const double z22 = 3.0 * z - (z11 - 0.05 * z20) - (0.2 * z4 + 0.5 * (y_dot * y_dot * z15) + x_dot * x_dot
        * z21);
    const double z23 = s_z * z20;
    const double z24 = x_dot * z2;
    const double z25 = z23 * z24;
    const double z26 = z22 + (0.1 * (x + t * x_dot) + 0.3 * (y_dot + z25));
    const double z27 = z * x_dot + x * z20;
    const double z28 = x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z23)) + 0.5 * (y_dot * z27);
    const double z29 = z28 + (0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z27);
    const double z30 = x_dot * c_t;
    const double z31 = z6 * z29 + (0.06 * (c_z * z30) + z20 * (0.2 * (z5 * c_t) + 2.0 * (x * z24)));
    const double z32 = 0.3 * z25 - z31;
    const double z33 = 0.3 * (z2 * z20 * z23) + (0.1 * (t * z20) - x_dot * (0.2 * (z9 * c_t) + 2.0 * (z21 *
        z20)));
    const double z34 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - (0.1 * x_dot + (x + (0.4 * (y_dot *
        c_t - y_2 * s_t) - z33)));
    const double z35 = z13 * z32 - (c_z * (0.06 * (c_t * z20) + 0.3 * (z2 * z29)) - (z34 - z13 * z26));
    const double z36 = 0.3 * z20;
    const double z37 = z36 + (z36 - (0.2 * y_dot + (2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20))));
    const double z38 = 0.4 * z30 + z37 - 0.5 * (z3 * z26) + 0.5 * (z3 * z32);
    const double z39 = (z35 - z18 * z38) / z19;
    const double z40 = 0.3 * (z15 * z39) + z6 * (z13 * z39 - 0.5 * (z3 * (z18 * z39 - z17 * z38)));
    /* (I.4.1) 18:5 */
    lambda[0] = z26 - (z32 - z40); /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(z8) > 1e-13 * z8 && fabs(z19) > 1e-13 * z14)) {
        /* the mass matrix is singular, if z8 is nearly 0 */
        if (!(fabs(z8) > 1e-13 * z8)) {
            return affine_voronec_refuse(fabs(z8), 1e-13 * z8, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular, if z19 is nearly 0 */
        if (!(fabs(z19) > 1e-13 * z14)) {
            return affine_voronec_refuse(fabs(z19), 1e-13 * z14, AFFINE_VORONEC_SINGULAR_2);
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
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

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
    const double s_z = sin(z);
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double c_t = cos(t);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = 2.0 + s_z;
    const double z2 = 1.0 + 0.2 * s_t;
    const double z3 = x * z;
    const double z4 = x * x;
    const double z5 = 1.0 + z4;
    const double z6 = z5 * z2;
    const double z7 = z3 * z6;
    const double z8 = z1 * z2 + 0.25 * (z3 * z7);
    const double z9 = 1.0 + z * z;
    const double z10 = y_2 * c_z;
    const double z11 = 0.1 * s_t;
    const double z12 = 1.0 + z11;
    const double z13 = z10 * z12;
    const double z14 = z13 * z6;
    const double z15 = z9 * z2 + z13 * z14;
    const double z16 = c_z * z2;
    const double z17 = 0.15 * (z3 * z16) + 0.5 * (z13 * z7);
    const double z18 = 1.0 / z8;
    const double z19 = z17 * z18;
    const double z20 = z15 + (0.6 * (z13 * z16) - z17 * z19);
    const double z21 = 0.3 + 0.5 * y_dot;
    const double z22 = x_dot * z12;
    const double z23 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3)) + 0.4 * (c_t * s_t);
    const double z24 = 1.0 / z20;
    const double z25 = c_z * z24;
    const double z26 = z19 * z24;
    const double z27 = 0.5 * (z3 * z26) - z13 * z24;
    const double z28 = 0.3 * (z2 * z25) - z6 * z27;
    const double z29 = 0.3 * z28 + 0.5 * (y_dot * z28);
    const double z30 = z2 * z23;
    const double z31 = x_dot * z30;
    const double z32 = z31 * z27;
    const double z33 = 0.2 * z + 0.5 * (z2 * (z23 * z23));
    const double z34 = x_dot * z24;
    const double z35 = z2 * z34;
    const double z36 = y_dot * z26;
    const double z37 = z2 * z36;
    const double z38 = x * z2;
    const double z39 = 0.2 * (z5 * c_t) + 2.0 * (x_dot * z38);
    const double z40 = x * z24;
    const double z41 = z39 * z27 - (0.6 * z26 - (0.1 * (t * z24) + (0.05 * z27 + 2.0 * (z30 * z40))));
    const double z42 = x_dot * z28;
    const double z43 = z12 * z42;
    const double z44 = x_dot * z2;
    const double z45 = y_2 * z43 - 0.3 * (z44 * z27 - z30 * z24);
    const double z46 = s_z * z27;
    const double z47 = s_z * z23;
    const double z48 = 2.0 * (z * z35) - (c_z * z37 - (0.06 * (c_t * z25) - z41)) - s_z * z45 - 0.3 * (z2 *
        (x_dot * z46 + z47 * z24));
    const double z49 = x * z29 + z48;
    const double z50 = z47 * z44;
    const double z51 = 0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z47);
    const double z52 = z * x_dot + x * z23;
    const double z53 = x_dot * z51 + 0.5 * (y_dot * z52) + (0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z52);
    const double z54 = x_dot * c_t;
    const double z55 = 0.3 * z50 - (z6 * z53 + (0.06 * (c_z * z54) + z23 * z39));
    const double z56 = z2 * y_dot * y_dot;
    const double z57 = z2 * x_dot * x_dot;
    const double z58 = 0.2 * z4 + 0.5 * (c_z * z56) + z * z57 - (3.0 * z - (z11 - 0.05 * z23));
    const double z59 = z58 - (0.1 * (x + t * x_dot) + 0.3 * (y_dot + z50));
    const double z60 = z55 + z59;
    const double z61 = 0.3 * z23;
    const double z62 = 0.2 * (z1 * c_t) + z16 * z23;
    const double z63 = 0.4 * z54 + (z61 + (z61 - (0.2 * y_dot + (2.0 * y_2 + y_dot * z62)))) + 0.5 * (z3 *
        z59);
    const double z64 = 0.5 * (z3 * z55) + z63;
    const double z65 = 0.06 * (c_t * z23) + 0.3 * (z2 * z53);
    const double z66 = z * z2;
    const double z67 = 0.2 * (z9 * c_t) + 2.0 * (z66 * z23);
    const double z68 = 0.4 * (y_dot * c_t - y_2 * s_t) - (0.3 * (z30 * z47) + (0.1 * (t * z23) - x_dot *
        z67));
    const double z69 = z13 * z55 - (c_z * z65 - (2.0 * (x * z33) - (0.1 * x_dot + (x + z68)) + z13 * z59));
    const double z70 = z69 - z19 * z64;
    const double z71 = z70 * (z24 * z24);
    const double z72 = z24 * z64 - z17 * z71;
    const double z73 = z18 * z18;
    const double z74 = z72 * (z17 * z73);
    const double z75 = z19 * z71;
    const double z76 = z75 - z18 * z72;
    const double z77 = 0.5 * (z13 * z76) + 0.25 * (z3 * z74);
    const double z78 = 0.3 * z49 + (0.5 * (z26 * z60) - 0.25 * (z7 * z74) - z6 * z77 - 0.15 * (z16 * z76));
    const double z79 = 0.5 * (y_dot * z49) + z78;
    const double z80 = z23 * z29 - (2.0 * z32 + (0.1 * z27 - (z24 - 2.0 * (z33 * z24)))) + z * z79;
    const double z81 = z23 * z27;
    const double z82 = z13 * z71;
    const double z83 = 0.2 * z27 - (0.2 * (c_t * z81) + z2 * (z53 * z27 + z3 * z77 - z13 * z82));
    const double z84 = z14 * z71;
    const double z85 = z84 - (z24 * z55 + 0.5 * (z7 * z76) - z84 + z24 * z59) + 0.6 * (z16 * z71);
    const double z86 = 0.1 * (c_t * z42) + z12 * (x_dot * z49 + z85);
    const double z87 = x_dot * z29 - (3.0 * z27 - (z57 * z27 - 0.4 * z40) - 2.0 * (z23 * z35)) + x * z79;
    const double z88 = c_t * z27;
    const double z89 = y_dot * z43 + (0.5 * (z56 * z27) + z65 * z24 - z23 * z37) + z2 * (0.6 * z82 - 0.15 *
        (z3 * z76));
    const double z90 = z87 + s_z * (0.06 * (x_dot * z88) - (z89 + y_2 * z86)) - c_z * (0.3 * z32 + z23 * z45
        + (0.2 * (c_t * z36) + z2 * z74));
    const double z91 = x_dot * z66;
    const double z92 = 0.3 * (z30 * z46);
    const double z93 = 0.4 * (c_t * z26);
    const double z94 = z * z29 - (2.0 * (z38 * z81) - (z92 - (0.1 * (t * z27) - (z93 - z92) - z67 * z24)));
    const double z95 = 2.0 * (z27 * z91) - (0.06 * (c_z * z88) - (z13 * z49 + (0.1 * z24 + (z51 * z28 +
        z94))));
    const double z96 = y_dot * z16;
    const double z97 = c_z * z43 - (0.3 * z27 - 0.4 * (c_t * z24) + z62 * z26 - 0.5 * (z52 * z28));
    const double z98 = c_z * z26;
    const double z99 = z18 + z19 * z26;
    const double z100 = 0.5 * (z3 * z99) - z13 * z26;
    const double z101 = 0.3 * (z2 * z98) - z6 * z100;
    const double z102 = 0.3 * z101 + 0.5 * (y_dot * z101);
    const double z103 = z31 * z100;
    const double z104 = x_dot * z26;
    const double z105 = z2 * z104;
    const double z106 = y_dot * z99;
    const double z107 = z2 * z106;
    const double z108 = x * z26;
    const double z109 = z39 * z100 - (0.6 * z99 - (0.1 * (t * z26) + (0.05 * z100 + 2.0 * (z30 * z108))));
    const double z110 = x_dot * z101;
    const double z111 = z12 * z110;
    const double z112 = y_2 * z111 - 0.3 * (z44 * z100 - z30 * z26);
    const double z113 = s_z * z100;
    const double z114 = 2.0 * (z * z105) - (c_z * z107 - (0.06 * (c_t * z98) - z109)) - s_z * z112 - 0.3 *
        (z2 * (x_dot * z113 + z47 * z26));
    const double z115 = x * z102 + z114;
    const double z116 = z24 * z70 - z64 * z26 + z17 * z75;
    const double z117 = z73 * (z64 - z17 * z116);
    const double z118 = z19 * z75 + z18 * z116;
    const double z119 = 0.5 * (z13 * z118) + 0.25 * (z3 * z117);
    const double z120 = 0.3 * z115 + (0.5 * (z99 * z60) - 0.25 * (z7 * z117) - z6 * z119 - 0.15 * (z16 *
        z118));
    const double z121 = 0.5 * (y_dot * z115) + z120;
    const double z122 = z23 * z102 - (2.0 * z103 + (0.1 * z100 - (z26 - 2.0 * (z33 * z26)))) + z * z121;
    const double z123 = z23 * z100;
    const double z124 = z13 * z75;
    const double z125 = 0.2 * z100 - (0.2 * (c_t * z123) + z2 * (z53 * z100 + z3 * z119 - z13 * z124));
    const double z126 = z14 * z75;
    const double z127 = z126 - (z59 * z26 + (z55 * z26 + 0.5 * (z7 * z118) - z126)) + 0.6 * (z16 * z75);
    const double z128 = 0.1 * (c_t * z110) + z12 * (x_dot * z115 + z127);
    const double z129 = x_dot * z102 - (3.0 * z100 - (z57 * z100 - 0.4 * z108) - 2.0 * (z23 * z105)) + x *
        z121;
    const double z130 = c_t * z100;
    const double z131 = y_dot * z111 + (0.5 * (z56 * z100) + z65 * z26 - z23 * z107) + z2 * (0.6 * z124 -
        0.15 * (z3 * z118));
    const double z132 = z129 + s_z * (0.06 * (x_dot * z130) - (z131 + y_2 * z128)) - c_z * (0.3 * z103 + z23
        * z112 + (0.2 * (c_t * z106) + z2 * z117));
    const double z133 = 0.3 * (z30 * z113);
    const double z134 = 2.0 * (z38 * z123) - (z133 - (0.1 * (t * z100) - (0.4 * (c_t * z99) - z133) - z67 *
        z26));
    const double z135 = 0.06 * (c_z * z130) - (z13 * z115 + (0.1 * z26 + (z51 * z101 + (z * z102 - z134))));
    const double z136 = 0.2 * z99 - (c_z * z111 + (z93 - 0.3 * z100 - z62 * z99 + 0.5 * (z52 * z101)));
    /* (I.4.9) */
    J[3] = 1.0;
    J[9] = 1.0;
    J[10] = z * z21;
    J[11] = c_z * z22;
    J[12] = x * z21 - y_2 * s_z * z22;
    J[13] = z13;
    J[14] = 0.5 * z3;
    J[15] = -(z80 + 2.0 * (x * z83));
    J[16] = 2.0 * z26 + 0.4 * (s_t * z24) + z47 * z43 - c_z * z86;
    J[17] = -(z90 + 2.0 * (z * (0.2 * (c_t * z34) + z2 * z71)));
    J[18] = -z95;
    J[19] = 0.2 * z26 - z97 - 0.5 * (z3 * z49) - z27 * z96;
    J[20] = z122 + 2.0 * (x * z125);
    J[21] = c_z * z128 - (2.0 * z99 + 0.4 * (s_t * z26) + z47 * z111);
    J[22] = z132 + 2.0 * (z * (0.2 * (c_t * z104) + z2 * z75));
    J[23] = 2.0 * (z91 * z100) - z135;
    J[24] = z96 * z100 - (z136 - 0.5 * (z3 * z115));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[10] + J[12] + J[14] + J[15] + J[16] + J[17] + J[18] + J[19] + J[20] + J[21] + J[22] + J[23]
        + J[24]) <= DBL_MAX
        && fabs(z8) > 1e-13 * z8
        && fabs(z20) > 1e-13 * z15)) {
        /* the mass matrix is singular, if z8 is nearly 0 */
        if (!(fabs(z8) > 1e-13 * z8)) {
            return affine_voronec_refuse(fabs(z8), 1e-13 * z8, AFFINE_VORONEC_SINGULAR_2);
        }
        /* the mass matrix is singular, if z20 is nearly 0 */
        if (!(fabs(z20) > 1e-13 * z15)) {
            return affine_voronec_refuse(fabs(z20), 1e-13 * z15, AFFINE_VORONEC_SINGULAR_2);
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
    affine_voronec_lanes sine1, cosine1;
    affine_voronec_turn_lanes(AFFINE_VORONEC_SPREAD(z), &far, &sine1, &cosine1);
    const affine_voronec_lanes s_z = sine1;
    const affine_voronec_lanes z1 = 2.0 + s_z;
    affine_voronec_lanes sine2, cosine2;
    affine_voronec_turn_lanes(AFFINE_VORONEC_SPREAD(t_), &far, &sine2, &cosine2);
    const affine_voronec_lanes s_t = sine2;
    const affine_voronec_lanes z2 = 1.0 + 0.2 * s_t;
    const affine_voronec_lanes z3 = x * z;
    const affine_voronec_lanes z4 = x * x;
    const affine_voronec_lanes z5 = 1.0 + z4;
    const affine_voronec_lanes z6 = z5 * z2;
    const affine_voronec_lanes z7 = z3 * z6;
    const affine_voronec_lanes z8 = z1 * z2 + 0.25 * (z3 * z7);
    /* the mass matrix is singular, if z8 is nearly 0 */
    bad |= affine_voronec_misses(affine_voronec_size(AFFINE_VORONEC_SPREAD(z8)), 1e-13 * z8);
    const affine_voronec_lanes c_z = cosine1;
    const affine_voronec_lanes z9 = y_2 * c_z;
    const affine_voronec_lanes z10 = 0.1 * s_t;
    const affine_voronec_lanes z11 = 1.0 + z10;
    const affine_voronec_lanes z12 = z9 * z11;
    const affine_voronec_lanes z13 = c_z * z2;
    const affine_voronec_lanes z14 = 1.0 + z * z;
    const affine_voronec_lanes z15 = z14 * z2;
    const affine_voronec_lanes z16 = 0.15 * (z3 * z13) + 0.5 * (z12 * z7);
    const affine_voronec_lanes z17 = 1.0 / z8;
    const affine_voronec_lanes z18 = z16 * z17;
    const affine_voronec_lanes z19 = z12 * (0.6 * z13 + z12 * z6) + (z15 - z16 * z18);
    /* the mass matrix is singular, if z19 is nearly 0 */
    bad |= affine_voronec_misses(affine_voronec_size(AFFINE_VORONEC_SPREAD(z19)), 1e-13 * (z15 + z6 * (z12 *
        z12)));
    const affine_voronec_lanes z20 = 0.3 + 0.5 * y_dot;
    const affine_voronec_lanes c_t = cosine2;
    const affine_voronec_lanes z21 = z3 * z20 + (x_dot * z12 + 0.4 * (c_t * s_t));
    const affine_voronec_lanes z22 = 0.1 * t_;
    const affine_voronec_lanes z23 = 0.06 * (c_z * c_t);
    const affine_voronec_lanes z24 = z * x_dot;
    const affine_voronec_lanes z25 = x * z21;
    const affine_voronec_lanes z26 = s_z * z21;
    const affine_voronec_lanes z27 = z2 * z21;
    const affine_voronec_lanes z28 = x_dot * (z2 * (z24 - (2.0 * z25 - 0.3 * z26)) - (z22 + (z23 + 0.3 * (s_z
        * z27))));
    const affine_voronec_lanes z29 = y_dot * c_z;
    const affine_voronec_lanes z30 = x_dot * (0.1 * (c_t * z9) + z11 * (z29 - y_2 * z26)) + (0.4 - 0.8 * (s_t
        * s_t) + z20 * (z24 + z25));
    const affine_voronec_lanes z31 = z21 * (0.05 + 0.2 * (z5 * c_t)) - (0.2 * z4 + (z10 - (0.1 * x + 3.0 * z
        + z6 * z30)));
    const affine_voronec_lanes z32 = z28 - (y_dot * (0.3 - 0.5 * (z2 * z29)) + z31);
    const affine_voronec_lanes z33 = 0.6 * z21 - (2.0 * y_2 - 0.4 * (x_dot * c_t)) + 0.5 * (z3 * z32) - y_dot
        * (0.2 * (z1 * c_t) + (0.2 + c_z * z27));
    const affine_voronec_lanes z34 = 0.3 * (z27 * z26) - (z18 * z33 + (0.4 * (y_dot * c_t - y_2 * s_t) + 0.3
        * (z13 * z30)));
    const affine_voronec_lanes z35 = x * (1.0 - 0.4 * z) + (x_dot * (0.1 + 0.2 * (z14 * c_t)) - (z12 * z32 +
        z34));
    const affine_voronec_lanes z36 = (z21 * (z22 - z23 - z2 * (2.0 * z24 - z25)) - z35) / z19;
    /* (I.1.2) */
    const affine_voronec_lanes slope1 = x_dot;
    affine_voronec_put(dydt, slope1);
    const affine_voronec_lanes slope2 = y_dot;
    affine_voronec_put(dydt + 1 * stride, slope2);
    const affine_voronec_lanes slope3 = z21;
    affine_voronec_put(dydt + 2 * stride, slope3);
    /* (I.4.9) 11:4 */
    const affine_voronec_lanes slope4 = z36;
    affine_voronec_put(dydt + 3 * stride, slope4);
    const affine_voronec_lanes slope5 = z17 * z33 - z18 * z36;
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
