/*
 * snakeboard.c: snakeboard, emitted by nhc 0.1.0 (nhc:d05b4ecdb28e6df5)
 * A board on two steerable axles and a rotor; it moves by turning the rotor and the axles to and fro.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, psi', p_b', p_f': the dependent velocities of the spec (x', y') are
 *     singular somewhere
 * snakeboard.h says what each function does.
 */
#include "snakeboard.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const snakeboard_coordinate_names[SNAKEBOARD_NQ] = {
    "x",
    "y",
    "theta",
    "psi",
    "p_b",
    "p_f"
};
const char *const snakeboard_state_names[SNAKEBOARD_NY] = {
    "x",
    "y",
    "theta",
    "psi",
    "p_b",
    "p_f",
    "v",
    "psi'",
    "p_b'",
    "p_f'"
};
const char *const snakeboard_parameter_names[SNAKEBOARD_NP] = {
    "m",
    "l",
    "J",
    "J_r",
    "J_w",
    "tau",
    "sigma",
    "nu"
};
const char *const snakeboard_constraint_names[SNAKEBOARD_NC] = {
    "back",
    "front"
};
const char *const snakeboard_output_names[SNAKEBOARD_NOUT] = {
    "speed"
};
const double snakeboard_parameter_defaults[SNAKEBOARD_NP] = {
    1.0,
    0.5,
    0.1,
    0.05,
    0.02,
    0.05,
    0.02,
    1.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define SNAKEBOARD_SLOW __attribute__((cold, optimize("O1")))
#else
#define SNAKEBOARD_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int snakeboard_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return SNAKEBOARD_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return SNAKEBOARD_NOT_FINITE;
        }
    }
    return SNAKEBOARD_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int snakeboard_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : SNAKEBOARD_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef SNAKEBOARD_LANES
#if !defined(__GNUC__)
#define SNAKEBOARD_LANES 1
#elif defined(__AVX512F__)
#define SNAKEBOARD_LANES 8
#elif defined(__AVX__)
#define SNAKEBOARD_LANES 4
#else
#define SNAKEBOARD_LANES 2
#endif
#endif
#if SNAKEBOARD_LANES > 1
typedef double snakeboard_lanes __attribute__((vector_size(8 * SNAKEBOARD_LANES)));
#else
typedef double snakeboard_lanes;
#endif

