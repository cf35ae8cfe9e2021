/*
 * nh_particle.c: nh_particle, emitted by nhc 0.1.0 (nhc:453e34b4df80ded1)
 * A free particle with one velocity constraint that cannot be integrated.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * nh_particle.h says what each function does.
 */
#include "nh_particle.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const nh_particle_coordinate_names[NH_PARTICLE_NQ] = {
    "x",
    "y",
    "z"
};
const char *const nh_particle_state_names[NH_PARTICLE_NY] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const nh_particle_parameter_names[NH_PARTICLE_NP] = {
    "m"
};
const char *const nh_particle_constraint_names[NH_PARTICLE_NC] = {
    "contact"
};
const char *const nh_particle_output_names[NH_PARTICLE_NOUT] = {
    "p_x"
};
const double nh_particle_parameter_defaults[NH_PARTICLE_NP] = {
    1.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int nh_particle_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return NH_PARTICLE_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return NH_PARTICLE_NOT_FINITE;
        }
    }
    return NH_PARTICLE_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int nh_particle_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : NH_PARTICLE_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef NH_PARTICLE_LANES
#if !defined(__GNUC__)
#define NH_PARTICLE_LANES 1
#elif defined(__AVX512F__)
#define NH_PARTICLE_LANES 8
#elif defined(__AVX__)
#define NH_PARTICLE_LANES 4
#else
#define NH_PARTICLE_LANES 2
#endif
#endif
#if NH_PARTICLE_LANES > 1
typedef double nh_particle_lanes __attribute__((vector_size(8 * NH_PARTICLE_LANES)));
#else
typedef double nh_particle_lanes;
#endif

#if NH_PARTICLE_LANES >= 2
static inline nh_particle_lanes nh_particle_get(const double *from)
{
    nh_particle_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void nh_particle_put(double *to, nh_particle_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int nh_particle_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = NH_PARTICLE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[NH_PARTICLE_NY];
        double slope[NH_PARTICLE_NY];
        for (size_t k = 0; k < NH_PARTICLE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = nh_particle_rhs(t[i], state, p, slope);
        status = status == NH_PARTICLE_OK ? one : status;
        for (size_t k = 0; k < NH_PARTICLE_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if NH_PARTICLE_LANES >= 2
#define NH_PARTICLE_SPREAD(x) ((x) - (nh_particle_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long nh_particle_bits __attribute__((vector_size(8 * NH_PARTICLE_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline nh_particle_lanes nh_particle_mark(nh_particle_lanes value, nh_particle_bits bad)
{
    return (nh_particle_lanes)((nh_particle_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int nh_particle_is_good(int count, const double *check)
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
static inline void nh_particle_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < NH_PARTICLE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < NH_PARTICLE_NY; ++k) {
            state[k * NH_PARTICLE_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void nh_particle_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < NH_PARTICLE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * NH_PARTICLE_LANES + l];
        }
    }
}
#endif

int nh_particle_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double m = p[0];
    const double z1 = m * (1.0 + y_2 * y_2);
    const double x_dot = y[3]; /* x' */
    const double z2 = y_2 * x_dot;
    /* (I.1.2) */
    dydt[0] = x_dot; /* x' */
    const double y_dot = y[4]; /* y' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z2; /* z' */
    /* (III.3) 9:4 */
    dydt[3] = -m * (y_dot * z2) / z1; /* x'' */
    dydt[4] = 0.0; /* y'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[3]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_refuse(fabs(m), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return nh_particle_refuse(fabs(z1), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        return nh_particle_finish(5, dydt);
    }
    return NH_PARTICLE_OK;
}

int nh_particle_velocities(double t, const double *y, const double *p, double *qdot)
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
        return nh_particle_finish(3, qdot);
    }
    return NH_PARTICLE_OK;
}

int nh_particle_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double m = p[0];
    const double z1 = m * (1.0 + y_2 * y_2);
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */
    const double z2 = x_dot * y_dot;
    const double z3 = m * (y_2 * z2 / z1);
    /* (III.3) */
    qddot[0] = -z3; /* x'' */
    qddot[1] = 0.0; /* y'' */
    qddot[2] = z2 - y_2 * z3; /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[2]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_refuse(fabs(m), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return nh_particle_refuse(fabs(z1), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        return nh_particle_finish(3, qddot);
    }
    return NH_PARTICLE_OK;
}

int nh_particle_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
        return nh_particle_finish(5, y);
    }
    return NH_PARTICLE_OK;
}

int nh_particle_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double y = q[1];
    const double x_dot = qdot[0]; /* x' */
    const double z_dot = qdot[2]; /* z' */
    /* (I.1.1) 11:5 */
    r[0] = z_dot - y * x_dot; /* contact = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return nh_particle_finish(1, r);
    }
    return NH_PARTICLE_OK;
}

int nh_particle_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = y_2 * y_2;
    const double m = p[0];
    const double z2 = m * (1.0 + z1);
    const double x_dot = y[3]; /* x' */
    const double y_dot = y[4]; /* y' */
    /* (I.4.1) 11:5 */
    lambda[0] = m * (x_dot * y_dot) * (1.0 - m * z1 / z2); /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_refuse(fabs(m), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return nh_particle_refuse(fabs(z2), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        return nh_particle_finish(1, lambda);
    }
    return NH_PARTICLE_OK;
}

double nh_particle_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double z1 = y_2 * x_dot;
    const double y_dot = y[4]; /* y' */
    const double m = p[0];
    return 0.5 * (m * (x_dot * x_dot + y_dot * y_dot + z1 * z1));
}

int nh_particle_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = y_2 * y_2;
    const double m = p[0];
    const double z2 = m * (1.0 + z1);
    const double z3 = m / z2;
    const double z4 = y_2 * z3;
    /* (III.3) */
    J[3] = 1.0;
    J[9] = 1.0;
    const double x_dot = y[3]; /* x' */
    J[11] = x_dot;
    J[13] = y_2;
    const double y_dot = y[4]; /* y' */
    J[16] = (2.0 * (z1 * z3) - 1.0) * (y_dot * (x_dot * z3));
    J[18] = -y_dot * z4;
    J[19] = -x_dot * z4;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[16] + J[18] + J[19]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return nh_particle_refuse(fabs(m), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return nh_particle_refuse(fabs(z2), 0.0, NH_PARTICLE_SINGULAR_2);
        }
        return nh_particle_finish(25, J);
    }
    return NH_PARTICLE_OK;
}

