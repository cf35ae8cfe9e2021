/*
 * pumped_pendulum.c: pumped_pendulum, emitted by nhc 0.1.0 (nhc:830831e7a5203b86)
 * A pendulum whose pivot is moved to and fro; T depends on time and is not homogeneous in the velocities.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * pumped_pendulum.h says what each function does.
 */
#include "pumped_pendulum.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const pumped_pendulum_coordinate_names[PUMPED_PENDULUM_NQ] = {
    "theta"
};
const char *const pumped_pendulum_state_names[PUMPED_PENDULUM_NY] = {
    "theta",
    "theta'"
};
const char *const pumped_pendulum_parameter_names[PUMPED_PENDULUM_NP] = {
    "m",
    "l",
    "g",
    "a",
    "nu"
};
const char *const pumped_pendulum_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const pumped_pendulum_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double pumped_pendulum_parameter_defaults[PUMPED_PENDULUM_NP] = {
    1.0,
    1.0,
    9.81,
    0.3,
    3.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int pumped_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return PUMPED_PENDULUM_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return PUMPED_PENDULUM_NOT_FINITE;
        }
    }
    return PUMPED_PENDULUM_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int pumped_pendulum_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : PUMPED_PENDULUM_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef PUMPED_PENDULUM_LANES
#if !defined(__GNUC__)
#define PUMPED_PENDULUM_LANES 1
#elif defined(__AVX512F__)
#define PUMPED_PENDULUM_LANES 8
#elif defined(__AVX__)
#define PUMPED_PENDULUM_LANES 4
#else
#define PUMPED_PENDULUM_LANES 2
#endif
#endif
#if PUMPED_PENDULUM_LANES > 1
typedef double pumped_pendulum_lanes __attribute__((vector_size(8 * PUMPED_PENDULUM_LANES)));
#else
typedef double pumped_pendulum_lanes;
#endif

#if PUMPED_PENDULUM_LANES >= 2
static inline pumped_pendulum_lanes pumped_pendulum_get(const double *from)
{
    pumped_pendulum_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void pumped_pendulum_put(double *to, pumped_pendulum_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int pumped_pendulum_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = PUMPED_PENDULUM_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[PUMPED_PENDULUM_NY];
        double slope[PUMPED_PENDULUM_NY];
        for (size_t k = 0; k < PUMPED_PENDULUM_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = pumped_pendulum_rhs(t[i], state, p, slope);
        status = status == PUMPED_PENDULUM_OK ? one : status;
        for (size_t k = 0; k < PUMPED_PENDULUM_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if PUMPED_PENDULUM_LANES >= 2
#define PUMPED_PENDULUM_SPREAD(x) ((x) - (pumped_pendulum_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long pumped_pendulum_bits __attribute__((vector_size(8 * PUMPED_PENDULUM_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline pumped_pendulum_lanes pumped_pendulum_mark(pumped_pendulum_lanes value, pumped_pendulum_bits bad)
{
    return (pumped_pendulum_lanes)((pumped_pendulum_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int pumped_pendulum_is_good(int count, const double *check)
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
static inline void pumped_pendulum_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < PUMPED_PENDULUM_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < PUMPED_PENDULUM_NY; ++k) {
            state[k * PUMPED_PENDULUM_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void pumped_pendulum_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < PUMPED_PENDULUM_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * PUMPED_PENDULUM_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void pumped_pendulum_turn_lanes(pumped_pendulum_lanes x, pumped_pendulum_lanes *far,
    pumped_pendulum_lanes *sine, pumped_pendulum_lanes *cosine)
{
    double angle[PUMPED_PENDULUM_LANES];
    double up[PUMPED_PENDULUM_LANES];
    double along[PUMPED_PENDULUM_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < PUMPED_PENDULUM_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int pumped_pendulum_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s1 = sin(t * nu);

    /* what else is read */
    const double theta_dot = y[1]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */

    /* from the parameters alone */
    const double k1 = a * nu * nu;
    const double k2 = -1.0 / l;

    /* from the state */
    /* (II.3) */
    dydt[0] = theta_dot; /* theta' */
    /* (II.3) 17:4 */
    dydt[1] = (g * s_theta - c_theta * (s1 * k1)) * k2; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (dydt[0] + dydt[1]))) {
        /* the mass matrix is singular, if m * (l * l) is 0 */
        if (!(fabs(m * (l * l)) > 0.0)) {
            return pumped_pendulum_refuse(fabs(m * (l * l)), 0.0, PUMPED_PENDULUM_SINGULAR_2);
        }
        return pumped_pendulum_finish(2, dydt);
    }
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double theta_dot = y[1]; /* theta' [rad/s] */
    qdot[0] = theta_dot; /* theta' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0]) <= DBL_MAX)) {
        return pumped_pendulum_finish(1, qdot);
    }
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s1 = sin(t * nu);

    /* what else is read */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */

    /* from the parameters alone */
    const double k1 = a * nu * nu;
    const double k2 = -1.0 / l;

    /* from the state */
    /* (II.3) */
    qddot[0] = (g * s_theta - c_theta * (s1 * k1)) * k2; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * qddot[0])) {
        /* the mass matrix is singular, if m * (l * l) is 0 */
        if (!(fabs(m * (l * l)) > 0.0)) {
            return pumped_pendulum_refuse(fabs(m * (l * l)), 0.0, PUMPED_PENDULUM_SINGULAR_2);
        }
        return pumped_pendulum_finish(1, qddot);
    }
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
        return pumped_pendulum_finish(2, y);
    }
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;

    /* from the state */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    /* the mass matrix is singular, if m * (l * l) is 0 */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return pumped_pendulum_refuse(fabs(m * (l * l)), 0.0, PUMPED_PENDULUM_SINGULAR_2);
    }
    (void)lambda;
    return PUMPED_PENDULUM_OK;
}

double pumped_pendulum_energy(double t, const double *y, const double *p)
{
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* sines and cosines */
    const double c1 = cos(t * nu);
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double theta_dot = y[1]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */

    /* from the parameters alone */
    const double k1 = a * nu;
    const double k2 = l * (m * g);

    /* from the state */
    const double z1 = theta_dot * l;
    const double x_dot = c1 * k1 + c_theta * z1;
    const double y_dot = s_theta * z1;
    return 0.5 * (m * (x_dot * x_dot + y_dot * y_dot)) - c_theta * k2;
}

int pumped_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    J[0] = 0.0;
    J[3] = 0.0;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double s1 = sin(t * nu);

    /* what else is read */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */

    /* from the parameters alone */
    const double k1 = a * nu * nu;
    const double k2 = -1.0 / l;

    /* from the state */
    /* (II.3) */
    J[1] = 1.0;
    J[2] = k2 * (g * c_theta + s_theta * (s1 * k1));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * J[2])) {
        /* the mass matrix is singular, if m * (l * l) is 0 */
        if (!(fabs(m * (l * l)) > 0.0)) {
            return pumped_pendulum_refuse(fabs(m * (l * l)), 0.0, PUMPED_PENDULUM_SINGULAR_2);
        }
        return pumped_pendulum_finish(4, J);
    }
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return PUMPED_PENDULUM_OK;
}

