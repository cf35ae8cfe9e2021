/*
 * cartesian_pendulum.c: cartesian_pendulum, emitted by nhc 0.1.0 (nhc:c369c3d0b6899784)
 * The plane pendulum in Cartesian coordinates; its constraint is written with velocities, but it is
 *     holonomic.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v: the dependent velocities that nhc would choose (x') are singular
 *     somewhere
 * cartesian_pendulum.h says what each function does.
 */
#include "cartesian_pendulum.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const cartesian_pendulum_coordinate_names[CARTESIAN_PENDULUM_NQ] = {
    "x",
    "y"
};
const char *const cartesian_pendulum_state_names[CARTESIAN_PENDULUM_NY] = {
    "x",
    "y",
    "v"
};
const char *const cartesian_pendulum_parameter_names[CARTESIAN_PENDULUM_NP] = {
    "m",
    "g"
};
const char *const cartesian_pendulum_constraint_names[CARTESIAN_PENDULUM_NC] = {
    "rod"
};
const char *const cartesian_pendulum_output_names[CARTESIAN_PENDULUM_NOUT] = {
    "length"
};
const double cartesian_pendulum_parameter_defaults[CARTESIAN_PENDULUM_NP] = {
    1.0,
    9.81
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int cartesian_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CARTESIAN_PENDULUM_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CARTESIAN_PENDULUM_NOT_FINITE;
        }
    }
    return CARTESIAN_PENDULUM_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int cartesian_pendulum_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CARTESIAN_PENDULUM_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CARTESIAN_PENDULUM_LANES
#if !defined(__GNUC__)
#define CARTESIAN_PENDULUM_LANES 1
#elif defined(__AVX512F__)
#define CARTESIAN_PENDULUM_LANES 8
#elif defined(__AVX__)
#define CARTESIAN_PENDULUM_LANES 4
#else
#define CARTESIAN_PENDULUM_LANES 2
#endif
#endif
#if CARTESIAN_PENDULUM_LANES > 1
typedef double cartesian_pendulum_lanes __attribute__((vector_size(8 * CARTESIAN_PENDULUM_LANES)));
#else
typedef double cartesian_pendulum_lanes;
#endif

#if CARTESIAN_PENDULUM_LANES >= 2
static inline cartesian_pendulum_lanes cartesian_pendulum_get(const double *from)
{
    cartesian_pendulum_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void cartesian_pendulum_put(double *to, cartesian_pendulum_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int cartesian_pendulum_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CARTESIAN_PENDULUM_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CARTESIAN_PENDULUM_NY];
        double slope[CARTESIAN_PENDULUM_NY];
        for (size_t k = 0; k < CARTESIAN_PENDULUM_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = cartesian_pendulum_rhs(t[i], state, p, slope);
        status = status == CARTESIAN_PENDULUM_OK ? one : status;
        for (size_t k = 0; k < CARTESIAN_PENDULUM_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CARTESIAN_PENDULUM_LANES >= 2
#define CARTESIAN_PENDULUM_SPREAD(x) ((x) - (cartesian_pendulum_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long cartesian_pendulum_bits __attribute__((vector_size(8 * CARTESIAN_PENDULUM_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline cartesian_pendulum_lanes cartesian_pendulum_mark(cartesian_pendulum_lanes value, cartesian_pendulum_bits bad)
{
    return (cartesian_pendulum_lanes)((cartesian_pendulum_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int cartesian_pendulum_is_good(int count, const double *check)
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
static inline void cartesian_pendulum_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CARTESIAN_PENDULUM_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CARTESIAN_PENDULUM_NY; ++k) {
            state[k * CARTESIAN_PENDULUM_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void cartesian_pendulum_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CARTESIAN_PENDULUM_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CARTESIAN_PENDULUM_LANES + l];
        }
    }
}
#endif

int cartesian_pendulum_rhs(double t, const double *y, const double *p, double *restrict dydt)
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
    /* (I.2.15) 12:4 */
    dydt[2] = x * k1 / z2; /* v' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2]) <= DBL_MAX)) {
        /* the coframe is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return cartesian_pendulum_refuse(fabs(z1), 0.0, CARTESIAN_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return cartesian_pendulum_refuse(fabs(z2), 0.0, CARTESIAN_PENDULUM_SINGULAR_2);
        }
        return cartesian_pendulum_finish(3, dydt);
    }
    return CARTESIAN_PENDULUM_OK;
}

int cartesian_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
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
            return cartesian_pendulum_refuse(fabs(x * x + y_2 * y_2), 0.0, CARTESIAN_PENDULUM_SINGULAR_1);
        }
        return cartesian_pendulum_finish(2, qdot);
    }
    return CARTESIAN_PENDULUM_OK;
}

int cartesian_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
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
            return cartesian_pendulum_refuse(fabs(z1), 0.0, CARTESIAN_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return cartesian_pendulum_refuse(fabs(z2), 0.0, CARTESIAN_PENDULUM_SINGULAR_2);
        }
        return cartesian_pendulum_finish(2, qddot);
    }
    return CARTESIAN_PENDULUM_OK;
}

int cartesian_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
        return cartesian_pendulum_finish(3, y);
    }
    return CARTESIAN_PENDULUM_OK;
}

int cartesian_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* across [m] */
    const double y = q[1]; /* up [m] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    /* (I.1.1) 15:5 */
    r[0] = x * x_dot + y * y_dot; /* rod = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return cartesian_pendulum_finish(1, r);
    }
    return CARTESIAN_PENDULUM_OK;
}

int cartesian_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the state */
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* y: up [m] */
    const double z1 = x * x + y_2 * y_2;
    const double v = y[2]; /* [1/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    /* (I.4.1) 15:5 */
    lambda[0] = (y_2 * g / z1 - v * v) * m; /* reaction of rod: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * lambda[0])) {
        /* the coframe is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return cartesian_pendulum_refuse(fabs(z1), 0.0, CARTESIAN_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if m * z1 is 0 */
        if (!(fabs(m * z1) > 0.0)) {
            return cartesian_pendulum_refuse(fabs(m * z1), 0.0, CARTESIAN_PENDULUM_SINGULAR_2);
        }
        return cartesian_pendulum_finish(1, lambda);
    }
    return CARTESIAN_PENDULUM_OK;
}

double cartesian_pendulum_energy(double t, const double *y, const double *p)
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

int cartesian_pendulum_jacobian(double t, const double *y, const double *p, double *J)
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
            return cartesian_pendulum_refuse(fabs(z1), 0.0, CARTESIAN_PENDULUM_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return cartesian_pendulum_refuse(fabs(z2), 0.0, CARTESIAN_PENDULUM_SINGULAR_2);
        }
        return cartesian_pendulum_finish(9, J);
    }
    return CARTESIAN_PENDULUM_OK;
}

