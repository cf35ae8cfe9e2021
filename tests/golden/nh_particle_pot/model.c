/*
 * nh_particle_pot.c: nh_particle_pot, emitted by nhc 0.1.0 (nhc:06e88d1439501f8f)
 * The nonholonomic particle with springs in x and y.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * nh_particle_pot.h says what each function does.
 */
#include "nh_particle_pot.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const nh_particle_pot_coordinate_names[NH_PARTICLE_POT_NQ] = {
    "x",
    "y",
    "z"
};
const char *const nh_particle_pot_state_names[NH_PARTICLE_POT_NY] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const nh_particle_pot_parameter_names[NH_PARTICLE_POT_NP] = {
    "m",
    "k"
};
const char *const nh_particle_pot_constraint_names[NH_PARTICLE_POT_NC] = {
    "contact"
};
const char *const nh_particle_pot_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double nh_particle_pot_parameter_defaults[NH_PARTICLE_POT_NP] = {
    1.0,
    1.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int nh_particle_pot_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return NH_PARTICLE_POT_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return NH_PARTICLE_POT_NOT_FINITE;
        }
    }
    return NH_PARTICLE_POT_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int nh_particle_pot_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : NH_PARTICLE_POT_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef NH_PARTICLE_POT_LANES
#if !defined(__GNUC__)
#define NH_PARTICLE_POT_LANES 1
#elif defined(__AVX512F__)
#define NH_PARTICLE_POT_LANES 8
#elif defined(__AVX__)
#define NH_PARTICLE_POT_LANES 4
#else
#define NH_PARTICLE_POT_LANES 2
#endif
#endif
#if NH_PARTICLE_POT_LANES > 1
typedef double nh_particle_pot_lanes __attribute__((vector_size(8 * NH_PARTICLE_POT_LANES)));
#else
typedef double nh_particle_pot_lanes;
#endif

#if NH_PARTICLE_POT_LANES >= 2
static inline nh_particle_pot_lanes nh_particle_pot_get(const double *from)
{
    nh_particle_pot_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void nh_particle_pot_put(double *to, nh_particle_pot_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int nh_particle_pot_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = NH_PARTICLE_POT_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[NH_PARTICLE_POT_NY];
        double slope[NH_PARTICLE_POT_NY];
        for (size_t k = 0; k < NH_PARTICLE_POT_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = nh_particle_pot_rhs(t[i], state, p, slope);
        status = status == NH_PARTICLE_POT_OK ? one : status;
        for (size_t k = 0; k < NH_PARTICLE_POT_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if NH_PARTICLE_POT_LANES >= 2
#define NH_PARTICLE_POT_SPREAD(x) ((x) - (nh_particle_pot_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long nh_particle_pot_bits __attribute__((vector_size(8 * NH_PARTICLE_POT_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline nh_particle_pot_lanes nh_particle_pot_mark(nh_particle_pot_lanes value, nh_particle_pot_bits bad)
{
    return (nh_particle_pot_lanes)((nh_particle_pot_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int nh_particle_pot_is_good(int count, const double *check)
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
static inline void nh_particle_pot_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < NH_PARTICLE_POT_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < NH_PARTICLE_POT_NY; ++k) {
            state[k * NH_PARTICLE_POT_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void nh_particle_pot_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < NH_PARTICLE_POT_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * NH_PARTICLE_POT_LANES + l];
        }
    }
}
#endif

int nh_particle_pot_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0];
    const double k = p[1];
    const double k1 = -k / m;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = m * (1.0 + y_2 * y_2);
    const double x_dot = y[3]; /* x' */
    const double z2 = y_2 * x_dot;
    /* (I.1.2) */
    dydt[0] = x_dot; /* x' */
    const double y_dot = y[4]; /* y' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z2; /* z' */
    const double x = y[0];
    /* (III.3) 10:4 */
    dydt[3] = -(x * k + m * (y_dot * z2)) / z1; /* x'' */
    dydt[4] = y_2 * k1; /* y'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[3] + dydt[4]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_pot_refuse(fabs(m), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return nh_particle_pot_refuse(fabs(z1), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        return nh_particle_pot_finish(5, dydt);
    }
    return NH_PARTICLE_POT_OK;
}

int nh_particle_pot_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double x_dot = y[3]; /* x' */
    /* (I.1.2) */
    qdot[0] = x_dot; /* x' */
    const double y_dot = y[4]; /* y' */
    qdot[1] = y_dot; /* y' */
    const double y_2 = y[1]; /* y */
    qdot[2] = y_2 * x_dot; /* z' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2]) <= DBL_MAX)) {
        return nh_particle_pot_finish(3, qdot);
    }
    return NH_PARTICLE_POT_OK;
}

int nh_particle_pot_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0];
    const double k = p[1];
    const double k1 = -k / m;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = m * (1.0 + y_2 * y_2);
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */
    const double z2 = x_dot * y_dot;
    const double x = y[0];
    const double z3 = (x * k + m * (y_2 * z2)) / z1;
    /* (III.3) */
    qddot[0] = -z3; /* x'' */
    qddot[1] = y_2 * k1; /* y'' */
    qddot[2] = z2 - y_2 * z3; /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[1] + qddot[2]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_pot_refuse(fabs(m), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return nh_particle_pot_refuse(fabs(z1), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        return nh_particle_pot_finish(3, qddot);
    }
    return NH_PARTICLE_POT_OK;
}

int nh_particle_pot_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
        return nh_particle_pot_finish(5, y);
    }
    return NH_PARTICLE_POT_OK;
}

int nh_particle_pot_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double y = q[1];
    const double x_dot = qdot[0]; /* x' */
    const double z_dot = qdot[2]; /* z' */
    /* (I.1.1) 13:5 */
    r[0] = z_dot - y * x_dot; /* contact = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return nh_particle_pot_finish(1, r);
    }
    return NH_PARTICLE_POT_OK;
}

int nh_particle_pot_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double m = p[0];
    const double z1 = m * (1.0 + y_2 * y_2);
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */
    const double z2 = x_dot * y_dot;
    const double x = y[0];
    const double k = p[1];
    /* (I.4.1) 13:5 */
    /* reaction of contact: Q_i gains lambda_1 a_1i */
    lambda[0] = m * (z2 - y_2 * (x * k + m * (y_2 * z2)) / z1);
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_pot_refuse(fabs(m), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return nh_particle_pot_refuse(fabs(z1), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        return nh_particle_pot_finish(1, lambda);
    }
    return NH_PARTICLE_POT_OK;
}

double nh_particle_pot_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = y_2 * y_2;
    const double x = y[0];
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */
    const double m = p[0];
    const double k = p[1];
    const double z2 = 0.5 * (k * (x * x + z1) + m * (y_dot * y_dot + x_dot * x_dot * (1.0 + z1)));
    return z2;
}

