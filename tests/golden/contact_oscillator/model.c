/*
 * contact_oscillator.c: contact_oscillator, emitted by nhc 0.1.0 (nhc:dffc3e24516f833a)
 * Three equal oscillators with one contact constraint; reversible and integrable.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x`
 * contact_oscillator.h says what each function does.
 */
#include "contact_oscillator.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const contact_oscillator_coordinate_names[CONTACT_OSCILLATOR_NQ] = {
    "x",
    "y",
    "z"
};
const char *const contact_oscillator_state_names[CONTACT_OSCILLATOR_NY] = {
    "x",
    "y",
    "z",
    "y'",
    "z'"
};
const char *const contact_oscillator_parameter_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const contact_oscillator_constraint_names[CONTACT_OSCILLATOR_NC] = {
    "contact"
};
const char *const contact_oscillator_output_names[CONTACT_OSCILLATOR_NOUT] = {
    "H_y",
    "R"
};
const double contact_oscillator_parameter_defaults[1] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int contact_oscillator_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CONTACT_OSCILLATOR_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CONTACT_OSCILLATOR_NOT_FINITE;
        }
    }
    return CONTACT_OSCILLATOR_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int contact_oscillator_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CONTACT_OSCILLATOR_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CONTACT_OSCILLATOR_LANES
#if !defined(__GNUC__)
#define CONTACT_OSCILLATOR_LANES 1
#elif defined(__AVX512F__)
#define CONTACT_OSCILLATOR_LANES 8
#elif defined(__AVX__)
#define CONTACT_OSCILLATOR_LANES 4
#else
#define CONTACT_OSCILLATOR_LANES 2
#endif
#endif
#if CONTACT_OSCILLATOR_LANES > 1
typedef double contact_oscillator_lanes __attribute__((vector_size(8 * CONTACT_OSCILLATOR_LANES)));
#else
typedef double contact_oscillator_lanes;
#endif

#if CONTACT_OSCILLATOR_LANES >= 2
static inline contact_oscillator_lanes contact_oscillator_get(const double *from)
{
    contact_oscillator_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void contact_oscillator_put(double *to, contact_oscillator_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int contact_oscillator_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CONTACT_OSCILLATOR_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CONTACT_OSCILLATOR_NY];
        double slope[CONTACT_OSCILLATOR_NY];
        for (size_t k = 0; k < CONTACT_OSCILLATOR_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = contact_oscillator_rhs(t[i], state, p, slope);
        status = status == CONTACT_OSCILLATOR_OK ? one : status;
        for (size_t k = 0; k < CONTACT_OSCILLATOR_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CONTACT_OSCILLATOR_LANES >= 2
#define CONTACT_OSCILLATOR_SPREAD(x) ((x) - (contact_oscillator_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long contact_oscillator_bits __attribute__((vector_size(8 * CONTACT_OSCILLATOR_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline contact_oscillator_lanes contact_oscillator_mark(contact_oscillator_lanes value, contact_oscillator_bits bad)
{
    return (contact_oscillator_lanes)((contact_oscillator_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int contact_oscillator_is_good(int count, const double *check)
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
static inline void contact_oscillator_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CONTACT_OSCILLATOR_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CONTACT_OSCILLATOR_NY; ++k) {
            state[k * CONTACT_OSCILLATOR_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void contact_oscillator_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CONTACT_OSCILLATOR_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CONTACT_OSCILLATOR_LANES + l];
        }
    }
}
#endif

int contact_oscillator_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double z_dot = y[4]; /* z' */
    /* (I.1.2) */
    dydt[0] = -y_2 * z_dot; /* x' */
    const double y_dot = y[3]; /* y' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z_dot; /* z' */
    /* (III.3) 7:4 */
    dydt[3] = -y_2; /* y'' */
    const double x = y[0];
    const double z = y[2];
    dydt[4] = (y_2 * (x - y_dot * z_dot) - z) / z1; /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[4]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_SINGULAR_2);
        }
        return contact_oscillator_finish(5, dydt);
    }
    return CONTACT_OSCILLATOR_OK;
}

int contact_oscillator_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z_dot = y[4]; /* z' */
    /* (I.1.2) */
    qdot[0] = -y_2 * z_dot; /* x' */
    const double y_dot = y[3]; /* y' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = z_dot; /* z' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1]) <= DBL_MAX)) {
        return contact_oscillator_finish(3, qdot);
    }
    return CONTACT_OSCILLATOR_OK;
}

int contact_oscillator_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double y_dot = y[3]; /* y' */
    const double z_dot = y[4]; /* z' */
    const double z2 = y_dot * z_dot;
    const double x = y[0];
    const double z = y[2];
    const double z3 = (z - y_2 * (x - z2)) / z1;
    /* (III.3) */
    qddot[0] = y_2 * z3 - z2; /* x'' */
    qddot[1] = -y_2; /* y'' */
    qddot[2] = -z3; /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[2]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_SINGULAR_2);
        }
        return contact_oscillator_finish(3, qddot);
    }
    return CONTACT_OSCILLATOR_OK;
}

int contact_oscillator_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
    const double y_dot = qdot[1]; /* y' */
    y[3] = y_dot;
    const double z_dot = qdot[2]; /* z' */
    y[4] = z_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4]) <= DBL_MAX)) {
        return contact_oscillator_finish(5, y);
    }
    return CONTACT_OSCILLATOR_OK;
}