#if SNAKEBOARD_LANES >= 2
static inline snakeboard_lanes snakeboard_get(const double *from)
{
    snakeboard_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void snakeboard_put(double *to, snakeboard_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int snakeboard_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = SNAKEBOARD_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[SNAKEBOARD_NY];
        double slope[SNAKEBOARD_NY];
        for (size_t k = 0; k < SNAKEBOARD_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = snakeboard_rhs(t[i], state, p, slope);
        status = status == SNAKEBOARD_OK ? one : status;
        for (size_t k = 0; k < SNAKEBOARD_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if SNAKEBOARD_LANES >= 2
#define SNAKEBOARD_SPREAD(x) ((x) - (snakeboard_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long snakeboard_bits __attribute__((vector_size(8 * SNAKEBOARD_LANES)));

/* all bits where value is not above bound, or is no number */
static inline snakeboard_bits snakeboard_misses(snakeboard_lanes value, snakeboard_lanes bound)
{
    return ~(snakeboard_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline snakeboard_lanes snakeboard_mark(snakeboard_lanes value, snakeboard_bits bad)
{
    return (snakeboard_lanes)((snakeboard_bits)value | bad);
}

static inline snakeboard_lanes snakeboard_size(snakeboard_lanes x)
{
    return (snakeboard_lanes)((snakeboard_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int snakeboard_is_good(int count, const double *check)
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
static inline void snakeboard_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < SNAKEBOARD_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < SNAKEBOARD_NY; ++k) {
            state[k * SNAKEBOARD_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void snakeboard_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < SNAKEBOARD_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * SNAKEBOARD_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void snakeboard_turn_lanes(snakeboard_lanes x, snakeboard_lanes *far,
    snakeboard_lanes *sine, snakeboard_lanes *cosine)
{
    double angle[SNAKEBOARD_LANES];
    double up[SNAKEBOARD_LANES];
    double along[SNAKEBOARD_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < SNAKEBOARD_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int snakeboard_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* sines and cosines */
    const double z3 = theta + p_b;
    const double z17 = t * nu;
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    const double s2 = sin(z17);
    const double c2 = cos(z17);

    /* what else is read */
    const double v = y[6]; /* [1/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double p_b_dot = y[8]; /* p_b' [rad/s] */
    const double p_f_dot = y[9]; /* p_f' [rad/s] */
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = J + J_r;
    const double k2 = fabs(l);
    const double k3 = m * l;
    const double k4 = 1.0 / J_r;
    const double k5 = 1.0 / J_w;

    /* from the state */
    const double z1 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z2 = z1 * z1;
    const double z4 = c1 * c_p_f;
    const double z5 = z4 - s1 * s_p_f;
    const double z6 = s1 * c_p_f;
    const double z7 = z6 + c1 * s_p_f;
    const double z8 = c_p_b * z5 + s_p_b * z7;
    const double z9 = c_p_b * z8;
    const double z10 = l * (z4 + z9);
    const double z11 = c_p_b * z7 - s_p_b * z5;
    const double z12 = c_p_b * z11;
    const double z13 = l * (z6 + z12);
    const double z14 = z10 * z10 + z13 * z13;
    const double z15 = J * z2 + m * z14;
    const double z16 = z1 * v;
    const double z18 = p_b_dot * s_p_b;
    const double z19 = p_f_dot * s_p_f;
    const double z20 = v * (c_p_b * c_p_f * (p_b_dot - p_f_dot) + (s_p_f * z18 - s_p_b * z19));
    const double z21 = tau * s2 + J_r * z20;
    const double z22 = p_f_dot + z16;
    const double z23 = p_b_dot + z16;
    const double z24 = z10 * (z18 * z8 + (z22 * z12 + (c1 * z19 + z6 * z23))) + z13 * (z18 * z11 - (z4 * z23
        - (s1 * z19 - z22 * z9)));
    const double z25 = (z1 * (z21 - k1 * z20) - k3 * (v * z24)) / z15;
    const double z26 = z1 * z25;
    const double z27 = sigma * c2;
    const double z28 = J_w * z20;
    /* (I.2.4) */
    dydt[0] = v * z10; /* x' */
    dydt[1] = v * z13; /* y' */
    dydt[2] = z16; /* theta' */
    dydt[3] = psi_dot; /* psi' */
    dydt[4] = p_b_dot; /* p_b' */
    dydt[5] = p_f_dot; /* p_f' */
    /* (I.2.15) 22:4 */
    dydt[6] = -z25; /* v' */
    dydt[7] = k4 * z21 + z26; /* psi'' */
    dydt[8] = k5 * (z27 + z28) + z26; /* p_b'' */
    dydt[9] = z26 - k5 * (z27 - z28); /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[7] + dydt[8] + dydt[9]) <= DBL_MAX
        && fabs(z2 + z14) > 1e-12 * (4.0 + 8.0 * (k2 * k2))
        && fabs(z15) > 1e-13 * z15)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_r is 0 */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_w is 0 */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular, if z2 + z14 is nearly 0 */
        if (!(fabs(z2 + z14) > 1e-12 * (4.0 + 8.0 * (k2 * k2)))) {
            return snakeboard_refuse(fabs(z2 + z14), 1e-12 * (4.0 + 8.0 * (k2 * k2)), SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z15 is nearly 0 */
        if (!(fabs(z15) > 1e-13 * z15)) {
            return snakeboard_refuse(fabs(z15), 1e-13 * z15, SNAKEBOARD_SINGULAR_2);
        }
        return snakeboard_finish(10, dydt);
    }
    return SNAKEBOARD_OK;
}

int snakeboard_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */

    /* sines and cosines */
    const double z2 = theta + p_b;
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z2);
    const double s1 = sin(z2);

    /* what else is read */
    const double v = y[6]; /* [1/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double p_b_dot = y[8]; /* p_b' [rad/s] */
    const double p_f_dot = y[9]; /* p_f' [rad/s] */
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the parameters alone */
    const double k1 = fabs(l);

    /* from the state */
    const double z1 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z3 = c1 * c_p_f;
    const double z4 = z3 - s1 * s_p_f;
    const double z5 = s1 * c_p_f;
    const double z6 = z5 + c1 * s_p_f;
    const double z7 = l * (z3 + c_p_b * (c_p_b * z4 + s_p_b * z6));
    const double z8 = l * (z5 + c_p_b * (c_p_b * z6 - s_p_b * z4));
    /* (I.2.4) */
    qdot[0] = v * z7; /* x' */
    qdot[1] = v * z8; /* y' */
    qdot[2] = z1 * v; /* theta' */
    qdot[3] = psi_dot; /* psi' */
    qdot[4] = p_b_dot; /* p_b' */
    qdot[5] = p_f_dot; /* p_f' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4] + qdot[5]) <= DBL_MAX
        && fabs(z1 * z1 + (z7 * z7 + z8 * z8)) > 1e-12 * (4.0 + 8.0 * (k1 * k1)))) {
        /* the coframe is singular */
        if (!(fabs(z1 * z1 + (z7 * z7 + z8 * z8)) > 1e-12 * (4.0 + 8.0 * (k1 * k1)))) {
            return snakeboard_refuse(fabs(z1 * z1 + (z7 * z7 + z8 * z8)), 1e-12 * (4.0 + 8.0 * (k1 * k1)),
                SNAKEBOARD_SINGULAR_1);
        }
        return snakeboard_finish(6, qdot);
    }
    return SNAKEBOARD_OK;
}

SNAKEBOARD_SLOW
int snakeboard_accelerations(double t, const double *y, const double *p, double *qddot)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* sines and cosines */
    const double z3 = theta + p_b;
    const double z22 = t * nu;
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    const double s2 = sin(z22);
    const double c2 = cos(z22);

    /* what else is read */
    const double v = y[6]; /* [1/s] */
    const double p_b_dot = y[8]; /* p_b' [rad/s] */
    const double p_f_dot = y[9]; /* p_f' [rad/s] */
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = m * l * l;
    const double k2 = fabs(l);
    const double k3 = 1.0 / J_r;
    const double k4 = 1.0 / J_w;
    const double k5 = J + J_w;

    /* from the state */
    const double z1 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z2 = z1 * z1;
    const double z4 = c1 * c_p_f;
    const double z5 = z4 - s1 * s_p_f;
    const double z6 = s1 * c_p_f;
    const double z7 = z6 + c1 * s_p_f;
    const double z8 = c_p_b * z5 + s_p_b * z7;
    const double z9 = z4 + c_p_b * z8;
    const double z10 = l * z9;
    const double z11 = c_p_b * z7 - s_p_b * z5;
    const double z12 = z6 + c_p_b * z11;
    const double z13 = l * z12;
    const double z14 = J * z2 + k1 * (z9 * z9 + z12 * z12);
    const double z15 = l * v;
    const double z16 = p_f_dot * s_p_f;
    const double z17 = z1 * v;
    const double z18 = p_b_dot + z17;
    const double z19 = p_b_dot * s_p_b;
    const double z20 = c_p_b * (p_f_dot + z17);
    const double z21 = z15 * (c1 * z16 + z6 * z18 + (z19 * z8 + z11 * z20));
    const double z23 = c_p_b * c_p_f;
    const double z24 = v * (s_p_f * z19 - p_f_dot * z23 - (s_p_b * z16 - p_b_dot * z23));
    const double z25 = J_r * z24;
    const double z26 = tau * s2 + z25;
    const double z27 = sigma * c2;
    const double z28 = J_w * z24;
    const double z29 = z27 + z28;
    const double z30 = z27 - z28;
    const double z31 = z15 * (s1 * z16 - z4 * z18 + (z19 * z11 - z8 * z20));
    const double z32 = z1 * (z26 - (z25 - (z29 - (z28 + (z30 + k5 * z24))))) - m * (z13 * z31) - m * (z10 *
        z21);
    const double z33 = z32 / z14;
    const double z34 = z1 * z33;
    /* (I.2.15) */
    qddot[0] = -(z21 + z10 * z33); /* x'' */
    qddot[1] = -(z31 + z13 * z33); /* y'' */
    qddot[2] = -(z24 + z34); /* theta'' */
    qddot[3] = k3 * z26 + z34; /* psi'' */
    qddot[4] = k4 * z29 + z34; /* p_b'' */
    qddot[5] = z34 - k4 * z30; /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(z2 + (z10 * z10 + z13 * z13)) > 1e-12 * (4.0 + 8.0 * (k2 * k2))
        && fabs(z14) > 1e-13 * z14)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_r is 0 */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_w is 0 */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(z2 + (z10 * z10 + z13 * z13)) > 1e-12 * (4.0 + 8.0 * (k2 * k2)))) {
            return snakeboard_refuse(fabs(z2 + (z10 * z10 + z13 * z13)), 1e-12 * (4.0 + 8.0 * (k2 * k2)),
                SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z14 is nearly 0 */
        if (!(fabs(z14) > 1e-13 * z14)) {
            return snakeboard_refuse(fabs(z14), 1e-13 * z14, SNAKEBOARD_SINGULAR_2);
        }
        return snakeboard_finish(6, qddot);
    }
    return SNAKEBOARD_OK;
}

int snakeboard_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    const double theta = q[2]; /* heading of the board [rad] */
    const double p_b = q[4]; /* back axle, relative to the board [rad] */
    const double p_f = q[5]; /* front axle, relative to the board [rad] */

    /* sines and cosines */
    const double z1 = theta + p_b;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double c1 = cos(z1);
    const double s1 = sin(z1);

    /* what else is read */
    const double x = q[0]; /* centre of the board [m] */
    const double y_2 = q[1]; /* y: centre of the board [m] */
    const double psi = q[3]; /* rotor, relative to the board [rad] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */
    const double psi_dot = qdot[3]; /* psi' [rad/s] */
    const double p_b_dot = qdot[4]; /* p_b' [rad/s] */
    const double p_f_dot = qdot[5]; /* p_f' [rad/s] */
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / l;

    /* from the coordinates and velocities */
    const double z2 = c1 * c_p_f;
    const double z3 = z2 - s1 * s_p_f;
    const double z4 = s1 * c_p_f;
    const double z5 = z4 + c1 * s_p_f;
    const double z6 = x_dot * (k1 * (z2 + c_p_b * (c_p_b * z3 + s_p_b * z5))) + y_dot * (k1 * (z4 + c_p_b *
        (c_p_b * z5 - s_p_b * z3)));
    const double z7 = (theta_dot * (c_p_b * s_p_f - c_p_f * s_p_b) + z6) / (s_p_f * s_p_f - (2.0 - s_p_b *
        s_p_b));
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = psi;
    y[4] = p_b;
    y[5] = p_f;
    y[6] = -0.5 * z7;
    y[7] = psi_dot;
    y[8] = p_b_dot;
    y[9] = p_f_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[6] + y[7] + y[8] + y[9]) <= DBL_MAX)) {
        return snakeboard_finish(10, y);
    }
    return SNAKEBOARD_OK;
}

