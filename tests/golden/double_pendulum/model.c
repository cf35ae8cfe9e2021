/*
 * double_pendulum.c: double_pendulum, emitted by nhc 0.1.0 (nhc:301505fb0dba274c)
 * Two pendulums in a row, absolute angles; the model gives positions and nhc differentiates them.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * double_pendulum.h says what each function does.
 */
#include "double_pendulum.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const double_pendulum_coordinate_names[DOUBLE_PENDULUM_NQ] = {
    "theta1",
    "theta2"
};
const char *const double_pendulum_state_names[DOUBLE_PENDULUM_NY] = {
    "theta1",
    "theta2",
    "theta1'",
    "theta2'"
};
const char *const double_pendulum_parameter_names[DOUBLE_PENDULUM_NP] = {
    "m1",
    "m2",
    "l1",
    "l2",
    "g"
};
const char *const double_pendulum_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const double_pendulum_output_names[DOUBLE_PENDULUM_NOUT] = {
    "tip_x",
    "tip_y"
};
const double double_pendulum_parameter_defaults[DOUBLE_PENDULUM_NP] = {
    1.0,
    1.0,
    1.0,
    1.0,
    9.81
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define DOUBLE_PENDULUM_SLOW __attribute__((cold, optimize("O1")))
#else
#define DOUBLE_PENDULUM_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int double_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return DOUBLE_PENDULUM_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return DOUBLE_PENDULUM_NOT_FINITE;
        }
    }
    return DOUBLE_PENDULUM_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int double_pendulum_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : DOUBLE_PENDULUM_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef DOUBLE_PENDULUM_LANES
#if !defined(__GNUC__)
#define DOUBLE_PENDULUM_LANES 1
#elif defined(__AVX512F__)
#define DOUBLE_PENDULUM_LANES 8
#elif defined(__AVX__)
#define DOUBLE_PENDULUM_LANES 4
#else
#define DOUBLE_PENDULUM_LANES 2
#endif
#endif
#if DOUBLE_PENDULUM_LANES > 1
typedef double double_pendulum_lanes __attribute__((vector_size(8 * DOUBLE_PENDULUM_LANES)));
#else
typedef double double_pendulum_lanes;
#endif

