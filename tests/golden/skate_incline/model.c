/*
 * skate_incline.c: skate_incline, emitted by nhc 0.1.0 (nhc:cb04d65b81dd3d8c)
 * A skate on an inclined plane with its centre of mass above the edge; it never gets far downhill.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, phi': the dependent velocities that nhc would choose (y') are
 *     singular somewhere
 * skate_incline.h says what each function does.
 */
#include "skate_incline.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const skate_incline_coordinate_names[SKATE_INCLINE_NQ] = {
    "x",
    "y",
    "phi"
};
const char *const skate_incline_state_names[SKATE_INCLINE_NY] = {
    "x",
    "y",
    "phi",
    "v",
    "phi'"
};
const char *const skate_incline_parameter_names[SKATE_INCLINE_NP] = {
    "m",
    "J",
    "g",
    "alpha"
};
const char *const skate_incline_constraint_names[SKATE_INCLINE_NC] = {
    "slip"
};
const char *const skate_incline_output_names[SKATE_INCLINE_NOUT] = {
    "speed"
};
const double skate_incline_parameter_defaults[SKATE_INCLINE_NP] = {
    1.0,
    0.4,
    9.81,
    0.5235987755982988
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int skate_incline_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return SKATE_INCLINE_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return SKATE_INCLINE_NOT_FINITE;
        }
    }
    return SKATE_INCLINE_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int skate_incline_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : SKATE_INCLINE_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef SKATE_INCLINE_LANES
#if !defined(__GNUC__)
#define SKATE_INCLINE_LANES 1
#elif defined(__AVX512F__)
#define SKATE_INCLINE_LANES 8
#elif defined(__AVX__)
#define SKATE_INCLINE_LANES 4
#else
#define SKATE_INCLINE_LANES 2
#endif
#endif
#if SKATE_INCLINE_LANES > 1
typedef double skate_incline_lanes __attribute__((vector_size(8 * SKATE_INCLINE_LANES)));
#else
typedef double skate_incline_lanes;
#endif