int snakeboard_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta = q[2]; /* heading of the board [rad] */
    const double p_b = q[4]; /* back axle, relative to the board [rad] */
    const double p_f = q[5]; /* front axle, relative to the board [rad] */

    /* sines and cosines */
    const double z1 = theta + p_b;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double c_p_f = cos(p_f);
    const double s_p_f = sin(p_f);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the coordinates and velocities */
    const double z2 = theta_dot * l;
    const double z3 = s1 * c_p_f + c1 * s_p_f;
    const double z4 = c1 * c_p_f - s1 * s_p_f;
    const double z5 = x_dot * (c_p_b * z3 - s_p_b * z4) - y_dot * (c_p_b * z4 + s_p_b * z3) - c_p_f * z2;
    /* (I.1.1) 28:5 */
    r[0] = -(x_dot * s1 - y_dot * c1 + c_p_b * z2); /* back = 0 */
    /* (I.1.1) 29:5 */
    r[1] = -z5; /* front = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1]) <= DBL_MAX)) {
        return snakeboard_finish(2, r);
    }
    return SNAKEBOARD_OK;
}

SNAKEBOARD_SLOW
int snakeboard_reactions(double t, const double *y, const double *p, double *lambda)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* sines and cosines */
    const double z3 = theta + p_b;
    const double z17 = t * nu;
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    const double s2 = sin(z17);
    const double c2 = cos(z17);

    /* what else is read */
    const double v = y[6]; /* [1/s] */
    const double p_b_dot = y[8]; /* p_b' [rad/s] */
    const double p_f_dot = y[9]; /* p_f' [rad/s] */
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / l;
    const double k2 = m * l * l;
    const double k3 = fabs(l);
    const double k4 = J + J_w;

    /* from the state */
    const double z1 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z2 = z1 * z1;
    const double z4 = c1 * c_p_f;
    const double z5 = z4 - s1 * s_p_f;
    const double z6 = s1 * c_p_f;
    const double z7 = z6 + c1 * s_p_f;
    const double z8 = c_p_b * z5 + s_p_b * z7;
    const double z9 = z4 + c_p_b * z8;
    const double z10 = l * z9;
    const double z11 = c_p_b * z7 - s_p_b * z5;
    const double z12 = z6 + c_p_b * z11;
    const double z13 = l * z12;
    const double z14 = J * z2 + k2 * (z9 * z9 + z12 * z12);
    const double z15 = k1 * z12;
    const double z16 = 1.0 / (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b));
    const double z18 = tau * s2;
    const double z19 = p_b_dot * s_p_b;
    const double z20 = c_p_b * c_p_f;
    const double z21 = p_f_dot * s_p_f;
    const double z22 = v * (s_p_f * z19 - p_f_dot * z20 - (s_p_b * z21 - p_b_dot * z20));
    const double z23 = J_r * z22;
    const double z24 = sigma * c2;
    const double z25 = J_w * z22;
    const double z26 = l * v;
    const double z27 = z1 * v;
    const double z28 = p_b_dot + z27;
    const double z29 = c_p_b * (p_f_dot + z27);
    const double z30 = z26 * (s1 * z21 - z4 * z28 + (z19 * z11 - z8 * z29));
    const double z31 = z1 * (z18 + z23 - (z23 - (z24 + z25 - (z25 + (z24 - z25 + k4 * z22))))) - m * (z13 *
        z30);
    const double z32 = z26 * (c1 * z21 + z6 * z28 + (z19 * z8 + z11 * z29));
    const double z33 = (z31 - m * (z10 * z32)) / z14;
    const double z34 = z16 * (z18 - J * (z22 + z1 * z33));
    const double z35 = m * z16;
    const double z36 = (z30 + z13 * z33) * z35;
    const double z37 = z15 * z34 + z1 * z36;
    const double z38 = k1 * z9;
    const double z39 = (z32 + z10 * z33) * z35;
    const double z40 = z38 * z34 + z1 * z39;
    const double z41 = l * (z38 * z36 - z15 * z39);
    /* (I.4.1) 28:5 */
    lambda[0] = 0.5 * (z11 * z37 + z8 * z40 + c_p_f * z41); /* reaction of back: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 29:5 */
    lambda[1] = (c_p_b * z41 - (s1 * z37 + c1 * z40)) * 0.5; /* reaction of front: Q_i gains lambda_2 a_2i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J_r * J_w) > 0.0 * (lambda[0] + lambda[1])
        && fabs(z2 + (z10 * z10 + z13 * z13)) > 1e-12 * (4.0 + 8.0 * (k3 * k3))
        && fabs(z14) > 1e-13 * z14)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_r is 0 */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_w is 0 */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(z2 + (z10 * z10 + z13 * z13)) > 1e-12 * (4.0 + 8.0 * (k3 * k3)))) {
            return snakeboard_refuse(fabs(z2 + (z10 * z10 + z13 * z13)), 1e-12 * (4.0 + 8.0 * (k3 * k3)),
                SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z14 is nearly 0 */
        if (!(fabs(z14) > 1e-13 * z14)) {
            return snakeboard_refuse(fabs(z14), 1e-13 * z14, SNAKEBOARD_SINGULAR_2);
        }
        return snakeboard_finish(2, lambda);
    }
    return SNAKEBOARD_OK;
}