#if PUMPED_PENDULUM_LANES >= 2
static __attribute__((noinline)) void pumped_pendulum_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    pumped_pendulum_lanes far = {0}; /* the squares of the angles */
    pumped_pendulum_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    pumped_pendulum_bits bad = {0}; /* singular blocks */
    const double g = fixed[0];
    const double nu = fixed[1];
    const double k1 = fixed[2];
    const double k2 = fixed[3];
    const pumped_pendulum_lanes t_ = pumped_pendulum_get(t);
    const pumped_pendulum_lanes theta = pumped_pendulum_get(y);
    const pumped_pendulum_lanes theta_dot = pumped_pendulum_get(y + 1 * stride);
    pumped_pendulum_lanes sine1, cosine1;
    pumped_pendulum_turn_lanes(PUMPED_PENDULUM_SPREAD(theta), &far, &sine1, &cosine1);
    const pumped_pendulum_lanes s_theta = sine1;
    const pumped_pendulum_lanes c_theta = cosine1;
    pumped_pendulum_lanes sine2, cosine2;
    pumped_pendulum_turn_lanes(PUMPED_PENDULUM_SPREAD(t_ * nu), &far, &sine2, &cosine2);
    const pumped_pendulum_lanes s1 = sine2;
    /* (II.3) */
    const pumped_pendulum_lanes slope1 = theta_dot;
    sum += slope1;
    pumped_pendulum_put(dydt, slope1);
    /* (II.3) 17:4 */
    const pumped_pendulum_lanes slope2 = (g * s_theta - c_theta * (s1 * k1)) * k2;
    sum += slope2;
    pumped_pendulum_put(dydt + 1 * stride, slope2);
    pumped_pendulum_put(check, pumped_pendulum_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void pumped_pendulum_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[PUMPED_PENDULUM_LANES];
    double state[2 * PUMPED_PENDULUM_LANES];
    double slope[2 * PUMPED_PENDULUM_LANES];
    pumped_pendulum_fill(left, count, t, y, time, state);
    pumped_pendulum_rhs_lanes(fixed, PUMPED_PENDULUM_LANES, time, state, slope, check);
    pumped_pendulum_pour(left, count, slope, dydt);
}
#endif

int pumped_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if PUMPED_PENDULUM_LANES >= 2
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */
    const double k1 = a * nu * nu;
    const double k2 = -1.0 / l;
    /* the mass matrix is singular, if m * (l * l) is 0 */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return pumped_pendulum_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {g, nu, k1, k2};
    double check[1 * PUMPED_PENDULUM_LANES];
    int status = PUMPED_PENDULUM_OK;
    for (size_t i = 0; i < count; i += PUMPED_PENDULUM_LANES) {
        const size_t left = count - i < PUMPED_PENDULUM_LANES ? count - i : PUMPED_PENDULUM_LANES;
        if (left == PUMPED_PENDULUM_LANES) {
            pumped_pendulum_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            pumped_pendulum_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!pumped_pendulum_is_good(1 * PUMPED_PENDULUM_LANES, check)) {
            const int one = pumped_pendulum_one_by_one(count, i, left, t, y, p, dydt);
            status = status == PUMPED_PENDULUM_OK ? one : status;
        }
    }
    return status;
#else
    return pumped_pendulum_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
