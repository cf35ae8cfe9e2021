/*
 * roller_racer.c: roller_racer, emitted by nhc 0.1.0 (nhc:caeb9994daee9759)
 * Two wheeled bodies with a hinge; it is driven by moving the hinge to and fro.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, theta': the dependent velocities that nhc would choose (x', y') are
 *     singular somewhere
 * roller_racer.h says what each function does.
 */
#include "roller_racer.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const roller_racer_coordinate_names[ROLLER_RACER_NQ] = {
    "x",
    "y",
    "theta",
    "phi"
};
const char *const roller_racer_state_names[ROLLER_RACER_NY] = {
    "x",
    "y",
    "theta",
    "phi",
    "v",
    "theta'"
};
const char *const roller_racer_parameter_names[ROLLER_RACER_NP] = {
    "m",
    "I1",
    "I2",
    "d1",
    "d2"
};
const char *const roller_racer_constraint_names[ROLLER_RACER_NC] = {
    "rear",
    "front"
};
const char *const roller_racer_output_names[ROLLER_RACER_NOUT] = {
    "speed"
};
const double roller_racer_parameter_defaults[ROLLER_RACER_NP] = {
    1.0,
    0.2,
    0.05,
    0.6,
    0.25
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define ROLLER_RACER_SLOW __attribute__((cold, optimize("O1")))
#else
#define ROLLER_RACER_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int roller_racer_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return ROLLER_RACER_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return ROLLER_RACER_NOT_FINITE;
        }
    }
    return ROLLER_RACER_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int roller_racer_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : ROLLER_RACER_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef ROLLER_RACER_LANES
#if !defined(__GNUC__)
#define ROLLER_RACER_LANES 1
#elif defined(__AVX512F__)
#define ROLLER_RACER_LANES 8
#elif defined(__AVX__)
#define ROLLER_RACER_LANES 4
#else
#define ROLLER_RACER_LANES 2
#endif
#endif
#if ROLLER_RACER_LANES > 1
typedef double roller_racer_lanes __attribute__((vector_size(8 * ROLLER_RACER_LANES)));
#else
typedef double roller_racer_lanes;
#endif

