/*
 * rolling_disk.c: rolling_disk, emitted by nhc 0.1.0 (nhc:f092f7d6b954c561)
 * A thin disk that rolls on a horizontal plane and may lean and fall (Euler's disk).
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * rolling_disk.h says what each function does.
 */
#include "rolling_disk.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const rolling_disk_coordinate_names[ROLLING_DISK_NQ] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const rolling_disk_state_names[ROLLING_DISK_NY] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "w_t",
    "w_u",
    "w_n"
};
const char *const rolling_disk_parameter_names[ROLLING_DISK_NP] = {
    "m",
    "R",
    "A",
    "C",
    "g"
};
const char *const rolling_disk_constraint_names[ROLLING_DISK_NC] = {
    "roll_x",
    "roll_y"
};
const char *const rolling_disk_output_names[ROLLING_DISK_NOUT] = {
    "height",
    "contact_x",
    "contact_y"
};
const double rolling_disk_parameter_defaults[ROLLING_DISK_NP] = {
    1.0,
    0.5,
    0.0625,
    0.125,
    9.81
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define ROLLING_DISK_SLOW __attribute__((cold, optimize("O1")))
#else
#define ROLLING_DISK_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int rolling_disk_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return ROLLING_DISK_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return ROLLING_DISK_NOT_FINITE;
        }
    }
    return ROLLING_DISK_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int rolling_disk_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : ROLLING_DISK_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef ROLLING_DISK_LANES
#if !defined(__GNUC__)
#define ROLLING_DISK_LANES 1
#elif defined(__AVX512F__)
#define ROLLING_DISK_LANES 8
#elif defined(__AVX__)
#define ROLLING_DISK_LANES 4
#else
#define ROLLING_DISK_LANES 2
#endif
#endif
#if ROLLING_DISK_LANES > 1
typedef double rolling_disk_lanes __attribute__((vector_size(8 * ROLLING_DISK_LANES)));
#else
typedef double rolling_disk_lanes;
#endif