double snakeboard_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */

    /* sines and cosines */
    const double z6 = theta + p_b;
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z6);
    const double s1 = sin(z6);

    /* what else is read */
    const double v = y[6]; /* [1/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double p_b_dot = y[8]; /* p_b' [rad/s] */
    const double p_f_dot = y[9]; /* p_f' [rad/s] */
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */

    /* from the state */
    const double z1 = (c_p_b * s_p_f - c_p_f * s_p_b) * v;
    const double z2 = p_b_dot + z1;
    const double z3 = p_f_dot + z1;
    const double z4 = psi_dot + z1;
    const double z5 = l * v;
    const double z7 = c1 * c_p_f;
    const double z8 = z7 - s1 * s_p_f;
    const double z9 = s1 * c_p_f;
    const double z10 = z9 + c1 * s_p_f;
    const double z11 = z5 * (z7 + c_p_b * (c_p_b * z8 + s_p_b * z10));
    const double z12 = z5 * (z9 + c_p_b * (c_p_b * z10 - s_p_b * z8));
    const double z13 = J_w * (z2 * z2 + z3 * z3) + (J_r * (z4 * z4) + (J * (z1 * z1) + m * (z11 * z11 + z12 *
        z12)));
    return 0.5 * z13;
}

SNAKEBOARD_SLOW
int snakeboard_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 100 * sizeof *J);
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* sines and cosines */
    const double z3 = theta + p_b;
    const double z33 = t * nu;
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    const double s2 = sin(z33);
    const double c2 = cos(z33);

    /* what else is read */
    const double v = y[6]; /* [1/s] */
    const double p_b_dot = y[8]; /* p_b' [rad/s] */
    const double p_f_dot = y[9]; /* p_f' [rad/s] */
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J_2 = p[2]; /* J: board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = m * l * l;
    const double k2 = fabs(l);
    const double k3 = J_2 + J_w;

    /* from the state */
    const double z1 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z2 = z1 * z1;
    const double z4 = c1 * c_p_f;
    const double z5 = s1 * s_p_f;
    const double z6 = z4 - z5;
    const double z7 = s1 * c_p_f;
    const double z8 = c1 * s_p_f;
    const double z9 = z7 + z8;
    const double z10 = c_p_b * z6 + s_p_b * z9;
    const double z11 = c_p_b * z10;
    const double z12 = z4 + z11;
    const double z13 = l * z12;
    const double z14 = c_p_b * z9 - s_p_b * z6;
    const double z15 = c_p_b * z14;
    const double z16 = z7 + z15;
    const double z17 = l * z16;
    const double z18 = J_2 * z2 + k1 * (z12 * z12 + z16 * z16);
    const double z19 = l * v;
    const double z20 = z7 + s_p_b * z10;
    const double z21 = z19 * z20;
    const double z22 = z8 + z15;
    const double z23 = z19 * z22;
    const double z24 = z4 - s_p_b * z14;
    const double z25 = z19 * z24;
    const double z26 = z5 - z11;
    const double z27 = z19 * z26;
    const double z28 = c_p_b * c_p_f + s_p_b * s_p_f;
    const double z29 = v * z28;
    const double z30 = J_2 * z1;
    const double z31 = z30 * z28;
    const double z32 = 1.0 / z18;
    const double z34 = p_b_dot * s_p_b;
    const double z35 = p_f_dot * c_p_f;
    const double z36 = p_f_dot * s_p_f;
    const double z37 = p_b_dot * c_p_b;
    const double z38 = s_p_f * z34 - c_p_b * z35 - (s_p_b * z36 - c_p_f * z37);
    const double z39 = v * z38;
    const double z40 = J_r * z39;
    const double z41 = sigma * c2;
    const double z42 = J_w * z39;
    const double z43 = tau * s2 + z40 - (z40 - (z41 + z42 - (z42 + (z41 - z42 + z39 * k3))));
    const double z44 = z1 * v;
    const double z45 = p_b_dot + z44;
    const double z46 = c1 * z45;
    const double z47 = s1 * z36;
    const double z48 = z34 * z14;
    const double z49 = p_f_dot + z44;
    const double z50 = z49 * z10;
    const double z51 = c_p_f * z46 - z47 - (z48 - c_p_b * z50);
    const double z52 = m * z19;
    const double z53 = z51 * z52;
    const double z54 = s1 * z45;
    const double z55 = c1 * z36;
    const double z56 = z34 * z10;
    const double z57 = z49 * z14;
    const double z58 = c_p_f * z54 + z55 + (z56 + c_p_b * z57);
    const double z59 = z58 * z52;
    const double z60 = z1 * z43 + z17 * z53 - z13 * z59;
    const double z61 = z32 * z32 * z60;
    const double z62 = v * (s_p_f * z37 + s_p_b * z35 - (c_p_b * z36 + c_p_f * z34));
    const double z63 = z28 * z43 + z30 * z62;
    const double z64 = l * z53;
    const double z65 = z17 * z52;
    const double z66 = c1 * z29;
    const double z67 = z10 * z29;
    const double z68 = z24 * z64 - z65 * (z55 + c_p_f * (z54 + z66) + (z37 * z14 + (s_p_b * z50 + c_p_b *
        z67)));
    const double z69 = l * z59;
    const double z70 = z13 * z52;
    const double z71 = s1 * z29;
    const double z72 = z14 * z29;
    const double z73 = z20 * z69 + z70 * (z47 - c_p_f * (z46 - z71) - (z37 * z10 - (s_p_b * z57 + c_p_b *
        z72)));
    const double z74 = 2.0 * ((k1 * (z12 * z20 - z16 * z24) + z31) * z61) - z32 * (z63 - z68 - z73);
    const double z75 = z26 * z64 + z65 * (s_p_f * z46 - c_p_f * z66 + s1 * z35 + (z56 + c_p_b * (z57 - z67)));
    const double z76 = z22 * z69 + z70 * (s_p_f * z54 - c_p_f * z71 - c1 * z35 + (z48 - c_p_b * (z50 + z72)));
    const double z77 = 2.0 * (z61 * (k1 * (z12 * z22 + z16 * z26) - z31)) + z32 * (z63 - z75 + z76);
    const double z78 = c_p_b * z1;
    const double z79 = m * z17;
    const double z80 = m * z13;
    const double z81 = z38 * z30 - (l * z51 + z19 * (z4 * z1 + z10 * z78)) * z79 + (l * z58 + z19 * (z7 * z1
        + z14 * z78)) * z80;
    const double z82 = z32 * z81;
    const double z83 = z30 * z29;
    const double z84 = z32 * (z83 - z25 * z79 + z21 * z80);
    const double z85 = z32 * (z83 - z27 * z79 - z23 * z80);
    const double z86 = z62 - z60 * (z28 * z32);
    const double z87 = z1 * z74 + z86;
    const double z88 = z86 - z1 * z77;
    const double z89 = z38 - z1 * z82;
    const double z90 = z29 - z1 * z84;
    const double z91 = z29 - z1 * z85;
    /* (I.2.15) */
    J[2] = -v * z17;
    J[4] = -z21;
    J[5] = -z23;
    J[6] = z13;
    J[12] = v * z13;
    J[14] = z25;
    J[15] = -z27;
    J[16] = z17;
    J[24] = -z29;
    J[25] = z29;
    J[26] = z1;
    J[37] = 1.0;
    J[48] = 1.0;
    J[59] = 1.0;
    J[64] = -z74;
    J[65] = -z77;
    J[66] = z82;
    J[68] = z84;
    J[69] = -z85;
    J[74] = z87;
    J[75] = -z88;
    J[76] = z89;
    J[78] = z90;
    J[79] = -z91;
    J[84] = z87;
    J[85] = -z88;
    J[86] = z89;
    J[88] = z90;
    J[89] = -z91;
    J[94] = z87;
    J[95] = -z88;
    J[96] = z89;
    J[98] = z90;
    J[99] = -z91;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J_r * J_w) > 0.0 * (J[2] + J[4] + J[12] + J[14] + J[64] + J[66] + J[68] + J[74] + J[76] +
        J[78] + J[95] + J[99])
        && fabs(z2 + (z13 * z13 + z17 * z17)) > 1e-12 * (4.0 + 8.0 * (k2 * k2))
        && fabs(z18) > 1e-13 * z18)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_r is 0 */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if J_w is 0 */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(z2 + (z13 * z13 + z17 * z17)) > 1e-12 * (4.0 + 8.0 * (k2 * k2)))) {
            return snakeboard_refuse(fabs(z2 + (z13 * z13 + z17 * z17)), 1e-12 * (4.0 + 8.0 * (k2 * k2)),
                SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z18 is nearly 0 */
        if (!(fabs(z18) > 1e-13 * z18)) {
            return snakeboard_refuse(fabs(z18), 1e-13 * z18, SNAKEBOARD_SINGULAR_2);
        }
        return snakeboard_finish(100, J);
    }
    return SNAKEBOARD_OK;
}

