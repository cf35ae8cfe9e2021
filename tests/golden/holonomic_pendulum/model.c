/*
 * holonomic_pendulum.c: holonomic_pendulum, emitted by nhc 0.1.0 (nhc:798864644dea9c9b)
 * The plane pendulum in Cartesian coordinates with the rod as a constraint on the positions.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v: the dependent velocities that nhc would choose (x') are singular
 *     somewhere
 * holonomic_pendulum.h says what each function does.
 */
#include "holonomic_pendulum.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const holonomic_pendulum_coordinate_names[HOLONOMIC_PENDULUM_NQ] = {
    "x",
    "y"
};
const char *const holonomic_pendulum_state_names[HOLONOMIC_PENDULUM_NY] = {
    "x",
    "y",
    "v"
};
const char *const holonomic_pendulum_parameter_names[HOLONOMIC_PENDULUM_NP] = {
    "m",
    "g",
    "l"
};
const char *const holonomic_pendulum_constraint_names[HOLONOMIC_PENDULUM_NC] = {
    "rod"
};
const char *const holonomic_pendulum_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double holonomic_pendulum_parameter_defaults[HOLONOMIC_PENDULUM_NP] = {
    1.0,
    9.81,
    1.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int holonomic_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return HOLONOMIC_PENDULUM_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return HOLONOMIC_PENDULUM_NOT_FINITE;
        }
    }
    return HOLONOMIC_PENDULUM_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int holonomic_pendulum_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : HOLONOMIC_PENDULUM_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef HOLONOMIC_PENDULUM_LANES
#if !defined(__GNUC__)
#define HOLONOMIC_PENDULUM_LANES 1
#elif defined(__AVX512F__)
#define HOLONOMIC_PENDULUM_LANES 8
#elif defined(__AVX__)
#define HOLONOMIC_PENDULUM_LANES 4
#else
#define HOLONOMIC_PENDULUM_LANES 2
#endif
#endif
#if HOLONOMIC_PENDULUM_LANES > 1
typedef double holonomic_pendulum_lanes __attribute__((vector_size(8 * HOLONOMIC_PENDULUM_LANES)));
#else
typedef double holonomic_pendulum_lanes;
#endif