#if DOUBLE_PENDULUM_LANES >= 2
static inline double_pendulum_lanes double_pendulum_get(const double *from)
{
    double_pendulum_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void double_pendulum_put(double *to, double_pendulum_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int double_pendulum_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = DOUBLE_PENDULUM_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[DOUBLE_PENDULUM_NY];
        double slope[DOUBLE_PENDULUM_NY];
        for (size_t k = 0; k < DOUBLE_PENDULUM_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = double_pendulum_rhs(t[i], state, p, slope);
        status = status == DOUBLE_PENDULUM_OK ? one : status;
        for (size_t k = 0; k < DOUBLE_PENDULUM_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if DOUBLE_PENDULUM_LANES >= 2
#define DOUBLE_PENDULUM_SPREAD(x) ((x) - (double_pendulum_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long double_pendulum_bits __attribute__((vector_size(8 * DOUBLE_PENDULUM_LANES)));

/* all bits where value is not above bound, or is no number */
static inline double_pendulum_bits double_pendulum_misses(double_pendulum_lanes value, double_pendulum_lanes bound)
{
    return ~(double_pendulum_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline double_pendulum_lanes double_pendulum_mark(double_pendulum_lanes value, double_pendulum_bits bad)
{
    return (double_pendulum_lanes)((double_pendulum_bits)value | bad);
}

static inline double_pendulum_lanes double_pendulum_size(double_pendulum_lanes x)
{
    return (double_pendulum_lanes)((double_pendulum_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int double_pendulum_is_good(int count, const double *check)
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
static inline void double_pendulum_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < DOUBLE_PENDULUM_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < DOUBLE_PENDULUM_NY; ++k) {
            state[k * DOUBLE_PENDULUM_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void double_pendulum_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < DOUBLE_PENDULUM_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * DOUBLE_PENDULUM_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void double_pendulum_turn_lanes(double_pendulum_lanes x, double_pendulum_lanes *far,
    double_pendulum_lanes *sine, double_pendulum_lanes *cosine)
{
    double angle[DOUBLE_PENDULUM_LANES];
    double up[DOUBLE_PENDULUM_LANES];
    double along[DOUBLE_PENDULUM_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < DOUBLE_PENDULUM_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int double_pendulum_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);

    /* what else is read */
    const double theta1_dot = y[2]; /* theta1' [rad/s] */
    const double theta2_dot = y[3]; /* theta2' [rad/s] */
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = -1.0 / l1;
    const double k2 = 1.0 / l2;

    /* from the state */
    const double z2 = m2 * s1;
    const double z3 = m1 + s1 * z2;
    const double z4 = l1 * (theta1_dot * theta1_dot) + g * c_theta1;
    const double z5 = (l2 * (theta2_dot * theta2_dot) + z4 * c1) * (z2 / z3);
    /* (II.3) */
    dydt[0] = theta1_dot; /* theta1' */
    dydt[1] = theta2_dot; /* theta2' */
    /* (II.3) 20:4 */
    dydt[2] = k1 * (g * s_theta1 + z5); /* theta1'' */
    dydt[3] = k2 * (z4 * s1 + c1 * z5); /* theta2'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m2) > 0.0 * (dydt[2] + dydt[3]) && fabs(z3) > 1e-13 * m1)) {
        /* the mass matrix is singular, if m2 is 0 */
        if (!(fabs(m2) > 0.0)) {
            return double_pendulum_refuse(fabs(m2), 0.0, DOUBLE_PENDULUM_SINGULAR_2);
        }
        /* the mass matrix is singular, if z3 is nearly 0 */
        if (!(fabs(z3) > 1e-13 * m1)) {
            return double_pendulum_refuse(fabs(z3), 1e-13 * m1, DOUBLE_PENDULUM_SINGULAR_2);
        }
        return double_pendulum_finish(4, dydt);
    }
    return DOUBLE_PENDULUM_OK;
}

int double_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double theta1_dot = y[2]; /* theta1' [rad/s] */
    qdot[0] = theta1_dot; /* theta1' */
    const double theta2_dot = y[3]; /* theta2' [rad/s] */
    qdot[1] = theta2_dot; /* theta2' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1]) <= DBL_MAX)) {
        return double_pendulum_finish(2, qdot);
    }
    return DOUBLE_PENDULUM_OK;
}

int double_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);

    /* what else is read */
    const double theta1_dot = y[2]; /* theta1' [rad/s] */
    const double theta2_dot = y[3]; /* theta2' [rad/s] */
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = -1.0 / l1;
    const double k2 = 1.0 / l2;

    /* from the state */
    const double z2 = m2 * s1;
    const double z3 = m1 + s1 * z2;
    const double z4 = l1 * (theta1_dot * theta1_dot) + g * c_theta1;
    const double z5 = (l2 * (theta2_dot * theta2_dot) + z4 * c1) * (z2 / z3);
    /* (II.3) */
    qddot[0] = k1 * (g * s_theta1 + z5); /* theta1'' */
    qddot[1] = k2 * (z4 * s1 + c1 * z5); /* theta2'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m2) > 0.0 * (qddot[0] + qddot[1]) && fabs(z3) > 1e-13 * m1)) {
        /* the mass matrix is singular, if m2 is 0 */
        if (!(fabs(m2) > 0.0)) {
            return double_pendulum_refuse(fabs(m2), 0.0, DOUBLE_PENDULUM_SINGULAR_2);
        }
        /* the mass matrix is singular, if z3 is nearly 0 */
        if (!(fabs(z3) > 1e-13 * m1)) {
            return double_pendulum_refuse(fabs(z3), 1e-13 * m1, DOUBLE_PENDULUM_SINGULAR_2);
        }
        return double_pendulum_finish(2, qddot);
    }
    return DOUBLE_PENDULUM_OK;
}

int double_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double theta1 = q[0]; /* upper rod from the downward vertical [rad] */
    y[0] = theta1;
    const double theta2 = q[1]; /* lower rod from the downward vertical [rad] */
    y[1] = theta2;
    const double theta1_dot = qdot[0]; /* theta1' [rad/s] */
    y[2] = theta1_dot;
    const double theta2_dot = qdot[1]; /* theta2' [rad/s] */
    y[3] = theta2_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3]) <= DBL_MAX)) {
        return double_pendulum_finish(4, y);
    }
    return DOUBLE_PENDULUM_OK;
}

int double_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return DOUBLE_PENDULUM_OK;
}

int double_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */

    /* sines and cosines */
    const double s1 = sin(theta1 - theta2);

    /* what else is read */
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */

    /* from the state */
    /* the mass matrix is singular, if m2 is 0 */
    if (!(fabs(m2) > 0.0)) {
        return double_pendulum_refuse(fabs(m2), 0.0, DOUBLE_PENDULUM_SINGULAR_2);
    }
    /* the mass matrix is singular, if m1 + s1 * (m2 * s1) is nearly 0 */
    if (!(fabs(m1 + s1 * (m2 * s1)) > 1e-13 * m1)) {
        return double_pendulum_refuse(fabs(m1 + s1 * (m2 * s1)), 1e-13 * m1, DOUBLE_PENDULUM_SINGULAR_2);
    }
    (void)lambda;
    return DOUBLE_PENDULUM_OK;
}

