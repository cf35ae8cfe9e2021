/*
 * chaplygin_sleigh.c: chaplygin_sleigh, emitted by nhc 0.1.0 (nhc:a4b2274f6203b6f9)
 * A rigid body on a knife edge; the centre of mass is a distance a ahead of the edge.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * chaplygin_sleigh.h says what each function does.
 */
#include "chaplygin_sleigh.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const chaplygin_sleigh_coordinate_names[CHAPLYGIN_SLEIGH_NQ] = {
    "x",
    "y",
    "theta"
};
const char *const chaplygin_sleigh_state_names[CHAPLYGIN_SLEIGH_NY] = {
    "x",
    "y",
    "theta",
    "v",
    "w"
};
const char *const chaplygin_sleigh_parameter_names[CHAPLYGIN_SLEIGH_NP] = {
    "m",
    "J",
    "a"
};
const char *const chaplygin_sleigh_constraint_names[CHAPLYGIN_SLEIGH_NC] = {
    "slip"
};
const char *const chaplygin_sleigh_output_names[CHAPLYGIN_SLEIGH_NOUT] = {
    "speed",
    "X",
    "Y"
};
const double chaplygin_sleigh_parameter_defaults[CHAPLYGIN_SLEIGH_NP] = {
    1.0,
    0.5,
    0.7
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int chaplygin_sleigh_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CHAPLYGIN_SLEIGH_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CHAPLYGIN_SLEIGH_NOT_FINITE;
        }
    }
    return CHAPLYGIN_SLEIGH_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int chaplygin_sleigh_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CHAPLYGIN_SLEIGH_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CHAPLYGIN_SLEIGH_LANES
#if !defined(__GNUC__)
#define CHAPLYGIN_SLEIGH_LANES 1
#elif defined(__AVX512F__)
#define CHAPLYGIN_SLEIGH_LANES 8
#elif defined(__AVX__)
#define CHAPLYGIN_SLEIGH_LANES 4
#else
#define CHAPLYGIN_SLEIGH_LANES 2
#endif
#endif
#if CHAPLYGIN_SLEIGH_LANES > 1
typedef double chaplygin_sleigh_lanes __attribute__((vector_size(8 * CHAPLYGIN_SLEIGH_LANES)));
#else
typedef double chaplygin_sleigh_lanes;
#endif