#if ROLLER_RACER_LANES >= 2
static inline roller_racer_lanes roller_racer_get(const double *from)
{
    roller_racer_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void roller_racer_put(double *to, roller_racer_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int roller_racer_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = ROLLER_RACER_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[ROLLER_RACER_NY];
        double slope[ROLLER_RACER_NY];
        for (size_t k = 0; k < ROLLER_RACER_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = roller_racer_rhs(t[i], state, p, slope);
        status = status == ROLLER_RACER_OK ? one : status;
        for (size_t k = 0; k < ROLLER_RACER_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if ROLLER_RACER_LANES >= 2
#define ROLLER_RACER_SPREAD(x) ((x) - (roller_racer_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long roller_racer_bits __attribute__((vector_size(8 * ROLLER_RACER_LANES)));

/* all bits where value is not above bound, or is no number */
static inline roller_racer_bits roller_racer_misses(roller_racer_lanes value, roller_racer_lanes bound)
{
    return ~(roller_racer_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline roller_racer_lanes roller_racer_mark(roller_racer_lanes value, roller_racer_bits bad)
{
    return (roller_racer_lanes)((roller_racer_bits)value | bad);
}

static inline roller_racer_lanes roller_racer_size(roller_racer_lanes x)
{
    return (roller_racer_lanes)((roller_racer_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int roller_racer_is_good(int count, const double *check)
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
static inline void roller_racer_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < ROLLER_RACER_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < ROLLER_RACER_NY; ++k) {
            state[k * ROLLER_RACER_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void roller_racer_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < ROLLER_RACER_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * ROLLER_RACER_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void roller_racer_turn_lanes(roller_racer_lanes x, roller_racer_lanes *far,
    roller_racer_lanes *sine, roller_racer_lanes *cosine)
{
    double angle[ROLLER_RACER_LANES];
    double up[ROLLER_RACER_LANES];
    double along[ROLLER_RACER_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < ROLLER_RACER_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int roller_racer_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[4]; /* [m/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / d2;
    const double k2 = I2 * k1;
    const double k3 = k1 * k2;

    /* from the state */
    const double z1 = m + k3 * (s_phi * s_phi);
    const double z2 = d1 * c_phi;
    const double z3 = z2 * k1;
    const double z4 = I1 + I2 * (z3 * z3);
    const double z5 = k2 * z3;
    const double z6 = s_phi * z5;
    const double z7 = 1.0 / z1;
    const double z8 = z7 * z6;
    const double z9 = z4 - z6 * z8;
    const double z10 = k1 * (theta_dot * (d2 + z2) - v * s_phi);
    const double z11 = d1 * (z10 * (theta_dot * s_phi)) + z10 * (c_phi * v);
    const double z12 = k3 * (s_phi * z11);
    const double z13 = (z11 * z5 - z12 * z8) / z9;
    /* (I.2.4) */
    dydt[0] = c_theta * v; /* x' */
    dydt[1] = s_theta * v; /* y' */
    dydt[2] = theta_dot; /* theta' */
    dydt[3] = -z10; /* phi' */
    /* (I.2.15) 17:4 */
    dydt[4] = z7 * z12 - z8 * z13; /* v' */
    dydt[5] = -z13; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[4] + dydt[5]) <= DBL_MAX && fabs(z9) > 1e-13 * z4)) {
        /* the coframe is singular, if d2 is 0 */
        if (!(fabs(d2) > 0.0)) {
            return roller_racer_refuse(fabs(d2), 0.0, ROLLER_RACER_SINGULAR_1);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return roller_racer_refuse(fabs(z1), 0.0, ROLLER_RACER_SINGULAR_2);
        }
        /* the mass matrix is singular, if z9 is nearly 0 */
        if (!(fabs(z9) > 1e-13 * z4)) {
            return roller_racer_refuse(fabs(z9), 1e-13 * z4, ROLLER_RACER_SINGULAR_2);
        }
        return roller_racer_finish(6, dydt);
    }
    return ROLLER_RACER_OK;
}

int roller_racer_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double v = y[4]; /* [m/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* from the parameters alone */
    const double k1 = -1.0 / d2;

    /* from the state */
    /* (I.2.4) */
    qdot[0] = c_theta * v; /* x' */
    qdot[1] = s_theta * v; /* y' */
    qdot[2] = theta_dot; /* theta' */
    qdot[3] = k1 * (theta_dot * (d2 + d1 * c_phi) - v * s_phi); /* phi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[3]) <= DBL_MAX)) {
        /* the coframe is singular, if d2 is 0 */
        if (!(fabs(d2) > 0.0)) {
            return roller_racer_refuse(fabs(d2), 0.0, ROLLER_RACER_SINGULAR_1);
        }
        return roller_racer_finish(4, qdot);
    }
    return ROLLER_RACER_OK;
}

int roller_racer_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double v = y[4]; /* [m/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / d2;
    const double k2 = I2 * k1;
    const double k3 = k1 * k2;

    /* from the state */
    const double z1 = m + k3 * (s_phi * s_phi);
    const double z2 = d2 + d1 * c_phi;
    const double z3 = 1.0 - z2 * k1;
    const double z4 = I1 + I2 * (z3 * z3);
    const double z5 = z3 * k2;
    const double z6 = s_phi * z5;
    const double z7 = 1.0 / z1;
    const double z8 = z7 * z6;
    const double z9 = z4 - z6 * z8;
    const double z10 = theta_dot * v;
    const double z11 = k1 * (theta_dot * z2 - v * s_phi);
    const double z12 = d1 * (z11 * (theta_dot * s_phi)) + z11 * (c_phi * v);
    const double z13 = k3 * (s_phi * z12);
    const double z14 = (z12 * z5 - z13 * z8) / z9;
    const double z15 = z7 * z13 - z8 * z14;
    /* (I.2.15) */
    qddot[0] = c_theta * z15 - s_theta * z10; /* x'' */
    qddot[1] = c_theta * z10 + s_theta * z15; /* y'' */
    qddot[2] = z14; /* theta'' */
    qddot[3] = -k1 * (z12 + (z2 * z14 - s_phi * z15)); /* phi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[3]) <= DBL_MAX && fabs(z9) > 1e-13 * z4)) {
        /* the coframe is singular, if d2 is 0 */
        if (!(fabs(d2) > 0.0)) {
            return roller_racer_refuse(fabs(d2), 0.0, ROLLER_RACER_SINGULAR_1);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return roller_racer_refuse(fabs(z1), 0.0, ROLLER_RACER_SINGULAR_2);
        }
        /* the mass matrix is singular, if z9 is nearly 0 */
        if (!(fabs(z9) > 1e-13 * z4)) {
            return roller_racer_refuse(fabs(z9), 1e-13 * z4, ROLLER_RACER_SINGULAR_2);
        }
        return roller_racer_finish(4, qddot);
    }
    return ROLLER_RACER_OK;
}

int roller_racer_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[2]; /* heading of the main body [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x = q[0]; /* axle of the main body [m] */
    const double y_2 = q[1]; /* y: axle of the main body [m] */
    const double phi = q[3]; /* second body, relative to the first [rad] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = phi;
    y[4] = x_dot * c_theta + y_dot * s_theta;
    y[5] = theta_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[4] + y[5]) <= DBL_MAX)) {
        return roller_racer_finish(6, y);
    }
    return ROLLER_RACER_OK;
}

int roller_racer_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta = q[2]; /* heading of the main body [rad] */
    const double phi = q[3]; /* second body, relative to the first [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */
    const double phi_dot = qdot[3]; /* phi' [rad/s] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* from the coordinates and velocities */
    const double z1 = theta_dot * (d2 + d1 * c_phi) - (x_dot * (s_theta * c_phi + c_theta * s_phi) - y_dot *
        (c_theta * c_phi - s_theta * s_phi));
    /* (I.1.1) 19:5 */
    r[0] = y_dot * c_theta - x_dot * s_theta; /* rear = 0 */
    /* (I.1.1) 20:5 */
    r[1] = phi_dot * d2 + z1; /* front = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1]) <= DBL_MAX)) {
        return roller_racer_finish(2, r);
    }
    return ROLLER_RACER_OK;
}

int roller_racer_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[3]; /* second body, relative to the first [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double v = y[4]; /* [m/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / d2;
    const double k2 = I2 * k1;
    const double k3 = k1 * k2;

    /* from the state */
    const double z1 = m + k3 * (s_phi * s_phi);
    const double z2 = d2 + d1 * c_phi;
    const double z3 = 1.0 - z2 * k1;
    const double z4 = I1 + I2 * (z3 * z3);
    const double z5 = z3 * k2;
    const double z6 = s_phi * z5;
    const double z7 = 1.0 / z1;
    const double z8 = z7 * z6;
    const double z9 = z4 - z6 * z8;
    const double z10 = k1 * (theta_dot * z2 - v * s_phi);
    const double z11 = d1 * (z10 * (theta_dot * s_phi)) + z10 * (c_phi * v);
    const double z12 = k3 * (s_phi * z11);
    const double z13 = (z11 * z5 - z12 * z8) / z9;
    const double z14 = k2 * (k1 * z11 - (k1 * (s_phi * (z7 * z12 - z8 * z13)) + z3 * z13));
    /* (I.4.1) 19:5 */
    lambda[0] = m * (theta_dot * v) + c_phi * z14; /* reaction of rear: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 20:5 */
    lambda[1] = -z14; /* reaction of front: Q_i gains lambda_2 a_2i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX && fabs(z9) > 1e-13 * z4)) {
        /* the coframe is singular, if d2 is 0 */
        if (!(fabs(d2) > 0.0)) {
            return roller_racer_refuse(fabs(d2), 0.0, ROLLER_RACER_SINGULAR_1);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return roller_racer_refuse(fabs(z1), 0.0, ROLLER_RACER_SINGULAR_2);
        }
        /* the mass matrix is singular, if z9 is nearly 0 */
        if (!(fabs(z9) > 1e-13 * z4)) {
            return roller_racer_refuse(fabs(z9), 1e-13 * z4, ROLLER_RACER_SINGULAR_2);
        }
        return roller_racer_finish(2, lambda);
    }
    return ROLLER_RACER_OK;
}

double roller_racer_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double phi = y[3]; /* second body, relative to the first [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double v = y[4]; /* [m/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / d2;

    /* from the state */
    const double z1 = theta_dot - k1 * (theta_dot * (d2 + d1 * c_phi) - v * s_phi);
    return 0.5 * (I2 * (z1 * z1) + (I1 * (theta_dot * theta_dot) + m * (v * v)));
}

ROLLER_RACER_SLOW
int roller_racer_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 36 * sizeof *J);
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double v = y[4]; /* [m/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / d2;
    const double k2 = I2 * k1;
    const double k3 = k1 * k2;

    /* from the state */
    const double z1 = m + k3 * (s_phi * s_phi);
    const double z2 = d2 + d1 * c_phi;
    const double z3 = z2 * k1;
    const double z4 = 1.0 - z3;
    const double z5 = I1 + I2 * (z4 * z4);
    const double z6 = z4 * k2;
    const double z7 = s_phi * z6;
    const double z8 = 1.0 / z1;
    const double z9 = z8 * z7;
    const double z10 = z5 - z7 * z9;
    const double z11 = theta_dot * d1;
    const double z12 = s_phi * k1;
    const double z13 = s_phi * k3;
    const double z14 = v * z13;
    const double z15 = z11 * z13;
    const double z16 = k1 * (c_phi * z14 + s_phi * z15);
    const double z17 = k1 * (theta_dot * z2 - v * s_phi);
    const double z18 = d1 * (s_phi * z17);
    const double z19 = c_phi * z17;
    const double z20 = theta_dot * z18 + v * z19;
    const double z21 = 1.0 / z10;
    const double z22 = z20 * z13;
    const double z23 = z21 * (z20 * z6 - z9 * z22);
    const double z24 = k2 * z23;
    const double z25 = z8 * z22 - z9 * z23;
    const double z26 = c_phi * (v * z16 - (z17 * z15 + (z20 * k3 - z4 * z24 - 2.0 * (z13 * z25))));
    const double z27 = z26 + s_phi * (z17 * z14 + d1 * (theta_dot * z16 + z12 * z24));
    const double z28 = v * z6;
    const double z29 = z11 * z6;
    const double z30 = k1 * (c_phi * z28 + s_phi * z29);
    const double z31 = k2 * z25;
    const double z32 = d1 * (theta_dot * z30 - k1 * (z20 * k2 - 2.0 * (I2 * (z4 * z23)) - s_phi * z31));
    const double z33 = c_phi * (v * z30 - (z17 * z29 - z4 * z31)) + s_phi * (z17 * z28 + z32) - z9 * z27;
    const double z34 = z21 * z33;
    const double z35 = z19 * z13 - s_phi * z16;
    const double z36 = z21 * (z19 * z6 - s_phi * z30 - z9 * z35);
    const double z37 = z18 * z13 + z2 * z16;
    const double z38 = z21 * (z18 * z6 + z2 * z30 - z9 * z37);
    /* (I.2.15) */
    J[2] = -s_theta * v;
    J[4] = c_theta;
    J[8] = c_theta * v;
    J[10] = s_theta;
    J[17] = 1.0;
    J[21] = k1 * (c_phi * v + s_phi * z11);
    J[22] = z12;
    J[23] = -z3;
    J[27] = z9 * z34 - z8 * z27;
    J[28] = z8 * z35 - z9 * z36;
    J[29] = z8 * z37 - z9 * z38;
    J[33] = -z34;
    J[34] = z36;
    J[35] = z38;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[21] + J[27] + J[28] + J[29] + J[33]) <= DBL_MAX && fabs(z10) > 1e-13 * z5)) {
        /* the coframe is singular, if d2 is 0 */
        if (!(fabs(d2) > 0.0)) {
            return roller_racer_refuse(fabs(d2), 0.0, ROLLER_RACER_SINGULAR_1);
        }
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return roller_racer_refuse(fabs(z1), 0.0, ROLLER_RACER_SINGULAR_2);
        }
        /* the mass matrix is singular, if z10 is nearly 0 */
        if (!(fabs(z10) > 1e-13 * z5)) {
            return roller_racer_refuse(fabs(z10), 1e-13 * z5, ROLLER_RACER_SINGULAR_2);
        }
        return roller_racer_finish(36, J);
    }
    return ROLLER_RACER_OK;
}

