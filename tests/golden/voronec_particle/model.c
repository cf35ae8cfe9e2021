/*
 * voronec_particle.c: voronec_particle, emitted by nhc 0.1.0 (nhc:579ea24530ac5923)
 * A particle whose T, U and constraint depend on the dependent coordinate, so that Caplygin's hypotheses
 *     fail.
 * Equations of motion: voronec (I.4.9)
 * Why: dependent velocities of the spec; Caplygin's equations do not apply: T contains the dependent
 *     coordinate `z`
 * voronec_particle.h says what each function does.
 */
#include "voronec_particle.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const voronec_particle_coordinate_names[VORONEC_PARTICLE_NQ] = {
    "x",
    "y",
    "z"
};
const char *const voronec_particle_state_names[VORONEC_PARTICLE_NY] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const voronec_particle_parameter_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const voronec_particle_constraint_names[VORONEC_PARTICLE_NC] = {
    "contact"
};
const char *const voronec_particle_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double voronec_particle_parameter_defaults[1] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define VORONEC_PARTICLE_SLOW __attribute__((cold, optimize("O1")))
#else
#define VORONEC_PARTICLE_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int voronec_particle_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return VORONEC_PARTICLE_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return VORONEC_PARTICLE_NOT_FINITE;
        }
    }
    return VORONEC_PARTICLE_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int voronec_particle_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : VORONEC_PARTICLE_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef VORONEC_PARTICLE_LANES
#if !defined(__GNUC__)
#define VORONEC_PARTICLE_LANES 1
#elif defined(__AVX512F__)
#define VORONEC_PARTICLE_LANES 8
#elif defined(__AVX__)
#define VORONEC_PARTICLE_LANES 4
#else
#define VORONEC_PARTICLE_LANES 2
#endif
#endif
#if VORONEC_PARTICLE_LANES > 1
typedef double voronec_particle_lanes __attribute__((vector_size(8 * VORONEC_PARTICLE_LANES)));
#else
typedef double voronec_particle_lanes;
#endif

