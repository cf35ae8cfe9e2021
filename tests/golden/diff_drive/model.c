/*
 * diff_drive.c: diff_drive, emitted by nhc 0.1.0 (nhc:da22e17bb96de98a)
 * A cart with two driven wheels and a caster; three velocity constraints, one of which is holonomic in
 *     disguise.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * diff_drive.h says what each function does.
 */
#include "diff_drive.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const diff_drive_coordinate_names[DIFF_DRIVE_NQ] = {
    "x",
    "y",
    "theta",
    "p_R",
    "p_L"
};
const char *const diff_drive_state_names[DIFF_DRIVE_NY] = {
    "x",
    "y",
    "theta",
    "p_R",
    "p_L",
    "v",
    "w"
};
const char *const diff_drive_parameter_names[DIFF_DRIVE_NP] = {
    "m",
    "I",
    "J_w",
    "r",
    "b",
    "d",
    "tau_R",
    "tau_L"
};
const char *const diff_drive_constraint_names[DIFF_DRIVE_NC] = {
    "slip",
    "roll_R",
    "roll_L"
};
const char *const diff_drive_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double diff_drive_parameter_defaults[DIFF_DRIVE_NP] = {
    10.0,
    0.6,
    0.02,
    0.1,
    0.25,
    0.1,
    0.3,
    0.2
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int diff_drive_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return DIFF_DRIVE_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return DIFF_DRIVE_NOT_FINITE;
        }
    }
    return DIFF_DRIVE_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int diff_drive_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : DIFF_DRIVE_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef DIFF_DRIVE_LANES
#if !defined(__GNUC__)
#define DIFF_DRIVE_LANES 1
#elif defined(__AVX512F__)
#define DIFF_DRIVE_LANES 8
#elif defined(__AVX__)
#define DIFF_DRIVE_LANES 4
#else
#define DIFF_DRIVE_LANES 2
#endif
#endif
#if DIFF_DRIVE_LANES > 1
typedef double diff_drive_lanes __attribute__((vector_size(8 * DIFF_DRIVE_LANES)));
#else
typedef double diff_drive_lanes;
#endif

