/*
 * point_mass.c: point_mass, emitted by nhc 0.1.0 (nhc:1b8f7f5e69d52ec8)
 * A point mass thrown in a uniform field of gravity, with linear drag.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * point_mass.h says what each function does.
 */
#include "point_mass.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const point_mass_coordinate_names[POINT_MASS_NQ] = {
    "x",
    "y",
    "z"
};
const char *const point_mass_state_names[POINT_MASS_NY] = {
    "x",
    "y",
    "z",
    "x'",
    "y'",
    "z'"
};
const char *const point_mass_parameter_names[POINT_MASS_NP] = {
    "m",
    "g",
    "c"
};
const char *const point_mass_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const point_mass_output_names[POINT_MASS_NOUT] = {
    "speed"
};
const double point_mass_parameter_defaults[POINT_MASS_NP] = {
    2.0,
    9.81,
    0.5
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int point_mass_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return POINT_MASS_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return POINT_MASS_NOT_FINITE;
        }
    }
    return POINT_MASS_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int point_mass_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : POINT_MASS_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef POINT_MASS_LANES
#if !defined(__GNUC__)
#define POINT_MASS_LANES 1
#elif defined(__AVX512F__)
#define POINT_MASS_LANES 8
#elif defined(__AVX__)
#define POINT_MASS_LANES 4
#else
#define POINT_MASS_LANES 2
#endif
#endif
#if POINT_MASS_LANES > 1
typedef double point_mass_lanes __attribute__((vector_size(8 * POINT_MASS_LANES)));
#else
typedef double point_mass_lanes;
#endif

#if POINT_MASS_LANES >= 2
static inline point_mass_lanes point_mass_get(const double *from)
{
    point_mass_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void point_mass_put(double *to, point_mass_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int point_mass_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = POINT_MASS_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[POINT_MASS_NY];
        double slope[POINT_MASS_NY];
        for (size_t k = 0; k < POINT_MASS_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = point_mass_rhs(t[i], state, p, slope);
        status = status == POINT_MASS_OK ? one : status;
        for (size_t k = 0; k < POINT_MASS_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if POINT_MASS_LANES >= 2
#define POINT_MASS_SPREAD(x) ((x) - (point_mass_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long point_mass_bits __attribute__((vector_size(8 * POINT_MASS_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline point_mass_lanes point_mass_mark(point_mass_lanes value, point_mass_bits bad)
{
    return (point_mass_lanes)((point_mass_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int point_mass_is_good(int count, const double *check)
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
static inline void point_mass_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < POINT_MASS_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < POINT_MASS_NY; ++k) {
            state[k * POINT_MASS_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void point_mass_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < POINT_MASS_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * POINT_MASS_LANES + l];
        }
    }
}
#endif

int point_mass_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double c = p[2]; /* drag coefficient [kg/s] */
    const double k1 = c / m;

    /* from the state */
    const double x_dot = y[3]; /* x' [m/s] */
    /* (II.3) */
    dydt[0] = x_dot; /* x' */
    const double y_dot = y[4]; /* y' [m/s] */
    dydt[1] = y_dot; /* y' */
    const double z_dot = y[5]; /* z' [m/s] */
    dydt[2] = z_dot; /* z' */
    /* (II.3) 14:4 */
    dydt[3] = -x_dot * k1; /* x'' */
    dydt[4] = -y_dot * k1; /* y'' */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    dydt[5] = -(g + z_dot * k1); /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[3] + dydt[4] + dydt[5]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return point_mass_refuse(fabs(m), 0.0, POINT_MASS_SINGULAR_2);
        }
        return point_mass_finish(6, dydt);
    }
    return POINT_MASS_OK;
}

int point_mass_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double x_dot = y[3]; /* x' [m/s] */
    qdot[0] = x_dot; /* x' */
    const double y_dot = y[4]; /* y' [m/s] */
    qdot[1] = y_dot; /* y' */
    const double z_dot = y[5]; /* z' [m/s] */
    qdot[2] = z_dot; /* z' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2]) <= DBL_MAX)) {
        return point_mass_finish(3, qdot);
    }
    return POINT_MASS_OK;
}

int point_mass_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double c = p[2]; /* drag coefficient [kg/s] */
    const double k1 = c / m;

    /* from the state */
    const double x_dot = y[3]; /* x' [m/s] */
    /* (II.3) */
    qddot[0] = -x_dot * k1; /* x'' */
    const double y_dot = y[4]; /* y' [m/s] */
    qddot[1] = -y_dot * k1; /* y'' */
    const double z_dot = y[5]; /* z' [m/s] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    qddot[2] = -(g + z_dot * k1); /* z'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return point_mass_refuse(fabs(m), 0.0, POINT_MASS_SINGULAR_2);
        }
        return point_mass_finish(3, qddot);
    }
    return POINT_MASS_OK;
}

int point_mass_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* horizontal [m] */
    y[0] = x;
    const double y_2 = q[1]; /* y: horizontal [m] */
    y[1] = y_2;
    const double z = q[2]; /* height [m] */
    y[2] = z;
    const double x_dot = qdot[0]; /* x' [m/s] */
    y[3] = x_dot;
    const double y_dot = qdot[1]; /* y' [m/s] */
    y[4] = y_dot;
    const double z_dot = qdot[2]; /* z' [m/s] */
    y[5] = z_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5]) <= DBL_MAX)) {
        return point_mass_finish(6, y);
    }
    return POINT_MASS_OK;
}

