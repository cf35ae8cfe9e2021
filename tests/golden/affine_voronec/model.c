/*
 * affine_voronec.c: affine_voronec, emitted by nhc 0.1.0 (nhc:932a98e865ebc752)
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
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double c_z = cos(z);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = (1.0 + 0.1 * s_t) * (c_z * (y_2 * x_dot)) + (0.4 * (c_t * s_t) + x * z * (0.3 + 0.5 *
        y_dot));
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = z1; /* z' */
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
    const double z29 = z26 + z27;
    const double z30 = 0.3 * z29;
    const double z31 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24));
    const double z32 = y_dot * z29;
    const double z33 = 0.4 - 0.8 * (s_t * s_t);
    const double z34 = z30 + (z31 + 0.5 * z32) + z33;
    const double z35 = 0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t))) - 0.3 * (z7 * z34);
    const double z36 = z22 * (0.1 * t - z23 + z2 * (z25 - (2.0 * z26 - z27))) - (x_dot * (0.1 + 0.2 * (z1 *
        c_t)) + (z * z6 * (3.0 - z28) - z35));
    const double z37 = c_z * y_dot * y_dot;
    const double z38 = x_dot * z24;
    const double z39 = x + t * x_dot;
    const double z40 = z4 - 0.05 * z22;
    const double z41 = x_dot * (z23 + z2 * (2.0 * z27 - z25)) + (0.2 * (z10 * c_t * z22) + z11 * z34);
    const double z42 = z2 * (0.5 * z37 - 0.3 * z38) - (0.1 * z39 - (z40 - (0.3 * y_dot - 0.2 * z9) - z41));
    const double z43 = z36 + z6 * z42;
    const double z44 = z2 * (0.25 * z37 - 0.15 * z38) - (0.05 * z39 - (0.1 * z9 + 0.5 * z40 - 0.5 * z41));
    const double z45 = 0.15 * z21 - (0.6 * z22 - (2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17 * z43)));
    const double z46 = y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22)) + (z * z14 * (1.5 - 0.5 * z28) + z45);
    const double z47 = (z14 * z44 - z46) / z20;
    const double z48 = z16 * z43 + 0.5 * (z17 * z47);
    /* (I.4.9) */
    qddot[0] = z48; /* x'' */
    qddot[1] = -z47; /* y'' */
    qddot[2] = z33 + (z30 + (z31 + z6 * z48 + 0.5 * (z32 - z14 * z47))); /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[2]) <= DBL_MAX && fabs(-z20) > 1e-14 * z19)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(-z20) > 1e-14 * z19)) {
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
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double c_z = cos(z);
    const double x = q[0];
    const double y = q[1];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];

    /* state */
    const double z1 = (1.0 + 0.1 * s_t) * (c_z * (y * x_dot)) + (x * z * (0.3 + 0.5 * y_dot) - (z_dot - 0.4 *
        (c_t * s_t)));
    /* (I.1.1) 18:5 */
    r[0] = -z1; /* contact = 0 */
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
    const double z8 = 0.3 * z7;
    const double z9 = x * x;
    const double z10 = 1.0 + z9;
    const double z11 = z10 * z2;
    const double z12 = z8 + z6 * z11;
    const double z13 = z1 * z2 + z6 * (z8 + z12);
    const double z14 = 2.0 + s_z;
    const double z15 = x * z;
    const double z16 = z15 * z11;
    const double z17 = z14 * z2 + 0.25 * (z15 * z16);
    const double z18 = z15 * z12;
    const double z19 = 1.0 / z13;
    const double z20 = z18 * z19;
    const double z21 = z17 - 0.25 * (z18 * z20);
    const double z22 = c_z * y_dot * y_dot;
    const double z23 = 0.5 * z22;
    const double z24 = x_dot * x_dot;
    const double z25 = y_dot * z15;
    const double z26 = 0.3 * z15 + (x_dot * z6 + 0.5 * z25) + 0.4 * (c_t * s_t);
    const double z27 = s_z * z26;
    const double z28 = x_dot * z27;
    const double z29 = 0.3 * z28;
    const double z30 = x + t * x_dot;
    const double z31 = z4 - 0.05 * z26;
    const double z32 = 0.06 * (c_z * c_t);
    const double z33 = x * z26;
    const double z34 = 0.3 * z27;
    const double z35 = z * x_dot;
    const double z36 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z27)) + (0.4 - 0.8 * (s_t * s_t)
        + (z35 + z33) * (0.3 + 0.5 * y_dot));
    const double z37 = x_dot * (z32 + z2 * (2.0 * z33 - z34)) + (z11 * z36 + 0.2 * (z10 * c_t * z26));
    const double z38 = z2 * (0.25 * z22 - 0.15 * z28) - (0.05 * z30 - (0.1 * z9 + 0.5 * z31 - 0.5 * z37));
    const double z39 = z24 * z2;
    const double z40 = 0.3 * (z7 * z36) - (0.4 * z15 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t))));
    const double z41 = z26 * (0.1 * t - z32 + z2 * (z34 - (2.0 * z35 - z33))) - (x_dot * (0.1 + 0.2 * (z1 *
        c_t)) + (z * z6 * (3.0 - z39) + z40));
    const double z42 = 0.1 * z30;
    const double z43 = 0.3 * y_dot;
    const double z44 = 0.2 * z9;
    const double z45 = z41 + z6 * (z2 * (z23 - z29) - (z42 - (z31 - (z43 - z44) - z37)));
    const double z46 = 0.15 * z25 - (0.6 * z26 - (2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z20 * z45)));
    const double z47 = y_dot * (0.2 * (z14 * c_t) + (0.2 + z7 * z26)) + (z * z15 * (1.5 - 0.5 * z39) + z46);
    const double z48 = 0.5 * ((z16 - z12 * z20) * ((z15 * z38 - z47) / z21)) + (z37 + (z42 - (z31 + (z44 -
        (3.0 * z + z43 + z45 * (z12 * z19))))));
    /* (I.4.1) 18:5 */
    lambda[0] = z48 - z2 * (z23 + (z * z24 - z29)); /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(z21) > 1e-14 * z17)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z21) > 1e-14 * z17)) {
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
    const double s_t = sin(t);
    const double c_t = cos(t);
    const double s_z = sin(z);
    const double c_z = cos(z);
    const double x = y[0];
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = z * z;
    const double z2 = x * x;
    const double z3 = y_2 * x_dot;
    const double z4 = (1.0 + 0.1 * s_t) * (c_z * z3) + (0.4 * (c_t * s_t) + x * z * (0.3 + 0.5 * y_dot));
    const double z5 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot) + (1.0 + z2) * (z4 * z4);
    const double z6 = (1.0 + 0.2 * s_t) * (0.5 * z5 + 0.3 * (x_dot * c_z * z4)) + (0.4 * (z3 * c_t) - 0.3 *
        (z * y_dot) + 0.1 * (t * x * z4));
    return 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2))) + (0.2 * (z * z2) + z6);
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
    const double z8 = 0.3 * z7;
    const double z9 = x * x;
    const double z10 = 1.0 + z9;
    const double z11 = z10 * z2;
    const double z12 = z8 + z6 * z11;
    const double z13 = z1 * z2 + z6 * (z8 + z12);
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
    const double z27 = x * z25;
    const double z28 = z * x_dot + z27;
    const double z29 = s_z * z25;
    const double z30 = 0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z29);
    const double z31 = z28 * z22 - (0.8 * (s_t * s_t) - (0.4 + x_dot * z30));
    const double z32 = x + t * x_dot;
    const double z33 = 0.1 * z32;
    const double z34 = z4 - 0.05 * z25;
    const double z35 = 0.3 * y_dot;
    const double z36 = 0.2 * z9;
    const double z37 = 0.06 * (c_z * c_t);
    const double z38 = x_dot * z2;
    const double z39 = 0.2 * (z10 * c_t) + 2.0 * (x * z38);
    const double z40 = x_dot * (z37 - 0.3 * (z2 * z29)) + (z11 * z31 + z25 * z39);
    const double z41 = x_dot * x_dot;
    const double z42 = z * z6;
    const double z43 = y_dot * y_dot;
    const double z44 = c_z * z6;
    const double z45 = z25 * z25;
    const double z46 = s_z * z6;
    const double z47 = x_dot * z46;
    const double z48 = y_dot * c_t;
    const double z49 = z2 * z25;
    const double z50 = c_t * z25;
    const double z51 = 3.0 * z42 + (0.06 * (c_z * z50) - (0.4 * (y_2 * s_t) - (x - 0.1 * (t * z25))));
    const double z52 = 0.2 * (z1 * c_t) + 2.0 * (z * z49);
    const double z53 = 0.4 * z48 - (0.3 * (z49 * z29) - (0.3 * (z7 * z31) - (0.4 * z15 - z51))) + x_dot *
        (0.1 + z52);
    const double z54 = z2 * (z41 * z42 + (0.5 * (z43 * z44) + (x * z45 - 0.3 * (z47 * z25)))) - z53;
    const double z55 = z6 * (z33 - (z34 - (z35 - z36) - z40)) - z54;
    const double z56 = 1.0 / z21;
    const double z57 = 0.05 * z32;
    const double z58 = 0.1 * z9;
    const double z59 = 0.5 * z34;
    const double z60 = 0.5 * z40;
    const double z61 = z * z15;
    const double z62 = c_z * z15;
    const double z63 = s_z * z15;
    const double z64 = x_dot * z63;
    const double z65 = 0.2 * (z14 * c_t) + c_z * z49;
    const double z66 = x_dot * c_t;
    const double z67 = 0.15 * z24 - (0.4 * z66 + (0.6 * z25 - (1.5 * z61 + (2.0 * y_2 - 0.5 * (z20 * z55)))));
    const double z68 = z2 * (0.5 * (z41 * z61) + (0.25 * (z43 * z62) - 0.15 * (z64 * z25))) - (y_dot * (0.2 +
        z65) + z67);
    const double z69 = z56 * (z15 * (z57 - (z58 + z59 - z60)) - z68);
    const double z70 = z19 * z55 - 0.5 * (z20 * z69);
    const double z71 = z6 * z70;
    const double z72 = z15 * z69;
    const double z73 = 0.5 * z72;
    const double z74 = z71 + z73;
    const double z75 = z12 * z22;
    const double z76 = z2 * z26;
    const double z77 = x_dot * z12;
    const double z78 = z5 * z77;
    const double z79 = z2 * z6;
    const double z80 = y_2 * z78 + 0.3 * (z49 + x_dot * z79);
    const double z81 = 0.1 * t;
    const double z82 = z37 - (s_z * z80 - (2.0 * (z * z38) - (z81 - x * z75))) + z6 * (0.05 + z39);
    const double z83 = z2 * (0.3 * z47 - (2.0 * z27 + 0.3 * z29)) + z82;
    const double z84 = 0.4 + 0.5 * (z12 * z69) - z22 * z83;
    const double z85 = z25 * z75 - (z2 * z45 - (0.1 * z6 + (2.0 * (x_dot * z76) + (1.0 - z * z84))));
    const double z86 = x * (0.4 * (c_t * z26) - z6 * (0.4 - 2.0 * (z2 * (z31 - z74)))) + z85;
    const double z87 = z15 * z25;
    const double z88 = z15 * z70;
    const double z89 = z16 * (0.15 + 0.25 * y_dot);
    const double z90 = z2 * z87;
    const double z91 = y_dot * z2;
    const double z92 = z2 * z15;
    const double z93 = x_dot * z16;
    const double z94 = z5 * z93;
    const double z95 = 0.15 * (x_dot * z92) + 0.5 * (y_2 * z94);
    const double z96 = 0.15 * (z2 * z64) + (c_z * z91 - (s_z * z95 + (0.6 - x * z89))) + z15 * (0.025 + 0.5 *
        z39);
    const double z97 = 0.15 + 0.5 * z96;
    const double z98 = z12 * z70;
    const double z99 = z41 * z2;
    const double z100 = 1.5 - 0.5 * z99;
    const double z101 = z43 * z2;
    const double z102 = c_z * z101;
    const double z103 = x_dot * z49;
    const double z104 = s_z * z103;
    const double z105 = z57 - (z59 - (z * z100 - (0.25 * z102 + (z58 - 0.15 * z104))) - z60) - 0.25 * (z16 *
        z69);
    const double z106 = y_dot * z97 + (0.3 * z96 - (0.5 * z98 - (z105 - 0.25 * (z11 * z72))));
    const double z107 = x * (z15 * (0.2 - z2 * (z31 - z73)) - (0.2 * (c_t * z87) - z79 * z88)) - (z25 * z89 +
        (0.05 * z15 - (0.5 * (z20 * z86) - (x_dot * z90 + z * z106))));
    const double z108 = z56 * z107;
    const double z109 = 3.0 - z99;
    const double z110 = z98 - (z33 + (z35 - (z34 - (z * z109 - (0.5 * z102 + (z36 - 0.3 * z104))) - z40)));
    const double z111 = 0.1 * (c_t * z77) + z5 * (x_dot * z83 - (z110 + z11 * z74 + 0.3 * (z7 * z70)));
    const double z112 = 0.4 * s_t + z29 * z78 - c_z * z111;
    const double z113 = 0.05 * (c_t * z93) + z5 * (x_dot * z96 - 0.5 * (z11 * z88));
    const double z114 = z56 * (2.0 - 0.5 * (z29 * z94) + c_z * z113 + 0.5 * (z20 * z112));
    const double z115 = c_t * z6;
    const double z116 = y_dot * z78 + (0.06 * z50 - 0.5 * (z6 * z101)) - 0.3 * (z2 * (z74 - (z31 - z71)));
    const double z117 = z6 * z109 + 2.0 * (z25 * z38) + x_dot * z75 - x * z84 - s_z * (0.06 * (x_dot * z115)
        + (z116 + y_2 * z111));
    const double z118 = c_z * (0.3 * (z6 * z103) - z25 * z80) + z117 + 2.0 * (z * (0.2 * z66 - z2 * z70));
    const double z119 = c_t * z15;
    const double z120 = 0.5 * (y_dot * z94) - (0.25 * (z15 * z101) - z25 * z91) - 0.15 * (z2 * z88) + y_2 *
        z113;
    const double z121 = z15 * z100 + x_dot * z89 + x * z106 - s_z * (0.03 * (x_dot * z119) + z120) + c_z *
        (0.15 * (z15 * z103) - z25 * z95 + (0.2 * z48 - z2 * z69));
    const double z122 = z56 * (z121 - 0.5 * (z20 * z118));
    const double z123 = 0.06 * (c_z * z115) + (z * z75 + (0.1 + 2.0 * (x * z76)) - 2.0 * (z42 * z38));
    const double z124 = z6 * (z81 + z83) + (z52 + (0.3 * (z46 * z49) - (0.3 * (z29 * z79) - (z12 * z30 +
        z123))));
    const double z125 = 0.4 * c_t;
    const double z126 = 0.05 * (t * z15) - (z125 - 0.15 * (z63 * z49)) - 0.15 * (z29 * z92) + x * z90;
    const double z127 = z61 * z38 - (0.03 * (c_z * z119) + (0.5 * (z16 * z30) + (z126 + z * z89) + z6 * z96));
    const double z128 = z56 * (z127 + 0.5 * (z20 * z124));
    const double z129 = z44 * z91 - (c_z * z78 + (z125 + 0.3 * z6 + 0.5 * (z12 * z28)) + 0.5 * (z15 * z83));
    const double z130 = 0.5 * (z62 * z91) - (0.2 + (0.5 * (c_z * z94) + (0.25 * (z16 * z28) + z65)) + z15 *
        z97);
    const double z131 = z56 * (z130 - 0.5 * (z20 * z129));
    /* (I.4.9) */
    J[3] = 1.0;
    J[9] = 1.0;
    J[10] = z * z22;
    J[11] = c_z * z23;
    J[12] = x * z22 - y_2 * s_z * z23;
    J[13] = z6;
    J[14] = 0.5 * z15;
    J[15] = -(z19 * z86 + 0.5 * (z20 * z108));
    J[16] = z19 * z112 + 0.5 * (z20 * z114);
    J[17] = 0.5 * (z20 * z122) - z19 * z118;
    J[18] = -(z19 * z124 + 0.5 * (z20 * z128));
    J[19] = z19 * z129 - 0.5 * (z20 * z131);
    J[20] = z108;
    J[21] = -z114;
    J[22] = -z122;
    J[23] = z128;
    J[24] = z131;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[10] + J[12] + J[14] + J[15] + J[16] + J[17] + J[18] + J[19] + J[21] + J[22]) <= DBL_MAX
        && fabs(z21) > 1e-14 * z17)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return AFFINE_VORONEC_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z21) > 1e-14 * z17)) {
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