#if ROLLING_DISK_LANES >= 2
static inline rolling_disk_lanes rolling_disk_get(const double *from)
{
    rolling_disk_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void rolling_disk_put(double *to, rolling_disk_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int rolling_disk_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = ROLLING_DISK_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[ROLLING_DISK_NY];
        double slope[ROLLING_DISK_NY];
        for (size_t k = 0; k < ROLLING_DISK_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = rolling_disk_rhs(t[i], state, p, slope);
        status = status == ROLLING_DISK_OK ? one : status;
        for (size_t k = 0; k < ROLLING_DISK_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if ROLLING_DISK_LANES >= 2
#define ROLLING_DISK_SPREAD(x) ((x) - (rolling_disk_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long rolling_disk_bits __attribute__((vector_size(8 * ROLLING_DISK_LANES)));

/* all bits where value is not above bound, or is no number */
static inline rolling_disk_bits rolling_disk_misses(rolling_disk_lanes value, rolling_disk_lanes bound)
{
    return ~(rolling_disk_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline rolling_disk_lanes rolling_disk_mark(rolling_disk_lanes value, rolling_disk_bits bad)
{
    return (rolling_disk_lanes)((rolling_disk_bits)value | bad);
}

static inline rolling_disk_lanes rolling_disk_size(rolling_disk_lanes x)
{
    return (rolling_disk_lanes)((rolling_disk_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int rolling_disk_is_good(int count, const double *check)
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
static inline void rolling_disk_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < ROLLING_DISK_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < ROLLING_DISK_NY; ++k) {
            state[k * ROLLING_DISK_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void rolling_disk_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < ROLLING_DISK_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * ROLLING_DISK_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void rolling_disk_turn_lanes(rolling_disk_lanes x, rolling_disk_lanes *far,
    rolling_disk_lanes *sine, rolling_disk_lanes *cosine)
{
    double angle[ROLLING_DISK_LANES];
    double up[ROLLING_DISK_LANES];
    double along[ROLLING_DISK_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < ROLLING_DISK_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int rolling_disk_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double w_t = y[5]; /* [rad/s] */
    const double w_u = y[6]; /* [rad/s] */
    const double w_n = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R;
    const double k2 = R * k1;
    const double k3 = C + k2;
    const double k4 = g * k1;
    const double k5 = 1.0 / A;
    const double k6 = A + k2;
    const double k7 = -1.0 / k6;
    const double k8 = k2 / k3;

    /* from the state */
    const double z1 = R * w_n;
    const double z2 = R * (s_theta * w_t);
    const double z3 = w_u / s_theta;
    const double z4 = c_theta * z3;
    const double z5 = A * z4;
    /* (I.2.4) */
    dydt[0] = s_phi * z2 - c_phi * z1; /* x' */
    dydt[1] = -(s_phi * z1 + c_phi * z2); /* y' */
    dydt[2] = z3; /* phi' */
    dydt[3] = w_t; /* theta' */
    dydt[4] = w_n - z4; /* psi' */
    /* (I.2.15) 22:4 */
    dydt[5] = (c_theta * k4 + w_u * (w_n * k3 - z5)) * k7; /* w_t' */
    dydt[6] = k5 * (w_t * (C * w_n - z5)); /* w_u' */
    dydt[7] = k8 * (w_t * w_u); /* w_n' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[4] + dydt[5] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(s_theta) > 1e-12)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if A is 0 */
        if (!(fabs(A) > 0.0)) {
            return rolling_disk_refuse(fabs(A), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return rolling_disk_refuse(fabs(k3), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k6 is 0 */
        if (!(fabs(k6) > 0.0)) {
            return rolling_disk_refuse(fabs(k6), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12)) {
            return rolling_disk_refuse(fabs(s_theta), 1e-12, ROLLING_DISK_SINGULAR_1);
        }
        return rolling_disk_finish(8, dydt);
    }
    return ROLLING_DISK_OK;
}

int rolling_disk_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double w_t = y[5]; /* [rad/s] */
    const double w_u = y[6]; /* [rad/s] */
    const double w_n = y[7]; /* [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the state */
    const double z1 = R * s_theta * w_t;
    const double z2 = R * w_n;
    const double z3 = w_u / s_theta;
    /* (I.2.4) */
    qdot[0] = s_phi * z1 - c_phi * z2; /* x' */
    qdot[1] = -(c_phi * z1 + s_phi * z2); /* y' */
    qdot[2] = z3; /* phi' */
    qdot[3] = w_t; /* theta' */
    qdot[4] = w_n - c_theta * z3; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[4]) <= DBL_MAX && fabs(s_theta) > 1e-12)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12)) {
            return rolling_disk_refuse(fabs(s_theta), 1e-12, ROLLING_DISK_SINGULAR_1);
        }
        return rolling_disk_finish(5, qdot);
    }
    return ROLLING_DISK_OK;
}

int rolling_disk_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double w_t = y[5]; /* [rad/s] */
    const double w_u = y[6]; /* [rad/s] */
    const double w_n = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R * R;
    const double k2 = A + k1;
    const double k3 = C + k1;
    const double k4 = g * (m * R);
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / A;
    const double k7 = k1 / k3;

    /* from the state */
    const double z = R * s_theta;
    const double z1 = z * w_t;
    const double z2 = 1.0 / s_theta;
    const double z3 = w_u * z2;
    const double z4 = c_phi * z3;
    const double z5 = c_theta * w_t;
    const double z6 = A * (c_theta * z3);
    const double z7 = k5 * (c_theta * k4 + w_u * (w_n * k3 - z6));
    const double z8 = R * (w_t * z5) - z * z7;
    const double z9 = R * w_n;
    const double z10 = s_phi * z3;
    const double z11 = w_t * w_u * k7;
    const double z12 = R * z11;
    const double z13 = z2 * z2 * (w_u * z5) - k6 * ((C * w_n - z6) * (w_t * z2));
    /* (I.2.15) */
    qddot[0] = z1 * z4 + s_phi * z8 + (z9 * z10 - c_phi * z12); /* x'' */
    qddot[1] = z1 * z10 - c_phi * z8 - (z9 * z4 + s_phi * z12); /* y'' */
    qddot[2] = -z13; /* phi'' */
    qddot[3] = -z7; /* theta'' */
    qddot[4] = z11 + (z3 * (s_theta * w_t) + c_theta * z13); /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[3] + qddot[4]) <= DBL_MAX && fabs(s_theta) > 1e-12)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if A is 0 */
        if (!(fabs(A) > 0.0)) {
            return rolling_disk_refuse(fabs(A), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k2 is 0 */
        if (!(fabs(k2) > 0.0)) {
            return rolling_disk_refuse(fabs(k2), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return rolling_disk_refuse(fabs(k3), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12)) {
            return rolling_disk_refuse(fabs(s_theta), 1e-12, ROLLING_DISK_SINGULAR_1);
        }
        return rolling_disk_finish(5, qddot);
    }
    return ROLLING_DISK_OK;
}

int rolling_disk_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double x = q[0]; /* centre [m] */
    const double y_2 = q[1]; /* y: centre [m] */
    const double phi = q[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double psi = q[4]; /* spin [rad] */
    const double phi_dot = qdot[2]; /* phi' [rad/s] */
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    const double psi_dot = qdot[4]; /* psi' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = theta_dot;
    y[6] = phi_dot * s_theta;
    y[7] = psi_dot + phi_dot * c_theta;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[4] + y[5] + y[7]) <= DBL_MAX)) {
        return rolling_disk_finish(8, y);
    }
    return ROLLING_DISK_OK;
}

int rolling_disk_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = q[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double phi_dot = qdot[2]; /* phi' [rad/s] */
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    const double psi_dot = qdot[4]; /* psi' [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the coordinates and velocities */
    const double z1 = R * (psi_dot + phi_dot * c_theta);
    const double z2 = theta_dot * (R * s_theta);
    /* (I.1.1) 25:5 */
    r[0] = x_dot + z1 * c_phi - s_phi * z2; /* roll_x = 0 */
    /* (I.1.1) 26:5 */
    r[1] = y_dot + z1 * s_phi + c_phi * z2; /* roll_y = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1]) <= DBL_MAX)) {
        return rolling_disk_finish(2, r);
    }
    return ROLLING_DISK_OK;
}

int rolling_disk_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double w_t = y[5]; /* [rad/s] */
    const double w_u = y[6]; /* [rad/s] */
    const double w_n = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R;
    const double k2 = m * R * R;
    const double k3 = A + k2;
    const double k4 = C + k2;
    const double k5 = g * k1;
    const double k6 = 1.0 / k3;
    const double k7 = 1.0 - k2 / k4;
    const double k8 = k4 * k6;

    /* from the state */
    const double z1 = w_t * w_u * k7;
    const double z2 = c_theta * (w_t * w_t + k6 * (A * (w_u * w_u) - s_theta * k5)) + w_u * w_n * (1.0 /
        s_theta - s_theta * k8);
    /* (I.4.1) 25:5 */
    lambda[0] = k1 * (c_phi * z1 + s_phi * z2); /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 26:5 */
    lambda[1] = k1 * (s_phi * z1 - c_phi * z2); /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(A) > 0.0 * (lambda[0] + lambda[1]) && fabs(s_theta) > 1e-12)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if A is 0 */
        if (!(fabs(A) > 0.0)) {
            return rolling_disk_refuse(fabs(A), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return rolling_disk_refuse(fabs(k3), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k4 is 0 */
        if (!(fabs(k4) > 0.0)) {
            return rolling_disk_refuse(fabs(k4), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12)) {
            return rolling_disk_refuse(fabs(s_theta), 1e-12, ROLLING_DISK_SINGULAR_1);
        }
        return rolling_disk_finish(2, lambda);
    }
    return ROLLING_DISK_OK;
}

double rolling_disk_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double w_t = y[5]; /* [rad/s] */
    const double w_u = y[6]; /* [rad/s] */
    const double w_n = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R;

    /* from the state */
    const double z1 = w_t * w_t;
    const double z2 = w_n * w_n;
    const double z3 = k1 * (0.5 * (R * (z1 + z2)) + g * s_theta) + 0.5 * (A * (w_u * w_u + z1) + C * z2);
    return z3;
}

ROLLING_DISK_SLOW
int rolling_disk_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 64 * sizeof *J);
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double w_t = y[5]; /* [rad/s] */
    const double w_u = y[6]; /* [rad/s] */
    const double w_n = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R * R;
    const double k2 = A + k1;
    const double k3 = C + k1;
    const double k4 = g * (m * R);
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / A;
    const double k7 = k1 / k3;
    const double k8 = -k3 * k5;
    const double k9 = C * k6;

    /* from the state */
    const double z = R * s_theta;
    const double z1 = z * w_t;
    const double z2 = R * w_n;
    const double z_dot = R * (c_theta * w_t);
    const double z3 = 1.0 / s_theta;
    const double z4 = z3 * z3;
    const double z5 = w_u * z4;
    const double z6 = c_theta * z5;
    const double z7 = c_theta * z3;
    const double z8 = A * (w_u * z7);
    /* (I.2.15) */
    J[2] = c_phi * z1 + s_phi * z2;
    J[3] = s_phi * z_dot;
    J[5] = z * s_phi;
    J[7] = -R * c_phi;
    J[10] = s_phi * z1 - c_phi * z2;
    J[11] = -c_phi * z_dot;
    J[13] = -z * c_phi;
    J[15] = -R * s_phi;
    J[19] = -z6;
    J[22] = z3;
    J[29] = 1.0;
    J[35] = w_u + c_theta * z6;
    J[38] = -z7;
    J[39] = 1.0;
    J[43] = k5 * (s_theta * k4 - A * (z4 * (w_u * w_u)));
    J[46] = (2.0 * z8 - w_n * k3) * k5;
    J[47] = w_u * k8;
    J[51] = w_t * z5;
    J[53] = k6 * (C * w_n - z8);
    J[54] = -w_t * z7;
    J[55] = w_t * k9;
    J[61] = w_u * k7;
    J[62] = w_t * k7;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[10] + J[11] + J[15] + J[35] + J[43] + J[46] + J[47] + J[51] + J[53] + J[54] + J[55] +
        J[61] + J[62]) <= DBL_MAX
        && fabs(s_theta) > 1e-12)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if A is 0 */
        if (!(fabs(A) > 0.0)) {
            return rolling_disk_refuse(fabs(A), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k2 is 0 */
        if (!(fabs(k2) > 0.0)) {
            return rolling_disk_refuse(fabs(k2), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return rolling_disk_refuse(fabs(k3), 0.0, ROLLING_DISK_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12)) {
            return rolling_disk_refuse(fabs(s_theta), 1e-12, ROLLING_DISK_SINGULAR_1);
        }
        return rolling_disk_finish(64, J);
    }
    return ROLLING_DISK_OK;
}

int rolling_disk_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double R = p[1]; /* radius [m] */

    /* from the state */
    const double z1 = R * c_theta;
    /* 33:11 */
    out[0] = R * s_theta; /* height */
    /* 34:14 */
    out[1] = x - s_phi * z1; /* contact_x */
    /* 35:14 */
    out[2] = y_2 + c_phi * z1; /* contact_y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[1] + out[2]) <= DBL_MAX && fabs(s_theta) > 1e-12)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12)) {
            return rolling_disk_refuse(fabs(s_theta), 1e-12, ROLLING_DISK_SINGULAR_1);
        }
        return rolling_disk_finish(3, out);
    }
    return ROLLING_DISK_OK;
}

#if ROLLING_DISK_LANES >= 2
static __attribute__((noinline)) void rolling_disk_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    rolling_disk_lanes far = {0}; /* the squares of the angles */
    rolling_disk_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    rolling_disk_bits bad = {0}; /* singular blocks */
    const double R = fixed[0];
    const double A = fixed[1];
    const double C = fixed[2];
    const double k3 = fixed[3];
    const double k4 = fixed[4];
    const double k5 = fixed[5];
    const double k7 = fixed[6];
    const double k8 = fixed[7];
    const rolling_disk_lanes phi = rolling_disk_get(y + 2 * stride);
    const rolling_disk_lanes theta = rolling_disk_get(y + 3 * stride);
    const rolling_disk_lanes w_t = rolling_disk_get(y + 5 * stride);
    const rolling_disk_lanes w_u = rolling_disk_get(y + 6 * stride);
    const rolling_disk_lanes w_n = rolling_disk_get(y + 7 * stride);
    rolling_disk_lanes sine1, cosine1;
    rolling_disk_turn_lanes(ROLLING_DISK_SPREAD(theta), &far, &sine1, &cosine1);
    const rolling_disk_lanes s_theta = sine1;
    /* the coframe is singular, if s_theta is nearly 0 */
    bad |= rolling_disk_misses(rolling_disk_size(ROLLING_DISK_SPREAD(s_theta)), ROLLING_DISK_SPREAD(1e-12));
    rolling_disk_lanes sine2, cosine2;
    rolling_disk_turn_lanes(ROLLING_DISK_SPREAD(phi), &far, &sine2, &cosine2);
    const rolling_disk_lanes c_phi = cosine2;
    const rolling_disk_lanes z1 = R * w_n;
    const rolling_disk_lanes s_phi = sine2;
    const rolling_disk_lanes z2 = R * (s_theta * w_t);
    const rolling_disk_lanes z3 = w_u / s_theta;
    const rolling_disk_lanes c_theta = cosine1;
    const rolling_disk_lanes z4 = c_theta * z3;
    const rolling_disk_lanes z5 = A * z4;
    /* (I.2.4) */
    const rolling_disk_lanes slope1 = s_phi * z2 - c_phi * z1;
    sum += slope1;
    rolling_disk_put(dydt, slope1);
    const rolling_disk_lanes slope2 = -(s_phi * z1 + c_phi * z2);
    sum += slope2;
    rolling_disk_put(dydt + 1 * stride, slope2);
    const rolling_disk_lanes slope3 = z3;
    rolling_disk_put(dydt + 2 * stride, slope3);
    const rolling_disk_lanes slope4 = w_t;
    rolling_disk_put(dydt + 3 * stride, slope4);
    const rolling_disk_lanes slope5 = w_n - z4;
    sum += slope5;
    rolling_disk_put(dydt + 4 * stride, slope5);
    /* (I.2.15) 22:4 */
    const rolling_disk_lanes slope6 = (c_theta * k4 + w_u * (w_n * k3 - z5)) * k7;
    sum += slope6;
    rolling_disk_put(dydt + 5 * stride, slope6);
    const rolling_disk_lanes slope7 = k5 * (w_t * (C * w_n - z5));
    sum += slope7;
    rolling_disk_put(dydt + 6 * stride, slope7);
    const rolling_disk_lanes slope8 = k8 * (w_t * w_u);
    sum += slope8;
    rolling_disk_put(dydt + 7 * stride, slope8);
    rolling_disk_put(check, rolling_disk_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void rolling_disk_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[ROLLING_DISK_LANES];
    double state[8 * ROLLING_DISK_LANES];
    double slope[8 * ROLLING_DISK_LANES];
    rolling_disk_fill(left, count, t, y, time, state);
    rolling_disk_rhs_lanes(fixed, ROLLING_DISK_LANES, time, state, slope, check);
    rolling_disk_pour(left, count, slope, dydt);
}
#endif

int rolling_disk_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if ROLLING_DISK_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * R;
    const double k2 = R * k1;
    const double k3 = C + k2;
    const double k4 = g * k1;
    const double k5 = 1.0 / A;
    const double k6 = A + k2;
    const double k7 = -1.0 / k6;
    const double k8 = k2 / k3;
    const double fixed[] = {R, A, C, k3, k4, k5, k7, k8};
    double check[1 * ROLLING_DISK_LANES];
    int status = ROLLING_DISK_OK;
    for (size_t i = 0; i < count; i += ROLLING_DISK_LANES) {
        const size_t left = count - i < ROLLING_DISK_LANES ? count - i : ROLLING_DISK_LANES;
        if (left == ROLLING_DISK_LANES) {
            rolling_disk_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            rolling_disk_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!rolling_disk_is_good(1 * ROLLING_DISK_LANES, check)) {
            const int one = rolling_disk_one_by_one(count, i, left, t, y, p, dydt);
            status = status == ROLLING_DISK_OK ? one : status;
        }
    }
    return status;
#else
    return rolling_disk_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
