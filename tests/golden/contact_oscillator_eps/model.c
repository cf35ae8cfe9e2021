/*
 * contact_oscillator_eps.c: contact_oscillator_eps, emitted by nhc 0.1.0 (nhc:292239e1fc849649)
 * The contact oscillator with a quartic coupling; still reversible and still with a second integral.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `z` contains the
 *     dependent coordinate `x`
 * contact_oscillator_eps.h says what each function does.
 */
#include "contact_oscillator_eps.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const contact_oscillator_eps_coordinate_names[CONTACT_OSCILLATOR_EPS_NQ] = {
    "x",
    "y",
    "z"
};
const char *const contact_oscillator_eps_state_names[CONTACT_OSCILLATOR_EPS_NY] = {
    "x",
    "y",
    "z",
    "y'",
    "z'"
};
const char *const contact_oscillator_eps_parameter_names[CONTACT_OSCILLATOR_EPS_NP] = {
    "eps"
};
const char *const contact_oscillator_eps_constraint_names[CONTACT_OSCILLATOR_EPS_NC] = {
    "contact"
};
const char *const contact_oscillator_eps_output_names[CONTACT_OSCILLATOR_EPS_NOUT] = {
    "H_y",
    "R"
};
const double contact_oscillator_eps_parameter_defaults[CONTACT_OSCILLATOR_EPS_NP] = {
    0.3
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int contact_oscillator_eps_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CONTACT_OSCILLATOR_EPS_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CONTACT_OSCILLATOR_EPS_NOT_FINITE;
        }
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int contact_oscillator_eps_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CONTACT_OSCILLATOR_EPS_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CONTACT_OSCILLATOR_EPS_LANES
#if !defined(__GNUC__)
#define CONTACT_OSCILLATOR_EPS_LANES 1
#elif defined(__AVX512F__)
#define CONTACT_OSCILLATOR_EPS_LANES 8
#elif defined(__AVX__)
#define CONTACT_OSCILLATOR_EPS_LANES 4
#else
#define CONTACT_OSCILLATOR_EPS_LANES 2
#endif
#endif
#if CONTACT_OSCILLATOR_EPS_LANES > 1
typedef double contact_oscillator_eps_lanes __attribute__((vector_size(8 * CONTACT_OSCILLATOR_EPS_LANES)));
#else
typedef double contact_oscillator_eps_lanes;
#endif

#if CONTACT_OSCILLATOR_EPS_LANES >= 2
static inline contact_oscillator_eps_lanes contact_oscillator_eps_get(const double *from)
{
    contact_oscillator_eps_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void contact_oscillator_eps_put(double *to, contact_oscillator_eps_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int contact_oscillator_eps_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CONTACT_OSCILLATOR_EPS_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CONTACT_OSCILLATOR_EPS_NY];
        double slope[CONTACT_OSCILLATOR_EPS_NY];
        for (size_t k = 0; k < CONTACT_OSCILLATOR_EPS_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = contact_oscillator_eps_rhs(t[i], state, p, slope);
        status = status == CONTACT_OSCILLATOR_EPS_OK ? one : status;
        for (size_t k = 0; k < CONTACT_OSCILLATOR_EPS_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CONTACT_OSCILLATOR_EPS_LANES >= 2
#define CONTACT_OSCILLATOR_EPS_SPREAD(x) ((x) - (contact_oscillator_eps_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long contact_oscillator_eps_bits __attribute__((vector_size(8 * CONTACT_OSCILLATOR_EPS_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline contact_oscillator_eps_lanes contact_oscillator_eps_mark(contact_oscillator_eps_lanes value, contact_oscillator_eps_bits bad)
{
    return (contact_oscillator_eps_lanes)((contact_oscillator_eps_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int contact_oscillator_eps_is_good(int count, const double *check)
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
static inline void contact_oscillator_eps_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CONTACT_OSCILLATOR_EPS_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CONTACT_OSCILLATOR_EPS_NY; ++k) {
            state[k * CONTACT_OSCILLATOR_EPS_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void contact_oscillator_eps_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CONTACT_OSCILLATOR_EPS_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CONTACT_OSCILLATOR_EPS_LANES + l];
        }
    }
}
#endif

int contact_oscillator_eps_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double z_dot = y[4]; /* z' */
    const double z2 = y_2 * z_dot;
    const double x = y[0];
    const double z = y[2];
    const double y_dot = y[3]; /* y' */
    const double eps = p[0]; /* strength of the coupling */
    const double z3 = x * (y_2 * (1.0 + eps * (z * z)) - eps * (x * z)) - (z + y_dot * z2);
    /* (I.1.2) */
    dydt[0] = -z2; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z_dot; /* z' */
    /* (III.3) 9:4 */
    dydt[3] = -y_2; /* y'' */
    dydt[4] = z3 / z1; /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[4]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_eps_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_EPS_SINGULAR_2);
        }
        return contact_oscillator_eps_finish(5, dydt);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

int contact_oscillator_eps_velocities(double t, const double *y, const double *p, double *qdot)
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
        return contact_oscillator_eps_finish(3, qdot);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

int contact_oscillator_eps_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double y_dot = y[3]; /* y' */
    const double z_dot = y[4]; /* z' */
    const double z2 = y_dot * z_dot;
    const double x = y[0];
    const double z = y[2];
    const double eps = p[0]; /* strength of the coupling */
    const double z3 = x * (y_2 * (1.0 + eps * (z * z)) - eps * (x * z)) - (z + y_2 * z2);
    const double z4 = z3 / z1;
    /* (III.3) */
    qddot[0] = -(z2 + y_2 * z4); /* x'' */
    qddot[1] = -y_2; /* y'' */
    qddot[2] = z4; /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_eps_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_EPS_SINGULAR_2);
        }
        return contact_oscillator_eps_finish(3, qddot);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