#if HOLONOMIC_PENDULUM_LANES >= 2
static inline holonomic_pendulum_lanes holonomic_pendulum_get(const double *from)
{
    holonomic_pendulum_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void holonomic_pendulum_put(double *to, holonomic_pendulum_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int holonomic_pendulum_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = HOLONOMIC_PENDULUM_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[HOLONOMIC_PENDULUM_NY];
        double slope[HOLONOMIC_PENDULUM_NY];
        for (size_t k = 0; k < HOLONOMIC_PENDULUM_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = holonomic_pendulum_rhs(t[i], state, p, slope);
        status = status == HOLONOMIC_PENDULUM_OK ? one : status;
        for (size_t k = 0; k < HOLONOMIC_PENDULUM_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if HOLONOMIC_PENDULUM_LANES >= 2
#define HOLONOMIC_PENDULUM_SPREAD(x) ((x) - (holonomic_pendulum_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long holonomic_pendulum_bits __attribute__((vector_size(8 * HOLONOMIC_PENDULUM_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline holonomic_pendulum_lanes holonomic_pendulum_mark(holonomic_pendulum_lanes value, holonomic_pendulum_bits bad)
{
    return (holonomic_pendulum_lanes)((holonomic_pendulum_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int holonomic_pendulum_is_good(int count, const double *check)
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
static inline void holonomic_pendulum_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < HOLONOMIC_PENDULUM_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < HOLONOMIC_PENDULUM_NY; ++k) {
            state[k * HOLONOMIC_PENDULUM_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void holonomic_pendulum_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < HOLONOMIC_PENDULUM_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * HOLONOMIC_PENDULUM_LANES + l];
        }
    }
}
#endif

int holonomic_pendulum_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * g;

    /* from the state */
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* y: up [m] */
    const double z1 = x * x + y_2 * y_2;
    const double z2 = m * z1;
    const double v = y[2]; /* [1/s] */
    /* (I.2.4) */
    dydt[0] = y_2 * v; /* x' */
    dydt[1] = -x * v; /* y' */
    /* (I.2.15) 13:4 */
    dydt[2] = x * k1 / z2; /* v' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2]) <= DBL_MAX)) {
        /* the coframe is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(z1), 0.0, HOLONOMIC_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(z2), 0.0, HOLONOMIC_PENDULUM_SINGULAR_2);
        }
        return holonomic_pendulum_finish(3, dydt);
    }
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y_2 = y[1]; /* y: up [m] */
    const double v = y[2]; /* [1/s] */
    /* (I.2.4) */
    qdot[0] = y_2 * v; /* x' */
    const double x = y[0]; /* across [m] */
    qdot[1] = -x * v; /* y' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(x * x + y_2 * y_2) > 0.0 * (qdot[0] + qdot[1]))) {
        /* the coframe is singular, if x * x + y_2 * y_2 is 0 */
        if (!(fabs(x * x + y_2 * y_2) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(x * x + y_2 * y_2), 0.0, HOLONOMIC_PENDULUM_SINGULAR_1);
        }
        return holonomic_pendulum_finish(2, qdot);
    }
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * g;

    /* from the state */
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* y: up [m] */
    const double z1 = x * x + y_2 * y_2;
    const double z2 = m * z1;
    const double v = y[2]; /* [1/s] */
    const double z3 = v * v;
    const double z4 = k1 * (x / z2);
    /* (I.2.15) */
    qddot[0] = y_2 * z4 - x * z3; /* x'' */
    qddot[1] = -(y_2 * z3 + x * z4); /* y'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1]) <= DBL_MAX)) {
        /* the coframe is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(z1), 0.0, HOLONOMIC_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(z2), 0.0, HOLONOMIC_PENDULUM_SINGULAR_2);
        }
        return holonomic_pendulum_finish(2, qddot);
    }
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* across [m] */
    y[0] = x;
    const double y_2 = q[1]; /* y: up [m] */
    y[1] = y_2;
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    y[2] = (y_2 * x_dot - x * y_dot) / (x * x + y_2 * y_2);
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[2]) <= DBL_MAX)) {
        return holonomic_pendulum_finish(3, y);
    }
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* across [m] */
    const double y = q[1]; /* up [m] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    /* (I.1.1) 16:5 */
    r[0] = x * x_dot + y * y_dot; /* rod = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return holonomic_pendulum_finish(1, r);
    }
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_positions(double t, const double *q, const double *p, double *f)
{
    (void)t;

    /* from the parameters alone */
    const double l = p[2]; /* length of the rod [m] */
    const double k1 = l * l;

    /* from the coordinates */
    const double x = q[0]; /* across [m] */
    const double y = q[1]; /* up [m] */
    /* 16:5 */
    f[0] = 0.5 * (x * x + y * y - k1); /* rod = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(f[0]) <= DBL_MAX)) {
        return holonomic_pendulum_finish(1, f);
    }
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the state */
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* y: up [m] */
    const double z1 = x * x + y_2 * y_2;
    const double v = y[2]; /* [1/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    /* (I.4.1) 16:5 */
    lambda[0] = (y_2 * g / z1 - v * v) * m; /* reaction of rod: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * lambda[0])) {
        /* the coframe is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(z1), 0.0, HOLONOMIC_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if m * z1 is 0 */
        if (!(fabs(m * z1) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(m * z1), 0.0, HOLONOMIC_PENDULUM_SINGULAR_2);
        }
        return holonomic_pendulum_finish(1, lambda);
    }
    return HOLONOMIC_PENDULUM_OK;
}

double holonomic_pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * g;

    /* from the state */
    const double y_2 = y[1]; /* y: up [m] */
    const double v = y[2]; /* [1/s] */
    const double z1 = y_2 * v;
    const double x = y[0]; /* across [m] */
    const double z2 = x * v;
    return y_2 * k1 + 0.5 * (m * (z1 * z1 + z2 * z2));
}

