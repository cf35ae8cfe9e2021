/*
 * veselova.c: veselova, emitted by nhc 0.1.0 (nhc:a62858d2726f6c8c)
 * A rigid body with a fixed point that must not turn about the vertical.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * veselova.h says what each function does.
 */
#include "veselova.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const veselova_coordinate_names[VESELOVA_NQ] = {
    "phi",
    "theta",
    "psi"
};
const char *const veselova_state_names[VESELOVA_NY] = {
    "phi",
    "theta",
    "psi",
    "w_x",
    "w_y"
};
const char *const veselova_parameter_names[VESELOVA_NP] = {
    "I1",
    "I2",
    "I3"
};
const char *const veselova_constraint_names[VESELOVA_NC] = {
    "no_turn"
};
const char *const veselova_output_names[VESELOVA_NOUT] = {
    "L_x",
    "L_y"
};
const double veselova_parameter_defaults[VESELOVA_NP] = {
    1.0,
    1.7,
    2.3
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define VESELOVA_SLOW __attribute__((cold, optimize("O1")))
#else
#define VESELOVA_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int veselova_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return VESELOVA_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return VESELOVA_NOT_FINITE;
        }
    }
    return VESELOVA_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int veselova_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : VESELOVA_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef VESELOVA_LANES
#if !defined(__GNUC__)
#define VESELOVA_LANES 1
#elif defined(__AVX512F__)
#define VESELOVA_LANES 8
#elif defined(__AVX__)
#define VESELOVA_LANES 4
#else
#define VESELOVA_LANES 2
#endif
#endif
#if VESELOVA_LANES > 1
typedef double veselova_lanes __attribute__((vector_size(8 * VESELOVA_LANES)));
#else
typedef double veselova_lanes;
#endif