int nh_particle_pot_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double m = p[0];
    const double z1 = m * (1.0 + y_2 * y_2);
    const double z2 = 1.0 / z1;
    const double y_dot = y[4]; /* y' */
    const double z3 = y_dot * m;
    const double z4 = y_2 * z2;
    const double x_dot = y[3]; /* x' */
    const double z5 = y_2 * x_dot;
    /* (III.3) */
    J[3] = 1.0;
    J[9] = 1.0;
    J[11] = x_dot;
    J[13] = y_2;
    const double k = p[1];
    J[15] = -k * z2;
    const double x = y[0];
    J[16] = (2.0 * (m * (z4 * (x * k + z5 * z3))) - x_dot * z3) * z2;
    J[18] = -z3 * z4;
    J[19] = -m * (z5 * z2);
    J[21] = -k / m;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[15] + J[16] + J[18] + J[19] + J[21]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_pot_refuse(fabs(m), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return nh_particle_pot_refuse(fabs(z1), 0.0, NH_PARTICLE_POT_SINGULAR_2);
        }
        return nh_particle_pot_finish(25, J);
    }
    return NH_PARTICLE_POT_OK;
}

int nh_particle_pot_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return NH_PARTICLE_POT_OK;
}

#if NH_PARTICLE_POT_LANES >= 2
static __attribute__((noinline)) void nh_particle_pot_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    nh_particle_pot_lanes far = {0}; /* the squares of the angles */
    nh_particle_pot_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    nh_particle_pot_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double k = fixed[1];
    const double k1 = fixed[2];
    const nh_particle_pot_lanes x = nh_particle_pot_get(y);
    const nh_particle_pot_lanes y_2 = nh_particle_pot_get(y + 1 * stride);
    const nh_particle_pot_lanes x_dot = nh_particle_pot_get(y + 3 * stride);
    const nh_particle_pot_lanes y_dot = nh_particle_pot_get(y + 4 * stride);
    const nh_particle_pot_lanes z1 = m * (1.0 + y_2 * y_2);
    const nh_particle_pot_lanes z2 = y_2 * x_dot;
    /* (I.1.2) */
    const nh_particle_pot_lanes slope1 = x_dot;
    nh_particle_pot_put(dydt, slope1);
    const nh_particle_pot_lanes slope2 = y_dot;
    nh_particle_pot_put(dydt + 1 * stride, slope2);
    const nh_particle_pot_lanes slope3 = z2;
    nh_particle_pot_put(dydt + 2 * stride, slope3);
    /* (III.3) 10:4 */
    const nh_particle_pot_lanes slope4 = -(x * k + m * (y_dot * z2)) / z1;
    sum += slope4;
    nh_particle_pot_put(dydt + 3 * stride, slope4);
    const nh_particle_pot_lanes slope5 = y_2 * k1;
    sum += slope5;
    nh_particle_pot_put(dydt + 4 * stride, slope5);
    nh_particle_pot_put(check, nh_particle_pot_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void nh_particle_pot_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[NH_PARTICLE_POT_LANES];
    double state[5 * NH_PARTICLE_POT_LANES];
    double slope[5 * NH_PARTICLE_POT_LANES];
    nh_particle_pot_fill(left, count, t, y, time, state);
    nh_particle_pot_rhs_lanes(fixed, NH_PARTICLE_POT_LANES, time, state, slope, check);
    nh_particle_pot_pour(left, count, slope, dydt);
}
#endif

int nh_particle_pot_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if NH_PARTICLE_POT_LANES >= 2
    const double m = p[0];
    const double k = p[1];
    const double k1 = -k / m;
    const double fixed[] = {m, k, k1};
    double check[1 * NH_PARTICLE_POT_LANES];
    int status = NH_PARTICLE_POT_OK;
    for (size_t i = 0; i < count; i += NH_PARTICLE_POT_LANES) {
        const size_t left = count - i < NH_PARTICLE_POT_LANES ? count - i : NH_PARTICLE_POT_LANES;
        if (left == NH_PARTICLE_POT_LANES) {
            nh_particle_pot_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            nh_particle_pot_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!nh_particle_pot_is_good(1 * NH_PARTICLE_POT_LANES, check)) {
            const int one = nh_particle_pot_one_by_one(count, i, left, t, y, p, dydt);
            status = status == NH_PARTICLE_POT_OK ? one : status;
        }
    }
    return status;
#else
    return nh_particle_pot_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
