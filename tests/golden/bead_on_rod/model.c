/*
 * bead_on_rod.c: bead_on_rod, emitted by nhc 0.1.0 (nhc:268a048f756893d0)
 * A bead on a straight horizontal rod that turns at a constant rate; T has a part without velocities.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * bead_on_rod.h says what each function does.
 */
#include "bead_on_rod.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const bead_on_rod_coordinate_names[BEAD_ON_ROD_NQ] = {
    "r"
};
const char *const bead_on_rod_state_names[BEAD_ON_ROD_NY] = {
    "r",
    "r'"
};
const char *const bead_on_rod_parameter_names[BEAD_ON_ROD_NP] = {
    "m",
    "Omega"
};
const char *const bead_on_rod_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const bead_on_rod_output_names[BEAD_ON_ROD_NOUT] = {
    "jacobi",
    "torque"
};
const double bead_on_rod_parameter_defaults[BEAD_ON_ROD_NP] = {
    1.0,
    2.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int bead_on_rod_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return BEAD_ON_ROD_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return BEAD_ON_ROD_NOT_FINITE;
        }
    }
    return BEAD_ON_ROD_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int bead_on_rod_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : BEAD_ON_ROD_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef BEAD_ON_ROD_LANES
#if !defined(__GNUC__)
#define BEAD_ON_ROD_LANES 1
#elif defined(__AVX512F__)
#define BEAD_ON_ROD_LANES 8
#elif defined(__AVX__)
#define BEAD_ON_ROD_LANES 4
#else
#define BEAD_ON_ROD_LANES 2
#endif
#endif
#if BEAD_ON_ROD_LANES > 1
typedef double bead_on_rod_lanes __attribute__((vector_size(8 * BEAD_ON_ROD_LANES)));
#else
typedef double bead_on_rod_lanes;
#endif

#if BEAD_ON_ROD_LANES >= 2
static inline bead_on_rod_lanes bead_on_rod_get(const double *from)
{
    bead_on_rod_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void bead_on_rod_put(double *to, bead_on_rod_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int bead_on_rod_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = BEAD_ON_ROD_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[BEAD_ON_ROD_NY];
        double slope[BEAD_ON_ROD_NY];
        for (size_t k = 0; k < BEAD_ON_ROD_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = bead_on_rod_rhs(t[i], state, p, slope);
        status = status == BEAD_ON_ROD_OK ? one : status;
        for (size_t k = 0; k < BEAD_ON_ROD_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if BEAD_ON_ROD_LANES >= 2
#define BEAD_ON_ROD_SPREAD(x) ((x) - (bead_on_rod_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long bead_on_rod_bits __attribute__((vector_size(8 * BEAD_ON_ROD_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline bead_on_rod_lanes bead_on_rod_mark(bead_on_rod_lanes value, bead_on_rod_bits bad)
{
    return (bead_on_rod_lanes)((bead_on_rod_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int bead_on_rod_is_good(int count, const double *check)
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
static inline void bead_on_rod_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < BEAD_ON_ROD_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < BEAD_ON_ROD_NY; ++k) {
            state[k * BEAD_ON_ROD_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void bead_on_rod_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < BEAD_ON_ROD_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * BEAD_ON_ROD_LANES + l];
        }
    }
}
#endif

int bead_on_rod_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the parameters alone */
    const double Omega = p[1]; /* rate of the rod [rad/s] */
    const double k1 = Omega * Omega;

    /* from the state */
    const double r_dot = y[1]; /* r' [m/s] */
    /* (II.3) */
    dydt[0] = r_dot; /* r' */
    const double r = y[0]; /* distance from the axis [m] */
    /* (II.3) 14:4 */
    dydt[1] = r * k1; /* r'' */
    const double m = p[0]; /* mass of the bead [kg] */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (dydt[0] + dydt[1]))) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return bead_on_rod_refuse(fabs(m), 0.0, BEAD_ON_ROD_SINGULAR_2);
        }
        return bead_on_rod_finish(2, dydt);
    }
    return BEAD_ON_ROD_OK;
}

int bead_on_rod_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double r_dot = y[1]; /* r' [m/s] */
    qdot[0] = r_dot; /* r' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0]) <= DBL_MAX)) {
        return bead_on_rod_finish(1, qdot);
    }
    return BEAD_ON_ROD_OK;
}

int bead_on_rod_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the parameters alone */
    const double Omega = p[1]; /* rate of the rod [rad/s] */
    const double k1 = Omega * Omega;

    /* from the state */
    const double r = y[0]; /* distance from the axis [m] */
    /* (II.3) */
    qddot[0] = r * k1; /* r'' */
    const double m = p[0]; /* mass of the bead [kg] */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * qddot[0])) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return bead_on_rod_refuse(fabs(m), 0.0, BEAD_ON_ROD_SINGULAR_2);
        }
        return bead_on_rod_finish(1, qddot);
    }
    return BEAD_ON_ROD_OK;
}

