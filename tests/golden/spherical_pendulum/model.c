/*
 * spherical_pendulum.c: spherical_pendulum, emitted by nhc 0.1.0 (nhc:ddd18155c3336cc7)
 * A pendulum that swings in space.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * spherical_pendulum.h says what each function does.
 */
#include "spherical_pendulum.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const spherical_pendulum_coordinate_names[SPHERICAL_PENDULUM_NQ] = {
    "theta",
    "phi"
};
const char *const spherical_pendulum_state_names[SPHERICAL_PENDULUM_NY] = {
    "theta",
    "phi",
    "theta'",
    "phi'"
};
const char *const spherical_pendulum_parameter_names[SPHERICAL_PENDULUM_NP] = {
    "m",
    "l",
    "g"
};
const char *const spherical_pendulum_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const spherical_pendulum_output_names[SPHERICAL_PENDULUM_NOUT] = {
    "L_z"
};
const double spherical_pendulum_parameter_defaults[SPHERICAL_PENDULUM_NP] = {
    1.0,
    1.0,
    9.81
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int spherical_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return SPHERICAL_PENDULUM_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return SPHERICAL_PENDULUM_NOT_FINITE;
        }
    }
    return SPHERICAL_PENDULUM_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int spherical_pendulum_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : SPHERICAL_PENDULUM_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef SPHERICAL_PENDULUM_LANES
#if !defined(__GNUC__)
#define SPHERICAL_PENDULUM_LANES 1
#elif defined(__AVX512F__)
#define SPHERICAL_PENDULUM_LANES 8
#elif defined(__AVX__)
#define SPHERICAL_PENDULUM_LANES 4
#else
#define SPHERICAL_PENDULUM_LANES 2
#endif
#endif
#if SPHERICAL_PENDULUM_LANES > 1
typedef double spherical_pendulum_lanes __attribute__((vector_size(8 * SPHERICAL_PENDULUM_LANES)));
#else
typedef double spherical_pendulum_lanes;
#endif