int snakeboard_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */

    /* sines and cosines */
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[6]; /* [1/s] */
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the parameters alone */
    const double k1 = fabs(l);

    /* from the state */
    const double z1 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z2 = l * (c_p_f * (c_p_b * c_theta - s_theta * s_p_b) + c_p_b * (c_p_f * c_theta - s_theta *
        s_p_f));
    const double z3 = l * (c_p_f * (c_p_b * s_theta + c_theta * s_p_b) + c_p_b * (c_p_f * s_theta + c_theta *
        s_p_f));
    /* 32:10 */
    out[0] = 2.0 * (l * (c_p_b * c_p_f * v)); /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(z1 * z1 + (z2 * z2 + z3 * z3)) > 1e-12 * (4.0 + 8.0 * (k1 * k1)))) {
        /* the coframe is singular */
        if (!(fabs(z1 * z1 + (z2 * z2 + z3 * z3)) > 1e-12 * (4.0 + 8.0 * (k1 * k1)))) {
            return snakeboard_refuse(fabs(z1 * z1 + (z2 * z2 + z3 * z3)), 1e-12 * (4.0 + 8.0 * (k1 * k1)),
                SNAKEBOARD_SINGULAR_1);
        }
        return snakeboard_finish(1, out);
    }
    return SNAKEBOARD_OK;
}