int bead_on_rod_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double r = q[0]; /* distance from the axis [m] */
    y[0] = r;
    const double r_dot = qdot[0]; /* r' [m/s] */
    y[1] = r_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1]) <= DBL_MAX)) {
        return bead_on_rod_finish(2, y);
    }
    return BEAD_ON_ROD_OK;
}

int bead_on_rod_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return BEAD_ON_ROD_OK;
}

int bead_on_rod_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;

    /* from the state */
    const double m = p[0]; /* mass of the bead [kg] */
    /* the mass matrix is singular, if m is 0 */
    if (!(fabs(m) > 0.0)) {
        return bead_on_rod_refuse(fabs(m), 0.0, BEAD_ON_ROD_SINGULAR_2);
    }
    (void)lambda;
    return BEAD_ON_ROD_OK;
}

double bead_on_rod_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the parameters alone */
    const double Omega = p[1]; /* rate of the rod [rad/s] */
    const double k1 = Omega * Omega;

    /* from the state */
    const double r = y[0]; /* distance from the axis [m] */
    const double r_dot = y[1]; /* r' [m/s] */
    const double m = p[0]; /* mass of the bead [kg] */
    return 0.5 * (m * (r_dot * r_dot + k1 * (r * r)));
}

int bead_on_rod_jacobian(double t, const double *y, const double *p, double *J)
{
    J[0] = 0.0;
    J[3] = 0.0;
    (void)t;
    (void)y;

    /* from the state */
    /* (II.3) */
    J[1] = 1.0;
    const double Omega = p[1]; /* rate of the rod [rad/s] */
    J[2] = Omega * Omega;
    const double m = p[0]; /* mass of the bead [kg] */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * J[2])) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return bead_on_rod_refuse(fabs(m), 0.0, BEAD_ON_ROD_SINGULAR_2);
        }
        return bead_on_rod_finish(4, J);
    }
    return BEAD_ON_ROD_OK;
}

int bead_on_rod_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;

    /* from the parameters alone */
    const double Omega = p[1]; /* rate of the rod [rad/s] */
    const double k1 = Omega * Omega;
    const double m = p[0]; /* mass of the bead [kg] */
    const double k2 = m * Omega;

    /* from the state */
    const double r = y[0]; /* distance from the axis [m] */
    const double r_dot = y[1]; /* r' [m/s] */
    /* 16:11 */
    out[0] = 0.5 * (m * (r_dot * r_dot - k1 * (r * r))); /* jacobi */
    /* 17:11 */
    out[1] = 2.0 * (k2 * (r * r_dot)); /* torque */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return bead_on_rod_finish(2, out);
    }
    return BEAD_ON_ROD_OK;
}

#if BEAD_ON_ROD_LANES >= 2
static __attribute__((noinline)) void bead_on_rod_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    bead_on_rod_lanes far = {0}; /* the squares of the angles */
    bead_on_rod_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    bead_on_rod_bits bad = {0}; /* singular blocks */
    const double k1 = fixed[0];
    const bead_on_rod_lanes r = bead_on_rod_get(y);
    const bead_on_rod_lanes r_dot = bead_on_rod_get(y + 1 * stride);
    /* (II.3) */
    const bead_on_rod_lanes slope1 = r_dot;
    sum += slope1;
    bead_on_rod_put(dydt, slope1);
    /* (II.3) 14:4 */
    const bead_on_rod_lanes slope2 = r * k1;
    sum += slope2;
    bead_on_rod_put(dydt + 1 * stride, slope2);
    bead_on_rod_put(check, bead_on_rod_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void bead_on_rod_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[BEAD_ON_ROD_LANES];
    double state[2 * BEAD_ON_ROD_LANES];
    double slope[2 * BEAD_ON_ROD_LANES];
    bead_on_rod_fill(left, count, t, y, time, state);
    bead_on_rod_rhs_lanes(fixed, BEAD_ON_ROD_LANES, time, state, slope, check);
    bead_on_rod_pour(left, count, slope, dydt);
}
#endif

int bead_on_rod_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if BEAD_ON_ROD_LANES >= 2
    const double m = p[0]; /* mass of the bead [kg] */
    const double Omega = p[1]; /* rate of the rod [rad/s] */
    const double k1 = Omega * Omega;
    /* the mass matrix is singular, if m is 0 */
    if (!(fabs(m) > 0.0)) {
        return bead_on_rod_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {k1};
    double check[1 * BEAD_ON_ROD_LANES];
    int status = BEAD_ON_ROD_OK;
    for (size_t i = 0; i < count; i += BEAD_ON_ROD_LANES) {
        const size_t left = count - i < BEAD_ON_ROD_LANES ? count - i : BEAD_ON_ROD_LANES;
        if (left == BEAD_ON_ROD_LANES) {
            bead_on_rod_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            bead_on_rod_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!bead_on_rod_is_good(1 * BEAD_ON_ROD_LANES, check)) {
            const int one = bead_on_rod_one_by_one(count, i, left, t, y, p, dydt);
            status = status == BEAD_ON_ROD_OK ? one : status;
        }
    }
    return status;
#else
    return bead_on_rod_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