#if SPHERICAL_PENDULUM_LANES >= 2
static inline spherical_pendulum_lanes spherical_pendulum_get(const double *from)
{
    spherical_pendulum_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void spherical_pendulum_put(double *to, spherical_pendulum_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int spherical_pendulum_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = SPHERICAL_PENDULUM_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[SPHERICAL_PENDULUM_NY];
        double slope[SPHERICAL_PENDULUM_NY];
        for (size_t k = 0; k < SPHERICAL_PENDULUM_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = spherical_pendulum_rhs(t[i], state, p, slope);
        status = status == SPHERICAL_PENDULUM_OK ? one : status;
        for (size_t k = 0; k < SPHERICAL_PENDULUM_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if SPHERICAL_PENDULUM_LANES >= 2
#define SPHERICAL_PENDULUM_SPREAD(x) ((x) - (spherical_pendulum_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long spherical_pendulum_bits __attribute__((vector_size(8 * SPHERICAL_PENDULUM_LANES)));

/* all bits where value is not above bound, or is no number */
static inline spherical_pendulum_bits spherical_pendulum_misses(spherical_pendulum_lanes value, spherical_pendulum_lanes bound)
{
    return ~(spherical_pendulum_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline spherical_pendulum_lanes spherical_pendulum_mark(spherical_pendulum_lanes value, spherical_pendulum_bits bad)
{
    return (spherical_pendulum_lanes)((spherical_pendulum_bits)value | bad);
}

static inline spherical_pendulum_lanes spherical_pendulum_size(spherical_pendulum_lanes x)
{
    return (spherical_pendulum_lanes)((spherical_pendulum_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int spherical_pendulum_is_good(int count, const double *check)
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
static inline void spherical_pendulum_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < SPHERICAL_PENDULUM_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < SPHERICAL_PENDULUM_NY; ++k) {
            state[k * SPHERICAL_PENDULUM_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void spherical_pendulum_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < SPHERICAL_PENDULUM_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * SPHERICAL_PENDULUM_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void spherical_pendulum_turn_lanes(spherical_pendulum_lanes x, spherical_pendulum_lanes *far,
    spherical_pendulum_lanes *sine, spherical_pendulum_lanes *cosine)
{
    double angle[SPHERICAL_PENDULUM_LANES];
    double up[SPHERICAL_PENDULUM_LANES];
    double along[SPHERICAL_PENDULUM_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < SPHERICAL_PENDULUM_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int spherical_pendulum_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double theta_dot = y[2]; /* theta' [rad/s] */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * l * l;
    const double k2 = g / l;

    /* from the state */
    /* (II.3) */
    dydt[0] = theta_dot; /* theta' */
    dydt[1] = phi_dot; /* phi' */
    /* (II.3) 13:4 */
    dydt[2] = s_theta * (phi_dot * phi_dot * c_theta - k2); /* theta'' */
    dydt[3] = -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta); /* phi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (dydt[2] + dydt[3]))) {
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return spherical_pendulum_refuse(fabs(k1), 0.0, SPHERICAL_PENDULUM_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 * (s_theta * s_theta) is 0 */
        if (!(fabs(k1 * (s_theta * s_theta)) > 0.0)) {
            return spherical_pendulum_refuse(fabs(k1 * (s_theta * s_theta)), 0.0,
                SPHERICAL_PENDULUM_SINGULAR_2);
        }
        return spherical_pendulum_finish(4, dydt);
    }
    return SPHERICAL_PENDULUM_OK;
}

int spherical_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double theta_dot = y[2]; /* theta' [rad/s] */
    qdot[0] = theta_dot; /* theta' */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    qdot[1] = phi_dot; /* phi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1]) <= DBL_MAX)) {
        return spherical_pendulum_finish(2, qdot);
    }
    return SPHERICAL_PENDULUM_OK;
}

int spherical_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double theta_dot = y[2]; /* theta' [rad/s] */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * l * l;
    const double k2 = g / l;

    /* from the state */
    /* (II.3) */
    qddot[0] = s_theta * (phi_dot * phi_dot * c_theta - k2); /* theta'' */
    qddot[1] = -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta); /* phi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (qddot[0] + qddot[1]))) {
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return spherical_pendulum_refuse(fabs(k1), 0.0, SPHERICAL_PENDULUM_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 * (s_theta * s_theta) is 0 */
        if (!(fabs(k1 * (s_theta * s_theta)) > 0.0)) {
            return spherical_pendulum_refuse(fabs(k1 * (s_theta * s_theta)), 0.0,
                SPHERICAL_PENDULUM_SINGULAR_2);
        }
        return spherical_pendulum_finish(2, qddot);
    }
    return SPHERICAL_PENDULUM_OK;
}

int spherical_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double theta = q[0]; /* angle from the downward vertical [rad] */
    y[0] = theta;
    const double phi = q[1]; /* azimuth [rad] */
    y[1] = phi;
    const double theta_dot = qdot[0]; /* theta' [rad/s] */
    y[2] = theta_dot;
    const double phi_dot = qdot[1]; /* phi' [rad/s] */
    y[3] = phi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3]) <= DBL_MAX)) {
        return spherical_pendulum_finish(4, y);
    }
    return SPHERICAL_PENDULUM_OK;
}

int spherical_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return SPHERICAL_PENDULUM_OK;
}

int spherical_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */

    /* from the parameters alone */
    const double k1 = m * l * l;

    /* from the state */
    /* the mass matrix is singular, if k1 is 0 */
    if (!(fabs(k1) > 0.0)) {
        return spherical_pendulum_refuse(fabs(k1), 0.0, SPHERICAL_PENDULUM_SINGULAR_2);
    }
    /* the mass matrix is singular, if k1 * (s_theta * s_theta) is 0 */
    if (!(fabs(k1 * (s_theta * s_theta)) > 0.0)) {
        return spherical_pendulum_refuse(fabs(k1 * (s_theta * s_theta)), 0.0, SPHERICAL_PENDULUM_SINGULAR_2);
    }
    (void)lambda;
    return SPHERICAL_PENDULUM_OK;
}

double spherical_pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double theta_dot = y[2]; /* theta' [rad/s] */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * l;

    /* from the state */
    return k1 * (0.5 * (l * (theta_dot * theta_dot + s_theta * s_theta * (phi_dot * phi_dot))) - g * c_theta);
}