#if SKATE_INCLINE_LANES >= 2
static inline skate_incline_lanes skate_incline_get(const double *from)
{
    skate_incline_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void skate_incline_put(double *to, skate_incline_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int skate_incline_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = SKATE_INCLINE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[SKATE_INCLINE_NY];
        double slope[SKATE_INCLINE_NY];
        for (size_t k = 0; k < SKATE_INCLINE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = skate_incline_rhs(t[i], state, p, slope);
        status = status == SKATE_INCLINE_OK ? one : status;
        for (size_t k = 0; k < SKATE_INCLINE_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if SKATE_INCLINE_LANES >= 2
#define SKATE_INCLINE_SPREAD(x) ((x) - (skate_incline_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long skate_incline_bits __attribute__((vector_size(8 * SKATE_INCLINE_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline skate_incline_lanes skate_incline_mark(skate_incline_lanes value, skate_incline_bits bad)
{
    return (skate_incline_lanes)((skate_incline_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int skate_incline_is_good(int count, const double *check)
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
static inline void skate_incline_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < SKATE_INCLINE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < SKATE_INCLINE_NY; ++k) {
            state[k * SKATE_INCLINE_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void skate_incline_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < SKATE_INCLINE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * SKATE_INCLINE_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void skate_incline_turn_lanes(skate_incline_lanes x, skate_incline_lanes *far,
    skate_incline_lanes *sine, skate_incline_lanes *cosine)
{
    double angle[SKATE_INCLINE_LANES];
    double up[SKATE_INCLINE_LANES];
    double along[SKATE_INCLINE_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < SKATE_INCLINE_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int skate_incline_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* sines and cosines */
    const double s_alpha = sin(alpha);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = g * s_alpha;

    /* from the state */
    /* (I.2.4) */
    dydt[0] = c_phi * v; /* x' */
    dydt[1] = s_phi * v; /* y' */
    dydt[2] = phi_dot; /* phi' */
    /* (I.2.15) 15:4 */
    dydt[3] = c_phi * k1; /* v' */
    dydt[4] = 0.0; /* phi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m * J) > 0.0 * (dydt[0] + dydt[2] + dydt[3]))) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return skate_incline_refuse(fabs(m), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return skate_incline_refuse(fabs(J), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        return skate_incline_finish(5, dydt);
    }
    return SKATE_INCLINE_OK;
}

int skate_incline_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double phi = y[2]; /* heading, from the fall line [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double phi_dot = y[4]; /* phi' [rad/s] */

    /* from the state */
    /* (I.2.4) */
    qdot[0] = c_phi * v; /* x' */
    qdot[1] = s_phi * v; /* y' */
    qdot[2] = phi_dot; /* phi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[2]) <= DBL_MAX)) {
        return skate_incline_finish(3, qdot);
    }
    return SKATE_INCLINE_OK;
}

int skate_incline_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* sines and cosines */
    const double s_alpha = sin(alpha);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = g * s_alpha;

    /* from the state */
    const double z1 = c_phi * k1;
    const double z2 = phi_dot * v;
    /* (I.2.15) */
    qddot[0] = c_phi * z1 - s_phi * z2; /* x'' */
    qddot[1] = s_phi * z1 + c_phi * z2; /* y'' */
    qddot[2] = 0.0; /* phi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m * J) > 0.0 * (qddot[0] + qddot[1]))) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return skate_incline_refuse(fabs(m), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return skate_incline_refuse(fabs(J), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        return skate_incline_finish(3, qddot);
    }
    return SKATE_INCLINE_OK;
}

int skate_incline_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double phi = q[2]; /* heading, from the fall line [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x = q[0]; /* down the slope [m] */
    const double y_2 = q[1]; /* y: across the slope [m] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double phi_dot = qdot[2]; /* phi' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = x_dot * c_phi + y_dot * s_phi;
    y[4] = phi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[4]) <= DBL_MAX)) {
        return skate_incline_finish(5, y);
    }
    return SKATE_INCLINE_OK;
}

int skate_incline_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double phi = q[2]; /* heading, from the fall line [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */

    /* from the coordinates and velocities */
    /* (I.1.1) 18:5 */
    r[0] = x_dot * s_phi - y_dot * c_phi; /* slip = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return skate_incline_finish(1, r);
    }
    return SKATE_INCLINE_OK;
}

int skate_incline_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* sines and cosines */
    const double s_alpha = sin(alpha);
    const double s_phi = sin(phi);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = g * s_alpha;

    /* from the state */
    /* (I.4.1) 18:5 */
    lambda[0] = -m * (phi_dot * v + s_phi * k1); /* reaction of slip: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m * J) > 0.0 * lambda[0])) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return skate_incline_refuse(fabs(m), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return skate_incline_refuse(fabs(J), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        return skate_incline_finish(1, lambda);
    }
    return SKATE_INCLINE_OK;
}

double skate_incline_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* sines and cosines */
    const double s_alpha = sin(alpha);

    /* what else is read */
    const double x = y[0]; /* down the slope [m] */
    const double v = y[3]; /* [m/s] */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = g * s_alpha;

    /* from the state */
    return 0.5 * (J * (phi_dot * phi_dot)) + m * (0.5 * (v * v) - x * k1);
}

int skate_incline_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* sines and cosines */
    const double s_alpha = sin(alpha);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double m = p[0]; /* mass [kg] */
    const double J_2 = p[1]; /* J: moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = -g * s_alpha;

    /* from the state */
    /* (I.2.15) */
    J[2] = -s_phi * v;
    J[3] = c_phi;
    J[7] = c_phi * v;
    J[8] = s_phi;
    J[14] = 1.0;
    J[17] = s_phi * k1;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m * J_2) > 0.0 * (J[2] + J[17]))) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return skate_incline_refuse(fabs(m), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        /* the mass matrix is singular, if J_2 is 0 */
        if (!(fabs(J_2) > 0.0)) {
            return skate_incline_refuse(fabs(J_2), 0.0, SKATE_INCLINE_SINGULAR_2);
        }
        return skate_incline_finish(25, J);
    }
    return SKATE_INCLINE_OK;
}

int skate_incline_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;

    /* from the state */
    const double v = y[3]; /* [m/s] */
    /* 20:10 */
    out[0] = v; /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return skate_incline_finish(1, out);
    }
    return SKATE_INCLINE_OK;
}

#if SKATE_INCLINE_LANES >= 2
static __attribute__((noinline)) void skate_incline_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    skate_incline_lanes far = {0}; /* the squares of the angles */
    skate_incline_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    skate_incline_bits bad = {0}; /* singular blocks */
    const double k1 = fixed[0];
    const skate_incline_lanes phi = skate_incline_get(y + 2 * stride);
    const skate_incline_lanes v = skate_incline_get(y + 3 * stride);
    const skate_incline_lanes phi_dot = skate_incline_get(y + 4 * stride);
    skate_incline_lanes sine1, cosine1;
    skate_incline_turn_lanes(SKATE_INCLINE_SPREAD(phi), &far, &sine1, &cosine1);
    const skate_incline_lanes c_phi = cosine1;
    const skate_incline_lanes s_phi = sine1;
    /* (I.2.4) */
    const skate_incline_lanes slope1 = c_phi * v;
    sum += slope1;
    skate_incline_put(dydt, slope1);
    const skate_incline_lanes slope2 = s_phi * v;
    skate_incline_put(dydt + 1 * stride, slope2);
    const skate_incline_lanes slope3 = phi_dot;
    sum += slope3;
    skate_incline_put(dydt + 2 * stride, slope3);
    /* (I.2.15) 15:4 */
    const skate_incline_lanes slope4 = c_phi * k1;
    sum += slope4;
    skate_incline_put(dydt + 3 * stride, slope4);
    const skate_incline_lanes slope5 = SKATE_INCLINE_SPREAD(0.0);
    skate_incline_put(dydt + 4 * stride, slope5);
    skate_incline_put(check, skate_incline_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void skate_incline_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[SKATE_INCLINE_LANES];
    double state[5 * SKATE_INCLINE_LANES];
    double slope[5 * SKATE_INCLINE_LANES];
    skate_incline_fill(left, count, t, y, time, state);
    skate_incline_rhs_lanes(fixed, SKATE_INCLINE_LANES, time, state, slope, check);
    skate_incline_pour(left, count, slope, dydt);
}
#endif

int skate_incline_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if SKATE_INCLINE_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */
    const double s_alpha = sin(alpha);
    const double k1 = g * s_alpha;
    /* the mass matrix is singular, if m is 0 */
    if (!(fabs(m) > 0.0)) {
        return skate_incline_one_by_one(count, 0, count, t, y, p, dydt);
    }
    /* the mass matrix is singular, if J is 0 */
    if (!(fabs(J) > 0.0)) {
        return skate_incline_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {k1};
    double check[1 * SKATE_INCLINE_LANES];
    int status = SKATE_INCLINE_OK;
    for (size_t i = 0; i < count; i += SKATE_INCLINE_LANES) {
        const size_t left = count - i < SKATE_INCLINE_LANES ? count - i : SKATE_INCLINE_LANES;
        if (left == SKATE_INCLINE_LANES) {
            skate_incline_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            skate_incline_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!skate_incline_is_good(1 * SKATE_INCLINE_LANES, check)) {
            const int one = skate_incline_one_by_one(count, i, left, t, y, p, dydt);
            status = status == SKATE_INCLINE_OK ? one : status;
        }
    }
    return status;
#else
    return skate_incline_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