#if CHAPLYGIN_SLEIGH_LANES >= 2
static inline chaplygin_sleigh_lanes chaplygin_sleigh_get(const double *from)
{
    chaplygin_sleigh_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void chaplygin_sleigh_put(double *to, chaplygin_sleigh_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int chaplygin_sleigh_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CHAPLYGIN_SLEIGH_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CHAPLYGIN_SLEIGH_NY];
        double slope[CHAPLYGIN_SLEIGH_NY];
        for (size_t k = 0; k < CHAPLYGIN_SLEIGH_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = chaplygin_sleigh_rhs(t[i], state, p, slope);
        status = status == CHAPLYGIN_SLEIGH_OK ? one : status;
        for (size_t k = 0; k < CHAPLYGIN_SLEIGH_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CHAPLYGIN_SLEIGH_LANES >= 2
#define CHAPLYGIN_SLEIGH_SPREAD(x) ((x) - (chaplygin_sleigh_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long chaplygin_sleigh_bits __attribute__((vector_size(8 * CHAPLYGIN_SLEIGH_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline chaplygin_sleigh_lanes chaplygin_sleigh_mark(chaplygin_sleigh_lanes value, chaplygin_sleigh_bits bad)
{
    return (chaplygin_sleigh_lanes)((chaplygin_sleigh_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int chaplygin_sleigh_is_good(int count, const double *check)
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
static inline void chaplygin_sleigh_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CHAPLYGIN_SLEIGH_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CHAPLYGIN_SLEIGH_NY; ++k) {
            state[k * CHAPLYGIN_SLEIGH_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void chaplygin_sleigh_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CHAPLYGIN_SLEIGH_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CHAPLYGIN_SLEIGH_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void chaplygin_sleigh_turn_lanes(chaplygin_sleigh_lanes x, chaplygin_sleigh_lanes *far,
    chaplygin_sleigh_lanes *sine, chaplygin_sleigh_lanes *cosine)
{
    double angle[CHAPLYGIN_SLEIGH_LANES];
    double up[CHAPLYGIN_SLEIGH_LANES];
    double along[CHAPLYGIN_SLEIGH_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < CHAPLYGIN_SLEIGH_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int chaplygin_sleigh_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */

    /* from the parameters alone */
    const double k1 = m * a;
    const double k2 = J + a * k1;
    const double k3 = -k1 / k2;

    /* from the state */
    /* (I.2.4) */
    dydt[0] = c_theta * v; /* x' */
    dydt[1] = s_theta * v; /* y' */
    dydt[2] = w; /* theta' */
    /* (I.2.15) 17:4 */
    dydt[3] = a * w * w; /* v' */
    dydt[4] = v * w * k3; /* w' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (dydt[0] + dydt[3] + dydt[4]))) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(m), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k2 is 0 */
        if (!(fabs(k2) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(k2), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        return chaplygin_sleigh_finish(5, dydt);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

int chaplygin_sleigh_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */

    /* from the state */
    /* (I.2.4) */
    qdot[0] = c_theta * v; /* x' */
    qdot[1] = s_theta * v; /* y' */
    qdot[2] = w; /* theta' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[2]) <= DBL_MAX)) {
        return chaplygin_sleigh_finish(3, qdot);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

int chaplygin_sleigh_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */

    /* from the parameters alone */
    const double k1 = m * a;
    const double k2 = J + a * k1;
    const double k3 = -k1 / k2;

    /* from the state */
    const double z1 = a * w * w;
    const double z2 = v * w;
    /* (I.2.15) */
    qddot[0] = c_theta * z1 - s_theta * z2; /* x'' */
    qddot[1] = s_theta * z1 + c_theta * z2; /* y'' */
    qddot[2] = z2 * k3; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (qddot[0] + qddot[1] + qddot[2]))) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(m), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k2 is 0 */
        if (!(fabs(k2) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(k2), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        return chaplygin_sleigh_finish(3, qddot);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

int chaplygin_sleigh_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x = q[0]; /* point of the edge [m] */
    const double y_2 = q[1]; /* y: point of the edge [m] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = x_dot * c_theta + y_dot * s_theta;
    y[4] = theta_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[4]) <= DBL_MAX)) {
        return chaplygin_sleigh_finish(5, y);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

int chaplygin_sleigh_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double theta = q[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */

    /* from the coordinates and velocities */
    /* (I.1.1) 19:5 */
    r[0] = y_dot * c_theta - x_dot * s_theta; /* slip = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return chaplygin_sleigh_finish(1, r);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

int chaplygin_sleigh_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double k1 = J + a * (m * a);
    const double k2 = m * J / k1;

    /* from the state */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    /* (I.4.1) 19:5 */
    lambda[0] = v * w * k2; /* reaction of slip: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * lambda[0])) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(m), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(k1), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        return chaplygin_sleigh_finish(1, lambda);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

double chaplygin_sleigh_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the parameters alone */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double k1 = a * a;

    /* from the state */
    const double w = y[4]; /* [rad/s] */
    const double z1 = w * w;
    const double v = y[3]; /* [m/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    return 0.5 * (J * z1 + m * (z1 * k1 + v * v));
}

int chaplygin_sleigh_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J_2 = p[1]; /* J: moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */

    /* from the parameters alone */
    const double k1 = m * a;
    const double k2 = J_2 + a * k1;
    const double k3 = -k1 / k2;

    /* from the state */
    /* (I.2.15) */
    J[2] = -s_theta * v;
    J[3] = c_theta;
    J[7] = c_theta * v;
    J[8] = s_theta;
    J[14] = 1.0;
    J[19] = 2.0 * (a * w);
    J[23] = w * k3;
    J[24] = v * k3;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * (J[2] + J[19] + J[23] + J[24]))) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(m), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k2 is 0 */
        if (!(fabs(k2) > 0.0)) {
            return chaplygin_sleigh_refuse(fabs(k2), 0.0, CHAPLYGIN_SLEIGH_SINGULAR_2);
        }
        return chaplygin_sleigh_finish(25, J);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

int chaplygin_sleigh_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x = y[0]; /* point of the edge [m] */
    const double y_2 = y[1]; /* y: point of the edge [m] */
    const double v = y[3]; /* [m/s] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */

    /* from the state */
    /* 24:10 */
    out[0] = v; /* speed */
    /* 25:6 */
    out[1] = x + a * c_theta; /* X */
    /* 26:6 */
    out[2] = y_2 + a * s_theta; /* Y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1] + out[2]) <= DBL_MAX)) {
        return chaplygin_sleigh_finish(3, out);
    }
    return CHAPLYGIN_SLEIGH_OK;
}

#if CHAPLYGIN_SLEIGH_LANES >= 2
static __attribute__((noinline)) void chaplygin_sleigh_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    chaplygin_sleigh_lanes far = {0}; /* the squares of the angles */
    chaplygin_sleigh_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    chaplygin_sleigh_bits bad = {0}; /* singular blocks */
    const double a = fixed[0];
    const double k3 = fixed[1];
    const chaplygin_sleigh_lanes theta = chaplygin_sleigh_get(y + 2 * stride);
    const chaplygin_sleigh_lanes v = chaplygin_sleigh_get(y + 3 * stride);
    const chaplygin_sleigh_lanes w = chaplygin_sleigh_get(y + 4 * stride);
    chaplygin_sleigh_lanes sine1, cosine1;
    chaplygin_sleigh_turn_lanes(CHAPLYGIN_SLEIGH_SPREAD(theta), &far, &sine1, &cosine1);
    const chaplygin_sleigh_lanes c_theta = cosine1;
    const chaplygin_sleigh_lanes s_theta = sine1;
    /* (I.2.4) */
    const chaplygin_sleigh_lanes slope1 = c_theta * v;
    sum += slope1;
    chaplygin_sleigh_put(dydt, slope1);
    const chaplygin_sleigh_lanes slope2 = s_theta * v;
    chaplygin_sleigh_put(dydt + 1 * stride, slope2);
    const chaplygin_sleigh_lanes slope3 = w;
    chaplygin_sleigh_put(dydt + 2 * stride, slope3);
    /* (I.2.15) 17:4 */
    const chaplygin_sleigh_lanes slope4 = a * w * w;
    sum += slope4;
    chaplygin_sleigh_put(dydt + 3 * stride, slope4);
    const chaplygin_sleigh_lanes slope5 = v * w * k3;
    sum += slope5;
    chaplygin_sleigh_put(dydt + 4 * stride, slope5);
    chaplygin_sleigh_put(check, chaplygin_sleigh_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void chaplygin_sleigh_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CHAPLYGIN_SLEIGH_LANES];
    double state[5 * CHAPLYGIN_SLEIGH_LANES];
    double slope[5 * CHAPLYGIN_SLEIGH_LANES];
    chaplygin_sleigh_fill(left, count, t, y, time, state);
    chaplygin_sleigh_rhs_lanes(fixed, CHAPLYGIN_SLEIGH_LANES, time, state, slope, check);
    chaplygin_sleigh_pour(left, count, slope, dydt);
}
#endif

int chaplygin_sleigh_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if CHAPLYGIN_SLEIGH_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double k1 = m * a;
    const double k2 = J + a * k1;
    const double k3 = -k1 / k2;
    /* the mass matrix is singular, if m is 0 */
    if (!(fabs(m) > 0.0)) {
        return chaplygin_sleigh_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {a, k3};
    double check[1 * CHAPLYGIN_SLEIGH_LANES];
    int status = CHAPLYGIN_SLEIGH_OK;
    for (size_t i = 0; i < count; i += CHAPLYGIN_SLEIGH_LANES) {
        const size_t left = count - i < CHAPLYGIN_SLEIGH_LANES ? count - i : CHAPLYGIN_SLEIGH_LANES;
        if (left == CHAPLYGIN_SLEIGH_LANES) {
            chaplygin_sleigh_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            chaplygin_sleigh_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!chaplygin_sleigh_is_good(1 * CHAPLYGIN_SLEIGH_LANES, check)) {
            const int one = chaplygin_sleigh_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CHAPLYGIN_SLEIGH_OK ? one : status;
        }
    }
    return status;
#else
    return chaplygin_sleigh_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