int spherical_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 16 * sizeof *J);
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double theta_dot = y[2]; /* theta' [rad/s] */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * l * l;
    const double k2 = g / l;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = phi_dot * c_theta;
    const double z3 = 1.0 / s_theta;
    /* (II.3) */
    J[2] = 1.0;
    J[7] = 1.0;
    J[8] = phi_dot * phi_dot * (1.0 - 2.0 * z1) - c_theta * k2;
    J[11] = 2.0 * (s_theta * z2);
    J[12] = 2.0 * (theta_dot * phi_dot * (z3 * z3));
    J[14] = -2.0 * (z3 * z2);
    J[15] = -2.0 * (theta_dot * c_theta * z3);
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (J[8] + J[11] + J[12] + J[14] + J[15]))) {
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return spherical_pendulum_refuse(fabs(k1), 0.0, SPHERICAL_PENDULUM_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 * z1 is 0 */
        if (!(fabs(k1 * z1) > 0.0)) {
            return spherical_pendulum_refuse(fabs(k1 * z1), 0.0, SPHERICAL_PENDULUM_SINGULAR_2);
        }
        return spherical_pendulum_finish(16, J);
    }
    return SPHERICAL_PENDULUM_OK;
}

int spherical_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */

    /* from the parameters alone */
    const double k1 = m * l * l;

    /* from the state */
    /* 16:8 */
    out[0] = phi_dot * (k1 * (s_theta * s_theta)); /* L_z */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return spherical_pendulum_finish(1, out);
    }
    return SPHERICAL_PENDULUM_OK;
}

#if SPHERICAL_PENDULUM_LANES >= 2
static __attribute__((noinline)) void spherical_pendulum_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    spherical_pendulum_lanes far = {0}; /* the squares of the angles */
    spherical_pendulum_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    spherical_pendulum_bits bad = {0}; /* singular blocks */
    const double k1 = fixed[0];
    const double k2 = fixed[1];
    const spherical_pendulum_lanes theta = spherical_pendulum_get(y);
    const spherical_pendulum_lanes theta_dot = spherical_pendulum_get(y + 2 * stride);
    const spherical_pendulum_lanes phi_dot = spherical_pendulum_get(y + 3 * stride);
    spherical_pendulum_lanes sine1, cosine1;
    spherical_pendulum_turn_lanes(SPHERICAL_PENDULUM_SPREAD(theta), &far, &sine1, &cosine1);
    const spherical_pendulum_lanes s_theta = sine1;
    /* the mass matrix is singular, if k1 * (s_theta * s_theta) is 0 */
    bad |= spherical_pendulum_misses(spherical_pendulum_size(SPHERICAL_PENDULUM_SPREAD(k1 * (s_theta *
        s_theta))), SPHERICAL_PENDULUM_SPREAD(0.0));
    const spherical_pendulum_lanes c_theta = cosine1;
    /* (II.3) */
    const spherical_pendulum_lanes slope1 = theta_dot;
    spherical_pendulum_put(dydt, slope1);
    const spherical_pendulum_lanes slope2 = phi_dot;
    spherical_pendulum_put(dydt + 1 * stride, slope2);
    /* (II.3) 13:4 */
    const spherical_pendulum_lanes slope3 = s_theta * (phi_dot * phi_dot * c_theta - k2);
    sum += slope3;
    spherical_pendulum_put(dydt + 2 * stride, slope3);
    const spherical_pendulum_lanes slope4 = -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta);
    sum += slope4;
    spherical_pendulum_put(dydt + 3 * stride, slope4);
    spherical_pendulum_put(check, spherical_pendulum_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void spherical_pendulum_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[SPHERICAL_PENDULUM_LANES];
    double state[4 * SPHERICAL_PENDULUM_LANES];
    double slope[4 * SPHERICAL_PENDULUM_LANES];
    spherical_pendulum_fill(left, count, t, y, time, state);
    spherical_pendulum_rhs_lanes(fixed, SPHERICAL_PENDULUM_LANES, time, state, slope, check);
    spherical_pendulum_pour(left, count, slope, dydt);
}
#endif

int spherical_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if SPHERICAL_PENDULUM_LANES >= 2
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * l * l;
    const double k2 = g / l;
    const double fixed[] = {k1, k2};
    double check[1 * SPHERICAL_PENDULUM_LANES];
    int status = SPHERICAL_PENDULUM_OK;
    for (size_t i = 0; i < count; i += SPHERICAL_PENDULUM_LANES) {
        const size_t left = count - i < SPHERICAL_PENDULUM_LANES ? count - i : SPHERICAL_PENDULUM_LANES;
        if (left == SPHERICAL_PENDULUM_LANES) {
            spherical_pendulum_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            spherical_pendulum_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!spherical_pendulum_is_good(1 * SPHERICAL_PENDULUM_LANES, check)) {
            const int one = spherical_pendulum_one_by_one(count, i, left, t, y, p, dydt);
            status = status == SPHERICAL_PENDULUM_OK ? one : status;
        }
    }
    return status;
#else
    return spherical_pendulum_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
