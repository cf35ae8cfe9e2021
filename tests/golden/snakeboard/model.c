/*
 * snakeboard.c: snakeboard, emitted by nhc 0.1.0 (nhc:8c7cb0ae64a61948)
 * A board on two steerable axles and a rotor; it moves by turning the rotor and the axles to and fro.
 * Source: snakeboard.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, psi', p_b', p_f': the dependent velocities of the spec (x', y') are
 *     singular somewhere
 * snakeboard.h says what each function does.
 */
#include "snakeboard.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const snakeboard_coordinate_names[] = {
    "x",
    "y",
    "theta",
    "psi",
    "p_b",
    "p_f"
};
const char *const snakeboard_state_names[] = {
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
const char *const snakeboard_parameter_names[] = {
    "m",
    "l",
    "J",
    "J_r",
    "J_w",
    "tau",
    "sigma",
    "nu"
};
const double snakeboard_parameter_defaults[] = {
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
    const double z4 = theta + p_b;
    const double z30 = t * nu;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double c1 = cos(z4);
    const double s1 = sin(z4);
    const double s2 = sin(z30);
    const double c2 = cos(z30);

    /* what else is read */
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;
    const double k4 = J + J_r;
    const double k5 = 1.0 / J_r;
    const double k6 = 1.0 / J_w;
    const double k7 = J * (k1 * k1);

    /* from the state */
    const double z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    const double z2 = l * z1;
    const double z3 = 1.0 / z1;
    const double z5 = c1 * c_p_f;
    const double z6 = z5 - s1 * s_p_f;
    const double z7 = s1 * c_p_f;
    const double z8 = z7 + c1 * s_p_f;
    const double z9 = c_p_b * z6 + s_p_b * z8;
    const double z10 = z5 + c_p_b * z9;
    const double z11 = z3 * z10;
    const double z12 = c_p_b * z8 - s_p_b * z6;
    const double z13 = z7 + c_p_b * z12;
    const double z14 = z3 * z13;
    const double z15 = s1 * z9 - c1 * z12;
    const double z16 = z3 * z15;
    const double z17 = m * (z11 * z11 + z14 * z14) + k7 * (z16 * z16);
    const double z18 = 0.5 * (v / z2 * z15);
    const double z19 = p_b_dot * s_p_b;
    const double z20 = p_f_dot * s_p_f;
    const double z21 = z3 * z3 * (c_p_b * z19 + c_p_f * z20);
    const double z22 = p_b_dot + z18;
    const double z23 = s1 * z22;
    const double z24 = p_f_dot + z18;
    const double z25 = z12 * z24;
    const double z26 = c1 * z22;
    const double z27 = z9 * z24;
    const double z28 = z11 * (z19 * z9 + (c_p_f * z23 + (c1 * z20 + c_p_b * z25))) + z14 * (z19 * z12 -
        (c_p_f * z26 - (s1 * z20 - c_p_b * z27)));
    const double z29 = k1 * z16;
    const double z31 = 2.0 * (z15 * z21) - z3 * (z9 * z26 - s1 * z25 + (z12 * z23 - c1 * z27));
    const double z32 = k1 * (v * z31);
    const double z33 = tau * s2 + 0.5 * (J_r * z32);
    const double z34 = m * (v * ((z10 * z11 + z13 * z14) * z21 + 0.5 * (z3 * z28))) - z29 * (z33 - 0.5 * (k4
        * z32));
    const double z35 = z34 / z17;
    const double z36 = z29 * z35;
    const double z37 = sigma * c2;
    const double z38 = 0.5 * (J_w * z32);
    /* (I.2.4) */
    dydt[0] = -0.5 * (v * z11); /* x' */
    dydt[1] = -0.5 * (v * z14); /* y' */
    dydt[2] = z18; /* theta' */
    dydt[3] = psi_dot; /* psi' */
    dydt[4] = p_b_dot; /* p_b' */
    dydt[5] = p_f_dot; /* p_f' */
    /* (I.2.15) 22:4 */
    dydt[6] = 2.0 * z35; /* v' */
    dydt[7] = k5 * z33 - z36; /* psi'' */
    dydt[8] = k6 * (z37 + z38) - z36; /* p_b'' */
    dydt[9] = -(k6 * (z37 - z38) + z36); /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[6] + dydt[7] + dydt[8] + dydt[9]) <= DBL_MAX
        && fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3))
        && fabs(z17) > 1e-13 * z17)) {
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)))) {
            return snakeboard_refuse(fabs(2.0 * z2), 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)),
                SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z17) > 1e-13 * z17)) {
            return snakeboard_refuse(fabs(z17), 1e-13 * z17, SNAKEBOARD_SINGULAR_2);
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
    const double z4 = theta + p_b;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double c1 = cos(z4);
    const double s1 = sin(z4);

    /* what else is read */
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the parameters alone */
    const double k1 = fabs(l);
    const double k2 = 2.0 + k1;

    /* from the state */
    const double z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    const double z2 = l * z1;
    const double z3 = v / z1;
    const double z5 = c1 * c_p_f;
    const double z6 = z5 - s1 * s_p_f;
    const double z7 = s1 * c_p_f;
    const double z8 = z7 + c1 * s_p_f;
    const double z9 = c_p_b * z6 + s_p_b * z8;
    const double z10 = c_p_b * z8 - s_p_b * z6;
    /* (I.2.4) */
    qdot[0] = -0.5 * (z3 * (z5 + c_p_b * z9)); /* x' */
    qdot[1] = -0.5 * (z3 * (z7 + c_p_b * z10)); /* y' */
    qdot[2] = 0.5 * (v / z2 * (s1 * z9 - c1 * z10)); /* theta' */
    qdot[3] = psi_dot; /* psi' */
    qdot[4] = p_b_dot; /* p_b' */
    qdot[5] = p_f_dot; /* p_f' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4] + qdot[5]) <= DBL_MAX
        && fabs(2.0 * z2) > 1e-12 * (k2 * ((4.0 + 2.0 * k1) * k2)))) {
        /* the coframe is singular */
        if (!(fabs(2.0 * z2) > 1e-12 * (k2 * ((4.0 + 2.0 * k1) * k2)))) {
            return snakeboard_refuse(fabs(2.0 * z2), 1e-12 * (k2 * ((4.0 + 2.0 * k1) * k2)),
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
    const double z4 = theta + p_b;
    const double z32 = t * nu;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double c1 = cos(z4);
    const double s1 = sin(z4);
    const double s2 = sin(z32);
    const double c2 = cos(z32);

    /* what else is read */
    const double v = y[6];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;
    const double k4 = 1.0 / J_r;
    const double k5 = 1.0 / J_w;
    const double k6 = J + J_w;
    const double k7 = J * (k1 * k1);

    /* from the state */
    const double z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    const double z2 = l * z1;
    const double z3 = 1.0 / z1;
    const double z5 = c1 * c_p_f;
    const double z6 = z5 - s1 * s_p_f;
    const double z7 = s1 * c_p_f;
    const double z8 = z7 + c1 * s_p_f;
    const double z9 = c_p_b * z6 + s_p_b * z8;
    const double z10 = z5 + c_p_b * z9;
    const double z11 = z3 * z10;
    const double z12 = c_p_b * z8 - s_p_b * z6;
    const double z13 = z7 + c_p_b * z12;
    const double z14 = z3 * z13;
    const double z15 = s1 * z9 - c1 * z12;
    const double z16 = z3 * z15;
    const double z17 = m * (z11 * z11 + z14 * z14) + k7 * (z16 * z16);
    const double z18 = p_f_dot * s_p_f;
    const double z19 = 1.0 / z2;
    const double z20 = v * z15;
    const double z21 = 0.5 * (z19 * z20);
    const double z22 = p_b_dot + z21;
    const double z23 = s1 * z22;
    const double z24 = p_b_dot * s_p_b;
    const double z25 = p_f_dot + z21;
    const double z26 = z12 * z25;
    const double z27 = c_p_b * z24 + c_p_f * z18;
    const double z28 = z3 * z3 * z27;
    const double z29 = z3 * (c1 * z18 + c_p_f * z23 + (z24 * z9 + c_p_b * z26)) + 2.0 * (z10 * z28);
    const double z30 = v * z29;
    const double z31 = k1 * z16;
    const double z33 = c1 * z22;
    const double z34 = z9 * z25;
    const double z35 = z9 * z33 - s1 * z26 + (z12 * z23 - c1 * z34);
    const double z36 = k1 * (v * (z3 * z35 - 2.0 * (z15 * z28)));
    const double z37 = 0.5 * (J_r * z36);
    const double z38 = tau * s2 - z37;
    const double z39 = sigma * c2;
    const double z40 = 0.5 * (J_w * z36);
    const double z41 = z39 - z40;
    const double z42 = z39 + z40;
    const double z43 = z3 * (s1 * z18 - c_p_f * z33 + (z24 * z12 - c_p_b * z34)) + 2.0 * (z13 * z28);
    const double z44 = v * z43;
    const double z45 = z31 * (z38 + (z37 + (z41 + (z40 - (z42 - 0.5 * (k6 * z36)))))) - 0.5 * (m * (z14 *
        z44));
    const double z46 = (z45 - 0.5 * (m * (z11 * z30))) / z17;
    const double z47 = 2.0 * (l * (z20 * (z19 * z19 * z27))) - z19 * (v * z35 - 2.0 * (z15 * z46));
    const double z48 = z31 * z46;
    /* (I.2.15) */
    qddot[0] = 0.5 * (z30 + 2.0 * (z11 * z46)); /* x'' */
    qddot[1] = 0.5 * (z44 + 2.0 * (z14 * z46)); /* y'' */
    qddot[2] = -0.5 * z47; /* theta'' */
    qddot[3] = z48 + k4 * z38; /* psi'' */
    qddot[4] = z48 + k5 * z41; /* p_b'' */
    qddot[5] = z48 - k5 * z42; /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3))
        && fabs(z17) > 1e-13 * z17)) {
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)))) {
            return snakeboard_refuse(fabs(2.0 * z2), 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)),
                SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z17) > 1e-13 * z17)) {
            return snakeboard_refuse(fabs(z17), 1e-13 * z17, SNAKEBOARD_SINGULAR_2);
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
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z1);
    const double s1 = sin(z1);

    /* what else is read */
    const double x = q[0]; /* centre of the board [m] */
    const double y_2 = q[1]; /* centre of the board [m] */
    const double psi = q[3]; /* rotor, relative to the board [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];
    const double psi_dot = qdot[3];
    const double p_b_dot = qdot[4];
    const double p_f_dot = qdot[5];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the state */
    const double z2 = c1 * c_p_f;
    const double z3 = z2 - s1 * s_p_f;
    const double z4 = s1 * c_p_f;
    const double z5 = z4 + c1 * s_p_f;
    const double z6 = x_dot * (z2 + c_p_b * (c_p_b * z3 + s_p_b * z5)) + y_dot * (z4 + c_p_b * (c_p_b * z5 -
        s_p_b * z3));
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = psi;
    y[4] = p_b;
    y[5] = p_f;
    y[6] = theta_dot * (l * (c_p_b * s_p_f - c_p_f * s_p_b)) + z6;
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
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the state */
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
    const double z4 = theta + p_b;
    const double z18 = t * nu;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double c1 = cos(z4);
    const double s1 = sin(z4);
    const double s2 = sin(z18);
    const double c2 = cos(z18);

    /* what else is read */
    const double v = y[6];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;
    const double k4 = J + J_w;
    const double k5 = J * (k1 * k1);

    /* from the state */
    const double z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    const double z2 = l * z1;
    const double z3 = 1.0 / z1;
    const double z5 = c1 * c_p_f;
    const double z6 = z5 - s1 * s_p_f;
    const double z7 = s1 * c_p_f;
    const double z8 = z7 + c1 * s_p_f;
    const double z9 = c_p_b * z6 + s_p_b * z8;
    const double z10 = z5 + c_p_b * z9;
    const double z11 = z3 * z10;
    const double z12 = c_p_b * z8 - s_p_b * z6;
    const double z13 = z7 + c_p_b * z12;
    const double z14 = z3 * z13;
    const double z15 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z16 = z15 * z3;
    const double z17 = m * (z11 * z11 + z14 * z14) + k5 * (z16 * z16);
    const double z19 = tau * s2;
    const double z20 = 1.0 / z2;
    const double z21 = p_b_dot * s_p_b;
    const double z22 = p_f_dot * s_p_f;
    const double z23 = c_p_b * z21 + c_p_f * z22;
    const double z24 = z15 * v;
    const double z25 = 0.5 * (z20 * z24);
    const double z26 = p_b_dot - z25;
    const double z27 = c1 * z26;
    const double z28 = p_f_dot - z25;
    const double z29 = z12 * z28;
    const double z30 = s1 * z26;
    const double z31 = z9 * z28;
    const double z32 = z9 * z27 - s1 * z29 + (z12 * z30 - c1 * z31);
    const double z33 = k1 * z16;
    const double z34 = z3 * z3 * z23;
    const double z35 = k1 * (v * (z3 * z32 + 2.0 * (z15 * z34)));
    const double z36 = 0.5 * (J_r * z35);
    const double z37 = sigma * c2;
    const double z38 = 0.5 * (J_w * z35);
    const double z39 = z33 * (z19 - z36 + (z36 + (z37 - z38 + (z38 - (z37 + z38 - 0.5 * (k4 * z35))))));
    const double z40 = 2.0 * (z13 * z34) + z3 * (s1 * z22 - c_p_f * z27 + (z21 * z12 - c_p_b * z31));
    const double z41 = v * z40;
    const double z42 = 2.0 * (z10 * z34) + z3 * (c1 * z22 + c_p_f * z30 + (z21 * z9 + c_p_b * z29));
    const double z43 = v * z42;
    const double z44 = (z39 + 0.5 * (m * (z14 * z41)) + 0.5 * (m * (z11 * z43))) / z17;
    const double z45 = 2.0 * (l * (z20 * z20 * z23 * z24)) + v * z20 * z32 - 2.0 * (z33 * z44);
    const double z46 = k1 * (z3 * (z19 + 0.5 * (J * z45)));
    const double z47 = z46 * (c1 * z9 + s1 * z12);
    const double z48 = l * z15;
    const double z49 = m * z20;
    const double z50 = (z41 - 2.0 * (z14 * z44)) * z49;
    const double z51 = z48 * z50;
    const double z52 = (z43 - 2.0 * (z11 * z44)) * z49;
    const double z53 = z48 * z52;
    const double z54 = l * (z10 * z50 - z13 * z52);
    const double z55 = 0.5 * (c_p_b * z46 + c_p_f * z47) - 0.25 * (z12 * z51) - 0.25 * (z9 * z53) - 0.25 *
        (c_p_f * z54);
    const double z56 = 0.5 * (c_p_f * z46 + c_p_b * z47) - 0.25 * (s1 * z51) - 0.25 * (c1 * z53) + 0.25 *
        (c_p_b * z54);
    /* (I.4.1) 28:5 */
    lambda[0] = z55; /* reaction of back: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 29:5 */
    lambda[1] = -z56; /* reaction of front: Q_i gains lambda_2 a_2i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (0 times it is NaN then, and nothing is larger) */
    if (!(fabs(J_r * J_w) > 0.0 * (lambda[0] + lambda[1])
        && fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3))
        && fabs(z17) > 1e-13 * z17)) {
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)))) {
            return snakeboard_refuse(fabs(2.0 * z2), 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)),
                SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z17) > 1e-13 * z17)) {
            return snakeboard_refuse(fabs(z17), 1e-13 * z17, SNAKEBOARD_SINGULAR_2);
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
    const double z4 = theta + p_b;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double c1 = cos(z4);
    const double s1 = sin(z4);

    /* what else is read */
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */

    /* from the parameters alone */
    const double k1 = fabs(l);
    const double k2 = 2.0 + k1;

    /* from the state */
    const double z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    const double z2 = l * z1;
    const double z3 = v / z1;
    const double z5 = c1 * c_p_f;
    const double z6 = z5 - s1 * s_p_f;
    const double z7 = s1 * c_p_f;
    const double z8 = z7 + c1 * s_p_f;
    const double z9 = c_p_b * z6 + s_p_b * z8;
    const double z10 = z3 * (z5 + c_p_b * z9);
    const double z11 = c_p_b * z8 - s_p_b * z6;
    const double z12 = z3 * (z7 + c_p_b * z11);
    const double z13 = v / z2 * (s1 * z9 - c1 * z11);
    const double z14 = 0.5 * z13;
    const double z15 = psi_dot + z14;
    const double z16 = 0.25 * (m * (z10 * z10 + z12 * z12) + J * (z13 * z13)) + J_r * (z15 * z15);
    const double z17 = p_b_dot + z14;
    const double z18 = p_f_dot + z14;
    /* the coframe is singular */
    if (!(fabs(2.0 * z2) > 1e-12 * (k2 * ((4.0 + 2.0 * k1) * k2)))) {
        return (double)NAN;
    }
    return 0.5 * (z16 + J_w * (z17 * z17 + z18 * z18));
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
    const double z4 = theta + p_b;
    const double z52 = t * nu;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double c1 = cos(z4);
    const double s1 = sin(z4);
    const double s2 = sin(z52);
    const double c2 = cos(z52);

    /* what else is read */
    const double v = y[6];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J_2 = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;
    const double k4 = J_2 + J_w;
    const double k5 = J_2 * (k1 * k1);

    /* from the state */
    const double z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    const double z2 = l * z1;
    const double z3 = 1.0 / z1;
    const double z5 = c1 * c_p_f;
    const double z6 = s1 * s_p_f;
    const double z7 = z5 - z6;
    const double z8 = s1 * c_p_f;
    const double z9 = c1 * s_p_f;
    const double z10 = z8 + z9;
    const double z11 = c_p_b * z7 + s_p_b * z10;
    const double z12 = c_p_b * z11;
    const double z13 = z5 + z12;
    const double z14 = z3 * z13;
    const double z15 = c_p_b * z10 - s_p_b * z7;
    const double z16 = c_p_b * z15;
    const double z17 = z8 + z16;
    const double z18 = z3 * z17;
    const double z19 = s1 * z11 - c1 * z15;
    const double z20 = z3 * z19;
    const double z21 = m * (z14 * z14 + z18 * z18) + k5 * (z20 * z20);
    const double z22 = z8 + s_p_b * z11;
    const double z23 = z3 * z3;
    const double z24 = c_p_b * s_p_b;
    const double z25 = z23 * z24;
    const double z26 = z3 * z22 + 2.0 * (z13 * z25);
    const double z27 = v * z26;
    const double z28 = z9 + z16;
    const double z29 = c_p_f * s_p_f;
    const double z30 = z23 * z29;
    const double z31 = z3 * z28 + 2.0 * (z13 * z30);
    const double z32 = v * z31;
    const double z33 = z5 - s_p_b * z15;
    const double z34 = z3 * z33 - 2.0 * (z17 * z25);
    const double z35 = v * z34;
    const double z36 = z6 - z12;
    const double z37 = z3 * z36 + 2.0 * (z17 * z30);
    const double z38 = v * z37;
    const double z39 = v * z19;
    const double z40 = 1.0 / z2;
    const double z41 = z39 * (l * (z40 * z40));
    const double z42 = c1 * z11 + s1 * z15;
    const double z43 = v * z40 * z42;
    const double z44 = 2.0 * (z24 * z41) - z43;
    const double z45 = z43 + 2.0 * (z29 * z41);
    const double z46 = z40 * z19;
    const double z47 = z3 * z42;
    const double z48 = z47 - 2.0 * (z19 * z25);
    const double z49 = k5 * z20;
    const double z50 = 1.0 / z21;
    const double z51 = k1 * z20;
    const double z53 = k1 * v;
    const double z54 = 0.5 * (z40 * z39);
    const double z55 = p_b_dot + z54;
    const double z56 = c1 * z55;
    const double z57 = p_f_dot + z54;
    const double z58 = z15 * z57;
    const double z59 = s1 * z55;
    const double z60 = z11 * z57;
    const double z61 = z11 * z56 - s1 * z58 + (z15 * z59 - c1 * z60);
    const double z62 = p_b_dot * c_p_b;
    const double z63 = p_f_dot * c_p_f;
    const double z64 = s_p_b * z62 + s_p_f * z63;
    const double z65 = z23 * z64;
    const double z66 = z3 * z61 - 2.0 * (z65 * z19);
    const double z67 = z53 * z66;
    const double z68 = 0.5 * (J_r * z67);
    const double z69 = sigma * c2;
    const double z70 = 0.5 * (J_w * z67);
    const double z71 = tau * s2 - z68 + (z68 + (z69 - z70 + (z70 - (z69 + z70 - 0.5 * (k4 * z67)))));
    const double z72 = p_f_dot * s_p_f;
    const double z73 = s1 * z72;
    const double z74 = p_b_dot * s_p_b;
    const double z75 = z74 * z15;
    const double z76 = z73 - c_p_f * z56 + (z75 - c_p_b * z60);
    const double z77 = z3 * z76 + 2.0 * (z65 * z17);
    const double z78 = m * v;
    const double z79 = z77 * z78;
    const double z80 = c1 * z72;
    const double z81 = z74 * z11;
    const double z82 = z80 + c_p_f * z59 + (z81 + c_p_b * z58);
    const double z83 = z3 * z82 + 2.0 * (z65 * z13);
    const double z84 = z83 * z78;
    const double z85 = z51 * z71 - 0.5 * (z18 * z79) - 0.5 * (z14 * z84);
    const double z86 = z50 * z50 * z85;
    const double z87 = k1 * z48;
    const double z88 = z59 + 0.5 * (c1 * z44);
    const double z89 = z15 * z44;
    const double z90 = z56 - 0.5 * (s1 * z44);
    const double z91 = z11 * z44;
    const double z92 = z11 * z88 + (c1 * z58 - 0.5 * (s1 * z89)) - (z15 * z90 + (s1 * z60 + 0.5 * (c1 *
        z91)));
    const double z93 = z3 * z92;
    const double z94 = z65 * z42;
    const double z95 = z64 * (z23 * z3);
    const double z96 = z23 * (c_p_b * z62 - s_p_b * z74) - 4.0 * (z24 * z95);
    const double z97 = z53 * (2.0 * (z61 * z25) + z93 + 2.0 * (z94 + z19 * z96));
    const double z98 = J_2 * z51;
    const double z99 = z18 * z78;
    const double z100 = 2.0 * (z76 * z25) - z3 * (z80 + c_p_f * z88 + (z62 * z15 + (s_p_b * z60 + 0.5 *
        (c_p_b * z91))));
    const double z101 = z71 * z87 - 0.5 * (z97 * z98) - 0.5 * (z34 * z79 - z99 * (z100 - 2.0 * (z65 * z33 +
        z17 * z96)));
    const double z102 = z14 * z78;
    const double z103 = 2.0 * (z82 * z25) + z3 * (z73 - c_p_f * z90 - (z62 * z11 - (s_p_b * z58 + 0.5 *
        (c_p_b * z89))));
    const double z104 = z50 * (z101 + 0.5 * (z26 * z84 + z102 * (z103 + 2.0 * (z65 * z22 - z13 * z96))));
    const double z105 = 2.0 * ((m * (z14 * z26 - z18 * z34) - z48 * z49) * z86) + z104;
    const double z106 = z47 + 2.0 * (z19 * z30);
    const double z107 = c1 * z63 - (s_p_f * z59 + 0.5 * (z8 * z45)) - (z75 - c_p_b * (z60 - 0.5 * (z15 *
        z45)));
    const double z108 = z23 * (c_p_f * z63 - s_p_f * z72) - 4.0 * (z29 * z95);
    const double z109 = z31 * z84 + z102 * (2.0 * (z82 * z30) - z3 * z107 + 2.0 * (z65 * z28 - z13 * z108));
    const double z110 = s1 * z63 + (s_p_f * z56 + 0.5 * (z5 * z45)) + (z81 + c_p_b * (z58 + 0.5 * (z11 *
        z45)));
    const double z111 = z37 * z79 + z99 * (2.0 * (z76 * z30) - z3 * z110 + 2.0 * (z65 * z36 - z17 * z108));
    const double z112 = k1 * z106;
    const double z113 = z53 * (2.0 * (z94 - z19 * z108) - (2.0 * (z61 * z30) - z93));
    const double z114 = 2.0 * (z86 * (m * (z14 * z31 + z18 * z37) + z106 * z49)) + z50 * (0.5 * z109 + (0.5 *
        z111 - (z71 * z112 - 0.5 * (z98 * z113))));
    const double z115 = v * z3;
    const double z116 = m * z14;
    const double z117 = m * z18;
    const double z118 = k1 * z66;
    const double z119 = (z83 + 0.5 * (z115 * (z17 * z46))) * z116 + ((z77 - 0.5 * (z115 * (z13 * z46))) *
        z117 - z118 * z98);
    const double z120 = z50 * z119;
    const double z121 = z53 * z48;
    const double z122 = z50 * (z121 * z98 + z35 * z117 - z27 * z116);
    const double z123 = z53 * z106;
    const double z124 = z50 * (z123 * z98 + z38 * z117 + z32 * z116);
    const double z125 = z50 * z85;
    const double z126 = 0.5 * z97 + (z87 * z125 + z51 * z105);
    const double z127 = 0.5 * z113 + (z112 * z125 - z51 * z114);
    const double z128 = 0.5 * (z118 + z51 * z120);
    const double z129 = 0.5 * (z121 - z51 * z122);
    const double z130 = 0.5 * (z123 - z51 * z124);
    /* (I.2.15) */
    J[2] = 0.5 * (v * z18);
    J[4] = 0.5 * z27;
    J[5] = 0.5 * z32;
    J[6] = -0.5 * z14;
    J[12] = -0.5 * (v * z14);
    J[14] = -0.5 * z35;
    J[15] = 0.5 * z38;
    J[16] = -0.5 * z18;
    J[24] = -0.5 * z44;
    J[25] = -0.5 * z45;
    J[26] = 0.5 * z46;
    J[37] = 1.0;
    J[48] = 1.0;
    J[59] = 1.0;
    J[64] = -2.0 * z105;
    J[65] = -2.0 * z114;
    J[66] = z120;
    J[68] = -z122;
    J[69] = z124;
    J[74] = z126;
    J[75] = -z127;
    J[76] = -z128;
    J[78] = -z129;
    J[79] = z130;
    J[84] = z126;
    J[85] = -z127;
    J[86] = -z128;
    J[88] = -z129;
    J[89] = z130;
    J[94] = z126;
    J[95] = -z127;
    J[96] = -z128;
    J[98] = -z129;
    J[99] = z130;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (0 times it is NaN then, and nothing is larger) */
    if (!(fabs(J_r * J_w) > 0.0 * (J[2] + J[4] + J[5] + J[6] + J[12] + J[14] + J[15] + J[16] + J[24] + J[25]
        + J[26] + J[64] + J[65] + J[69] + J[74] + J[79] + J[95] + J[96] + J[98])
        && fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3))
        && fabs(z21) > 1e-13 * z21)) {
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(2.0 * z2) > 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)))) {
            return snakeboard_refuse(fabs(2.0 * z2), 1e-12 * (k3 * ((4.0 + 2.0 * k2) * k3)),
                SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z21) > 1e-13 * z21)) {
            return snakeboard_refuse(fabs(z21), 1e-13 * z21, SNAKEBOARD_SINGULAR_2);
        }
        return snakeboard_finish(100, J);
    }
    return SNAKEBOARD_OK;
}