#if DIFF_DRIVE_LANES >= 2
static inline diff_drive_lanes diff_drive_get(const double *from)
{
    diff_drive_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void diff_drive_put(double *to, diff_drive_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int diff_drive_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = DIFF_DRIVE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[DIFF_DRIVE_NY];
        double slope[DIFF_DRIVE_NY];
        for (size_t k = 0; k < DIFF_DRIVE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = diff_drive_rhs(t[i], state, p, slope);
        status = status == DIFF_DRIVE_OK ? one : status;
        for (size_t k = 0; k < DIFF_DRIVE_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if DIFF_DRIVE_LANES >= 2
#define DIFF_DRIVE_SPREAD(x) ((x) - (diff_drive_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long diff_drive_bits __attribute__((vector_size(8 * DIFF_DRIVE_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline diff_drive_lanes diff_drive_mark(diff_drive_lanes value, diff_drive_bits bad)
{
    return (diff_drive_lanes)((diff_drive_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int diff_drive_is_good(int count, const double *check)
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
static inline void diff_drive_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < DIFF_DRIVE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < DIFF_DRIVE_NY; ++k) {
            state[k * DIFF_DRIVE_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void diff_drive_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < DIFF_DRIVE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * DIFF_DRIVE_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void diff_drive_turn_lanes(diff_drive_lanes x, diff_drive_lanes *far,
    diff_drive_lanes *sine, diff_drive_lanes *cosine)
{
    double angle[DIFF_DRIVE_LANES];
    double up[DIFF_DRIVE_LANES];
    double along[DIFF_DRIVE_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < DIFF_DRIVE_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int diff_drive_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / r;
    const double k2 = b * k1;
    const double k3 = m + 2.0 * (k1 * (J_w * k1));
    const double k4 = m * d;
    const double k5 = k1 * (tau_R + tau_L);
    const double k6 = d * k4 + (I + 2.0 * (k2 * (J_w * k2)));
    const double k7 = k2 * (tau_R - tau_L);
    const double k8 = 1.0 / k3;
    const double k9 = -1.0 / k6;

    /* from the state */
    const double z1 = b * w;
    /* (I.2.4) */
    dydt[0] = c_theta * v; /* x' */
    dydt[1] = s_theta * v; /* y' */
    dydt[2] = w; /* theta' */
    dydt[3] = k1 * (v + z1); /* p_R' */
    dydt[4] = k1 * (v - z1); /* p_L' */
    /* (I.2.15) 24:4 */
    dydt[5] = (k4 * (w * w) + k5) * k8; /* v' */
    dydt[6] = (v * w * k4 - k7) * k9; /* w' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[3] + dydt[4] + dydt[5] + dydt[6]) <= DBL_MAX)) {
        /* the coframe is singular, if r is 0 */
        if (!(fabs(r) > 0.0)) {
            return diff_drive_refuse(fabs(r), 0.0, DIFF_DRIVE_SINGULAR_1);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return diff_drive_refuse(fabs(k3), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k6 is 0 */
        if (!(fabs(k6) > 0.0)) {
            return diff_drive_refuse(fabs(k6), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        return diff_drive_finish(7, dydt);
    }
    return DIFF_DRIVE_OK;
}

int diff_drive_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / r;

    /* from the state */
    const double z1 = b * w;
    /* (I.2.4) */
    qdot[0] = c_theta * v; /* x' */
    qdot[1] = s_theta * v; /* y' */
    qdot[2] = w; /* theta' */
    qdot[3] = k1 * (v + z1); /* p_R' */
    qdot[4] = k1 * (v - z1); /* p_L' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[3] + qdot[4]) <= DBL_MAX)) {
        /* the coframe is singular, if r is 0 */
        if (!(fabs(r) > 0.0)) {
            return diff_drive_refuse(fabs(r), 0.0, DIFF_DRIVE_SINGULAR_1);
        }
        return diff_drive_finish(5, qdot);
    }
    return DIFF_DRIVE_OK;
}

int diff_drive_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / r;
    const double k2 = b * k1;
    const double k3 = m + 2.0 * (k1 * (J_w * k1));
    const double k4 = m * d;
    const double k5 = k1 * (tau_R + tau_L);
    const double k6 = d * k4 + (I + 2.0 * (k2 * (J_w * k2)));
    const double k7 = k2 * (tau_R - tau_L);
    const double k8 = 1.0 / k3;
    const double k9 = 1.0 / k6;

    /* from the state */
    const double z1 = (k4 * (w * w) + k5) * k8;
    const double z2 = v * w;
    const double z3 = (z2 * k4 - k7) * k9;
    const double z4 = b * z3;
    /* (I.2.15) */
    qddot[0] = c_theta * z1 - s_theta * z2; /* x'' */
    qddot[1] = s_theta * z1 + c_theta * z2; /* y'' */
    qddot[2] = -z3; /* theta'' */
    qddot[3] = k1 * (z1 - z4); /* p_R'' */
    qddot[4] = k1 * (z1 + z4); /* p_L'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[3] + qddot[4]) <= DBL_MAX)) {
        /* the coframe is singular, if r is 0 */
        if (!(fabs(r) > 0.0)) {
            return diff_drive_refuse(fabs(r), 0.0, DIFF_DRIVE_SINGULAR_1);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return diff_drive_refuse(fabs(k3), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k6 is 0 */
        if (!(fabs(k6) > 0.0)) {
            return diff_drive_refuse(fabs(k6), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        return diff_drive_finish(5, qddot);
    }
    return DIFF_DRIVE_OK;
}

int diff_drive_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x = q[0]; /* midpoint of the axle [m] */
    const double y_2 = q[1]; /* y: midpoint of the axle [m] */
    const double p_R = q[3]; /* right wheel [rad] */
    const double p_L = q[4]; /* left wheel [rad] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = p_R;
    y[4] = p_L;
    y[5] = x_dot * c_theta + y_dot * s_theta;
    y[6] = theta_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[4] + y[5] + y[6]) <= DBL_MAX)) {
        return diff_drive_finish(7, y);
    }
    return DIFF_DRIVE_OK;
}

int diff_drive_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta = q[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */
    const double p_R_dot = qdot[3]; /* p_R' [rad/s] */
    const double p_L_dot = qdot[4]; /* p_L' [rad/s] */
    const double r_2 = p[3]; /* r: radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */

    /* from the coordinates and velocities */
    const double v = x_dot * c_theta + y_dot * s_theta;
    const double z1 = theta_dot * b;
    /* (I.1.1) 29:5 */
    r[0] = y_dot * c_theta - x_dot * s_theta; /* slip = 0 */
    /* (I.1.1) 30:5 */
    r[1] = v + z1 - p_R_dot * r_2; /* roll_R = 0 */
    /* (I.1.1) 31:5 */
    r[2] = v - z1 - p_L_dot * r_2; /* roll_L = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2]) <= DBL_MAX)) {
        return diff_drive_finish(3, r);
    }
    return DIFF_DRIVE_OK;
}

int diff_drive_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the parameters alone */
    const double r = p[3]; /* radius of the wheels [m] */
    const double k1 = 1.0 / r;
    const double b = p[4]; /* half the track [m] */
    const double k2 = b * k1;
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double k3 = J_w * k1;
    const double m = p[0]; /* mass [kg] */
    const double k4 = m + 2.0 * (k1 * k3);
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double k5 = m * d;
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */
    const double k6 = k1 * (tau_R + tau_L);
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double k7 = d * k5 + (I + 2.0 * (k2 * (J_w * k2)));
    const double k8 = k2 * (tau_R - tau_L);
    const double k9 = 1.0 / k4;
    const double k10 = 1.0 / k7;

    /* from the state */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double z1 = v * w;
    const double z2 = (z1 * k5 - k8) * k10;
    const double z3 = (k5 * (w * w) + k6) * k9;
    const double z4 = b * z2;
    /* (I.4.1) 29:5 */
    lambda[0] = m * (z1 - d * z2); /* reaction of slip: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 30:5 */
    lambda[1] = k1 * (tau_R - k3 * (z3 - z4)); /* reaction of roll_R: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 31:5 */
    lambda[2] = k1 * (tau_L - k3 * (z3 + z4)); /* reaction of roll_L: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1] + lambda[2]) <= DBL_MAX)) {
        /* the coframe is singular, if r is 0 */
        if (!(fabs(r) > 0.0)) {
            return diff_drive_refuse(fabs(r), 0.0, DIFF_DRIVE_SINGULAR_1);
        }
        /* the mass matrix is singular, if k4 is 0 */
        if (!(fabs(k4) > 0.0)) {
            return diff_drive_refuse(fabs(k4), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k7 is 0 */
        if (!(fabs(k7) > 0.0)) {
            return diff_drive_refuse(fabs(k7), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        return diff_drive_finish(3, lambda);
    }
    return DIFF_DRIVE_OK;
}

double diff_drive_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the parameters alone */
    const double r = p[3]; /* radius of the wheels [m] */
    const double k1 = 1.0 / (r * r);
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double k2 = k1 * (J_w * (b * b)) + 0.5 * (I + m * (d * d));
    const double k3 = 0.5 * m + J_w * k1;

    /* from the state */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    return w * w * k2 + v * v * k3;
}

int diff_drive_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 49 * sizeof *J);
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / r;
    const double k2 = b * k1;
    const double k3 = m + 2.0 * (k1 * (J_w * k1));
    const double k4 = m * d;
    const double k5 = d * k4 + (I + 2.0 * (k2 * (J_w * k2)));
    const double k6 = 1.0 / k3;
    const double k7 = 1.0 / k5;
    const double k8 = -k4 * k7;

    /* from the state */
    const double z1 = w * k4;
    /* (I.2.15) */
    J[2] = -s_theta * v;
    J[5] = c_theta;
    J[9] = c_theta * v;
    J[12] = s_theta;
    J[20] = 1.0;
    J[26] = k1;
    J[27] = k2;
    J[33] = k1;
    J[34] = -k2;
    J[41] = 2.0 * (k6 * z1);
    J[47] = -k7 * z1;
    J[48] = v * k8;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[34] + J[41] + J[47] + J[48]) <= DBL_MAX)) {
        /* the coframe is singular, if r is 0 */
        if (!(fabs(r) > 0.0)) {
            return diff_drive_refuse(fabs(r), 0.0, DIFF_DRIVE_SINGULAR_1);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return diff_drive_refuse(fabs(k3), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k5 is 0 */
        if (!(fabs(k5) > 0.0)) {
            return diff_drive_refuse(fabs(k5), 0.0, DIFF_DRIVE_SINGULAR_2);
        }
        return diff_drive_finish(49, J);
    }
    return DIFF_DRIVE_OK;
}

int diff_drive_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;

    /* from the state */
    const double r = p[3]; /* radius of the wheels [m] */
    /* the coframe is singular, if r is 0 */
    if (!(fabs(r) > 0.0)) {
        return diff_drive_refuse(fabs(r), 0.0, DIFF_DRIVE_SINGULAR_1);
    }
    (void)out;
    return DIFF_DRIVE_OK;
}

#if DIFF_DRIVE_LANES >= 2
static __attribute__((noinline)) void diff_drive_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    diff_drive_lanes far = {0}; /* the squares of the angles */
    diff_drive_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    diff_drive_bits bad = {0}; /* singular blocks */
    const double b = fixed[0];
    const double k1 = fixed[1];
    const double k4 = fixed[2];
    const double k5 = fixed[3];
    const double k7 = fixed[4];
    const double k8 = fixed[5];
    const double k9 = fixed[6];
    const diff_drive_lanes theta = diff_drive_get(y + 2 * stride);
    const diff_drive_lanes v = diff_drive_get(y + 5 * stride);
    const diff_drive_lanes w = diff_drive_get(y + 6 * stride);
    diff_drive_lanes sine1, cosine1;
    diff_drive_turn_lanes(DIFF_DRIVE_SPREAD(theta), &far, &sine1, &cosine1);
    const diff_drive_lanes c_theta = cosine1;
    const diff_drive_lanes s_theta = sine1;
    const diff_drive_lanes z1 = b * w;
    /* (I.2.4) */
    const diff_drive_lanes slope1 = c_theta * v;
    sum += slope1;
    diff_drive_put(dydt, slope1);
    const diff_drive_lanes slope2 = s_theta * v;
    diff_drive_put(dydt + 1 * stride, slope2);
    const diff_drive_lanes slope3 = w;
    diff_drive_put(dydt + 2 * stride, slope3);
    const diff_drive_lanes slope4 = k1 * (v + z1);
    sum += slope4;
    diff_drive_put(dydt + 3 * stride, slope4);
    const diff_drive_lanes slope5 = k1 * (v - z1);
    sum += slope5;
    diff_drive_put(dydt + 4 * stride, slope5);
    /* (I.2.15) 24:4 */
    const diff_drive_lanes slope6 = (k4 * (w * w) + k5) * k8;
    sum += slope6;
    diff_drive_put(dydt + 5 * stride, slope6);
    const diff_drive_lanes slope7 = (v * w * k4 - k7) * k9;
    sum += slope7;
    diff_drive_put(dydt + 6 * stride, slope7);
    diff_drive_put(check, diff_drive_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void diff_drive_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[DIFF_DRIVE_LANES];
    double state[7 * DIFF_DRIVE_LANES];
    double slope[7 * DIFF_DRIVE_LANES];
    diff_drive_fill(left, count, t, y, time, state);
    diff_drive_rhs_lanes(fixed, DIFF_DRIVE_LANES, time, state, slope, check);
    diff_drive_pour(left, count, slope, dydt);
}
#endif

int diff_drive_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if DIFF_DRIVE_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */
    const double k1 = 1.0 / r;
    const double k2 = b * k1;
    const double k3 = m + 2.0 * (k1 * (J_w * k1));
    const double k4 = m * d;
    const double k5 = k1 * (tau_R + tau_L);
    const double k6 = d * k4 + (I + 2.0 * (k2 * (J_w * k2)));
    const double k7 = k2 * (tau_R - tau_L);
    const double k8 = 1.0 / k3;
    const double k9 = -1.0 / k6;
    const double fixed[] = {b, k1, k4, k5, k7, k8, k9};
    double check[1 * DIFF_DRIVE_LANES];
    int status = DIFF_DRIVE_OK;
    for (size_t i = 0; i < count; i += DIFF_DRIVE_LANES) {
        const size_t left = count - i < DIFF_DRIVE_LANES ? count - i : DIFF_DRIVE_LANES;
        if (left == DIFF_DRIVE_LANES) {
            diff_drive_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            diff_drive_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!diff_drive_is_good(1 * DIFF_DRIVE_LANES, check)) {
            const int one = diff_drive_one_by_one(count, i, left, t, y, p, dydt);
            status = status == DIFF_DRIVE_OK ? one : status;
        }
    }
    return status;
#else
    return diff_drive_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