int contact_oscillator_eps_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
        return contact_oscillator_eps_finish(5, y);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

int contact_oscillator_eps_residuals(double t, const double *q, const double *qdot, const double *p,
    double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double y = q[1];
    const double x_dot = qdot[0]; /* x' */
    const double z_dot = qdot[2]; /* z' */
    /* (I.1.1) 12:5 */
    r[0] = x_dot + y * z_dot; /* contact = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return contact_oscillator_eps_finish(1, r);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

int contact_oscillator_eps_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double x = y[0];
    const double z = y[2];
    const double y_dot = y[3]; /* y' */
    const double z_dot = y[4]; /* z' */
    const double eps = p[0]; /* strength of the coupling */
    const double z2 = (x * (1.0 + z * eps * (z + x * y_2)) - (y_dot * z_dot - y_2 * z)) / z1;
    /* (I.4.1) 12:5 */
    lambda[0] = z2; /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_eps_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_EPS_SINGULAR_2);
        }
        return contact_oscillator_eps_finish(1, lambda);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

double contact_oscillator_eps_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double z = y[2];
    const double z1 = z * z;
    const double z_dot = y[4]; /* z' */
    const double z2 = z_dot * z_dot;
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double y_dot = y[3]; /* y' */
    const double eps = p[0]; /* strength of the coupling */
    const double z3 = x * x * (1.0 + eps * z1) + (y_2 * y_2 * (1.0 + z2) + (z2 + (y_dot * y_dot + z1)));
    return 0.5 * z3;
}

int contact_oscillator_eps_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = 1.0 + y_2 * y_2;
    const double z2 = 1.0 / z1;
    const double x = y[0];
    const double eps = p[0]; /* strength of the coupling */
    const double z3 = x * eps;
    const double z = y[2];
    const double z4 = z * z3;
    const double z5 = 1.0 + eps * (z * z);
    const double z6 = y_2 * z5;
    const double y_dot = y[3]; /* y' */
    const double z7 = y_2 * y_dot;
    const double z_dot = y[4]; /* z' */
    const double z8 = y_dot * z_dot - x * z5 - 2.0 * (z2 * (y_2 * (z + z_dot * z7 + x * (z4 - z6))));
    /* (III.3) */
    J[1] = -z_dot;
    J[4] = -y_2;
    J[8] = 1.0;
    J[14] = 1.0;
    J[16] = -1.0;
    J[20] = (z6 - 2.0 * z4) * z2;
    J[21] = -z2 * z8;
    J[22] = -z2 * (1.0 + z3 * (x - 2.0 * (y_2 * z)));
    J[23] = -y_2 * z_dot * z2;
    J[24] = -z7 * z2;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[20] + J[21] + J[22] + J[23] + J[24]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return contact_oscillator_eps_refuse(fabs(z1), 0.0, CONTACT_OSCILLATOR_EPS_SINGULAR_2);
        }
        return contact_oscillator_eps_finish(25, J);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