int snakeboard_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */

    /* sines and cosines */
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);

    /* what else is read */
    const double v = y[6];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the parameters alone */
    const double k1 = fabs(l);
    const double k2 = 2.0 + k1;

    /* from the state */
    const double z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    /* 32:10 */
    out[0] = -c_p_b * c_p_f * v / z1; /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(2.0 * (l * z1)) > 1e-12 * (k2 * ((4.0 + 2.0 * k1) * k2)))) {
        /* the coframe is singular */
        if (!(fabs(2.0 * (l * z1)) > 1e-12 * (k2 * ((4.0 + 2.0 * k1) * k2)))) {
            return snakeboard_refuse(fabs(2.0 * (l * z1)), 1e-12 * (k2 * ((4.0 + 2.0 * k1) * k2)),
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
    const double J_r = fixed[2];
    const double J_w = fixed[3];
    const double tau = fixed[4];
    const double sigma = fixed[5];
    const double nu = fixed[6];
    const double k1 = fixed[7];
    const double k2 = fixed[8];
    const double k3 = fixed[9];
    const double k4 = fixed[10];
    const double k5 = fixed[11];
    const double k6 = fixed[12];
    const double k7 = fixed[13];
    const snakeboard_lanes t_ = snakeboard_get(t);
    const snakeboard_lanes theta = snakeboard_get(y + 2 * stride);
    const snakeboard_lanes p_b = snakeboard_get(y + 4 * stride);
    const snakeboard_lanes p_f = snakeboard_get(y + 5 * stride);
    const snakeboard_lanes v = snakeboard_get(y + 6 * stride);
    const snakeboard_lanes psi_dot = snakeboard_get(y + 7 * stride);
    const snakeboard_lanes p_b_dot = snakeboard_get(y + 8 * stride);
    const snakeboard_lanes p_f_dot = snakeboard_get(y + 9 * stride);
    snakeboard_lanes sine1, cosine1;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(p_f), &far, &sine1, &cosine1);
    const snakeboard_lanes s_p_f = sine1;
    snakeboard_lanes sine2, cosine2;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(p_b), &far, &sine2, &cosine2);
    const snakeboard_lanes s_p_b = sine2;
    const snakeboard_lanes z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b);
    const snakeboard_lanes z2 = l * z1;
    /* the coframe is singular */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(2.0 * z2)), SNAKEBOARD_SPREAD(1e-12 * (k3 *
        ((4.0 + 2.0 * k2) * k3))));
    const snakeboard_lanes z3 = 1.0 / z1;
    const snakeboard_lanes z4 = theta + p_b;
    snakeboard_lanes sine3, cosine3;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z4), &far, &sine3, &cosine3);
    const snakeboard_lanes c1 = cosine3;
    const snakeboard_lanes c_p_f = cosine1;
    const snakeboard_lanes z5 = c1 * c_p_f;
    const snakeboard_lanes c_p_b = cosine2;
    const snakeboard_lanes s1 = sine3;
    const snakeboard_lanes z6 = z5 - s1 * s_p_f;
    const snakeboard_lanes z7 = s1 * c_p_f;
    const snakeboard_lanes z8 = z7 + c1 * s_p_f;
    const snakeboard_lanes z9 = c_p_b * z6 + s_p_b * z8;
    const snakeboard_lanes z10 = z5 + c_p_b * z9;
    const snakeboard_lanes z11 = z3 * z10;
    const snakeboard_lanes z12 = c_p_b * z8 - s_p_b * z6;
    const snakeboard_lanes z13 = z7 + c_p_b * z12;
    const snakeboard_lanes z14 = z3 * z13;
    const snakeboard_lanes z15 = s1 * z9 - c1 * z12;
    const snakeboard_lanes z16 = z3 * z15;
    const snakeboard_lanes z17 = m * (z11 * z11 + z14 * z14) + k7 * (z16 * z16);
    /* the mass matrix is singular, or the velocities that are kept are */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(z17)), 1e-13 * z17);
    const snakeboard_lanes z18 = 0.5 * (v / z2 * z15);
    const snakeboard_lanes z19 = p_b_dot * s_p_b;
    const snakeboard_lanes z20 = p_f_dot * s_p_f;
    const snakeboard_lanes z21 = z3 * z3 * (c_p_b * z19 + c_p_f * z20);
    const snakeboard_lanes z22 = p_b_dot + z18;
    const snakeboard_lanes z23 = s1 * z22;
    const snakeboard_lanes z24 = p_f_dot + z18;
    const snakeboard_lanes z25 = z12 * z24;
    const snakeboard_lanes z26 = c1 * z22;
    const snakeboard_lanes z27 = z9 * z24;
    const snakeboard_lanes z28 = z11 * (z19 * z9 + (c_p_f * z23 + (c1 * z20 + c_p_b * z25))) + z14 * (z19 *
        z12 - (c_p_f * z26 - (s1 * z20 - c_p_b * z27)));
    const snakeboard_lanes z29 = k1 * z16;
    const snakeboard_lanes z30 = t_ * nu;
    snakeboard_lanes sine4, cosine4;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z30), &far, &sine4, &cosine4);
    const snakeboard_lanes s2 = sine4;
    const snakeboard_lanes z31 = 2.0 * (z15 * z21) - z3 * (z9 * z26 - s1 * z25 + (z12 * z23 - c1 * z27));
    const snakeboard_lanes z32 = k1 * (v * z31);
    const snakeboard_lanes z33 = tau * s2 + 0.5 * (J_r * z32);
    const snakeboard_lanes z34 = m * (v * ((z10 * z11 + z13 * z14) * z21 + 0.5 * (z3 * z28))) - z29 * (z33 -
        0.5 * (k4 * z32));
    const snakeboard_lanes z35 = z34 / z17;
    const snakeboard_lanes z36 = z29 * z35;
    const snakeboard_lanes c2 = cosine4;
    const snakeboard_lanes z37 = sigma * c2;
    const snakeboard_lanes z38 = 0.5 * (J_w * z32);
    /* (I.2.4) */
    const snakeboard_lanes slope1 = -0.5 * (v * z11);
    sum += slope1;
    snakeboard_put(dydt, slope1);
    const snakeboard_lanes slope2 = -0.5 * (v * z14);
    sum += slope2;
    snakeboard_put(dydt + 1 * stride, slope2);
    const snakeboard_lanes slope3 = z18;
    snakeboard_put(dydt + 2 * stride, slope3);
    const snakeboard_lanes slope4 = psi_dot;
    sum += slope4;
    snakeboard_put(dydt + 3 * stride, slope4);
    const snakeboard_lanes slope5 = p_b_dot;
    snakeboard_put(dydt + 4 * stride, slope5);
    const snakeboard_lanes slope6 = p_f_dot;
    snakeboard_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 22:4 */
    const snakeboard_lanes slope7 = 2.0 * z35;
    sum += slope7;
    snakeboard_put(dydt + 6 * stride, slope7);
    const snakeboard_lanes slope8 = k5 * z33 - z36;
    sum += slope8;
    snakeboard_put(dydt + 7 * stride, slope8);
    const snakeboard_lanes slope9 = k6 * (z37 + z38) - z36;
    sum += slope9;
    snakeboard_put(dydt + 8 * stride, slope9);
    const snakeboard_lanes slope10 = -(k6 * (z37 - z38) + z36);
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
    const double k1 = 1.0 / l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;
    const double k4 = J + J_r;
    const double k5 = 1.0 / J_r;
    const double k6 = 1.0 / J_w;
    const double k7 = J * (k1 * k1);
    const double fixed[] = {m, l, J_r, J_w, tau, sigma, nu, k1, k2, k3, k4, k5, k6, k7};
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
