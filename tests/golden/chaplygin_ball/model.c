/*
 * chaplygin_ball.c: chaplygin_ball, emitted by nhc 0.1.0 (nhc:9b1d2c6147ce17ee)
 * A ball with three different moments of inertia and its centre of mass at its centre rolls on a horizontal
 *     plane.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * chaplygin_ball.h says what each function does.
 */
#include "chaplygin_ball.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const chaplygin_ball_coordinate_names[CHAPLYGIN_BALL_NQ] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const chaplygin_ball_state_names[CHAPLYGIN_BALL_NY] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "w1",
    "w2",
    "w3"
};
const char *const chaplygin_ball_parameter_names[CHAPLYGIN_BALL_NP] = {
    "m",
    "a",
    "I1",
    "I2",
    "I3"
};
const char *const chaplygin_ball_constraint_names[CHAPLYGIN_BALL_NC] = {
    "roll_x",
    "roll_y"
};
const char *const chaplygin_ball_output_names[CHAPLYGIN_BALL_NOUT] = {
    "K1",
    "K2",
    "K3"
};
const double chaplygin_ball_parameter_defaults[CHAPLYGIN_BALL_NP] = {
    1.0,
    1.0,
    0.4,
    0.5,
    0.7
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define CHAPLYGIN_BALL_SLOW __attribute__((cold, optimize("O1")))
#else
#define CHAPLYGIN_BALL_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int chaplygin_ball_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CHAPLYGIN_BALL_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CHAPLYGIN_BALL_NOT_FINITE;
        }
    }
    return CHAPLYGIN_BALL_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int chaplygin_ball_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CHAPLYGIN_BALL_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CHAPLYGIN_BALL_LANES
#if !defined(__GNUC__)
#define CHAPLYGIN_BALL_LANES 1
#elif defined(__AVX512F__)
#define CHAPLYGIN_BALL_LANES 8
#elif defined(__AVX__)
#define CHAPLYGIN_BALL_LANES 4
#else
#define CHAPLYGIN_BALL_LANES 2
#endif
#endif
#if CHAPLYGIN_BALL_LANES > 1
typedef double chaplygin_ball_lanes __attribute__((vector_size(8 * CHAPLYGIN_BALL_LANES)));
#else
typedef double chaplygin_ball_lanes;
#endif