int contact_oscillator_eps_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;

    /* from the state */
    const double y_2 = y[1]; /* y */
    const double z1 = y_2 * y_2;
    const double x = y[0];
    const double z2 = x * x;
    const double y_dot = y[3]; /* y' */
    /* 15:8 */
    out[0] = 0.5 * (y_dot * y_dot + z1); /* H_y */
    const double z = y[2];
    const double z_dot = y[4]; /* z' */
    const double eps = p[0]; /* strength of the coupling */
    /* 16:6 */
    out[1] = 0.5 * (z2 + z * z * (1.0 + eps * z2) + z_dot * z_dot * (1.0 + z1)); /* R */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return contact_oscillator_eps_finish(2, out);
    }
    return CONTACT_OSCILLATOR_EPS_OK;
}

#if CONTACT_OSCILLATOR_EPS_LANES >= 2
static __attribute__((noinline)) void contact_oscillator_eps_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    contact_oscillator_eps_lanes far = {0}; /* the squares of the angles */
    contact_oscillator_eps_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    contact_oscillator_eps_bits bad = {0}; /* singular blocks */
    const double eps = fixed[0];
    const contact_oscillator_eps_lanes x = contact_oscillator_eps_get(y);
    const contact_oscillator_eps_lanes y_2 = contact_oscillator_eps_get(y + 1 * stride);
    const contact_oscillator_eps_lanes z = contact_oscillator_eps_get(y + 2 * stride);
    const contact_oscillator_eps_lanes y_dot = contact_oscillator_eps_get(y + 3 * stride);
    const contact_oscillator_eps_lanes z_dot = contact_oscillator_eps_get(y + 4 * stride);
    const contact_oscillator_eps_lanes z1 = 1.0 + y_2 * y_2;
    const contact_oscillator_eps_lanes z2 = y_2 * z_dot;
    const contact_oscillator_eps_lanes z3 = x * (y_2 * (1.0 + eps * (z * z)) - eps * (x * z)) - (z + y_dot *
        z2);
    /* (I.1.2) */
    const contact_oscillator_eps_lanes slope1 = -z2;
    sum += slope1;
    contact_oscillator_eps_put(dydt, slope1);
    const contact_oscillator_eps_lanes slope2 = y_dot;
    sum += slope2;
    contact_oscillator_eps_put(dydt + 1 * stride, slope2);
    const contact_oscillator_eps_lanes slope3 = z_dot;
    contact_oscillator_eps_put(dydt + 2 * stride, slope3);
    /* (III.3) 9:4 */
    const contact_oscillator_eps_lanes slope4 = -y_2;
    sum += slope4;
    contact_oscillator_eps_put(dydt + 3 * stride, slope4);
    const contact_oscillator_eps_lanes slope5 = z3 / z1;
    sum += slope5;
    contact_oscillator_eps_put(dydt + 4 * stride, slope5);
    contact_oscillator_eps_put(check, contact_oscillator_eps_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void contact_oscillator_eps_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CONTACT_OSCILLATOR_EPS_LANES];
    double state[5 * CONTACT_OSCILLATOR_EPS_LANES];
    double slope[5 * CONTACT_OSCILLATOR_EPS_LANES];
    contact_oscillator_eps_fill(left, count, t, y, time, state);
    contact_oscillator_eps_rhs_lanes(fixed, CONTACT_OSCILLATOR_EPS_LANES, time, state, slope, check);
    contact_oscillator_eps_pour(left, count, slope, dydt);
}
#endif

int contact_oscillator_eps_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if CONTACT_OSCILLATOR_EPS_LANES >= 2
    const double eps = p[0]; /* strength of the coupling */
    const double fixed[] = {eps};
    double check[1 * CONTACT_OSCILLATOR_EPS_LANES];
    int status = CONTACT_OSCILLATOR_EPS_OK;
    for (size_t i = 0; i < count; i += CONTACT_OSCILLATOR_EPS_LANES) {
        const size_t left = count - i < CONTACT_OSCILLATOR_EPS_LANES ? count - i : CONTACT_OSCILLATOR_EPS_LANES;
        if (left == CONTACT_OSCILLATOR_EPS_LANES) {
            contact_oscillator_eps_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            contact_oscillator_eps_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!contact_oscillator_eps_is_good(1 * CONTACT_OSCILLATOR_EPS_LANES, check)) {
            const int one = contact_oscillator_eps_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CONTACT_OSCILLATOR_EPS_OK ? one : status;
        }
    }
    return status;
#else
    return contact_oscillator_eps_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
