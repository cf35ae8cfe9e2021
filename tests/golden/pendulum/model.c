/*
 * pendulum.c: pendulum, emitted by nhc 0.1.0 (nhc:591be01219ceb7e2)
 * The plane pendulum, large swings.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * pendulum.h says what each function does.
 */
#include "pendulum.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const pendulum_coordinate_names[PENDULUM_NQ] = {
    "theta"
};
const char *const pendulum_state_names[PENDULUM_NY] = {
    "theta",
    "theta'"
};
const char *const pendulum_parameter_names[PENDULUM_NP] = {
    "m",
    "l",
    "g"
};
const char *const pendulum_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const pendulum_output_names[PENDULUM_NOUT] = {
    "rate"
};
const double pendulum_parameter_defaults[PENDULUM_NP] = {
    1.0,
    1.0,
    9.81
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return PENDULUM_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return PENDULUM_NOT_FINITE;
        }
    }
    return PENDULUM_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int pendulum_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : PENDULUM_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef PENDULUM_LANES
#if !defined(__GNUC__)
#define PENDULUM_LANES 1
#elif defined(__AVX512F__)
#define PENDULUM_LANES 8
#elif defined(__AVX__)
#define PENDULUM_LANES 4
#else
#define PENDULUM_LANES 2
#endif
#endif
#if PENDULUM_LANES > 1
typedef double pendulum_lanes __attribute__((vector_size(8 * PENDULUM_LANES)));
#else
typedef double pendulum_lanes;
#endif

#if PENDULUM_LANES >= 2
static inline pendulum_lanes pendulum_get(const double *from)
{
    pendulum_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void pendulum_put(double *to, pendulum_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int pendulum_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = PENDULUM_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[PENDULUM_NY];
        double slope[PENDULUM_NY];
        for (size_t k = 0; k < PENDULUM_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = pendulum_rhs(t[i], state, p, slope);
        status = status == PENDULUM_OK ? one : status;
        for (size_t k = 0; k < PENDULUM_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if PENDULUM_LANES >= 2
#define PENDULUM_SPREAD(x) ((x) - (pendulum_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long pendulum_bits __attribute__((vector_size(8 * PENDULUM_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline pendulum_lanes pendulum_mark(pendulum_lanes value, pendulum_bits bad)
{
    return (pendulum_lanes)((pendulum_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int pendulum_is_good(int count, const double *check)
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
static inline void pendulum_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < PENDULUM_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < PENDULUM_NY; ++k) {
            state[k * PENDULUM_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void pendulum_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < PENDULUM_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * PENDULUM_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void pendulum_turn_lanes(pendulum_lanes x, pendulum_lanes *far,
    pendulum_lanes *sine, pendulum_lanes *cosine)
{
    double angle[PENDULUM_LANES];
    double up[PENDULUM_LANES];
    double along[PENDULUM_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < PENDULUM_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int pendulum_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double theta_dot = y[1]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = -g / l;

    /* from the state */
    /* (II.3) */
    dydt[0] = theta_dot; /* theta' */
    /* (II.3) 12:4 */
    dydt[1] = s_theta * k1; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (dydt[0] + dydt[1]))) {
        /* the mass matrix is singular, if m * (l * l) is 0 */
        if (!(fabs(m * (l * l)) > 0.0)) {
            return pendulum_refuse(fabs(m * (l * l)), 0.0, PENDULUM_SINGULAR_2);
        }
        return pendulum_finish(2, dydt);
    }
    return PENDULUM_OK;
}

int pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double theta_dot = y[1]; /* theta' [rad/s] */
    qdot[0] = theta_dot; /* theta' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0]) <= DBL_MAX)) {
        return pendulum_finish(1, qdot);
    }
    return PENDULUM_OK;
}

int pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = -g / l;

    /* from the state */
    /* (II.3) */
    qddot[0] = s_theta * k1; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * qddot[0])) {
        /* the mass matrix is singular, if m * (l * l) is 0 */
        if (!(fabs(m * (l * l)) > 0.0)) {
            return pendulum_refuse(fabs(m * (l * l)), 0.0, PENDULUM_SINGULAR_2);
        }
        return pendulum_finish(1, qddot);
    }
    return PENDULUM_OK;
}

int pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double theta = q[0]; /* angle from the downward vertical [rad] */
    y[0] = theta;
    const double theta_dot = qdot[0]; /* theta' [rad/s] */
    y[1] = theta_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1]) <= DBL_MAX)) {
        return pendulum_finish(2, y);
    }
    return PENDULUM_OK;
}

int pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return PENDULUM_OK;
}

int pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;

    /* from the state */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    /* the mass matrix is singular, if m * (l * l) is 0 */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return pendulum_refuse(fabs(m * (l * l)), 0.0, PENDULUM_SINGULAR_2);
    }
    (void)lambda;
    return PENDULUM_OK;
}

double pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);

    /* what else is read */
    const double theta_dot = y[1]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * l;

    /* from the state */
    return k1 * (0.5 * (l * (theta_dot * theta_dot)) - g * c_theta);
}

int pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    J[0] = 0.0;
    J[3] = 0.0;
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);

    /* what else is read */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = -g / l;

    /* from the state */
    /* (II.3) */
    J[1] = 1.0;
    J[2] = c_theta * k1;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * J[2])) {
        /* the mass matrix is singular, if m * (l * l) is 0 */
        if (!(fabs(m * (l * l)) > 0.0)) {
            return pendulum_refuse(fabs(m * (l * l)), 0.0, PENDULUM_SINGULAR_2);
        }
        return pendulum_finish(4, J);
    }
    return PENDULUM_OK;
}

int pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;

    /* from the state */
    const double theta_dot = y[1]; /* theta' [rad/s] */
    /* 15:9 */
    out[0] = theta_dot; /* rate */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return pendulum_finish(1, out);
    }
    return PENDULUM_OK;
}

#if PENDULUM_LANES >= 2
static __attribute__((noinline)) void pendulum_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    pendulum_lanes far = {0}; /* the squares of the angles */
    pendulum_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    pendulum_bits bad = {0}; /* singular blocks */
    const double k1 = fixed[0];
    const pendulum_lanes theta = pendulum_get(y);
    const pendulum_lanes theta_dot = pendulum_get(y + 1 * stride);
    pendulum_lanes sine1, cosine1;
    pendulum_turn_lanes(PENDULUM_SPREAD(theta), &far, &sine1, &cosine1);
    const pendulum_lanes s_theta = sine1;
    /* (II.3) */
    const pendulum_lanes slope1 = theta_dot;
    sum += slope1;
    pendulum_put(dydt, slope1);
    /* (II.3) 12:4 */
    const pendulum_lanes slope2 = s_theta * k1;
    sum += slope2;
    pendulum_put(dydt + 1 * stride, slope2);
    pendulum_put(check, pendulum_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void pendulum_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[PENDULUM_LANES];
    double state[2 * PENDULUM_LANES];
    double slope[2 * PENDULUM_LANES];
    pendulum_fill(left, count, t, y, time, state);
    pendulum_rhs_lanes(fixed, PENDULUM_LANES, time, state, slope, check);
    pendulum_pour(left, count, slope, dydt);
}
#endif

int pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
#if PENDULUM_LANES >= 2
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double k1 = -g / l;
    /* the mass matrix is singular, if m * (l * l) is 0 */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return pendulum_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {k1};
    double check[1 * PENDULUM_LANES];
    int status = PENDULUM_OK;
    for (size_t i = 0; i < count; i += PENDULUM_LANES) {
        const size_t left = count - i < PENDULUM_LANES ? count - i : PENDULUM_LANES;
        if (left == PENDULUM_LANES) {
            pendulum_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            pendulum_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!pendulum_is_good(1 * PENDULUM_LANES, check)) {
            const int one = pendulum_one_by_one(count, i, left, t, y, p, dydt);
            status = status == PENDULUM_OK ? one : status;
        }
    }
    return status;
#else
    return pendulum_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