#if VESELOVA_LANES >= 2
static inline veselova_lanes veselova_get(const double *from)
{
    veselova_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void veselova_put(double *to, veselova_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int veselova_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = VESELOVA_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[VESELOVA_NY];
        double slope[VESELOVA_NY];
        for (size_t k = 0; k < VESELOVA_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = veselova_rhs(t[i], state, p, slope);
        status = status == VESELOVA_OK ? one : status;
        for (size_t k = 0; k < VESELOVA_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if VESELOVA_LANES >= 2
#define VESELOVA_SPREAD(x) ((x) - (veselova_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long veselova_bits __attribute__((vector_size(8 * VESELOVA_LANES)));

/* all bits where value is not above bound, or is no number */
static inline veselova_bits veselova_misses(veselova_lanes value, veselova_lanes bound)
{
    return ~(veselova_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline veselova_lanes veselova_mark(veselova_lanes value, veselova_bits bad)
{
    return (veselova_lanes)((veselova_bits)value | bad);
}

static inline veselova_lanes veselova_size(veselova_lanes x)
{
    return (veselova_lanes)((veselova_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int veselova_is_good(int count, const double *check)
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
static inline void veselova_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < VESELOVA_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < VESELOVA_NY; ++k) {
            state[k * VESELOVA_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void veselova_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < VESELOVA_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * VESELOVA_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void veselova_turn_lanes(veselova_lanes x, veselova_lanes *far,
    veselova_lanes *sine, veselova_lanes *cosine)
{
    double angle[VESELOVA_LANES];
    double up[VESELOVA_LANES];
    double along[VESELOVA_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < VESELOVA_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int veselova_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double w_x = y[3]; /* [rad/s] */
    const double w_y = y[4]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* from the state */
    const double z1 = s_psi * s_psi;
    const double z2 = 1.0 - z1;
    const double z3 = I1 * z2 + I2 * z1;
    const double z4 = s_theta * s_theta;
    const double z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4);
    const double z6 = s_psi * c_theta;
    const double z7 = k1 * (c_psi * z6);
    const double z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7));
    const double z9 = c_phi * z5 - 2.0 * (s_phi * z7);
    const double z10 = z7 + s_phi * z9;
    const double z11 = 1.0 / z8;
    const double z12 = z10 * z11;
    const double z13 = z3 - c_phi * z9;
    const double z14 = z10 * z12 - z13;
    const double z15 = s_phi * w_x - c_phi * w_y;
    const double z16 = z15 / s_theta;
    const double z17 = c_phi * w_x + s_phi * w_y;
    const double z18 = s_theta * (k1 * (s_psi * (c_psi * z17 - z15 * z6)) - k2 * (c_theta * z15));
    const double z19 = w_y * z18;
    const double z20 = (w_x * z18 + z19 * z12) / z14;
    /* (I.2.4) */
    dydt[0] = -c_theta * z16; /* phi' */
    dydt[1] = z17; /* theta' */
    dydt[2] = z16; /* psi' */
    /* (I.2.15) 24:4 */
    dydt[3] = z12 * z20 - z19 * z11; /* w_x' */
    dydt[4] = -z20; /* w_y' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[3] + dydt[4]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(-z14) > 1e-13 * z13)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return veselova_refuse(fabs(s_theta), 1e-12 * 4.0, VESELOVA_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z8 is 0 */
        if (!(fabs(-z8) > 0.0)) {
            return veselova_refuse(fabs(-z8), 0.0, VESELOVA_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z14 is nearly 0 */
        if (!(fabs(-z14) > 1e-13 * z13)) {
            return veselova_refuse(fabs(-z14), 1e-13 * z13, VESELOVA_SINGULAR_2);
        }
        return veselova_finish(5, dydt);
    }
    return VESELOVA_OK;
}

int veselova_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double w_x = y[3]; /* [rad/s] */
    const double w_y = y[4]; /* [rad/s] */

    /* from the state */
    const double z1 = (s_phi * w_x - c_phi * w_y) / s_theta;
    /* (I.2.4) */
    qdot[0] = -c_theta * z1; /* phi' */
    qdot[1] = c_phi * w_x + s_phi * w_y; /* theta' */
    qdot[2] = z1; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return veselova_refuse(fabs(s_theta), 1e-12 * 4.0, VESELOVA_SINGULAR_1);
        }
        return veselova_finish(3, qdot);
    }
    return VESELOVA_OK;
}

VESELOVA_SLOW
int veselova_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double w_x = y[3]; /* [rad/s] */
    const double w_y = y[4]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* from the state */
    const double z1 = s_psi * s_psi;
    const double z2 = 1.0 - z1;
    const double z3 = I1 * z2 + I2 * z1;
    const double z4 = s_theta * s_theta;
    const double z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4);
    const double z6 = c_theta * (s_psi * c_psi) * k1;
    const double z7 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z6));
    const double z8 = c_phi * z5 - 2.0 * (s_phi * z6);
    const double z9 = z6 + s_phi * z8;
    const double z10 = 1.0 / z7;
    const double z11 = z9 * z10;
    const double z12 = z3 - c_phi * z8;
    const double z13 = z9 * z11 - z12;
    const double z14 = 1.0 / s_theta;
    const double z15 = s_phi * w_x - c_phi * w_y;
    const double z16 = z14 * z15;
    const double z17 = c_phi * w_x + s_phi * w_y;
    const double z18 = c_theta * z15;
    const double z19 = c_theta * z16;
    const double z20 = c_phi * z19;
    const double z21 = s_theta * (k2 * z18 - k1 * (s_psi * (c_psi * z17 - s_psi * z18)));
    const double z22 = w_y * z21;
    const double z23 = (w_x * z21 + z22 * z11) / z13;
    const double z24 = z22 * z10 - z11 * z23;
    const double z25 = s_phi * z19;
    const double z26 = z14 * z14 * (z17 * z18) + z14 * (w_x * z20 - s_phi * z24 + (w_y * z25 + c_phi * z23));
    /* (I.2.15) */
    qddot[0] = z16 * (s_theta * z17) + c_theta * z26; /* phi'' */
    qddot[1] = w_x * z25 + c_phi * z24 - (w_y * z20 - s_phi * z23); /* theta'' */
    qddot[2] = -z26; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(-z13) > 1e-13 * z12)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return veselova_refuse(fabs(s_theta), 1e-12 * 4.0, VESELOVA_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z7 is 0 */
        if (!(fabs(-z7) > 0.0)) {
            return veselova_refuse(fabs(-z7), 0.0, VESELOVA_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z13 is nearly 0 */
        if (!(fabs(-z13) > 1e-13 * z12)) {
            return veselova_refuse(fabs(-z13), 1e-13 * z12, VESELOVA_SINGULAR_2);
        }
        return veselova_finish(3, qddot);
    }
    return VESELOVA_OK;
}

int veselova_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double phi = q[0]; /* precession [rad] */
    const double theta = q[1]; /* nutation [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double s_theta = sin(theta);

    /* what else is read */
    const double psi = q[2]; /* spin [rad] */
    const double theta_dot = qdot[1]; /* theta' [rad/s] */
    const double psi_dot = qdot[2]; /* psi' [rad/s] */

    /* from the coordinates and velocities */
    const double z1 = psi_dot * s_theta;
    y[0] = phi;
    y[1] = theta;
    y[2] = psi;
    y[3] = theta_dot * c_phi + s_phi * z1;
    y[4] = theta_dot * s_phi - c_phi * z1;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[2] + y[3] + y[4]) <= DBL_MAX)) {
        return veselova_finish(5, y);
    }
    return VESELOVA_OK;
}

