/*
 * affine_voronec.c: affine_voronec, emitted by nhc 0.1.0 (nhc:8e0b87496e4fd42f)
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
    const double z20 = z3 * (0.3 + 0.5 * y_dot) + (x_dot * z12 + 0.4 * (c_t * s_t));
    const double z21 = 0.1 * t;
    const double z22 = c_z * c_t;
    const double z23 = z * x_dot;
    const double z24 = x * z20;
    const double z25 = z2 * z20;
    const double z26 = y_dot * c_z;
    const double z27 = y_dot * (0.3 - 0.5 * (z2 * z26)) - (0.2 * z4 + (z10 - (0.05 * z20 + (0.1 * x + 3.0 *
        z))));
    const double z28 = x_dot * (0.3 * (s_z * z25) + (z21 - z2 * z23)) + z27;
    const double z29 = s_z * z20;
    const double z30 = x_dot * (0.01 * (c_t * z9) + 0.1 * (z11 * (z26 - y_2 * z29))) + (0.04 - 0.08 * (s_t *
        s_t) + (z23 + z24) * (0.03 + 0.05 * y_dot));
    const double z31 = x_dot * (0.6 * z22 + z2 * (20.0 * z24 - 3.0 * z29)) + (100.0 * (z6 * z30) + 2.0 * (z5
        * c_t * z20));
    const double z32 = 0.6 * z20 - (2.0 * y_2 - 0.4 * (x_dot * c_t)) - z3 * (0.5 * z28 + 0.05 * z31);
    const double z33 = y_dot * (0.2 * (z1 * c_t) + (0.2 + c_z * z25)) - z32;
    const double z34 = 0.3 * (z25 * z29) - (0.4 * (y_dot * c_t - y_2 * s_t) + 3.0 * (z13 * z30) - z18 * z33);
    const double z35 = x * (1.0 - 0.4 * z) + (x_dot * (0.1 + 0.2 * (z14 * c_t)) + (z12 * (z28 + 0.1 * z31) -
        z34));
    const double z36 = (z20 * (z21 - 0.06 * z22 - z2 * (2.0 * z23 - z24)) - z35) / z19;
    /* (I.1.2) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z20; /* z' */
    /* (I.4.9) 11:4 */
    dydt[3] = z36; /* x'' */
    dydt[4] = -(z18 * z36 + z17 * z33); /* y'' */
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
    const double z24 = z * x_dot + x * z20;
    const double z25 = 0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z24;
    const double z26 = x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z21));
    const double z27 = y_dot * z24;
    const double z28 = 0.1 * z25 + (0.1 * z26 + 0.05 * z27);
    const double z29 = x_dot * c_t;
    const double z30 = 100.0 * (z6 * z28) + 10.0 * (0.06 * (c_z * z29) + z20 * (0.2 * (z5 * c_t) + 2.0 * (x *
        z22)));
    const double z31 = 3.0 * z23 - z30;
    const double z32 = z * z2;
    const double z33 = 0.3 * (z20 * (z2 * z21)) + (0.1 * (t * z20) - x_dot * (0.2 * (z9 * c_t) + 2.0 * (z20 *
        z32)));
    const double z34 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - (0.1 * x_dot + (x + (0.4 * (y_dot *
        c_t - y_2 * s_t) - z33)));
    const double z35 = 3.0 * z - (z11 - 0.05 * z20) - (0.2 * z4 + 0.5 * (y_dot * y_dot * z15) + x_dot * x_dot
        * z32);
    const double z36 = z35 + (0.1 * (x + t * x_dot) + 0.3 * (y_dot + z23));
    const double z37 = 0.1 * (z13 * z31) - (c_z * (0.06 * (c_t * z20) + 3.0 * (z2 * z28)) - (z34 - z13 *
        z36));
    const double z38 = 0.3 * z20;
    const double z39 = z38 + (z38 - (0.2 * y_dot + (2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20))));
    const double z40 = 0.05 * (z3 * z31) + (0.4 * z29 + z39 - 0.5 * (z3 * z36));
    const double z41 = (z37 - z18 * z40) / z19;
    const double z42 = z18 * z41 - z17 * z40;
    /* (I.4.9) */
    qddot[0] = z41; /* x'' */
    qddot[1] = -z42; /* y'' */
    qddot[2] = z25 + (0.5 * (z27 - z3 * z42) + (z26 + z13 * z41)); /* z'' */
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
    const double z27 = z20 * (0.2 * (z5 * c_t) + 2.0 * (x * z24));
    const double z28 = x_dot * c_t;
    const double z29 = c_z * z28;
    const double z30 = z * x_dot + x * z20;
    const double z31 = 0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z30;
    const double z32 = x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z23));
    const double z33 = y_dot * z30;
    const double z34 = 0.1 * z31 + (0.1 * z32 + 0.05 * z33);
    const double z35 = 3.0 * z25 - (100.0 * (z6 * z34) + 10.0 * (0.06 * z29 + z27));
    const double z36 = 0.3 * (z20 * (z2 * z23)) + (0.1 * (t * z20) - x_dot * (0.2 * (z9 * c_t) + 2.0 * (z20 *
        z21)));
    const double z37 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - (0.1 * x_dot + (x + (0.4 * (y_dot *
        c_t - y_2 * s_t) - z36)));
    const double z38 = 0.1 * (z13 * z35) - (c_z * (0.06 * (c_t * z20) + 3.0 * (z2 * z34)) - (z37 - z13 *
        z26));
    const double z39 = 0.3 * z20;
    const double z40 = z39 + (z39 - (0.2 * y_dot + (2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20))));
    const double z41 = 0.05 * (z3 * z35) + (0.4 * z28 + z40 - 0.5 * (z3 * z26));
    const double z42 = (z38 - z18 * z41) / z19;
    const double z43 = 0.3 * (z15 * z42) + z6 * (z13 * z42 - 0.5 * (z3 * (z18 * z42 - z17 * z41)));
    const double z44 = z26 + (z27 + 0.3 * (0.2 * z29 - z25) + z6 * (z31 + (z32 + 0.5 * z33)) + z43);
    /* (I.4.1) 18:5 */
    lambda[0] = z44; /* reaction of contact: Q_i gains lambda_1 a_1i */
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
    const double z23 = 1.0 / z20;
    const double z24 = z19 * z23;
    const double z25 = z13 * z23 - 0.5 * (z3 * z24);
    const double z26 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3)) + 0.4 * (c_t * s_t);
    const double z27 = 0.2 * z + 0.5 * (z2 * (z26 * z26));
    const double z28 = z26 * z25;
    const double z29 = z2 * z28;
    const double z30 = c_z * z23;
    const double z31 = 3.0 * (z2 * z30) + 10.0 * (z6 * z25);
    const double z32 = 0.03 * z31 + 0.05 * (y_dot * z31);
    const double z33 = s_z * z26;
    const double z34 = x_dot * z2;
    const double z35 = z33 * z34;
    const double z36 = z * x_dot + x * z26;
    const double z37 = y_dot * c_z;
    const double z38 = 0.1 * (c_t * z10) + z12 * (z37 - y_2 * z33);
    const double z39 = 0.1 * (0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z36) + (0.1 * (x_dot * z38) + 0.05 *
        (y_dot * z36));
    const double z40 = x_dot * c_t;
    const double z41 = 0.2 * (z5 * c_t) + 2.0 * (x * z34);
    const double z42 = 3.0 * z35 - (100.0 * (z6 * z39) + 10.0 * (0.06 * (c_z * z40) + z26 * z41));
    const double z43 = z42 * z24;
    const double z44 = z2 * y_dot * y_dot;
    const double z45 = z2 * x_dot * x_dot;
    const double z46 = 0.2 * z4 + 0.5 * (c_z * z44) + z * z45 - (3.0 * z - (z11 - 0.05 * z26));
    const double z47 = z46 - (0.1 * (x + t * x_dot) + 0.3 * (y_dot + z35));
    const double z48 = z47 * z24;
    const double z49 = 0.3 * z26;
    const double z50 = z2 * z26;
    const double z51 = 0.2 * (z1 * c_t) + c_z * z50;
    const double z52 = 0.4 * z40 + (z49 + (z49 - (0.2 * y_dot + (2.0 * y_2 + y_dot * z51)))) + 0.5 * (z3 *
        z47);
    const double z53 = 0.05 * (z3 * z42) + z52;
    const double z54 = 0.06 * (c_t * z26) + 3.0 * (z2 * z39);
    const double z55 = 0.2 * (z9 * c_t) + 2.0 * (z * z50);
    const double z56 = 0.4 * (y_dot * c_t - y_2 * s_t) - (0.3 * (z50 * z33) + (0.1 * (t * z26) - x_dot *
        z55));
    const double z57 = 0.1 * (z13 * z42) - (c_z * z54 - (2.0 * (x * z27) - (0.1 * x_dot + (x + z56)) + z13 *
        z47));
    const double z58 = z57 - z19 * z53;
    const double z59 = z58 * (z23 * z23);
    const double z60 = z23 * z53 - z17 * z59;
    const double z61 = z18 * z18;
    const double z62 = z60 * (z17 * z61);
    const double z63 = z19 * z59;
    const double z64 = z63 - z18 * z60;
    const double z65 = 0.5 * (z13 * z64) + 0.25 * (z3 * z62);
    const double z66 = 0.05 * z43 + 0.5 * z48 - 0.25 * (z7 * z62) - z6 * z65 - 0.15 * (z16 * z64);
    const double z67 = s_z * z25;
    const double z68 = x_dot * z23;
    const double z69 = z2 * z68;
    const double z70 = y_dot * z24;
    const double z71 = z2 * z70;
    const double z72 = x * z23;
    const double z73 = 0.6 * z24 - (0.1 * (t * z23) - (0.05 * z25 - 2.0 * (z50 * z72))) + z41 * z25;
    const double z74 = x_dot * z31;
    const double z75 = z12 * z74;
    const double z76 = 0.1 * (y_2 * z75) + 0.3 * (z50 * z23 + z34 * z25);
    const double z77 = 0.3 * (z2 * (x_dot * z67 - z33 * z23)) + (2.0 * (z * z69) - (c_z * z71 - (0.06 * (c_t
        * z30) + z73)) - s_z * z76);
    const double z78 = x * z32 + z77;
    const double z79 = z66 + 0.3 * z78 + 0.5 * (y_dot * z78);
    const double z80 = 0.1 * z25 + (z23 - 2.0 * (z27 * z23)) + 2.0 * (x_dot * z29) + z26 * z32 + z * z79;
    const double z81 = z13 * z59;
    const double z82 = 0.2 * z25 - (0.2 * (c_t * z28) + z2 * (10.0 * (z39 * z25) - z3 * z65 + z13 * z81));
    const double z83 = z14 * z59;
    const double z84 = z83 - (0.1 * (z42 * z23) + 0.5 * (z7 * z64) - z83 + z23 * z47) + 0.6 * (z16 * z59);
    const double z85 = 0.01 * (c_t * z74) + z12 * (z84 + x_dot * z78);
    const double z86 = 3.0 * z25 - (z45 * z25 + 0.4 * z72) + 2.0 * (z26 * z69) + x_dot * z32 + x * z79;
    const double z87 = c_t * z25;
    const double z88 = 0.5 * (z44 * z25) - z54 * z23 + z26 * z71 - 0.1 * (y_dot * z75) - z2 * (0.6 * z81 -
        0.15 * (z3 * z64));
    const double z89 = x_dot * z50;
    const double z90 = z86 - s_z * (0.06 * (x_dot * z87) - (z88 - y_2 * z85)) + c_z * (0.3 * (z89 * z25) -
        z26 * z76 - (0.2 * (c_t * z70) + z2 * z62));
    const double z91 = z * z34;
    const double z92 = 0.3 * (z50 * z67);
    const double z93 = 0.4 * (c_t * z24);
    const double z94 = z * z32 - (z92 - (0.1 * (t * z25) + (z93 + z92) + z23 * z55) - 2.0 * (x * z29));
    const double z95 = 2.0 * (z91 * z25) - (0.06 * (c_z * z87) + (0.1 * z23 + (z94 + 0.1 * (z38 * z31)) + z13
        * z78));
    const double z96 = z2 * z37;
    const double z97 = 0.1 * (c_z * z75) + (0.3 * z25 + 0.4 * (c_t * z23) - z51 * z24 + 0.05 * (z36 * z31));
    const double z98 = z18 + z19 * z24;
    const double z99 = z13 * z24 - 0.5 * (z3 * z98);
    const double z100 = z26 * z99;
    const double z101 = z2 * z100;
    const double z102 = c_z * z24;
    const double z103 = 3.0 * (z2 * z102) + 10.0 * (z6 * z99);
    const double z104 = 0.03 * z103 + 0.05 * (y_dot * z103);
    const double z105 = z23 * z58 - z53 * z24 + z17 * z63;
    const double z106 = z61 * (z53 - z17 * z105);
    const double z107 = z19 * z63 + z18 * z105;
    const double z108 = 0.5 * (z13 * z107) + 0.25 * (z3 * z106);
    const double z109 = 0.05 * (z42 * z98) + 0.5 * (z47 * z98) - 0.25 * (z7 * z106) - z6 * z108 - 0.15 * (z16
        * z107);
    const double z110 = s_z * z99;
    const double z111 = x_dot * z24;
    const double z112 = z2 * z111;
    const double z113 = y_dot * z98;
    const double z114 = z2 * z113;
    const double z115 = x * z24;
    const double z116 = 0.6 * z98 - (0.1 * (t * z24) - (0.05 * z99 - 2.0 * (z50 * z115))) + z41 * z99;
    const double z117 = x_dot * z103;
    const double z118 = z12 * z117;
    const double z119 = 0.1 * (y_2 * z118) + 0.3 * (z50 * z24 + z34 * z99);
    const double z120 = 0.3 * (z2 * (x_dot * z110 - z33 * z24)) + (2.0 * (z * z112) - (c_z * z114 - (0.06 *
        (c_t * z102) + z116)) - s_z * z119);
    const double z121 = x * z104 + z120;
    const double z122 = z109 + 0.3 * z121 + 0.5 * (y_dot * z121);
    const double z123 = 0.1 * z99 + (z24 - 2.0 * (z27 * z24)) + 2.0 * (x_dot * z101) + z26 * z104 + z * z122;
    const double z124 = z13 * z63;
    const double z125 = 0.2 * z99 - (0.2 * (c_t * z100) + z2 * (10.0 * (z39 * z99) - z3 * z108 + z13 * z124));
    const double z126 = z14 * z63;
    const double z127 = z126 - (z48 + (0.1 * z43 + 0.5 * (z7 * z107) - z126)) + 0.6 * (z16 * z63) + x_dot *
        z121;
    const double z128 = 0.01 * (c_t * z117) + z12 * z127;
    const double z129 = 3.0 * z99 - (z45 * z99 + 0.4 * z115) + 2.0 * (z26 * z112) + x_dot * z104 + x * z122;
    const double z130 = c_t * z99;
    const double z131 = 0.5 * (z44 * z99) - z54 * z24 + z26 * z114 - 0.1 * (y_dot * z118) - z2 * (0.6 * z124
        - 0.15 * (z3 * z107));
    const double z132 = z129 - s_z * (0.06 * (x_dot * z130) - (z131 - y_2 * z128)) + c_z * (0.3 * (z89 * z99)
        - z26 * z119 - (0.2 * (c_t * z113) + z2 * z106));
    const double z133 = 0.3 * (z50 * z110);
    const double z134 = z133 - (0.1 * (t * z99) + (0.4 * (c_t * z98) + z133) + z55 * z24) - 2.0 * (x * z101);
    const double z135 = 0.06 * (c_z * z130) + (0.1 * z24 + (z * z104 - z134 + 0.1 * (z38 * z103)) + z13 *
        z121);
    const double z136 = 0.2 * z98 - (0.1 * (c_z * z118) + (z93 + 0.3 * z99 - z51 * z98 + 0.05 * (z36 *
        z103)));
    /* (I.4.9) */
    J[3] = 1.0;
    J[9] = 1.0;
    J[10] = z * z21;
    J[11] = c_z * z22;
    J[12] = x * z21 - y_2 * s_z * z22;
    J[13] = z13;
    J[14] = 0.5 * z3;
    J[15] = 2.0 * (x * z82) - z80;
    J[16] = 2.0 * z24 + 0.4 * (s_t * z23) + 0.1 * (z33 * z75) - c_z * z85;
    J[17] = -(z90 + 2.0 * (z * (0.2 * (c_t * z68) + z2 * z59)));
    J[18] = z95;
    J[19] = z96 * z25 + (0.2 * z24 - z97 - 0.5 * (z3 * z78));
    J[20] = z123 - 2.0 * (x * z125);
    J[21] = c_z * z128 - (2.0 * z98 + 0.4 * (s_t * z24) + 0.1 * (z33 * z118));
    J[22] = z132 + 2.0 * (z * (0.2 * (c_t * z111) + z2 * z63));
    J[23] = z135 - 2.0 * (z91 * z99);
    J[24] = -(z96 * z99 + (z136 - 0.5 * (z3 * z121)));
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
    const affine_voronec_lanes c_t = cosine2;
    const affine_voronec_lanes z20 = z3 * (0.3 + 0.5 * y_dot) + (x_dot * z12 + 0.4 * (c_t * s_t));
    const affine_voronec_lanes z21 = 0.1 * t_;
    const affine_voronec_lanes z22 = c_z * c_t;
    const affine_voronec_lanes z23 = z * x_dot;
    const affine_voronec_lanes z24 = x * z20;
    const affine_voronec_lanes z25 = z2 * z20;
    const affine_voronec_lanes z26 = y_dot * c_z;
    const affine_voronec_lanes z27 = y_dot * (0.3 - 0.5 * (z2 * z26)) - (0.2 * z4 + (z10 - (0.05 * z20 + (0.1
        * x + 3.0 * z))));
    const affine_voronec_lanes z28 = x_dot * (0.3 * (s_z * z25) + (z21 - z2 * z23)) + z27;
    const affine_voronec_lanes z29 = s_z * z20;
    const affine_voronec_lanes z30 = x_dot * (0.01 * (c_t * z9) + 0.1 * (z11 * (z26 - y_2 * z29))) + (0.04 -
        0.08 * (s_t * s_t) + (z23 + z24) * (0.03 + 0.05 * y_dot));
    const affine_voronec_lanes z31 = x_dot * (0.6 * z22 + z2 * (20.0 * z24 - 3.0 * z29)) + (100.0 * (z6 *
        z30) + 2.0 * (z5 * c_t * z20));
    const affine_voronec_lanes z32 = 0.6 * z20 - (2.0 * y_2 - 0.4 * (x_dot * c_t)) - z3 * (0.5 * z28 + 0.05 *
        z31);
    const affine_voronec_lanes z33 = y_dot * (0.2 * (z1 * c_t) + (0.2 + c_z * z25)) - z32;
    const affine_voronec_lanes z34 = 0.3 * (z25 * z29) - (0.4 * (y_dot * c_t - y_2 * s_t) + 3.0 * (z13 * z30)
        - z18 * z33);
    const affine_voronec_lanes z35 = x * (1.0 - 0.4 * z) + (x_dot * (0.1 + 0.2 * (z14 * c_t)) + (z12 * (z28 +
        0.1 * z31) - z34));
    const affine_voronec_lanes z36 = (z20 * (z21 - 0.06 * z22 - z2 * (2.0 * z23 - z24)) - z35) / z19;
    /* (I.1.2) */
    const affine_voronec_lanes slope1 = x_dot;
    affine_voronec_put(dydt, slope1);
    const affine_voronec_lanes slope2 = y_dot;
    affine_voronec_put(dydt + 1 * stride, slope2);
    const affine_voronec_lanes slope3 = z20;
    affine_voronec_put(dydt + 2 * stride, slope3);
    /* (I.4.9) 11:4 */
    const affine_voronec_lanes slope4 = z36;
    affine_voronec_put(dydt + 3 * stride, slope4);
    const affine_voronec_lanes slope5 = -(z18 * z36 + z17 * z33);
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