int nh_particle_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double m = p[0];
    /* 14:8 */
    out[0] = m * (x_dot + y_2 * (y_2 * x_dot)); /* p_x */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return nh_particle_finish(1, out);
    }
    return NH_PARTICLE_OK;
}

#if NH_PARTICLE_LANES >= 2
static __attribute__((noinline)) void nh_particle_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    nh_particle_lanes far = {0}; /* the squares of the angles */
    nh_particle_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    nh_particle_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const nh_particle_lanes y_2 = nh_particle_get(y + 1 * stride);
    const nh_particle_lanes x_dot = nh_particle_get(y + 3 * stride);
    const nh_particle_lanes y_dot = nh_particle_get(y + 4 * stride);
    const nh_particle_lanes z1 = m * (1.0 + y_2 * y_2);
    const nh_particle_lanes z2 = y_2 * x_dot;
    /* (I.1.2) */
    const nh_particle_lanes slope1 = x_dot;
    nh_particle_put(dydt, slope1);
    const nh_particle_lanes slope2 = y_dot;
    nh_particle_put(dydt + 1 * stride, slope2);
    const nh_particle_lanes slope3 = z2;
    nh_particle_put(dydt + 2 * stride, slope3);
    /* (III.3) 9:4 */
    const nh_particle_lanes slope4 = -m * (y_dot * z2) / z1;
    sum += slope4;
    nh_particle_put(dydt + 3 * stride, slope4);
    const nh_particle_lanes slope5 = NH_PARTICLE_SPREAD(0.0);
    nh_particle_put(dydt + 4 * stride, slope5);
    nh_particle_put(check, nh_particle_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void nh_particle_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[NH_PARTICLE_LANES];
    double state[5 * NH_PARTICLE_LANES];
    double slope[5 * NH_PARTICLE_LANES];
    nh_particle_fill(left, count, t, y, time, state);
    nh_particle_rhs_lanes(fixed, NH_PARTICLE_LANES, time, state, slope, check);
    nh_particle_pour(left, count, slope, dydt);
}
#endif

int nh_particle_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if NH_PARTICLE_LANES >= 2
    const double m = p[0];
    const double fixed[] = {m};
    double check[1 * NH_PARTICLE_LANES];
    int status = NH_PARTICLE_OK;
    for (size_t i = 0; i < count; i += NH_PARTICLE_LANES) {
        const size_t left = count - i < NH_PARTICLE_LANES ? count - i : NH_PARTICLE_LANES;
        if (left == NH_PARTICLE_LANES) {
            nh_particle_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            nh_particle_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!nh_particle_is_good(1 * NH_PARTICLE_LANES, check)) {
            const int one = nh_particle_one_by_one(count, i, left, t, y, p, dydt);
            status = status == NH_PARTICLE_OK ? one : status;
        }
    }
    return status;
#else
    return nh_particle_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