int contact_oscillator_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double y = q[1];
    const double x_dot = qdot[0]; /* x' */
    const double z_dot = qdot[2]; /* z' */
    /* (I.1.1) 10:5 */
    r[0] = x_dot + y * z_dot; /* contact = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return contact_oscillator_finish(1, r);
    }
    return CONTACT_OSCILLATOR_OK;
}

int contact_oscillator_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double x = y[0];
    const double z = y[2];
    const double y_dot = y[3]; /* y' */
    const double z_dot = y[4]; /* z' */
    /* (I.4.1) 10:5 */
    lambda[0] = (x + y_2 * z - y_dot * z_dot) / z1; /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_SINGULAR_2);
        }
        return contact_oscillator_finish(1, lambda);
    }
    return CONTACT_OSCILLATOR_OK;
}

double contact_oscillator_energy(double t, const double *y, const double *p)
{
    (void)t;
    (void)p;

    /* from the state */
    const double z_dot = y[4]; /* z' */
    const double z1 = z_dot * z_dot;
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double z = y[2];
    const double y_dot = y[3]; /* y' */
    const double z2 = 0.5 * (y_2 * y_2 * (1.0 + z1) + (z1 + (y_dot * y_dot + (x * x + z * z))));
    return z2;
}

int contact_oscillator_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;
    (void)p;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double z2 = 1.0 / z1;
    const double z3 = y_2 * z2;
    const double x = y[0];
    const double y_dot = y[3]; /* y' */
    const double z_dot = y[4]; /* z' */
    const double z4 = x - y_dot * z_dot;
    /* (III.3) */
    J[1] = -z_dot;
    J[4] = -y_2;
    J[8] = 1.0;
    J[14] = 1.0;
    J[16] = -1.0;
    J[20] = z3;
    const double z = y[2];
    J[21] = z2 * (z4 + 2.0 * ((z - y_2 * z4) * z3));
    J[22] = -z2;
    J[23] = -z_dot * z3;
    J[24] = -y_dot * z3;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[21] + J[23] + J[24]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_SINGULAR_2);
        }
        return contact_oscillator_finish(25, J);
    }
    return CONTACT_OSCILLATOR_OK;
}

int contact_oscillator_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = y_2 * y_2;
    const double y_dot = y[3]; /* y' */
    /* 13:8 */
    out[0] = 0.5 * (y_dot * y_dot + z1); /* H_y */
    const double x = y[0];
    const double z = y[2];
    const double z_dot = y[4]; /* z' */
    /* 14:6 */
    out[1] = 0.5 * (x * x + z * z + z_dot * z_dot * (1.0 + z1)); /* R */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return contact_oscillator_finish(2, out);
    }
    return CONTACT_OSCILLATOR_OK;
}

#if CONTACT_OSCILLATOR_LANES >= 2
static __attribute__((noinline)) void contact_oscillator_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    (void)fixed;
    contact_oscillator_lanes far = {0}; /* the squares of the angles */
    contact_oscillator_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    contact_oscillator_bits bad = {0}; /* singular blocks */
    const contact_oscillator_lanes x = contact_oscillator_get(y);
    const contact_oscillator_lanes y_2 = contact_oscillator_get(y + 1 * stride);
    const contact_oscillator_lanes z = contact_oscillator_get(y + 2 * stride);
    const contact_oscillator_lanes y_dot = contact_oscillator_get(y + 3 * stride);
    const contact_oscillator_lanes z_dot = contact_oscillator_get(y + 4 * stride);
    const contact_oscillator_lanes z1 = 1.0 + y_2 * y_2;
    /* (I.1.2) */
    const contact_oscillator_lanes slope1 = -y_2 * z_dot;
    sum += slope1;
    contact_oscillator_put(dydt, slope1);
    const contact_oscillator_lanes slope2 = y_dot;
    contact_oscillator_put(dydt + 1 * stride, slope2);
    const contact_oscillator_lanes slope3 = z_dot;
    contact_oscillator_put(dydt + 2 * stride, slope3);
    /* (III.3) 7:4 */
    const contact_oscillator_lanes slope4 = -y_2;
    contact_oscillator_put(dydt + 3 * stride, slope4);
    const contact_oscillator_lanes slope5 = (y_2 * (x - y_dot * z_dot) - z) / z1;
    sum += slope5;
    contact_oscillator_put(dydt + 4 * stride, slope5);
    contact_oscillator_put(check, contact_oscillator_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void contact_oscillator_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CONTACT_OSCILLATOR_LANES];
    double state[5 * CONTACT_OSCILLATOR_LANES];
    double slope[5 * CONTACT_OSCILLATOR_LANES];
    contact_oscillator_fill(left, count, t, y, time, state);
    contact_oscillator_rhs_lanes(fixed, CONTACT_OSCILLATOR_LANES, time, state, slope, check);
    contact_oscillator_pour(left, count, slope, dydt);
}
#endif

int contact_oscillator_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if CONTACT_OSCILLATOR_LANES >= 2
    const double *fixed = p;
    double check[1 * CONTACT_OSCILLATOR_LANES];
    int status = CONTACT_OSCILLATOR_OK;
    for (size_t i = 0; i < count; i += CONTACT_OSCILLATOR_LANES) {
        const size_t left = count - i < CONTACT_OSCILLATOR_LANES ? count - i : CONTACT_OSCILLATOR_LANES;
        if (left == CONTACT_OSCILLATOR_LANES) {
            contact_oscillator_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            contact_oscillator_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!contact_oscillator_is_good(1 * CONTACT_OSCILLATOR_LANES, check)) {
            const int one = contact_oscillator_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CONTACT_OSCILLATOR_OK ? one : status;
        }
    }
    return status;
#else
    return contact_oscillator_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