#if SNAKEBOARD_LANES >= 2
static __attribute__((noinline)) void snakeboard_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    snakeboard_lanes far = {0}; /* the squares of the angles */
    snakeboard_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    snakeboard_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double l = fixed[1];
    const double J = fixed[2];
    const double J_r = fixed[3];
    const double J_w = fixed[4];
    const double tau = fixed[5];
    const double sigma = fixed[6];
    const double nu = fixed[7];
    const double k1 = fixed[8];
    const double k2 = fixed[9];
    const double k3 = fixed[10];
    const double k4 = fixed[11];
    const double k5 = fixed[12];
    const snakeboard_lanes t_ = snakeboard_get(t);
    const snakeboard_lanes theta = snakeboard_get(y + 2 * stride);
    const snakeboard_lanes p_b = snakeboard_get(y + 4 * stride);
    const snakeboard_lanes p_f = snakeboard_get(y + 5 * stride);
    const snakeboard_lanes v = snakeboard_get(y + 6 * stride);
    const snakeboard_lanes psi_dot = snakeboard_get(y + 7 * stride);
    const snakeboard_lanes p_b_dot = snakeboard_get(y + 8 * stride);
    const snakeboard_lanes p_f_dot = snakeboard_get(y + 9 * stride);
    snakeboard_lanes sine1, cosine1;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(p_b), &far, &sine1, &cosine1);
    const snakeboard_lanes c_p_b = cosine1;
    snakeboard_lanes sine2, cosine2;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(p_f), &far, &sine2, &cosine2);
    const snakeboard_lanes s_p_f = sine2;
    const snakeboard_lanes c_p_f = cosine2;
    const snakeboard_lanes s_p_b = sine1;
    const snakeboard_lanes z1 = c_p_b * s_p_f - c_p_f * s_p_b;
    const snakeboard_lanes z2 = z1 * z1;
    const snakeboard_lanes z3 = theta + p_b;
    snakeboard_lanes sine3, cosine3;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z3), &far, &sine3, &cosine3);
    const snakeboard_lanes c1 = cosine3;
    const snakeboard_lanes z4 = c1 * c_p_f;
    const snakeboard_lanes s1 = sine3;
    const snakeboard_lanes z5 = z4 - s1 * s_p_f;
    const snakeboard_lanes z6 = s1 * c_p_f;
    const snakeboard_lanes z7 = z6 + c1 * s_p_f;
    const snakeboard_lanes z8 = c_p_b * z5 + s_p_b * z7;
    const snakeboard_lanes z9 = c_p_b * z8;
    const snakeboard_lanes z10 = l * (z4 + z9);
    const snakeboard_lanes z11 = c_p_b * z7 - s_p_b * z5;
    const snakeboard_lanes z12 = c_p_b * z11;
    const snakeboard_lanes z13 = l * (z6 + z12);
    const snakeboard_lanes z14 = z10 * z10 + z13 * z13;
    /* the coframe is singular, if z2 + z14 is nearly 0 */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(z2 + z14)), SNAKEBOARD_SPREAD(1e-12 * (4.0 +
        8.0 * (k2 * k2))));
    const snakeboard_lanes z15 = J * z2 + m * z14;
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z15 is nearly 0 */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(z15)), 1e-13 * z15);
    const snakeboard_lanes z16 = z1 * v;
    const snakeboard_lanes z17 = t_ * nu;
    snakeboard_lanes sine4, cosine4;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z17), &far, &sine4, &cosine4);
    const snakeboard_lanes s2 = sine4;
    const snakeboard_lanes z18 = p_b_dot * s_p_b;
    const snakeboard_lanes z19 = p_f_dot * s_p_f;
    const snakeboard_lanes z20 = v * (c_p_b * c_p_f * (p_b_dot - p_f_dot) + (s_p_f * z18 - s_p_b * z19));
    const snakeboard_lanes z21 = tau * s2 + J_r * z20;
    const snakeboard_lanes z22 = p_f_dot + z16;
    const snakeboard_lanes z23 = p_b_dot + z16;
    const snakeboard_lanes z24 = z10 * (z18 * z8 + (z22 * z12 + (c1 * z19 + z6 * z23))) + z13 * (z18 * z11 -
        (z4 * z23 - (s1 * z19 - z22 * z9)));
    const snakeboard_lanes z25 = (z1 * (z21 - k1 * z20) - k3 * (v * z24)) / z15;
    const snakeboard_lanes z26 = z1 * z25;
    const snakeboard_lanes c2 = cosine4;
    const snakeboard_lanes z27 = sigma * c2;
    const snakeboard_lanes z28 = J_w * z20;
    /* (I.2.4) */
    const snakeboard_lanes slope1 = v * z10;
    sum += slope1;
    snakeboard_put(dydt, slope1);
    const snakeboard_lanes slope2 = v * z13;
    sum += slope2;
    snakeboard_put(dydt + 1 * stride, slope2);
    const snakeboard_lanes slope3 = z16;
    snakeboard_put(dydt + 2 * stride, slope3);
    const snakeboard_lanes slope4 = psi_dot;
    sum += slope4;
    snakeboard_put(dydt + 3 * stride, slope4);
    const snakeboard_lanes slope5 = p_b_dot;
    snakeboard_put(dydt + 4 * stride, slope5);
    const snakeboard_lanes slope6 = p_f_dot;
    snakeboard_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 22:4 */
    const snakeboard_lanes slope7 = -z25;
    snakeboard_put(dydt + 6 * stride, slope7);
    const snakeboard_lanes slope8 = k4 * z21 + z26;
    sum += slope8;
    snakeboard_put(dydt + 7 * stride, slope8);
    const snakeboard_lanes slope9 = k5 * (z27 + z28) + z26;
    sum += slope9;
    snakeboard_put(dydt + 8 * stride, slope9);
    const snakeboard_lanes slope10 = z26 - k5 * (z27 - z28);
    sum += slope10;
    snakeboard_put(dydt + 9 * stride, slope10);
    snakeboard_put(check, snakeboard_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void snakeboard_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[SNAKEBOARD_LANES];
    double state[10 * SNAKEBOARD_LANES];
    double slope[10 * SNAKEBOARD_LANES];
    snakeboard_fill(left, count, t, y, time, state);
    snakeboard_rhs_lanes(fixed, SNAKEBOARD_LANES, time, state, slope, check);
    snakeboard_pour(left, count, slope, dydt);
}
#endif

int snakeboard_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if SNAKEBOARD_LANES >= 2
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */
    const double k1 = J + J_r;
    const double k2 = fabs(l);
    const double k3 = m * l;
    const double k4 = 1.0 / J_r;
    const double k5 = 1.0 / J_w;
    const double fixed[] = {m, l, J, J_r, J_w, tau, sigma, nu, k1, k2, k3, k4, k5};
    double check[1 * SNAKEBOARD_LANES];
    int status = SNAKEBOARD_OK;
    for (size_t i = 0; i < count; i += SNAKEBOARD_LANES) {
        const size_t left = count - i < SNAKEBOARD_LANES ? count - i : SNAKEBOARD_LANES;
        if (left == SNAKEBOARD_LANES) {
            snakeboard_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            snakeboard_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!snakeboard_is_good(1 * SNAKEBOARD_LANES, check)) {
            const int one = snakeboard_one_by_one(count, i, left, t, y, p, dydt);
            status = status == SNAKEBOARD_OK ? one : status;
        }
    }
    return status;
#else
    return snakeboard_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