int point_mass_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return POINT_MASS_OK;
}

int point_mass_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;

    /* from the state */
    const double m = p[0]; /* mass [kg] */
    /* the mass matrix is singular, if m is 0 */
    if (!(fabs(m) > 0.0)) {
        return point_mass_refuse(fabs(m), 0.0, POINT_MASS_SINGULAR_2);
    }
    (void)lambda;
    return POINT_MASS_OK;
}

double point_mass_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * g;

    /* from the state */
    const double z = y[2]; /* height [m] */
    const double x_dot = y[3]; /* x' [m/s] */
    const double y_dot = y[4]; /* y' [m/s] */
    const double z_dot = y[5]; /* z' [m/s] */
    return 0.5 * (m * (x_dot * x_dot + y_dot * y_dot + z_dot * z_dot)) + z * k1;
}

int point_mass_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 36 * sizeof *J);
    (void)t;
    (void)y;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double c = p[2]; /* drag coefficient [kg/s] */
    const double k1 = c / m;

    /* from the state */
    /* (II.3) */
    J[3] = 1.0;
    J[10] = 1.0;
    J[17] = 1.0;
    J[21] = -k1;
    J[28] = -k1;
    J[35] = -k1;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[35]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return point_mass_refuse(fabs(m), 0.0, POINT_MASS_SINGULAR_2);
        }
        return point_mass_finish(36, J);
    }
    return POINT_MASS_OK;
}

int point_mass_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;

    /* from the state */
    const double x_dot = y[3]; /* x' [m/s] */
    const double y_dot = y[4]; /* y' [m/s] */
    const double z_dot = y[5]; /* z' [m/s] */
    /* 21:10 */
    out[0] = sqrt(x_dot * x_dot + y_dot * y_dot + z_dot * z_dot); /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return point_mass_finish(1, out);
    }
    return POINT_MASS_OK;
}

#if POINT_MASS_LANES >= 2
static __attribute__((noinline)) void point_mass_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    point_mass_lanes far = {0}; /* the squares of the angles */
    point_mass_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    point_mass_bits bad = {0}; /* singular blocks */
    const double g = fixed[0];
    const double k1 = fixed[1];
    const point_mass_lanes x_dot = point_mass_get(y + 3 * stride);
    const point_mass_lanes y_dot = point_mass_get(y + 4 * stride);
    const point_mass_lanes z_dot = point_mass_get(y + 5 * stride);
    /* (II.3) */
    const point_mass_lanes slope1 = x_dot;
    point_mass_put(dydt, slope1);
    const point_mass_lanes slope2 = y_dot;
    point_mass_put(dydt + 1 * stride, slope2);
    const point_mass_lanes slope3 = z_dot;
    point_mass_put(dydt + 2 * stride, slope3);
    /* (II.3) 14:4 */
    const point_mass_lanes slope4 = -x_dot * k1;
    sum += slope4;
    point_mass_put(dydt + 3 * stride, slope4);
    const point_mass_lanes slope5 = -y_dot * k1;
    sum += slope5;
    point_mass_put(dydt + 4 * stride, slope5);
    const point_mass_lanes slope6 = -(g + z_dot * k1);
    sum += slope6;
    point_mass_put(dydt + 5 * stride, slope6);
    point_mass_put(check, point_mass_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void point_mass_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[POINT_MASS_LANES];
    double state[6 * POINT_MASS_LANES];
    double slope[6 * POINT_MASS_LANES];
    point_mass_fill(left, count, t, y, time, state);
    point_mass_rhs_lanes(fixed, POINT_MASS_LANES, time, state, slope, check);
    point_mass_pour(left, count, slope, dydt);
}
#endif

int point_mass_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if POINT_MASS_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double c = p[2]; /* drag coefficient [kg/s] */
    const double k1 = c / m;
    const double fixed[] = {g, k1};
    double check[1 * POINT_MASS_LANES];
    int status = POINT_MASS_OK;
    for (size_t i = 0; i < count; i += POINT_MASS_LANES) {
        const size_t left = count - i < POINT_MASS_LANES ? count - i : POINT_MASS_LANES;
        if (left == POINT_MASS_LANES) {
            point_mass_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            point_mass_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!point_mass_is_good(1 * POINT_MASS_LANES, check)) {
            const int one = point_mass_one_by_one(count, i, left, t, y, p, dydt);
            status = status == POINT_MASS_OK ? one : status;
        }
    }
    return status;
#else
    return point_mass_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