#if VORONEC_PARTICLE_LANES >= 2
static inline voronec_particle_lanes voronec_particle_get(const double *from)
{
    voronec_particle_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void voronec_particle_put(double *to, voronec_particle_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int voronec_particle_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = VORONEC_PARTICLE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[VORONEC_PARTICLE_NY];
        double slope[VORONEC_PARTICLE_NY];
        for (size_t k = 0; k < VORONEC_PARTICLE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = voronec_particle_rhs(t[i], state, p, slope);
        status = status == VORONEC_PARTICLE_OK ? one : status;
        for (size_t k = 0; k < VORONEC_PARTICLE_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if VORONEC_PARTICLE_LANES >= 2
#define VORONEC_PARTICLE_SPREAD(x) ((x) - (voronec_particle_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long voronec_particle_bits __attribute__((vector_size(8 * VORONEC_PARTICLE_LANES)));

/* all bits where value is not above bound, or is no number */
static inline voronec_particle_bits voronec_particle_misses(voronec_particle_lanes value, voronec_particle_lanes bound)
{
    return ~(voronec_particle_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline voronec_particle_lanes voronec_particle_mark(voronec_particle_lanes value, voronec_particle_bits bad)
{
    return (voronec_particle_lanes)((voronec_particle_bits)value | bad);
}

static inline voronec_particle_lanes voronec_particle_size(voronec_particle_lanes x)
{
    return (voronec_particle_lanes)((voronec_particle_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int voronec_particle_is_good(int count, const double *check)
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
static inline void voronec_particle_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < VORONEC_PARTICLE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < VORONEC_PARTICLE_NY; ++k) {
            state[k * VORONEC_PARTICLE_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void voronec_particle_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < VORONEC_PARTICLE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * VORONEC_PARTICLE_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void voronec_particle_turn_lanes(voronec_particle_lanes x, voronec_particle_lanes *far,
    voronec_particle_lanes *sine, voronec_particle_lanes *cosine)
{
    double angle[VORONEC_PARTICLE_LANES];
    double up[VORONEC_PARTICLE_LANES];
    double along[VORONEC_PARTICLE_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < VORONEC_PARTICLE_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int voronec_particle_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double c_z = cos(z);
    const double s_z = sin(z);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 0.3 * c_z + z3 * z1;
    const double z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4;
    const double z6 = x * z;
    const double z7 = 2.0 + s_z + 0.25 * (z6 * (z3 * z6));
    const double z8 = z6 * z4;
    const double z9 = 1.0 / z5;
    const double z10 = z8 * z9;
    const double z11 = z7 - 0.25 * (z8 * z10);
    const double z12 = x_dot * z1 + 0.5 * (y_dot * z6);
    const double z13 = s_z * z12;
    const double z14 = 0.3 * z13;
    const double z15 = x * z12;
    const double z16 = x_dot * x_dot;
    const double z17 = y_dot * y_dot;
    const double z18 = y_dot * c_z;
    const double z19 = x_dot * (z18 - y_2 * z13) + 0.5 * (y_dot * (z * x_dot + z15));
    const double z20 = z3 * z19 - x_dot * (z14 - 2.0 * z15);
    const double z21 = z * z1 * (3.0 - z16) - (0.5 * (z17 * z2) - (z1 * z20 + (x + 0.3 * (c_z * z19))));
    const double z22 = z12 * (x_dot * (2.0 * z + 0.3 * (s_z * z1)) - (z14 + z15)) + z21;
    const double z23 = z * (1.5 - 0.5 * z16) + (0.5 * z20 - (0.25 * (z17 * c_z) - 0.15 * (x_dot * z13)));
    const double z24 = (0.5 * (z10 * z22) - (2.0 * y_2 + z12 * z18) - z6 * z23) / z11;
    /* (I.1.2) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z12; /* z' */
    /* (I.4.9) 7:4 */
    dydt[3] = -(z9 * z22 + 0.5 * (z10 * z24)); /* x'' */
    dydt[4] = z24; /* y'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[3]) <= DBL_MAX && fabs(z11) > 1e-13 * z7)) {
        /* the mass matrix is singular, if z5 is 0 */
        if (!(fabs(z5) > 0.0)) {
            return voronec_particle_refuse(fabs(z5), 0.0, VORONEC_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z11 is nearly 0 */
        if (!(fabs(z11) > 1e-13 * z7)) {
            return voronec_particle_refuse(fabs(z11), 1e-13 * z7, VORONEC_PARTICLE_SINGULAR_2);
        }
        return voronec_particle_finish(5, dydt);
    }
    return VORONEC_PARTICLE_OK;
}

int voronec_particle_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double c_z = cos(z);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    /* (I.1.2) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = x_dot * (y_2 * c_z) + 0.5 * (y_dot * (x * z)); /* z' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[2]) <= DBL_MAX)) {
        return voronec_particle_finish(3, qdot);
    }
    return VORONEC_PARTICLE_OK;
}

int voronec_particle_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double c_z = cos(z);
    const double s_z = sin(z);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 0.3 * c_z + z3 * z1;
    const double z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4;
    const double z6 = x * z;
    const double z7 = 2.0 + s_z + 0.25 * (z6 * (z3 * z6));
    const double z8 = z6 * z4;
    const double z9 = 1.0 / z5;
    const double z10 = z8 * z9;
    const double z11 = z7 - 0.25 * (z8 * z10);
    const double z12 = y_dot * c_z;
    const double z13 = x_dot * z1 + 0.5 * (y_dot * z6);
    const double z14 = s_z * z13;
    const double z15 = x_dot * (z12 - y_2 * z14);
    const double z16 = y_dot * (z * x_dot + x * z13);
    const double z17 = z15 + 0.5 * z16;
    const double z18 = x_dot * z13;
    const double z19 = z3 * z17 - (0.3 * (x_dot * z14) - 2.0 * (x * z18));
    const double z20 = z * z1;
    const double z21 = x_dot * x_dot;
    const double z22 = y_dot * y_dot;
    const double z23 = s_z * z18;
    const double z24 = 0.5 * (2.0 * (z21 * z20) + z22 * z2 + 2.0 * (x * (z13 * z13))) - 0.3 * (z1 * z23);
    const double z25 = 0.3 * (c_z * z17) - (0.3 * (z13 * z14) - 2.0 * (z * z18)) + z1 * z19 + (0.5 * (2.0 * x
        + 6.0 * z20) - z24);
    const double z26 = z * z6;
    const double z27 = 0.5 * (4.0 * y_2 + 3.0 * z26) - (0.5 * (z21 * z26 + 0.5 * (c_z * (z22 * z6))) - 0.15 *
        (z6 * z23));
    const double z28 = (z13 * z12 + 0.5 * (z6 * z19) + z27 - 0.5 * (z10 * z25)) / z11;
    const double z29 = z9 * z25 - 0.5 * (z10 * z28);
    /* (I.4.9) */
    qddot[0] = -z29; /* x'' */
    qddot[1] = -z28; /* y'' */
    qddot[2] = z15 - z1 * z29 + 0.5 * (z16 - z6 * z28); /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[2]) <= DBL_MAX && fabs(z11) > 1e-13 * z7)) {
        /* the mass matrix is singular, if z5 is 0 */
        if (!(fabs(z5) > 0.0)) {
            return voronec_particle_refuse(fabs(z5), 0.0, VORONEC_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z11 is nearly 0 */
        if (!(fabs(z11) > 1e-13 * z7)) {
            return voronec_particle_refuse(fabs(z11), 1e-13 * z7, VORONEC_PARTICLE_SINGULAR_2);
        }
        return voronec_particle_finish(3, qddot);
    }
    return VORONEC_PARTICLE_OK;
}

int voronec_particle_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
        return voronec_particle_finish(5, y);
    }
    return VORONEC_PARTICLE_OK;
}

int voronec_particle_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double z = q[2];

    /* sines and cosines */
    const double c_z = cos(z);

    /* what else is read */
    const double x = q[0];
    const double y = q[1];
    const double x_dot = qdot[0]; /* x' */
    const double y_dot = qdot[1]; /* y' */
    const double z_dot = qdot[2]; /* z' */

    /* from the coordinates and velocities */
    /* (I.1.1) 10:5 */
    r[0] = z_dot - (x_dot * (y * c_z) + 0.5 * (y_dot * (x * z))); /* contact = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return voronec_particle_finish(1, r);
    }
    return VORONEC_PARTICLE_OK;
}

int voronec_particle_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double c_z = cos(z);
    const double s_z = sin(z);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 0.3 * c_z + z3 * z1;
    const double z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4;
    const double z6 = x * z;
    const double z7 = z3 * z6;
    const double z8 = 2.0 + s_z + 0.25 * (z6 * z7);
    const double z9 = z6 * z4;
    const double z10 = 1.0 / z5;
    const double z11 = z9 * z10;
    const double z12 = z8 - 0.25 * (z9 * z11);
    const double z13 = y_dot * c_z;
    const double z14 = x_dot * z1 + 0.5 * (y_dot * z6);
    const double z15 = s_z * z14;
    const double z16 = x_dot * (z13 - y_2 * z15) + 0.5 * (y_dot * (z * x_dot + x * z14));
    const double z17 = x_dot * z14;
    const double z18 = 0.3 * (x_dot * z15);
    const double z19 = z3 * z16 - (z18 - 2.0 * (x * z17));
    const double z20 = z * z1;
    const double z21 = x_dot * x_dot;
    const double z22 = y_dot * y_dot;
    const double z23 = s_z * z17;
    const double z24 = 0.5 * (2.0 * (z21 * z20) + z22 * z2 + 2.0 * (x * (z14 * z14))) - 0.3 * (z1 * z23);
    const double z25 = 0.3 * (c_z * z16) - (0.3 * (z14 * z15) - 2.0 * (z * z17)) + z1 * z19 + (0.5 * (2.0 * x
        + 6.0 * z20) - z24);
    const double z26 = z * z6;
    const double z27 = z22 * c_z;
    const double z28 = 0.5 * (4.0 * y_2 + 3.0 * z26) + (0.15 * (z6 * z23) - 0.5 * (z21 * z26 + 0.5 * (z6 *
        z27)));
    const double z29 = (0.5 * (z11 * z25) - (z14 * z13 + 0.5 * (z6 * z19) + z28)) / z12;
    const double z30 = z4 * (z10 * z25 + 0.5 * (z11 * z29)) - 0.5 * (z7 * z29) - (z19 + (3.0 * z - (0.5 *
        (2.0 * (z * z21) + z27) - z18)));
    /* (I.4.1) 10:5 */
    lambda[0] = -z30; /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(z12) > 1e-13 * z8)) {
        /* the mass matrix is singular, if z5 is 0 */
        if (!(fabs(z5) > 0.0)) {
            return voronec_particle_refuse(fabs(z5), 0.0, VORONEC_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z12 is nearly 0 */
        if (!(fabs(z12) > 1e-13 * z8)) {
            return voronec_particle_refuse(fabs(z12), 1e-13 * z8, VORONEC_PARTICLE_SINGULAR_2);
        }
        return voronec_particle_finish(1, lambda);
    }
    return VORONEC_PARTICLE_OK;
}

double voronec_particle_energy(double t, const double *y, const double *p)
{
    (void)t;
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double s_z = sin(z);
    const double c_z = cos(z);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = z * z;
    const double z2 = x * x;
    const double z3 = x_dot * c_z;
    const double z4 = 0.5 * (y_dot * (x * z)) + y_2 * z3;
    const double z5 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot) + (1.0 + z2) * (z4 * z4);
    const double z6 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2))) + (0.5 * z5 + 0.3 * (z3 * z4));
    return z6;
}

VORONEC_PARTICLE_SLOW
int voronec_particle_jacobian(double t, const double *y, const double *p, double *J)
{
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    (void)t;
    (void)p;
    const double z = y[2];

    /* sines and cosines */
    const double c_z = cos(z);
    const double s_z = sin(z);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */

    /* from the state */
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 0.3 * c_z + z3 * z1;
    const double z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4;
    const double z6 = x * z;
    const double z7 = z3 * z6;
    const double z8 = 2.0 + s_z + 0.25 * (z6 * z7);
    const double z9 = z6 * z4;
    const double z10 = 1.0 / z5;
    const double z11 = z9 * z10;
    const double z12 = z8 - 0.25 * (z9 * z11);
    const double z13 = x_dot * s_z;
    const double z14 = y_dot * c_z;
    const double z15 = x_dot * z1;
    const double z16 = z15 + 0.5 * (y_dot * z6);
    const double z17 = s_z * z16;
    const double z18 = z14 - y_2 * z17;
    const double z19 = z * x_dot;
    const double z20 = x * z16;
    const double z21 = z19 + z20;
    const double z22 = x_dot * z18 + 0.5 * (y_dot * z21);
    const double z23 = z * z16;
    const double z24 = x_dot * z17;
    const double z25 = 0.3 * z24;
    const double z26 = x * x_dot;
    const double z27 = z25 - 2.0 * (z16 * z26) - z3 * z22;
    const double z28 = z * z1;
    const double z29 = x_dot * x_dot;
    const double z30 = y_dot * y_dot;
    const double z31 = z16 * z16;
    const double z32 = z1 * z13;
    const double z33 = 0.5 * (2.0 * (z29 * z28) + z30 * z2 + 2.0 * (x * z31)) - 0.3 * (z16 * z32);
    const double z34 = 0.3 * (z16 * z17) - 2.0 * (x_dot * z23) - 0.3 * (c_z * z22) + z1 * z27 - (0.5 * (2.0 *
        x + 6.0 * z28) - z33);
    const double z35 = 1.0 / z12;
    const double z36 = c_z * z16;
    const double z37 = z * z6;
    const double z38 = c_z * z6;
    const double z39 = z6 * z13;
    const double z40 = 0.5 * (4.0 * y_2 + 3.0 * z37) - (0.5 * (z29 * z37 + 0.5 * (z30 * z38)) - 0.15 * (z16 *
        z39));
    const double z41 = z35 * (y_dot * z36 - 0.5 * (z6 * z27) + z40 + 0.5 * (z11 * z34));
    const double z42 = z10 * z34 + 0.5 * (z11 * z41);
    const double z43 = z6 * z41;
    const double z44 = z1 * z42 - 0.5 * z43;
    const double z45 = y_dot * z4;
    const double z46 = x_dot * z16;
    const double z47 = z1 * z46;
    const double z48 = x_dot * z4;
    const double z49 = 0.3 * (z15 + z16) + y_2 * z48;
    const double z50 = 0.5 * (x * z45) + (2.0 * z19 - (0.3 * z17 - (2.0 * (z1 * z26) - (2.0 * z20 - 0.3 *
        z32))));
    const double z51 = s_z * z49 - z50;
    const double z52 = y_dot * z51 + z4 * z41;
    const double z53 = 2.0 * ((z22 + z44) * (x * z1)) + (0.5 * (z16 * z45) + (1.0 - (z31 - 2.0 * z47)) - 0.5
        * (z * z52));
    const double z54 = z6 * z42;
    const double z55 = z6 * z46;
    const double z56 = y_dot * z7;
    const double z57 = x_dot * z7;
    const double z58 = 0.15 * (x_dot * z6) + 0.5 * (y_2 * z57);
    const double z59 = z14 - (s_z * z58 - (0.25 * (x * z56) + (z6 * z26 + 0.15 * z39)));
    const double z60 = z4 * z42;
    const double z61 = 0.25 * (z7 * z41);
    const double z62 = 1.5 - 0.5 * z29;
    const double z63 = 0.5 * z60 - (0.25 * (z30 * c_z) + (z61 + (0.5 * z27 - (0.15 * z24 + z * z62) + z61)));
    const double z64 = 0.5 * (y_dot * z59) + z63;
    const double z65 = 2.0 * (x * (0.5 * (z6 * z22) - (0.25 * (z6 * z43) - 0.5 * (z1 * z54)))) + (z55 + 0.25
        * (z16 * z56) + z * z64);
    const double z66 = z35 * (z65 - 0.5 * (z11 * z53));
    const double z67 = 0.5 * z30 - 0.3 * z42;
    const double z68 = 3.0 - z29;
    const double z69 = x_dot * z51 + (c_z * z67 - (z3 * z44 - (z27 - (z25 + z * z68) - z60)));
    const double z70 = z17 * z48 + c_z * z69;
    const double z71 = x_dot * z59 + 0.5 * (z3 * z54);
    const double z72 = z35 * (2.0 - 0.5 * (z17 * z57) + c_z * z71 + 0.5 * (z11 * z70));
    const double z73 = x_dot * z45;
    const double z74 = 2.0 * z46 + z1 * z68 + 0.5 * z73 - 0.5 * (x * z52) - s_z * (0.3 * z44 + (z73 + (0.3 *
        z22 - z1 * z67) - y_2 * z69));
    const double z75 = 2.0 * (z * z42) + (c_z * (0.3 * z47 - z16 * z49) + z74);
    const double z76 = x_dot * z56;
    const double z77 = s_z * (0.15 * z54 + (y_dot * z16 - (0.25 * (z30 * z6) - 0.5 * z76) + y_2 * z71));
    const double z78 = c_z * (0.15 * z55 - z16 * z58 - z41) + (z6 * z62 + 0.25 * z76 + x * z64 - z77);
    const double z79 = z35 * (z78 - 0.5 * (z11 * z75));
    const double z80 = 2.0 * (x_dot * z28) + (z1 * z51 - (z18 * z4 + (0.5 * (z * z45) + 2.0 * (z23 + z1 *
        z20))));
    const double z81 = x_dot * z37 - (z1 * z59 + (0.5 * (z18 * z7) + (0.25 * (z * z56) + z6 * z20)));
    const double z82 = z35 * (z81 - 0.5 * (z11 * z80));
    const double z83 = y_dot * z2 - (0.5 * (z21 * z4) + c_z * z48 - 0.5 * (z6 * z51));
    const double z84 = 0.5 * (y_dot * z38) - (z36 + 0.25 * (z21 * z7) + 0.5 * (c_z * z57) + 0.5 * (z6 * z59));
    const double z85 = z35 * (z84 - 0.5 * (z11 * z83));
    /* (I.4.9) */
    J[3] = 1.0;
    J[9] = 1.0;
    J[10] = 0.5 * (z * y_dot);
    J[11] = x_dot * c_z;
    J[12] = 0.5 * (x * y_dot) - y_2 * z13;
    J[13] = z1;
    J[14] = 0.5 * z6;
    J[15] = 0.5 * (z11 * z66) - z10 * z53;
    J[16] = z10 * z70 + 0.5 * (z11 * z72);
    J[17] = 0.5 * (z11 * z79) - z10 * z75;
    J[18] = z10 * z80 - 0.5 * (z11 * z82);
    J[19] = z10 * z83 - 0.5 * (z11 * z85);
    J[20] = -z66;
    J[21] = -z72;
    J[22] = -z79;
    J[23] = z82;
    J[24] = z85;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[10] + J[12] + J[14] + J[15] + J[16] + J[17] + J[18] + J[19] + J[20] + J[21] + J[22]) <=
        DBL_MAX
        && fabs(z12) > 1e-13 * z8)) {
        /* the mass matrix is singular, if z5 is 0 */
        if (!(fabs(z5) > 0.0)) {
            return voronec_particle_refuse(fabs(z5), 0.0, VORONEC_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z12 is nearly 0 */
        if (!(fabs(z12) > 1e-13 * z8)) {
            return voronec_particle_refuse(fabs(z12), 1e-13 * z8, VORONEC_PARTICLE_SINGULAR_2);
        }
        return voronec_particle_finish(25, J);
    }
    return VORONEC_PARTICLE_OK;
}

int voronec_particle_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return VORONEC_PARTICLE_OK;
}

#if VORONEC_PARTICLE_LANES >= 2
static __attribute__((noinline)) void voronec_particle_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    (void)fixed;
    voronec_particle_lanes far = {0}; /* the squares of the angles */
    voronec_particle_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    voronec_particle_bits bad = {0}; /* singular blocks */
    const voronec_particle_lanes x = voronec_particle_get(y);
    const voronec_particle_lanes y_2 = voronec_particle_get(y + 1 * stride);
    const voronec_particle_lanes z = voronec_particle_get(y + 2 * stride);
    const voronec_particle_lanes x_dot = voronec_particle_get(y + 3 * stride);
    const voronec_particle_lanes y_dot = voronec_particle_get(y + 4 * stride);
    voronec_particle_lanes sine1, cosine1;
    voronec_particle_turn_lanes(VORONEC_PARTICLE_SPREAD(z), &far, &sine1, &cosine1);
    const voronec_particle_lanes c_z = cosine1;
    const voronec_particle_lanes z1 = y_2 * c_z;
    const voronec_particle_lanes z2 = c_z * z1;
    const voronec_particle_lanes z3 = 1.0 + x * x;
    const voronec_particle_lanes z4 = 0.3 * c_z + z3 * z1;
    const voronec_particle_lanes z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4;
    const voronec_particle_lanes s_z = sine1;
    const voronec_particle_lanes z6 = x * z;
    const voronec_particle_lanes z7 = 2.0 + s_z + 0.25 * (z6 * (z3 * z6));
    const voronec_particle_lanes z8 = z6 * z4;
    const voronec_particle_lanes z9 = 1.0 / z5;
    const voronec_particle_lanes z10 = z8 * z9;
    const voronec_particle_lanes z11 = z7 - 0.25 * (z8 * z10);
    /* the mass matrix is singular, if z11 is nearly 0 */
    bad |= voronec_particle_misses(voronec_particle_size(VORONEC_PARTICLE_SPREAD(z11)), 1e-13 * z7);
    const voronec_particle_lanes z12 = x_dot * z1 + 0.5 * (y_dot * z6);
    const voronec_particle_lanes z13 = s_z * z12;
    const voronec_particle_lanes z14 = 0.3 * z13;
    const voronec_particle_lanes z15 = x * z12;
    const voronec_particle_lanes z16 = x_dot * x_dot;
    const voronec_particle_lanes z17 = y_dot * y_dot;
    const voronec_particle_lanes z18 = y_dot * c_z;
    const voronec_particle_lanes z19 = x_dot * (z18 - y_2 * z13) + 0.5 * (y_dot * (z * x_dot + z15));
    const voronec_particle_lanes z20 = z3 * z19 - x_dot * (z14 - 2.0 * z15);
    const voronec_particle_lanes z21 = z * z1 * (3.0 - z16) - (0.5 * (z17 * z2) - (z1 * z20 + (x + 0.3 * (c_z
        * z19))));
    const voronec_particle_lanes z22 = z12 * (x_dot * (2.0 * z + 0.3 * (s_z * z1)) - (z14 + z15)) + z21;
    const voronec_particle_lanes z23 = z * (1.5 - 0.5 * z16) + (0.5 * z20 - (0.25 * (z17 * c_z) - 0.15 *
        (x_dot * z13)));
    const voronec_particle_lanes z24 = (0.5 * (z10 * z22) - (2.0 * y_2 + z12 * z18) - z6 * z23) / z11;
    /* (I.1.2) */
    const voronec_particle_lanes slope1 = x_dot;
    voronec_particle_put(dydt, slope1);
    const voronec_particle_lanes slope2 = y_dot;
    voronec_particle_put(dydt + 1 * stride, slope2);
    const voronec_particle_lanes slope3 = z12;
    voronec_particle_put(dydt + 2 * stride, slope3);
    /* (I.4.9) 7:4 */
    const voronec_particle_lanes slope4 = -(z9 * z22 + 0.5 * (z10 * z24));
    sum += slope4;
    voronec_particle_put(dydt + 3 * stride, slope4);
    const voronec_particle_lanes slope5 = z24;
    voronec_particle_put(dydt + 4 * stride, slope5);
    voronec_particle_put(check, voronec_particle_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void voronec_particle_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[VORONEC_PARTICLE_LANES];
    double state[5 * VORONEC_PARTICLE_LANES];
    double slope[5 * VORONEC_PARTICLE_LANES];
    voronec_particle_fill(left, count, t, y, time, state);
    voronec_particle_rhs_lanes(fixed, VORONEC_PARTICLE_LANES, time, state, slope, check);
    voronec_particle_pour(left, count, slope, dydt);
}
#endif

int voronec_particle_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if VORONEC_PARTICLE_LANES >= 2
    const double *fixed = p;
    double check[1 * VORONEC_PARTICLE_LANES];
    int status = VORONEC_PARTICLE_OK;
    for (size_t i = 0; i < count; i += VORONEC_PARTICLE_LANES) {
        const size_t left = count - i < VORONEC_PARTICLE_LANES ? count - i : VORONEC_PARTICLE_LANES;
        if (left == VORONEC_PARTICLE_LANES) {
            voronec_particle_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            voronec_particle_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!voronec_particle_is_good(1 * VORONEC_PARTICLE_LANES, check)) {
            const int one = voronec_particle_one_by_one(count, i, left, t, y, p, dydt);
            status = status == VORONEC_PARTICLE_OK ? one : status;
        }
    }
    return status;
#else
    return voronec_particle_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