double double_pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */

    /* sines and cosines */
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double c_theta2 = cos(theta2);
    const double s_theta2 = sin(theta2);

    /* what else is read */
    const double theta1_dot = y[2]; /* theta1' [rad/s] */
    const double theta2_dot = y[3]; /* theta2' [rad/s] */
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m1 * l1;

    /* from the state */
    const double z1 = g * c_theta1;
    const double z2 = l1 * (z1 - theta1_dot * (0.5 * (theta1_dot * l1) + l2 * (theta2_dot * (c_theta1 *
        c_theta2 + s_theta1 * s_theta2))));
    const double z3 = k1 * (0.5 * (l1 * (theta1_dot * theta1_dot)) - z1) + m2 * (l2 * (0.5 * (l2 *
        (theta2_dot * theta2_dot)) - g * c_theta2) - z2);
    return z3;
}

DOUBLE_PENDULUM_SLOW
int double_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    J[0] = 0.0;
    J[1] = 0.0;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);

    /* what else is read */
    const double theta1_dot = y[2]; /* theta1' [rad/s] */
    const double theta2_dot = y[3]; /* theta2' [rad/s] */
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = 1.0 / l1;
    const double k2 = 1.0 / l2;

    /* from the state */
    const double z2 = m2 * s1;
    const double z3 = m1 + s1 * z2;
    const double z4 = g * c_theta1;
    const double z5 = 1.0 / z3;
    const double z6 = l1 * (theta1_dot * theta1_dot) + z4;
    const double z7 = z6 * c1;
    const double z8 = m2 * (l2 * (theta2_dot * theta2_dot) + z7);
    const double z9 = c1 * z8;
    const double z10 = z6 * s1;
    const double z11 = g * s_theta1;
    const double z12 = c1 * z2;
    const double z13 = s1 * z8;
    const double z14 = 2.0 * (z5 * z5 * (z12 * z13));
    const double z15 = z5 * (z9 - z2 * (z10 + z11 * c1)) - z14;
    const double z16 = z5 * (z9 - z2 * z10) - z14;
    const double x1_dot = theta1_dot * l1;
    const double z17 = z5 * (x1_dot * z12);
    const double z18 = l2 * (z5 * (theta2_dot * z2));
    const double z19 = z7 - z13 * (s1 * z5);
    /* (II.3) */
    J[2] = 1.0;
    J[7] = 1.0;
    J[8] = -k1 * (z4 + z15);
    J[9] = k1 * z16;
    J[10] = -2.0 * (k1 * z17);
    J[11] = -2.0 * (k1 * z18);
    J[12] = k2 * (z19 - (z11 * s1 - c1 * z15));
    J[13] = -k2 * (z19 + c1 * z16);
    J[14] = 2.0 * (k2 * (x1_dot * s1 + c1 * z17));
    J[15] = 2.0 * (k2 * (c1 * z18));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m2) > 0.0 * (J[8] + J[9] + J[10] + J[11] + J[12] + J[13] + J[14] + J[15])
        && fabs(z3) > 1e-13 * m1)) {
        /* the mass matrix is singular, if m2 is 0 */
        if (!(fabs(m2) > 0.0)) {
            return double_pendulum_refuse(fabs(m2), 0.0, DOUBLE_PENDULUM_SINGULAR_2);
        }
        /* the mass matrix is singular, if z3 is nearly 0 */
        if (!(fabs(z3) > 1e-13 * m1)) {
            return double_pendulum_refuse(fabs(z3), 1e-13 * m1, DOUBLE_PENDULUM_SINGULAR_2);
        }
        return double_pendulum_finish(16, J);
    }
    return DOUBLE_PENDULUM_OK;
}