int holonomic_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    J[0] = 0.0;
    J[4] = 0.0;
    J[8] = 0.0;
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * g;
    const double k2 = m * k1;

    /* from the state */
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* y: up [m] */
    const double z1 = x * x + y_2 * y_2;
    const double z2 = m * z1;
    const double z3 = 1.0 / z2;
    const double z4 = x * z3 * k2;
    const double v = y[2]; /* [1/s] */
    /* (I.2.15) */
    J[1] = v;
    J[2] = y_2;
    J[3] = -v;
    J[5] = -x;
    J[6] = z3 * (k1 - 2.0 * (x * z4));
    J[7] = -2.0 * (z3 * (y_2 * z4));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[3] + J[6] + J[7]) <= DBL_MAX)) {
        /* the coframe is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(z1), 0.0, HOLONOMIC_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return holonomic_pendulum_refuse(fabs(z2), 0.0, HOLONOMIC_PENDULUM_SINGULAR_2);
        }
        return holonomic_pendulum_finish(9, J);
    }
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;

    /* from the state */
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* y: up [m] */
    /* the coframe is singular, if x * x + y_2 * y_2 is 0 */
    if (!(fabs(x * x + y_2 * y_2) > 0.0)) {
        return holonomic_pendulum_refuse(fabs(x * x + y_2 * y_2), 0.0, HOLONOMIC_PENDULUM_SINGULAR_1);
    }
    (void)out;
    return HOLONOMIC_PENDULUM_OK;
}

#if HOLONOMIC_PENDULUM_LANES >= 2
static __attribute__((noinline)) void holonomic_pendulum_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    holonomic_pendulum_lanes far = {0}; /* the squares of the angles */
    holonomic_pendulum_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    holonomic_pendulum_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double k1 = fixed[1];
    const holonomic_pendulum_lanes x = holonomic_pendulum_get(y);
    const holonomic_pendulum_lanes y_2 = holonomic_pendulum_get(y + 1 * stride);
    const holonomic_pendulum_lanes v = holonomic_pendulum_get(y + 2 * stride);
    const holonomic_pendulum_lanes z1 = x * x + y_2 * y_2;
    const holonomic_pendulum_lanes z2 = m * z1;
    /* (I.2.4) */
    const holonomic_pendulum_lanes slope1 = y_2 * v;
    sum += slope1;
    holonomic_pendulum_put(dydt, slope1);
    const holonomic_pendulum_lanes slope2 = -x * v;
    sum += slope2;
    holonomic_pendulum_put(dydt + 1 * stride, slope2);
    /* (I.2.15) 13:4 */
    const holonomic_pendulum_lanes slope3 = x * k1 / z2;
    sum += slope3;
    holonomic_pendulum_put(dydt + 2 * stride, slope3);
    holonomic_pendulum_put(check, holonomic_pendulum_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void holonomic_pendulum_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[HOLONOMIC_PENDULUM_LANES];
    double state[3 * HOLONOMIC_PENDULUM_LANES];
    double slope[3 * HOLONOMIC_PENDULUM_LANES];
    holonomic_pendulum_fill(left, count, t, y, time, state);
    holonomic_pendulum_rhs_lanes(fixed, HOLONOMIC_PENDULUM_LANES, time, state, slope, check);
    holonomic_pendulum_pour(left, count, slope, dydt);
}
#endif

int holonomic_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if HOLONOMIC_PENDULUM_LANES >= 2
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * g;
    const double fixed[] = {m, k1};
    double check[1 * HOLONOMIC_PENDULUM_LANES];
    int status = HOLONOMIC_PENDULUM_OK;
    for (size_t i = 0; i < count; i += HOLONOMIC_PENDULUM_LANES) {
        const size_t left = count - i < HOLONOMIC_PENDULUM_LANES ? count - i : HOLONOMIC_PENDULUM_LANES;
        if (left == HOLONOMIC_PENDULUM_LANES) {
            holonomic_pendulum_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            holonomic_pendulum_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!holonomic_pendulum_is_good(1 * HOLONOMIC_PENDULUM_LANES, check)) {
            const int one = holonomic_pendulum_one_by_one(count, i, left, t, y, p, dydt);
            status = status == HOLONOMIC_PENDULUM_OK ? one : status;
        }
    }
    return status;
#else
    return holonomic_pendulum_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