int roller_racer_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;

    /* from the state */
    const double v = y[4]; /* [m/s] */
    /* 22:10 */
    out[0] = v; /* speed */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(d2) > 0.0 * out[0])) {
        /* the coframe is singular, if d2 is 0 */
        if (!(fabs(d2) > 0.0)) {
            return roller_racer_refuse(fabs(d2), 0.0, ROLLER_RACER_SINGULAR_1);
        }
        return roller_racer_finish(1, out);
    }
    return ROLLER_RACER_OK;
}

#if ROLLER_RACER_LANES >= 2
static __attribute__((noinline)) void roller_racer_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    roller_racer_lanes far = {0}; /* the squares of the angles */
    roller_racer_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    roller_racer_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double I1 = fixed[1];
    const double I2 = fixed[2];
    const double d1 = fixed[3];
    const double d2 = fixed[4];
    const double k1 = fixed[5];
    const double k2 = fixed[6];
    const double k3 = fixed[7];
    const roller_racer_lanes theta = roller_racer_get(y + 2 * stride);
    const roller_racer_lanes phi = roller_racer_get(y + 3 * stride);
    const roller_racer_lanes v = roller_racer_get(y + 4 * stride);
    const roller_racer_lanes theta_dot = roller_racer_get(y + 5 * stride);
    roller_racer_lanes sine1, cosine1;
    roller_racer_turn_lanes(ROLLER_RACER_SPREAD(phi), &far, &sine1, &cosine1);
    const roller_racer_lanes s_phi = sine1;
    const roller_racer_lanes z1 = m + k3 * (s_phi * s_phi);
    const roller_racer_lanes c_phi = cosine1;
    const roller_racer_lanes z2 = d1 * c_phi;
    const roller_racer_lanes z3 = z2 * k1;
    const roller_racer_lanes z4 = I1 + I2 * (z3 * z3);
    const roller_racer_lanes z5 = k2 * z3;
    const roller_racer_lanes z6 = s_phi * z5;
    const roller_racer_lanes z7 = 1.0 / z1;
    const roller_racer_lanes z8 = z7 * z6;
    const roller_racer_lanes z9 = z4 - z6 * z8;
    /* the mass matrix is singular, if z9 is nearly 0 */
    bad |= roller_racer_misses(roller_racer_size(ROLLER_RACER_SPREAD(z9)), 1e-13 * z4);
    roller_racer_lanes sine2, cosine2;
    roller_racer_turn_lanes(ROLLER_RACER_SPREAD(theta), &far, &sine2, &cosine2);
    const roller_racer_lanes c_theta = cosine2;
    const roller_racer_lanes s_theta = sine2;
    const roller_racer_lanes z10 = k1 * (theta_dot * (d2 + z2) - v * s_phi);
    const roller_racer_lanes z11 = d1 * (z10 * (theta_dot * s_phi)) + z10 * (c_phi * v);
    const roller_racer_lanes z12 = k3 * (s_phi * z11);
    const roller_racer_lanes z13 = (z11 * z5 - z12 * z8) / z9;
    /* (I.2.4) */
    const roller_racer_lanes slope1 = c_theta * v;
    sum += slope1;
    roller_racer_put(dydt, slope1);
    const roller_racer_lanes slope2 = s_theta * v;
    roller_racer_put(dydt + 1 * stride, slope2);
    const roller_racer_lanes slope3 = theta_dot;
    roller_racer_put(dydt + 2 * stride, slope3);
    const roller_racer_lanes slope4 = -z10;
    roller_racer_put(dydt + 3 * stride, slope4);
    /* (I.2.15) 17:4 */
    const roller_racer_lanes slope5 = z7 * z12 - z8 * z13;
    sum += slope5;
    roller_racer_put(dydt + 4 * stride, slope5);
    const roller_racer_lanes slope6 = -z13;
    sum += slope6;
    roller_racer_put(dydt + 5 * stride, slope6);
    roller_racer_put(check, roller_racer_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void roller_racer_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[ROLLER_RACER_LANES];
    double state[6 * ROLLER_RACER_LANES];
    double slope[6 * ROLLER_RACER_LANES];
    roller_racer_fill(left, count, t, y, time, state);
    roller_racer_rhs_lanes(fixed, ROLLER_RACER_LANES, time, state, slope, check);
    roller_racer_pour(left, count, slope, dydt);
}
#endif

int roller_racer_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if ROLLER_RACER_LANES >= 2
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */
    const double k1 = 1.0 / d2;
    const double k2 = I2 * k1;
    const double k3 = k1 * k2;
    const double fixed[] = {m, I1, I2, d1, d2, k1, k2, k3};
    double check[1 * ROLLER_RACER_LANES];
    int status = ROLLER_RACER_OK;
    for (size_t i = 0; i < count; i += ROLLER_RACER_LANES) {
        const size_t left = count - i < ROLLER_RACER_LANES ? count - i : ROLLER_RACER_LANES;
        if (left == ROLLER_RACER_LANES) {
            roller_racer_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            roller_racer_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!roller_racer_is_good(1 * ROLLER_RACER_LANES, check)) {
            const int one = roller_racer_one_by_one(count, i, left, t, y, p, dydt);
            status = status == ROLLER_RACER_OK ? one : status;
        }
    }
    return status;
#else
    return roller_racer_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