int veselova_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double theta = q[1]; /* nutation [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = qdot[0]; /* phi' [rad/s] */
    const double psi_dot = qdot[2]; /* psi' [rad/s] */

    /* from the coordinates and velocities */
    /* (I.1.1) 26:5 */
    r[0] = phi_dot + psi_dot * c_theta; /* no_turn = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return veselova_finish(1, r);
    }
    return VESELOVA_OK;
}

VESELOVA_SLOW
int veselova_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double w_x = y[3]; /* [rad/s] */
    const double w_y = y[4]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* from the state */
    const double z1 = s_psi * s_psi;
    const double z2 = 1.0 - z1;
    const double z3 = I1 * z2 + I2 * z1;
    const double z4 = s_theta * s_theta;
    const double z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4);
    const double z6 = s_psi * c_theta;
    const double z7 = k1 * (c_psi * z6);
    const double z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7));
    const double z9 = c_phi * z5 - 2.0 * (s_phi * z7);
    const double z10 = z7 + s_phi * z9;
    const double z11 = 1.0 / z8;
    const double z12 = z10 * z11;
    const double z13 = z3 - c_phi * z9;
    const double z14 = z10 * z12 - z13;
    const double z15 = s_phi * w_x - c_phi * w_y;
    const double z16 = z15 / s_theta;
    const double z17 = c_theta * z16;
    const double z18 = c_phi * w_x + s_phi * w_y;
    const double z19 = s_theta * c_psi;
    const double z20 = c_theta * z18;
    const double z21 = s_theta * s_psi;
    const double z22 = c_psi * z18;
    const double z23 = I2 * ((z19 * z17 + s_psi * z18) * (c_psi * z20 - z21 * z16)) + I1 * ((z21 * z17 - z22)
        * (s_psi * z20 + z19 * z16));
    const double z24 = s_psi * k1;
    const double z25 = c_theta * k2;
    const double z26 = s_theta * ((z22 - z15 * z6) * z24 - z15 * z25);
    const double z27 = w_y * z26;
    const double z28 = (w_x * z26 + z12 * z27) / z14;
    const double z29 = ((c_psi * c_phi - s_phi * z6) * z24 - s_phi * z25) * (s_theta * (z11 * z27 - z12 *
        z28));
    const double z30 = I3 * ((z16 - c_theta * z17) * (s_theta * z18)) + z23 + (z29 + ((c_psi * s_phi + c_phi
        * z6) * z24 + c_phi * z25) * (s_theta * z28));
    /* (I.4.1) 26:5 */
    lambda[0] = -z30; /* reaction of no_turn: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0 && fabs(-z14) > 1e-13 * z13)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return veselova_refuse(fabs(s_theta), 1e-12 * 4.0, VESELOVA_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z8 is 0 */
        if (!(fabs(-z8) > 0.0)) {
            return veselova_refuse(fabs(-z8), 0.0, VESELOVA_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z14 is nearly 0 */
        if (!(fabs(-z14) > 1e-13 * z13)) {
            return veselova_refuse(fabs(-z14), 1e-13 * z13, VESELOVA_SINGULAR_2);
        }
        return veselova_finish(1, lambda);
    }
    return VESELOVA_OK;
}

double veselova_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);

    /* what else is read */
    const double w_x = y[3]; /* [rad/s] */
    const double w_y = y[4]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the state */
    const double z1 = (s_phi * w_x - c_phi * w_y) / s_theta;
    const double z2 = c_theta * z1;
    const double omega3 = z1 - c_theta * z2;
    const double z3 = c_phi * w_x + s_phi * w_y;
    const double z4 = s_theta * z2;
    const double z5 = c_psi * z3 - s_psi * z4;
    const double z6 = s_psi * z3 + c_psi * z4;
    /* the coframe is singular, if s_theta is nearly 0 */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return (double)NAN;
    }
    return 0.5 * (I3 * (omega3 * omega3) + (I1 * (z5 * z5) + I2 * (z6 * z6)));
}