int double_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta2 = cos(theta2);

    /* what else is read */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */

    /* from the state */
    /* 23:10 */
    out[0] = l1 * s_theta1 + l2 * s_theta2; /* tip_x */
    /* 24:10 */
    out[1] = -(l1 * c_theta1 + l2 * c_theta2); /* tip_y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return double_pendulum_finish(2, out);
    }
    return DOUBLE_PENDULUM_OK;
}

#if DOUBLE_PENDULUM_LANES >= 2
static __attribute__((noinline)) void double_pendulum_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    double_pendulum_lanes far = {0}; /* the squares of the angles */
    double_pendulum_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    double_pendulum_bits bad = {0}; /* singular blocks */
    const double m1 = fixed[0];
    const double m2 = fixed[1];
    const double l1 = fixed[2];
    const double l2 = fixed[3];
    const double g = fixed[4];
    const double k1 = fixed[5];
    const double k2 = fixed[6];
    const double_pendulum_lanes theta1 = double_pendulum_get(y);
    const double_pendulum_lanes theta2 = double_pendulum_get(y + 1 * stride);
    const double_pendulum_lanes theta1_dot = double_pendulum_get(y + 2 * stride);
    const double_pendulum_lanes theta2_dot = double_pendulum_get(y + 3 * stride);
    const double_pendulum_lanes z1 = theta1 - theta2;
    double_pendulum_lanes sine1, cosine1;
    double_pendulum_turn_lanes(DOUBLE_PENDULUM_SPREAD(z1), &far, &sine1, &cosine1);
    const double_pendulum_lanes s1 = sine1;
    const double_pendulum_lanes z2 = m2 * s1;
    const double_pendulum_lanes z3 = m1 + s1 * z2;
    /* the mass matrix is singular, if z3 is nearly 0 */
    bad |= double_pendulum_misses(double_pendulum_size(DOUBLE_PENDULUM_SPREAD(z3)),
        DOUBLE_PENDULUM_SPREAD(1e-13 * m1));
    double_pendulum_lanes sine2, cosine2;
    double_pendulum_turn_lanes(DOUBLE_PENDULUM_SPREAD(theta1), &far, &sine2, &cosine2);
    const double_pendulum_lanes s_theta1 = sine2;
    const double_pendulum_lanes c_theta1 = cosine2;
    const double_pendulum_lanes z4 = l1 * (theta1_dot * theta1_dot) + g * c_theta1;
    const double_pendulum_lanes c1 = cosine1;
    const double_pendulum_lanes z5 = (l2 * (theta2_dot * theta2_dot) + z4 * c1) * (z2 / z3);
    /* (II.3) */
    const double_pendulum_lanes slope1 = theta1_dot;
    double_pendulum_put(dydt, slope1);
    const double_pendulum_lanes slope2 = theta2_dot;
    double_pendulum_put(dydt + 1 * stride, slope2);
    /* (II.3) 20:4 */
    const double_pendulum_lanes slope3 = k1 * (g * s_theta1 + z5);
    sum += slope3;
    double_pendulum_put(dydt + 2 * stride, slope3);
    const double_pendulum_lanes slope4 = k2 * (z4 * s1 + c1 * z5);
    sum += slope4;
    double_pendulum_put(dydt + 3 * stride, slope4);
    double_pendulum_put(check, double_pendulum_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void double_pendulum_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[DOUBLE_PENDULUM_LANES];
    double state[4 * DOUBLE_PENDULUM_LANES];
    double slope[4 * DOUBLE_PENDULUM_LANES];
    double_pendulum_fill(left, count, t, y, time, state);
    double_pendulum_rhs_lanes(fixed, DOUBLE_PENDULUM_LANES, time, state, slope, check);
    double_pendulum_pour(left, count, slope, dydt);
}
#endif

int double_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if DOUBLE_PENDULUM_LANES >= 2
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */
    const double k1 = -1.0 / l1;
    const double k2 = 1.0 / l2;
    /* the mass matrix is singular, if m2 is 0 */
    if (!(fabs(m2) > 0.0)) {
        return double_pendulum_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {m1, m2, l1, l2, g, k1, k2};
    double check[1 * DOUBLE_PENDULUM_LANES];
    int status = DOUBLE_PENDULUM_OK;
    for (size_t i = 0; i < count; i += DOUBLE_PENDULUM_LANES) {
        const size_t left = count - i < DOUBLE_PENDULUM_LANES ? count - i : DOUBLE_PENDULUM_LANES;
        if (left == DOUBLE_PENDULUM_LANES) {
            double_pendulum_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            double_pendulum_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!double_pendulum_is_good(1 * DOUBLE_PENDULUM_LANES, check)) {
            const int one = double_pendulum_one_by_one(count, i, left, t, y, p, dydt);
            status = status == DOUBLE_PENDULUM_OK ? one : status;
        }
    }
    return status;
#else
    return double_pendulum_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