#if CHAPLYGIN_BALL_LANES >= 2
static inline chaplygin_ball_lanes chaplygin_ball_get(const double *from)
{
    chaplygin_ball_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void chaplygin_ball_put(double *to, chaplygin_ball_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int chaplygin_ball_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CHAPLYGIN_BALL_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CHAPLYGIN_BALL_NY];
        double slope[CHAPLYGIN_BALL_NY];
        for (size_t k = 0; k < CHAPLYGIN_BALL_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = chaplygin_ball_rhs(t[i], state, p, slope);
        status = status == CHAPLYGIN_BALL_OK ? one : status;
        for (size_t k = 0; k < CHAPLYGIN_BALL_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CHAPLYGIN_BALL_LANES >= 2
#define CHAPLYGIN_BALL_SPREAD(x) ((x) - (chaplygin_ball_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long chaplygin_ball_bits __attribute__((vector_size(8 * CHAPLYGIN_BALL_LANES)));

/* all bits where value is not above bound, or is no number */
static inline chaplygin_ball_bits chaplygin_ball_misses(chaplygin_ball_lanes value, chaplygin_ball_lanes bound)
{
    return ~(chaplygin_ball_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline chaplygin_ball_lanes chaplygin_ball_mark(chaplygin_ball_lanes value, chaplygin_ball_bits bad)
{
    return (chaplygin_ball_lanes)((chaplygin_ball_bits)value | bad);
}

static inline chaplygin_ball_lanes chaplygin_ball_size(chaplygin_ball_lanes x)
{
    return (chaplygin_ball_lanes)((chaplygin_ball_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int chaplygin_ball_is_good(int count, const double *check)
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
static inline void chaplygin_ball_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CHAPLYGIN_BALL_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CHAPLYGIN_BALL_NY; ++k) {
            state[k * CHAPLYGIN_BALL_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void chaplygin_ball_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CHAPLYGIN_BALL_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CHAPLYGIN_BALL_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void chaplygin_ball_turn_lanes(chaplygin_ball_lanes x, chaplygin_ball_lanes *far,
    chaplygin_ball_lanes *sine, chaplygin_ball_lanes *cosine)
{
    double angle[CHAPLYGIN_BALL_LANES];
    double up[CHAPLYGIN_BALL_LANES];
    double along[CHAPLYGIN_BALL_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < CHAPLYGIN_BALL_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int chaplygin_ball_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double w1 = y[5]; /* [rad/s] */
    const double w2 = y[6]; /* [rad/s] */
    const double w3 = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;
    const double k5 = I2 + k1;
    const double k6 = I1 + k1;
    const double k7 = I3 + k1;
    const double k8 = 1.0 / k6;
    const double k9 = 1.0 / k5;
    const double k10 = 1.0 / k7;
    const double k11 = k8 - k9;
    const double k12 = k9 - k10;

    /* from the state */
    const double z1 = 1.0 - k1 * (k10 + s_theta * s_theta * (s_psi * s_psi * k11 + k12));
    const double z2 = s_psi * w2 - c_psi * w1;
    const double v2_x = a * z2;
    const double z3 = (c_psi * w2 + s_psi * w1) / s_theta;
    const double z4 = w3 - c_theta * z3;
    const double z5 = s_theta * (a * z4);
    const double z6 = w2 * w3 * k2;
    const double z7 = s_theta * s_psi;
    const double z8 = w1 * w2 * k4;
    const double z9 = w1 * w3 * k3;
    const double z10 = s_theta * c_psi;
    const double z11 = k1 / z1 * (z8 * (c_theta * k10) + (z6 * (z7 * k8) - z9 * (z10 * k9)));
    /* (I.2.4) */
    dydt[0] = -(s_phi * v2_x + c_phi * z5); /* x' */
    dydt[1] = c_phi * v2_x - s_phi * z5; /* y' */
    dydt[2] = z3; /* phi' */
    dydt[3] = -z2; /* theta' */
    dydt[4] = z4; /* psi' */
    /* (I.2.15) 25:4 */
    dydt[5] = k8 * (z6 + z7 * z11); /* w1' */
    dydt[6] = (z10 * z11 - z9) * k9; /* w2' */
    dydt[7] = k10 * (z8 + c_theta * z11); /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[5] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(z1) > 1e-13)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k5 is 0 */
        if (!(fabs(k5) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k5), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k6 is 0 */
        if (!(fabs(k6) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k6), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k7 is 0 */
        if (!(fabs(k7) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k7), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return chaplygin_ball_refuse(fabs(s_theta), 1e-12 * 4.0, CHAPLYGIN_BALL_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z1 is nearly 0 */
        if (!(fabs(z1) > 1e-13)) {
            return chaplygin_ball_refuse(fabs(z1), 1e-13, CHAPLYGIN_BALL_SINGULAR_2);
        }
        return chaplygin_ball_finish(8, dydt);
    }
    return CHAPLYGIN_BALL_OK;
}

int chaplygin_ball_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);

    /* what else is read */
    const double w1 = y[5]; /* [rad/s] */
    const double w2 = y[6]; /* [rad/s] */
    const double w3 = y[7]; /* [rad/s] */
    const double a = p[1]; /* radius [m] */

    /* from the state */
    const double z1 = s_psi * w2 - c_psi * w1;
    const double v2_x = a * z1;
    const double z2 = (c_psi * w2 + s_psi * w1) / s_theta;
    const double z3 = w3 - c_theta * z2;
    const double z4 = s_theta * (a * z3);
    /* (I.2.4) */
    qdot[0] = -(s_phi * v2_x + c_phi * z4); /* x' */
    qdot[1] = c_phi * v2_x - s_phi * z4; /* y' */
    qdot[2] = z2; /* phi' */
    qdot[3] = -z1; /* theta' */
    qdot[4] = z3; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[3]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return chaplygin_ball_refuse(fabs(s_theta), 1e-12 * 4.0, CHAPLYGIN_BALL_SINGULAR_1);
        }
        return chaplygin_ball_finish(5, qdot);
    }
    return CHAPLYGIN_BALL_OK;
}

CHAPLYGIN_BALL_SLOW
int chaplygin_ball_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double w1 = y[5]; /* [rad/s] */
    const double w2 = y[6]; /* [rad/s] */
    const double w3 = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;
    const double k5 = I2 + k1;
    const double k6 = I1 + k1;
    const double k7 = I3 + k1;
    const double k8 = 1.0 / k6;
    const double k9 = 1.0 / k5;
    const double k10 = 1.0 / k7;
    const double k11 = k8 - k9;
    const double k12 = k9 - k10;

    /* from the state */
    const double z1 = 1.0 - k1 * (k10 + s_theta * s_theta * (s_psi * s_psi * k11 + k12));
    const double z2 = s_psi * w2 - c_psi * w1;
    const double v2_x = a * z2;
    const double z3 = 1.0 / s_theta;
    const double z4 = c_psi * w2 + s_psi * w1;
    const double z5 = z3 * z4;
    const double z6 = c_phi * z5;
    const double z7 = w3 - c_theta * z5;
    const double z8 = c_psi * z7;
    const double z9 = w1 * w3 * k3;
    const double z10 = s_theta * c_psi;
    const double z11 = w1 * w2 * k4;
    const double z12 = w2 * w3 * k2;
    const double z13 = s_theta * s_psi;
    const double z14 = k1 / z1 * (z11 * (c_theta * k10) + (z12 * (z13 * k8) - z9 * (z10 * k9)));
    const double z15 = k9 * (z9 - z10 * z14);
    const double z16 = s_psi * z7;
    const double z17 = k8 * (z12 + z13 * z14);
    const double z18 = w2 * z8 - s_psi * z15 + (w1 * z16 - c_psi * z17);
    const double z19 = a * z18;
    const double z20 = a * z7;
    const double z21 = s_theta * z20;
    const double z22 = s_phi * z5;
    const double z23 = c_theta * z2;
    const double z24 = z4 * (z23 * (z3 * z3)) - z3 * (w2 * z16 + c_psi * z15 - (w1 * z8 + s_psi * z17));
    const double z25 = k10 * (z11 + c_theta * z14) - (z5 * (s_theta * z2) + c_theta * z24);
    const double z26 = z20 * z23 - s_theta * (a * z25);
    /* (I.2.15) */
    qddot[0] = z21 * z22 + c_phi * z26 - (v2_x * z6 + s_phi * z19); /* x'' */
    qddot[1] = -(v2_x * z22 - c_phi * z19 + (z21 * z6 - s_phi * z26)); /* y'' */
    qddot[2] = z24; /* phi'' */
    qddot[3] = -z18; /* theta'' */
    qddot[4] = z25; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[3]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(z1) > 1e-13)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k5 is 0 */
        if (!(fabs(k5) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k5), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k6 is 0 */
        if (!(fabs(k6) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k6), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k7 is 0 */
        if (!(fabs(k7) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k7), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return chaplygin_ball_refuse(fabs(s_theta), 1e-12 * 4.0, CHAPLYGIN_BALL_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z1 is nearly 0 */
        if (!(fabs(z1) > 1e-13)) {
            return chaplygin_ball_refuse(fabs(z1), 1e-13, CHAPLYGIN_BALL_SINGULAR_2);
        }
        return chaplygin_ball_finish(5, qddot);
    }
    return CHAPLYGIN_BALL_OK;
}

int chaplygin_ball_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[3]; /* nutation [rad] */
    const double psi = q[4]; /* spin [rad] */

    /* sines and cosines */
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double x = q[0]; /* centre [m] */
    const double y_2 = q[1]; /* y: centre [m] */
    const double phi = q[2]; /* precession [rad] */
    const double phi_dot = qdot[2]; /* phi' [rad/s] */
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    const double psi_dot = qdot[4]; /* psi' [rad/s] */

    /* from the coordinates and velocities */
    const double z1 = phi_dot * s_theta;
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = theta_dot * c_psi + s_psi * z1;
    y[6] = c_psi * z1 - theta_dot * s_psi;
    y[7] = psi_dot + phi_dot * c_theta;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[5] + y[6] + y[7]) <= DBL_MAX)) {
        return chaplygin_ball_finish(8, y);
    }
    return CHAPLYGIN_BALL_OK;
}

int chaplygin_ball_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    const double psi_dot = qdot[4]; /* psi' [rad/s] */
    const double a = p[1]; /* radius [m] */

    /* from the coordinates and velocities */
    const double z1 = psi_dot * s_theta;
    /* (I.1.1) 27:5 */
    r[0] = x_dot - a * (theta_dot * s_phi - c_phi * z1); /* roll_x = 0 */
    /* (I.1.1) 28:5 */
    r[1] = y_dot + a * (theta_dot * c_phi + s_phi * z1); /* roll_y = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1]) <= DBL_MAX)) {
        return chaplygin_ball_finish(2, r);
    }
    return CHAPLYGIN_BALL_OK;
}

CHAPLYGIN_BALL_SLOW
int chaplygin_ball_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double w1 = y[5]; /* [rad/s] */
    const double w2 = y[6]; /* [rad/s] */
    const double w3 = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = m * a;
    const double k3 = I2 - I3;
    const double k4 = I1 - I3;
    const double k5 = I1 - I2;
    const double k6 = I2 + k1;
    const double k7 = I1 + k1;
    const double k8 = I3 + k1;
    const double k9 = 1.0 / k7;
    const double k10 = 1.0 / k6;
    const double k11 = 1.0 / k8;
    const double k12 = k9 - k10;
    const double k13 = k10 - k11;

    /* from the state */
    const double z1 = 1.0 - k1 * (k11 + s_theta * s_theta * (s_psi * s_psi * k12 + k13));
    const double z2 = w1 * w2 * k5;
    const double z3 = s_theta * s_psi;
    const double z4 = w2 * w3 * k3;
    const double z5 = s_theta * c_psi;
    const double z6 = w1 * w3 * k4;
    const double z7 = k1 * ((k11 * (c_theta * z2) + (k9 * (z3 * z4) - k10 * (z5 * z6))) / z1);
    const double z8 = s_theta * k2 * (k11 * (z2 + c_theta * z7));
    const double z9 = s_psi * c_theta;
    const double z10 = k2 * (k9 * (z4 + z3 * z7));
    const double z11 = c_psi * c_theta;
    const double z12 = k2 * (k10 * (z6 - z5 * z7));
    const double z13 = c_phi * z8 - ((c_phi * z9 + c_psi * s_phi) * z10 + (s_psi * s_phi - c_phi * z11) *
        z12);
    const double z14 = s_phi * z8 - ((s_phi * z9 - c_psi * c_phi) * z10 - (s_psi * c_phi + s_phi * z11) *
        z12);
    /* (I.4.1) 27:5 */
    lambda[0] = -z13; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 28:5 */
    lambda[1] = -z14; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0 && fabs(z1) > 1e-13)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k6 is 0 */
        if (!(fabs(k6) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k6), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k7 is 0 */
        if (!(fabs(k7) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k7), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k8 is 0 */
        if (!(fabs(k8) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k8), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return chaplygin_ball_refuse(fabs(s_theta), 1e-12 * 4.0, CHAPLYGIN_BALL_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z1 is nearly 0 */
        if (!(fabs(z1) > 1e-13)) {
            return chaplygin_ball_refuse(fabs(z1), 1e-13, CHAPLYGIN_BALL_SINGULAR_2);
        }
        return chaplygin_ball_finish(2, lambda);
    }
    return CHAPLYGIN_BALL_OK;
}

double chaplygin_ball_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);

    /* what else is read */
    const double w1 = y[5]; /* [rad/s] */
    const double w2 = y[6]; /* [rad/s] */
    const double w3 = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * a * a;

    /* from the state */
    const double z1 = w3 * w3;
    const double z2 = w1 * w1;
    const double z3 = w2 * w2;
    const double z4 = c_psi * w2;
    const double z5 = (z4 + s_psi * w1) * (c_theta * w3) - s_theta * (0.5 * (z1 - z3) - s_psi * (0.5 * (s_psi
        * (z2 - z3)) + w1 * z4));
    const double z6 = 0.5 * (I3 * z1 + (I1 * z2 + I2 * z3)) + k1 * (0.5 * (z2 + z3) - s_theta * z5);
    return z6;
}

CHAPLYGIN_BALL_SLOW
int chaplygin_ball_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 64 * sizeof *J);
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double w1 = y[5]; /* [rad/s] */
    const double w2 = y[6]; /* [rad/s] */
    const double w3 = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;
    const double k5 = I2 + k1;
    const double k6 = I1 + k1;
    const double k7 = I3 + k1;
    const double k8 = 1.0 / k6;
    const double k9 = 1.0 / k5;
    const double k10 = 1.0 / k7;
    const double k11 = k8 - k9;
    const double k12 = k9 - k10;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = s_psi * s_psi;
    const double z3 = 1.0 - k1 * (k10 + z1 * (z2 * k11 + k12));
    const double z4 = s_psi * w2 - c_psi * w1;
    const double v2_x = a * z4;
    const double z5 = 1.0 / s_theta;
    const double z6 = c_psi * w2 + s_psi * w1;
    const double z7 = c_theta * z6;
    const double z8 = a * (w3 - z5 * z7);
    const double z9 = s_theta * z8;
    const double z10 = a * s_theta;
    const double z11 = z5 * z5 * z7;
    const double z12 = z6 + c_theta * z11;
    const double z13 = c_theta * z8 + z10 * z12;
    const double z14 = a * z6;
    const double z15 = z5 * z4;
    const double z16 = c_theta * z15;
    const double z17 = z10 * z16;
    const double z18 = a * c_psi;
    const double z19 = s_psi * z5;
    const double z20 = c_theta * z19;
    const double z21 = z20 * z10;
    const double z22 = a * s_psi;
    const double z23 = c_psi * z5;
    const double z24 = c_theta * z23;
    const double z25 = z24 * z10;
    const double z26 = s_theta * k1;
    const double z27 = s_psi * z26;
    const double z28 = w1 * k4;
    const double z29 = w2 * z28;
    const double z30 = k1 / z3;
    const double z31 = c_theta * k10;
    const double z32 = s_theta * s_psi;
    const double z33 = z32 * k8;
    const double z34 = w2 * k2;
    const double z35 = w3 * z34;
    const double z36 = s_theta * c_psi;
    const double z37 = z36 * k9;
    const double z38 = w1 * k3;
    const double z39 = w3 * z38;
    const double z40 = z30 * (z31 * z29 + (z33 * z35 - z37 * z39));
    const double z41 = k10 * (z29 + c_theta * z40);
    const double z42 = s_theta * z41;
    const double z43 = c_theta * z41;
    const double z44 = s_psi * k1;
    const double z45 = k9 * (z39 - z36 * z40);
    const double z46 = c_psi * z45;
    const double z47 = k8 * (z35 + z32 * z40);
    const double z48 = k1 * z47;
    const double z49 = z27 * z42 - c_theta * (z43 * z44 - 2.0 * (s_theta * (z46 * z44 - z2 * z48)));
    const double z50 = c_psi * z26;
    const double z51 = c_theta * z45;
    const double z52 = c_theta * z47;
    const double z53 = s_theta * (z50 * z45 - z27 * z47) - c_theta * (k1 * (c_psi * z51 - s_psi * z52) + 2.0
        * (k1 * z42));
    const double z54 = c_psi * z47;
    const double z55 = c_theta * (k1 * (c_psi * z43) - 2.0 * (s_theta * (k1 * (c_psi * c_psi * z45) - z54 *
        z44)));
    const double z56 = z50 * z42 - z55;
    const double z57 = z30 * (z31 * z53 - (z33 * z49 + z37 * z56));
    const double z58 = k1 * z1;
    const double z59 = z26 * z43;
    const double z60 = z58 * z46;
    const double z61 = s_psi * z1 * z48;
    const double z62 = z2 * z58 * z45 + c_psi * (z59 - z60 + 2.0 * z61);
    const double z63 = z27 * z51 + z50 * z52;
    const double z64 = c_psi * z58 * z54 + s_psi * (2.0 * z60 - (z59 + z61));
    const double z65 = z30 * (z31 * z63 + (z33 * z62 + z37 * z64));
    const double z66 = w3 * k3;
    const double z67 = w2 * k4;
    const double z68 = z30 * (z37 * z66 - z31 * z67);
    const double z69 = w3 * k2;
    const double z70 = z30 * (z33 * z69 + z31 * z28);
    const double z71 = z30 * (z34 * z33 - z38 * z37);
    /* (I.2.15) */
    J[2] = s_phi * z9 - c_phi * v2_x;
    J[3] = -c_phi * z13;
    J[4] = -(s_phi * z14 + c_phi * z17);
    J[5] = s_phi * z18 + c_phi * z21;
    J[6] = c_phi * z25 - s_phi * z22;
    J[7] = -c_phi * z10;
    J[10] = -(s_phi * v2_x + c_phi * z9);
    J[11] = -s_phi * z13;
    J[12] = c_phi * z14 - s_phi * z17;
    J[13] = s_phi * z21 - c_phi * z18;
    J[14] = c_phi * z22 + s_phi * z25;
    J[15] = -s_phi * z10;
    J[19] = -z11;
    J[20] = -z15;
    J[21] = z19;
    J[22] = z23;
    J[28] = -z6;
    J[29] = c_psi;
    J[30] = -s_psi;
    J[35] = z12;
    J[36] = z16;
    J[37] = -z20;
    J[38] = -z24;
    J[39] = 1.0;
    J[43] = (z32 * z57 - z49) * k8;
    J[44] = k8 * (z62 + z32 * z65);
    J[45] = -z33 * z68;
    J[46] = k8 * (z69 + z32 * z70);
    J[47] = k8 * (z34 + z32 * z71);
    J[51] = (z36 * z57 - z56) * k9;
    J[52] = k9 * (z64 + z36 * z65);
    J[53] = -k9 * (z66 + z36 * z68);
    J[54] = z37 * z70;
    J[55] = (z36 * z71 - z38) * k9;
    J[59] = k10 * (z53 + c_theta * z57);
    J[60] = k10 * (z63 + c_theta * z65);
    J[61] = k10 * (z67 - c_theta * z68);
    J[62] = k10 * (z28 + c_theta * z70);
    J[63] = z31 * z71;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[4] + J[5] + J[6] + J[10] + J[11] + J[12] + J[13] + J[14] + J[15] + J[19] + J[20] +
        J[28] + J[38] + J[43] + J[44] + J[45] + J[46] + J[47] + J[51] + J[52] + J[53] + J[54] + J[55] + J[59]
        + J[60] + J[61] + J[62] + J[63]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(z3) > 1e-13)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k5 is 0 */
        if (!(fabs(k5) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k5), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k6 is 0 */
        if (!(fabs(k6) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k6), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if k7 is 0 */
        if (!(fabs(k7) > 0.0)) {
            return chaplygin_ball_refuse(fabs(k7), 0.0, CHAPLYGIN_BALL_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return chaplygin_ball_refuse(fabs(s_theta), 1e-12 * 4.0, CHAPLYGIN_BALL_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z3 is nearly 0 */
        if (!(fabs(z3) > 1e-13)) {
            return chaplygin_ball_refuse(fabs(z3), 1e-13, CHAPLYGIN_BALL_SINGULAR_2);
        }
        return chaplygin_ball_finish(64, J);
    }
    return CHAPLYGIN_BALL_OK;
}

int chaplygin_ball_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);

    /* what else is read */
    const double w1 = y[5]; /* [rad/s] */
    const double w2 = y[6]; /* [rad/s] */
    const double w3 = y[7]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * a * a;

    /* from the state */
    const double z1 = c_psi * w2 + s_psi * w1;
    const double z2 = s_theta * (c_theta * w3 + s_theta * z1);
    /* 35:7 */
    out[0] = I1 * w1 + k1 * (w1 - s_psi * z2); /* K1 */
    /* 36:7 */
    out[1] = I2 * w2 + k1 * (w2 - c_psi * z2); /* K2 */
    /* 37:7 */
    out[2] = I3 * w3 + k1 * (s_theta * (s_theta * w3 - c_theta * z1)); /* K3 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1] + out[2]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return chaplygin_ball_refuse(fabs(s_theta), 1e-12 * 4.0, CHAPLYGIN_BALL_SINGULAR_1);
        }
        return chaplygin_ball_finish(3, out);
    }
    return CHAPLYGIN_BALL_OK;
}

#if CHAPLYGIN_BALL_LANES >= 2
static __attribute__((noinline)) void chaplygin_ball_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    chaplygin_ball_lanes far = {0}; /* the squares of the angles */
    chaplygin_ball_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    chaplygin_ball_bits bad = {0}; /* singular blocks */
    const double a = fixed[0];
    const double k1 = fixed[1];
    const double k2 = fixed[2];
    const double k3 = fixed[3];
    const double k4 = fixed[4];
    const double k8 = fixed[5];
    const double k9 = fixed[6];
    const double k10 = fixed[7];
    const double k11 = fixed[8];
    const double k12 = fixed[9];
    const chaplygin_ball_lanes phi = chaplygin_ball_get(y + 2 * stride);
    const chaplygin_ball_lanes theta = chaplygin_ball_get(y + 3 * stride);
    const chaplygin_ball_lanes psi = chaplygin_ball_get(y + 4 * stride);
    const chaplygin_ball_lanes w1 = chaplygin_ball_get(y + 5 * stride);
    const chaplygin_ball_lanes w2 = chaplygin_ball_get(y + 6 * stride);
    const chaplygin_ball_lanes w3 = chaplygin_ball_get(y + 7 * stride);
    chaplygin_ball_lanes sine1, cosine1;
    chaplygin_ball_turn_lanes(CHAPLYGIN_BALL_SPREAD(theta), &far, &sine1, &cosine1);
    const chaplygin_ball_lanes s_theta = sine1;
    /* the coframe is singular, if s_theta is nearly 0 */
    bad |= chaplygin_ball_misses(chaplygin_ball_size(CHAPLYGIN_BALL_SPREAD(s_theta)),
        CHAPLYGIN_BALL_SPREAD(1e-12 * 4.0));
    chaplygin_ball_lanes sine2, cosine2;
    chaplygin_ball_turn_lanes(CHAPLYGIN_BALL_SPREAD(psi), &far, &sine2, &cosine2);
    const chaplygin_ball_lanes s_psi = sine2;
    const chaplygin_ball_lanes z1 = 1.0 - k1 * (k10 + s_theta * s_theta * (s_psi * s_psi * k11 + k12));
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z1 is nearly 0 */
    bad |= chaplygin_ball_misses(chaplygin_ball_size(CHAPLYGIN_BALL_SPREAD(z1)),
        CHAPLYGIN_BALL_SPREAD(1e-13));
    chaplygin_ball_lanes sine3, cosine3;
    chaplygin_ball_turn_lanes(CHAPLYGIN_BALL_SPREAD(phi), &far, &sine3, &cosine3);
    const chaplygin_ball_lanes s_phi = sine3;
    const chaplygin_ball_lanes c_psi = cosine2;
    const chaplygin_ball_lanes z2 = s_psi * w2 - c_psi * w1;
    const chaplygin_ball_lanes v2_x = a * z2;
    const chaplygin_ball_lanes c_phi = cosine3;
    const chaplygin_ball_lanes c_theta = cosine1;
    const chaplygin_ball_lanes z3 = (c_psi * w2 + s_psi * w1) / s_theta;
    const chaplygin_ball_lanes z4 = w3 - c_theta * z3;
    const chaplygin_ball_lanes z5 = s_theta * (a * z4);
    const chaplygin_ball_lanes z6 = w2 * w3 * k2;
    const chaplygin_ball_lanes z7 = s_theta * s_psi;
    const chaplygin_ball_lanes z8 = w1 * w2 * k4;
    const chaplygin_ball_lanes z9 = w1 * w3 * k3;
    const chaplygin_ball_lanes z10 = s_theta * c_psi;
    const chaplygin_ball_lanes z11 = k1 / z1 * (z8 * (c_theta * k10) + (z6 * (z7 * k8) - z9 * (z10 * k9)));
    /* (I.2.4) */
    const chaplygin_ball_lanes slope1 = -(s_phi * v2_x + c_phi * z5);
    sum += slope1;
    chaplygin_ball_put(dydt, slope1);
    const chaplygin_ball_lanes slope2 = c_phi * v2_x - s_phi * z5;
    sum += slope2;
    chaplygin_ball_put(dydt + 1 * stride, slope2);
    const chaplygin_ball_lanes slope3 = z3;
    chaplygin_ball_put(dydt + 2 * stride, slope3);
    const chaplygin_ball_lanes slope4 = -z2;
    sum += slope4;
    chaplygin_ball_put(dydt + 3 * stride, slope4);
    const chaplygin_ball_lanes slope5 = z4;
    chaplygin_ball_put(dydt + 4 * stride, slope5);
    /* (I.2.15) 25:4 */
    const chaplygin_ball_lanes slope6 = k8 * (z6 + z7 * z11);
    sum += slope6;
    chaplygin_ball_put(dydt + 5 * stride, slope6);
    const chaplygin_ball_lanes slope7 = (z10 * z11 - z9) * k9;
    sum += slope7;
    chaplygin_ball_put(dydt + 6 * stride, slope7);
    const chaplygin_ball_lanes slope8 = k10 * (z8 + c_theta * z11);
    sum += slope8;
    chaplygin_ball_put(dydt + 7 * stride, slope8);
    chaplygin_ball_put(check, chaplygin_ball_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void chaplygin_ball_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CHAPLYGIN_BALL_LANES];
    double state[8 * CHAPLYGIN_BALL_LANES];
    double slope[8 * CHAPLYGIN_BALL_LANES];
    chaplygin_ball_fill(left, count, t, y, time, state);
    chaplygin_ball_rhs_lanes(fixed, CHAPLYGIN_BALL_LANES, time, state, slope, check);
    chaplygin_ball_pour(left, count, slope, dydt);
}
#endif

int chaplygin_ball_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if CHAPLYGIN_BALL_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k1 = m * a * a;
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;
    const double k5 = I2 + k1;
    const double k6 = I1 + k1;
    const double k7 = I3 + k1;
    const double k8 = 1.0 / k6;
    const double k9 = 1.0 / k5;
    const double k10 = 1.0 / k7;
    const double k11 = k8 - k9;
    const double k12 = k9 - k10;
    const double fixed[] = {a, k1, k2, k3, k4, k8, k9, k10, k11, k12};
    double check[1 * CHAPLYGIN_BALL_LANES];
    int status = CHAPLYGIN_BALL_OK;
    for (size_t i = 0; i < count; i += CHAPLYGIN_BALL_LANES) {
        const size_t left = count - i < CHAPLYGIN_BALL_LANES ? count - i : CHAPLYGIN_BALL_LANES;
        if (left == CHAPLYGIN_BALL_LANES) {
            chaplygin_ball_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            chaplygin_ball_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!chaplygin_ball_is_good(1 * CHAPLYGIN_BALL_LANES, check)) {
            const int one = chaplygin_ball_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CHAPLYGIN_BALL_OK ? one : status;
        }
    }
    return status;
#else
    return chaplygin_ball_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