VESELOVA_SLOW
int veselova_jacobian(double t, const double *y, const double *p, double *J)
{
    J[2] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[12] = 0.0;
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double w_x = y[3]; /* [rad/s] */
    const double w_y = y[4]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* from the state */
    const double z1 = s_psi * s_psi;
    const double z2 = 1.0 - z1;
    const double z3 = I1 * z2 + I2 * z1;
    const double z4 = s_theta * s_theta;
    const double z5 = 2.0 - z4;
    const double z6 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * z5) - I3 * z4);
    const double z7 = s_psi * c_psi;
    const double z8 = c_theta * z7;
    const double z9 = z8 * k1;
    const double z10 = s_phi * z6 + 2.0 * (c_phi * z9);
    const double z11 = z3 - s_phi * z10;
    const double z12 = c_phi * z6 - 2.0 * (s_phi * z9);
    const double z13 = z9 + s_phi * z12;
    const double z14 = 1.0 / z11;
    const double z15 = z13 * z14;
    const double z16 = z3 - c_phi * z12;
    const double z17 = z13 * z15 - z16;
    const double z18 = 1.0 / s_theta;
    const double z19 = c_phi * w_x + s_phi * w_y;
    const double z20 = z18 * z19;
    const double z21 = s_phi * w_x - c_phi * w_y;
    const double z22 = z18 * z18 * (c_theta * z21);
    const double z23 = s_phi * z18;
    const double z24 = c_phi * z18;
    const double z25 = 1.0 / z17;
    const double z26 = s_psi * c_theta;
    const double z27 = k1 * (c_psi * z19 - z21 * z26);
    const double z28 = z21 * k2;
    const double z29 = s_psi * z27 - c_theta * z28;
    const double z30 = s_theta * w_x;
    const double z31 = s_theta * w_y;
    const double z32 = z31 * z29;
    const double z33 = z25 * (z29 * z30 + z32 * z15);
    const double z34 = z32 * z14 - z15 * z33;
    const double z35 = s_phi * z34;
    const double z36 = z12 * z33 - z6 * z35;
    const double z37 = s_phi * z33;
    const double z38 = k1 * z37;
    const double z39 = c_theta * k2;
    const double z40 = s_psi * k1;
    const double z41 = z31 * z40;
    const double z42 = z31 * z39 + z26 * z41;
    const double z43 = c_psi * z41;
    const double z44 = w_x * z43;
    const double z45 = k1 * z35;
    const double z46 = c_phi * (z36 - (z10 * z34 + (2.0 * (z8 * z38) - (w_x * z42 - w_y * z43)))) + s_phi *
        (z44 + (w_y * z42 - (z6 * z37 - 2.0 * (z8 * z45))));
    const double z47 = z30 * z40;
    const double z48 = z30 * z39 + z26 * z47;
    const double z49 = c_phi * z33;
    const double z50 = k1 * (z35 - z49);
    const double z51 = c_psi * z47;
    const double z52 = c_phi * (z44 - (w_x * z48 - (z12 * z34 - 2.0 * (z8 * z50)))) + s_phi * (z36 + (z6 *
        z49 - w_x * (z42 + z51)));
    const double z53 = z25 * (z52 - z15 * z46);
    const double z54 = z21 * z41;
    const double z55 = k1 * z33 - 2.0 * (s_phi * z38) - 2.0 * (c_phi * z45);
    const double z56 = c_phi * z37 - s_phi * z35;
    const double z57 = I1 * z56;
    const double z58 = I2 * z56;
    const double z59 = s_theta * (z31 * z28 + s_psi * z54 + z7 * z55) + c_theta * (w_y * z29 + 2.0 * (s_theta
        * (I3 * z56 - z1 * z57 - z2 * z58)));
    const double z60 = z21 * z47;
    const double z61 = c_phi * z49;
    const double z62 = k1 * z61;
    const double z63 = k1 * z34 - 2.0 * (s_phi * z50);
    const double z64 = s_psi * z60 + (z28 * z30 - 2.0 * (c_theta * (z1 * z62 + k2 * z61))) - z7 * z63;
    const double z65 = c_phi * z35;
    const double z66 = I1 * z65;
    const double z67 = I2 * z65;
    const double z68 = s_theta * z64 + c_theta * (w_x * z29 - 2.0 * (s_theta * (I3 * z65 - z1 * z66 - z2 *
        z67)));
    const double z69 = z25 * (z68 + z15 * z59);
    const double z70 = c_theta * z55;
    const double z71 = 2.0 * (s_psi * (2.0 * z58 + (I2 * z34 - z5 * z57) - (I1 * z34 + z4 * z58)));
    const double z72 = s_psi * (z19 * z41 - s_psi * z70) - c_psi * (z31 * z27 - c_theta * z54 - c_psi * z70 -
        z71);
    const double z73 = c_theta * z63;
    const double z74 = 2.0 * z67 + (z5 * z62 + I2 * z33 - z5 * z66) - (I1 * z33 + z4 * z67);
    const double z75 = s_psi * (z19 * z47 + s_psi * z73) - c_psi * (z27 * z30 - c_theta * z60 + c_psi * z73 +
        2.0 * (s_psi * z74));
    const double z76 = z25 * (z75 + z15 * z72);
    const double z77 = s_phi * z42 - c_phi * z43;
    const double z78 = s_theta * z29;
    const double z79 = z25 * (z78 - s_phi * z48 + c_phi * z51 - z15 * z77);
    const double z80 = z78 + c_phi * z42 + s_phi * z43;
    const double z81 = z25 * (c_phi * z48 + s_phi * z51 + z15 * z80);
    /* (I.2.15) */
    J[0] = -c_theta * z20;
    J[1] = z21 + c_theta * z22;
    J[3] = -c_theta * z23;
    J[4] = c_theta * z24;
    J[5] = -z21;
    J[8] = c_phi;
    J[9] = s_phi;
    J[10] = z20;
    J[11] = -z22;
    J[13] = z23;
    J[14] = -z24;
    J[15] = z14 * z46 + z15 * z53;
    J[16] = z15 * z69 - z14 * z59;
    J[17] = z14 * z72 - z15 * z76;
    J[18] = z14 * z77 + z15 * z79;
    J[19] = z15 * z81 - z14 * z80;
    J[20] = -z53;
    J[21] = -z69;
    J[22] = z76;
    J[23] = -z79;
    J[24] = -z81;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[0] + J[1] + J[11] + J[14] + J[15] + J[16] + J[17] + J[18] + J[19] + J[20] + J[21] + J[23] +
        J[24]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(-z17) > 1e-13 * z16)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return veselova_refuse(fabs(s_theta), 1e-12 * 4.0, VESELOVA_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z11 is 0 */
        if (!(fabs(-z11) > 0.0)) {
            return veselova_refuse(fabs(-z11), 0.0, VESELOVA_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z17 is nearly 0 */
        if (!(fabs(-z17) > 1e-13 * z16)) {
            return veselova_refuse(fabs(-z17), 1e-13 * z16, VESELOVA_SINGULAR_2);
        }
        return veselova_finish(25, J);
    }
    return VESELOVA_OK;
}

int veselova_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);

    /* what else is read */
    const double w_x = y[3]; /* [rad/s] */
    const double w_y = y[4]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the state */
    const double z1 = c_phi * w_x + s_phi * w_y;
    const double z2 = (s_phi * w_x - c_phi * w_y) / s_theta;
    const double z3 = c_theta * z2;
    const double z4 = s_theta * z3;
    const double z5 = I1 * (c_psi * z1 - s_psi * z4);
    const double z6 = I2 * (s_psi * z1 + c_psi * z4);
    const double z7 = c_psi * z5 + s_psi * z6;
    const double z8 = c_theta * (s_psi * z5 - c_psi * z6) - I3 * (s_theta * (z2 - c_theta * z3));
    /* 32:8 */
    out[0] = c_phi * z7 - s_phi * z8; /* L_x */
    /* 33:8 */
    out[1] = s_phi * z7 + c_phi * z8; /* L_y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return veselova_refuse(fabs(s_theta), 1e-12 * 4.0, VESELOVA_SINGULAR_1);
        }
        return veselova_finish(2, out);
    }
    return VESELOVA_OK;
}

#if VESELOVA_LANES >= 2
static __attribute__((noinline)) void veselova_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    veselova_lanes far = {0}; /* the squares of the angles */
    veselova_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    veselova_bits bad = {0}; /* singular blocks */
    const double I1 = fixed[0];
    const double I2 = fixed[1];
    const double I3 = fixed[2];
    const double k1 = fixed[3];
    const double k2 = fixed[4];
    const veselova_lanes phi = veselova_get(y);
    const veselova_lanes theta = veselova_get(y + 1 * stride);
    const veselova_lanes psi = veselova_get(y + 2 * stride);
    const veselova_lanes w_x = veselova_get(y + 3 * stride);
    const veselova_lanes w_y = veselova_get(y + 4 * stride);
    veselova_lanes sine1, cosine1;
    veselova_turn_lanes(VESELOVA_SPREAD(theta), &far, &sine1, &cosine1);
    const veselova_lanes s_theta = sine1;
    /* the coframe is singular, if s_theta is nearly 0 */
    bad |= veselova_misses(veselova_size(VESELOVA_SPREAD(s_theta)), VESELOVA_SPREAD(1e-12 * 4.0));
    veselova_lanes sine2, cosine2;
    veselova_turn_lanes(VESELOVA_SPREAD(psi), &far, &sine2, &cosine2);
    const veselova_lanes s_psi = sine2;
    const veselova_lanes z1 = s_psi * s_psi;
    const veselova_lanes z2 = 1.0 - z1;
    const veselova_lanes z3 = I1 * z2 + I2 * z1;
    veselova_lanes sine3, cosine3;
    veselova_turn_lanes(VESELOVA_SPREAD(phi), &far, &sine3, &cosine3);
    const veselova_lanes s_phi = sine3;
    const veselova_lanes z4 = s_theta * s_theta;
    const veselova_lanes z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4);
    const veselova_lanes c_phi = cosine3;
    const veselova_lanes c_psi = cosine2;
    const veselova_lanes c_theta = cosine1;
    const veselova_lanes z6 = s_psi * c_theta;
    const veselova_lanes z7 = k1 * (c_psi * z6);
    const veselova_lanes z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7));
    const veselova_lanes z9 = c_phi * z5 - 2.0 * (s_phi * z7);
    const veselova_lanes z10 = z7 + s_phi * z9;
    const veselova_lanes z11 = 1.0 / z8;
    const veselova_lanes z12 = z10 * z11;
    const veselova_lanes z13 = z3 - c_phi * z9;
    const veselova_lanes z14 = z10 * z12 - z13;
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z14 is nearly 0 */
    bad |= veselova_misses(veselova_size(VESELOVA_SPREAD(-z14)), 1e-13 * z13);
    const veselova_lanes z15 = s_phi * w_x - c_phi * w_y;
    const veselova_lanes z16 = z15 / s_theta;
    const veselova_lanes z17 = c_phi * w_x + s_phi * w_y;
    const veselova_lanes z18 = s_theta * (k1 * (s_psi * (c_psi * z17 - z15 * z6)) - k2 * (c_theta * z15));
    const veselova_lanes z19 = w_y * z18;
    const veselova_lanes z20 = (w_x * z18 + z19 * z12) / z14;
    /* (I.2.4) */
    const veselova_lanes slope1 = -c_theta * z16;
    sum += slope1;
    veselova_put(dydt, slope1);
    const veselova_lanes slope2 = z17;
    veselova_put(dydt + 1 * stride, slope2);
    const veselova_lanes slope3 = z16;
    veselova_put(dydt + 2 * stride, slope3);
    /* (I.2.15) 24:4 */
    const veselova_lanes slope4 = z12 * z20 - z19 * z11;
    sum += slope4;
    veselova_put(dydt + 3 * stride, slope4);
    const veselova_lanes slope5 = -z20;
    sum += slope5;
    veselova_put(dydt + 4 * stride, slope5);
    veselova_put(check, veselova_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void veselova_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[VESELOVA_LANES];
    double state[5 * VESELOVA_LANES];
    double slope[5 * VESELOVA_LANES];
    veselova_fill(left, count, t, y, time, state);
    veselova_rhs_lanes(fixed, VESELOVA_LANES, time, state, slope, check);
    veselova_pour(left, count, slope, dydt);
}
#endif

int veselova_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
#if VESELOVA_LANES >= 2
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;
    const double fixed[] = {I1, I2, I3, k1, k2};
    double check[1 * VESELOVA_LANES];
    int status = VESELOVA_OK;
    for (size_t i = 0; i < count; i += VESELOVA_LANES) {
        const size_t left = count - i < VESELOVA_LANES ? count - i : VESELOVA_LANES;
        if (left == VESELOVA_LANES) {
            veselova_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            veselova_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!veselova_is_good(1 * VESELOVA_LANES, check)) {
            const int one = veselova_one_by_one(count, i, left, t, y, p, dydt);
            status = status == VESELOVA_OK ? one : status;
        }
    }
    return status;
#else
    return veselova_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