int cartesian_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;

    /* from the state */
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* y: up [m] */
    const double z1 = x * x + y_2 * y_2;
    /* 17:11 */
    out[0] = sqrt(z1); /* length */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(z1) > 0.0 * out[0])) {
        /* the coframe is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return cartesian_pendulum_refuse(fabs(z1), 0.0, CARTESIAN_PENDULUM_SINGULAR_1);
        }
        return cartesian_pendulum_finish(1, out);
    }
    return CARTESIAN_PENDULUM_OK;
}

#if CARTESIAN_PENDULUM_LANES >= 2
static __attribute__((noinline)) void cartesian_pendulum_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    cartesian_pendulum_lanes far = {0}; /* the squares of the angles */
    cartesian_pendulum_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    cartesian_pendulum_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double k1 = fixed[1];
    const cartesian_pendulum_lanes x = cartesian_pendulum_get(y);
    const cartesian_pendulum_lanes y_2 = cartesian_pendulum_get(y + 1 * stride);
    const cartesian_pendulum_lanes v = cartesian_pendulum_get(y + 2 * stride);
    const cartesian_pendulum_lanes z1 = x * x + y_2 * y_2;
    const cartesian_pendulum_lanes z2 = m * z1;
    /* (I.2.4) */
    const cartesian_pendulum_lanes slope1 = y_2 * v;
    sum += slope1;
    cartesian_pendulum_put(dydt, slope1);
    const cartesian_pendulum_lanes slope2 = -x * v;
    sum += slope2;
    cartesian_pendulum_put(dydt + 1 * stride, slope2);
    /* (I.2.15) 12:4 */
    const cartesian_pendulum_lanes slope3 = x * k1 / z2;
    sum += slope3;
    cartesian_pendulum_put(dydt + 2 * stride, slope3);
    cartesian_pendulum_put(check, cartesian_pendulum_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void cartesian_pendulum_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CARTESIAN_PENDULUM_LANES];
    double state[3 * CARTESIAN_PENDULUM_LANES];
    double slope[3 * CARTESIAN_PENDULUM_LANES];
    cartesian_pendulum_fill(left, count, t, y, time, state);
    cartesian_pendulum_rhs_lanes(fixed, CARTESIAN_PENDULUM_LANES, time, state, slope, check);
    cartesian_pendulum_pour(left, count, slope, dydt);
}
#endif

int cartesian_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if CARTESIAN_PENDULUM_LANES >= 2
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * g;
    const double fixed[] = {m, k1};
    double check[1 * CARTESIAN_PENDULUM_LANES];
    int status = CARTESIAN_PENDULUM_OK;
    for (size_t i = 0; i < count; i += CARTESIAN_PENDULUM_LANES) {
        const size_t left = count - i < CARTESIAN_PENDULUM_LANES ? count - i : CARTESIAN_PENDULUM_LANES;
        if (left == CARTESIAN_PENDULUM_LANES) {
            cartesian_pendulum_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            cartesian_pendulum_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!cartesian_pendulum_is_good(1 * CARTESIAN_PENDULUM_LANES, check)) {
            const int one = cartesian_pendulum_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CARTESIAN_PENDULUM_OK ? one : status;
        }
    }
    return status;
#else
    return cartesian_pendulum_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
