/*
 * snakeboard.c: snakeboard, emitted by nhc 0.1.0 (nhc:f2cb67853185d667)
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
    const double z8 = theta + p_b;
    const double z42 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z8);
    const double c1 = cos(z8);
    const double s2 = sin(z42);
    const double c2 = cos(z42);

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
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = J + J_r;
    const double k6 = 1.0 / J_r;
    const double k7 = 1.0 / J_w;

    /* from the state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = 1.0 - z2 - k1 * (3.0 - z2);
    const double z4 = c_p_b * c_p_f;
    const double z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2);
    const double z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z7 = 1.0 / z6;
    const double z9 = c1 * c_p_f - s1 * s_p_f;
    const double z10 = s1 * c_p_f + c1 * s_p_f;
    const double z11 = c_p_b * z9 + s_p_b * z10;
    const double z12 = c_p_b * z10 - s_p_b * z9;
    const double z13 = s1 * z11 - c1 * z12;
    const double z14 = z7 * z13;
    const double z15 = l * c_p_f;
    const double z16 = l * c_p_b;
    const double z17 = s1 * z15 + z16 * z12;
    const double z18 = z7 * z17;
    const double z19 = c1 * z15 + z16 * z11;
    const double z20 = z7 * z19;
    const double z21 = z17 * z18 + z19 * z20;
    const double z22 = J * (z14 * z14) + m * (z7 * z21);
    const double z23 = v * z7;
    const double z24 = z23 * z13;
    const double z25 = p_b_dot * c_p_b;
    const double z26 = p_f_dot * c_p_f;
    const double z27 = s_p_f * z26;
    const double z28 = k1 * z27;
    const double z29 = p_b_dot * s_p_b;
    const double z30 = p_f_dot * s_p_f;
    const double z31 = z3 * z25 - 4.0 * (s_p_b * (z27 - z28)) - 2.0 * (k2 * (z4 * z26 - s_p_f * (c_p_f * z29
        + c_p_b * z30)));
    const double z32 = z7 * z7 * (z5 * z25 + s_p_b * z31 + (2.0 * z27 - 6.0 * z28));
    const double z33 = p_b_dot - z24;
    const double z34 = s1 * z33;
    const double z35 = l * z29;
    const double z36 = l * z30;
    const double z37 = p_f_dot - z24;
    const double z38 = z12 * z37;
    const double z39 = c1 * z33;
    const double z40 = z11 * z37;
    const double z41 = z20 * (z15 * z34 + (z35 * z11 + (c1 * z36 + z16 * z38))) - z18 * (z15 * z39 - (z35 *
        z12 + (s1 * z36 - z16 * z40)));
    const double z43 = v * (z32 * z13 - z7 * (z11 * z39 - s1 * z38 + (z12 * z34 - c1 * z40)));
    const double z44 = tau * s2 - J_r * z43;
    const double z45 = (m * (v * (z32 * z21 + z7 * z41)) + z14 * (z44 + k5 * z43)) / z22;
    const double z46 = z14 * z45;
    const double z47 = sigma * c2;
    const double z48 = J_w * z43;
    /* (I.2.4) */
    dydt[0] = z23 * z19; /* x' */
    dydt[1] = z23 * z17; /* y' */
    dydt[2] = -z24; /* theta' */
    dydt[3] = psi_dot; /* psi' */
    dydt[4] = p_b_dot; /* p_b' */
    dydt[5] = p_f_dot; /* p_f' */
    /* (I.2.15) 22:4 */
    dydt[6] = z45; /* v' */
    dydt[7] = k6 * z44 + z46; /* psi'' */
    dydt[8] = k7 * (z47 - z48) + z46; /* p_b'' */
    dydt[9] = z46 - k7 * (z47 + z48); /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[7] + dydt[8] + dydt[9]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z22) > 1e-13 * z22)) {
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return snakeboard_refuse(fabs(z6), 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)), SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z22) > 1e-13 * z22)) {
            return snakeboard_refuse(fabs(z22), 1e-13 * z22, SNAKEBOARD_SINGULAR_2);
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
    const double z6 = theta + p_b;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z6);
    const double s1 = sin(z6);

    /* what else is read */
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the parameters alone */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;

    /* from the state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = s_p_b * (s_p_b * (1.0 - z2 - k1 * (3.0 - z2)) - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2));
    const double z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z5 = v / z4;
    const double z7 = l * c_p_f;
    const double z8 = l * c_p_b;
    const double z9 = c1 * c_p_f - s1 * s_p_f;
    const double z10 = s1 * c_p_f + c1 * s_p_f;
    const double z11 = c_p_b * z9 + s_p_b * z10;
    const double z12 = c_p_b * z10 - s_p_b * z9;
    /* (I.2.4) */
    qdot[0] = z5 * (c1 * z7 + z8 * z11); /* x' */
    qdot[1] = z5 * (s1 * z7 + z8 * z12); /* y' */
    qdot[2] = (c1 * z12 - s1 * z11) * z5; /* theta' */
    qdot[3] = psi_dot; /* psi' */
    qdot[4] = p_b_dot; /* p_b' */
    qdot[5] = p_f_dot; /* p_f' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4] + qdot[5]) <= DBL_MAX
        && fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
        /* the coframe is singular */
        if (!(fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return snakeboard_refuse(fabs(z4), 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)), SNAKEBOARD_SINGULAR_1);
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
    const double z8 = theta + p_b;
    const double z40 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z8);
    const double c1 = cos(z8);
    const double s2 = sin(z40);
    const double c2 = cos(z40);

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
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = 1.0 / J_r;
    const double k6 = 1.0 / J_w;
    const double k7 = J + J_w;

    /* from the state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = 1.0 - z2 - k1 * (3.0 - z2);
    const double z4 = c_p_b * c_p_f;
    const double z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2);
    const double z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z7 = 1.0 / z6;
    const double z9 = c1 * c_p_f - s1 * s_p_f;
    const double z10 = s1 * c_p_f + c1 * s_p_f;
    const double z11 = c_p_b * z9 + s_p_b * z10;
    const double z12 = c_p_b * z10 - s_p_b * z9;
    const double z13 = s1 * z11 - c1 * z12;
    const double z14 = z7 * z13;
    const double z15 = l * c_p_f;
    const double z16 = l * c_p_b;
    const double z17 = s1 * z15 + z16 * z12;
    const double z18 = z7 * z17;
    const double z19 = c1 * z15 + z16 * z11;
    const double z20 = z7 * z19;
    const double z21 = J * (z14 * z14) + m * (z7 * (z17 * z18 + z19 * z20));
    const double z22 = p_b_dot * c_p_b;
    const double z23 = p_f_dot * c_p_f;
    const double z24 = s_p_f * z23;
    const double z25 = k1 * z24;
    const double z26 = p_b_dot * s_p_b;
    const double z27 = p_f_dot * s_p_f;
    const double z28 = z3 * z22 - 4.0 * (s_p_b * (z24 - z25)) - 2.0 * (k2 * (z4 * z23 - s_p_f * (c_p_f * z26
        + c_p_b * z27)));
    const double z29 = z7 * z7 * (z5 * z22 + s_p_b * z28 + (2.0 * z24 - 6.0 * z25));
    const double z30 = v * z29;
    const double z31 = l * z27;
    const double z32 = v * z13;
    const double z33 = z7 * z32;
    const double z34 = p_b_dot - z33;
    const double z35 = s1 * z34;
    const double z36 = l * z26;
    const double z37 = p_f_dot - z33;
    const double z38 = z12 * z37;
    const double z39 = c1 * z31 + z15 * z35 + (z36 * z11 + z16 * z38);
    const double z41 = c1 * z34;
    const double z42 = z11 * z37;
    const double z43 = z11 * z41 - s1 * z38 + (z12 * z35 - c1 * z42);
    const double z44 = v * (z7 * z43 - z29 * z13);
    const double z45 = J_r * z44;
    const double z46 = tau * s2 + z45;
    const double z47 = sigma * c2;
    const double z48 = J_w * z44;
    const double z49 = z47 + z48;
    const double z50 = z47 - z48;
    const double z51 = s1 * z31 - z15 * z41 + (z36 * z12 - z16 * z42);
    const double z52 = m * v;
    const double z53 = z14 * (z46 - (z45 - (z49 - (z48 + (z50 + k7 * z44))))) + (z7 * z51 + z29 * z17) * (z18
        * z52);
    const double z54 = (z53 + (z7 * z39 + z29 * z19) * (z20 * z52)) / z21;
    const double z55 = z14 * z54;
    /* (I.2.15) */
    qddot[0] = -(z19 * z30 + z7 * (v * z39 - z19 * z54)); /* x'' */
    qddot[1] = -(z17 * z30 + z7 * (v * z51 - z17 * z54)); /* y'' */
    qddot[2] = z29 * z32 - z7 * (v * z43 + z13 * z54); /* theta'' */
    qddot[3] = k5 * z46 + z55; /* psi'' */
    qddot[4] = k6 * z49 + z55; /* p_b'' */
    qddot[5] = z55 - k6 * z50; /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
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
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return snakeboard_refuse(fabs(z6), 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)), SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z21) > 1e-13 * z21)) {
            return snakeboard_refuse(fabs(z21), 1e-13 * z21, SNAKEBOARD_SINGULAR_2);
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
    const double z6 = x_dot * (l * (z2 + c_p_b * (c_p_b * z3 + s_p_b * z5))) + y_dot * (l * (z4 + c_p_b *
        (c_p_b * z5 - s_p_b * z3)));
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = psi;
    y[4] = p_b;
    y[5] = p_f;
    y[6] = theta_dot * (c_p_b * s_p_f - c_p_f * s_p_b) + z6;
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
    const double z10 = theta + p_b;
    const double z23 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z10);
    const double c1 = cos(z10);
    const double s2 = sin(z23);
    const double c2 = cos(z23);

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
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = J + J_w;

    /* from the state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = 1.0 - z2 - k1 * (3.0 - z2);
    const double z4 = c_p_b * c_p_f;
    const double z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2);
    const double z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z7 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z8 = 1.0 / z6;
    const double z9 = z7 * z8;
    const double z11 = s1 * c_p_f;
    const double z12 = z11 + c1 * s_p_f;
    const double z13 = c1 * c_p_f;
    const double z14 = z13 - s1 * s_p_f;
    const double z15 = c_p_b * z12 - s_p_b * z14;
    const double z16 = l * (z11 + c_p_b * z15);
    const double z17 = z8 * z16;
    const double z18 = c_p_b * z14 + s_p_b * z12;
    const double z19 = l * (z13 + c_p_b * z18);
    const double z20 = z8 * z19;
    const double z21 = m * z8;
    const double z22 = J * (z9 * z9) + (z16 * z17 + z19 * z20) * z21;
    const double z24 = tau * s2;
    const double z25 = p_b_dot * c_p_b;
    const double z26 = p_f_dot * c_p_f;
    const double z27 = s_p_f * z26;
    const double z28 = k1 * z27;
    const double z29 = p_b_dot * s_p_b;
    const double z30 = p_f_dot * s_p_f;
    const double z31 = z3 * z25 - 4.0 * (s_p_b * (z27 - z28)) - 2.0 * (k2 * (z4 * z26 - s_p_f * (c_p_f * z29
        + c_p_b * z30)));
    const double z32 = z8 * z8 * (z5 * z25 + s_p_b * z31 + (2.0 * z27 - 6.0 * z28));
    const double z33 = v * z9;
    const double z34 = p_b_dot + z33;
    const double z35 = c1 * z34;
    const double z36 = p_f_dot + z33;
    const double z37 = z15 * z36;
    const double z38 = s1 * z34;
    const double z39 = z18 * z36;
    const double z40 = v * (z7 * z32 + z8 * (z18 * z35 - s1 * z37 + (z15 * z38 - c1 * z39)));
    const double z41 = J_r * z40;
    const double z42 = sigma * c2;
    const double z43 = J_w * z40;
    const double z44 = l * z30;
    const double z45 = l * c_p_f;
    const double z46 = l * z29;
    const double z47 = l * c_p_b;
    const double z48 = v * (z32 * z16 + z8 * (s1 * z44 - z45 * z35 + (z46 * z15 - z47 * z39)));
    const double z49 = z9 * (z24 + z41 - (z41 - (z42 + z43 - (z43 + (z42 - z43 + k5 * z40))))) - m * (z17 *
        z48);
    const double z50 = v * (z32 * z19 + z8 * (c1 * z44 + z45 * z38 + (z46 * z18 + z47 * z37)));
    const double z51 = (z49 - m * (z20 * z50)) / z22;
    const double z52 = z8 * (z24 - J * (z40 + z9 * z51));
    const double z53 = z21 * (z48 + z17 * z51);
    const double z54 = z16 * z52 + z7 * z53;
    const double z55 = z21 * (z50 + z20 * z51);
    const double z56 = z19 * z52 + z7 * z55;
    const double z57 = z19 * z53 - z16 * z55;
    /* (I.4.1) 28:5 */
    lambda[0] = -(z15 * z54 + z18 * z56 + z45 * z57); /* reaction of back: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 29:5 */
    lambda[1] = s1 * z54 + c1 * z56 - z47 * z57; /* reaction of front: Q_i gains lambda_2 a_2i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (0 times it is NaN then, and nothing is larger) */
    if (!(fabs(J_r * J_w) > 0.0 * (lambda[0] + lambda[1])
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z22) > 1e-13 * z22)) {
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return snakeboard_refuse(fabs(z6), 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)), SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z22) > 1e-13 * z22)) {
            return snakeboard_refuse(fabs(z22), 1e-13 * z22, SNAKEBOARD_SINGULAR_2);
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
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z6);
    const double s1 = sin(z6);

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
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;

    /* from the state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = s_p_b * (s_p_b * (1.0 - z2 - k1 * (3.0 - z2)) - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2));
    const double z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z5 = v / z4;
    const double z7 = l * c_p_f;
    const double z8 = l * c_p_b;
    const double z9 = c1 * c_p_f - s1 * s_p_f;
    const double z10 = s1 * c_p_f + c1 * s_p_f;
    const double z11 = c_p_b * z9 + s_p_b * z10;
    const double z12 = z5 * (c1 * z7 + z8 * z11);
    const double z13 = c_p_b * z10 - s_p_b * z9;
    const double z14 = z5 * (s1 * z7 + z8 * z13);
    const double z15 = z5 * (s1 * z11 - c1 * z13);
    const double z16 = psi_dot - z15;
    const double z17 = p_b_dot - z15;
    const double z18 = p_f_dot - z15;
    const double z19 = m * (z12 * z12 + z14 * z14) + J * (z15 * z15) + J_r * (z16 * z16) + J_w * (z17 * z17 +
        z18 * z18);
    /* the coframe is singular */
    if (!(fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
        return (double)NAN;
    }
    return 0.5 * z19;
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
    const double z8 = theta + p_b;
    const double z63 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z8);
    const double c1 = cos(z8);
    const double s2 = sin(z63);
    const double c2 = cos(z63);

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
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = J_2 + J_w;

    /* from the state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = 1.0 - z2 - k1 * (3.0 - z2);
    const double z4 = c_p_b * c_p_f;
    const double z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2);
    const double z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z7 = 1.0 / z6;
    const double z9 = c1 * c_p_f - s1 * s_p_f;
    const double z10 = s1 * c_p_f + c1 * s_p_f;
    const double z11 = c_p_b * z9 + s_p_b * z10;
    const double z12 = c_p_b * z10 - s_p_b * z9;
    const double z13 = s1 * z11 - c1 * z12;
    const double z14 = z7 * z13;
    const double z15 = l * c_p_f;
    const double z16 = s1 * z15;
    const double z17 = l * c_p_b;
    const double z18 = z17 * z12;
    const double z19 = z16 + z18;
    const double z20 = z7 * z19;
    const double z21 = c1 * z15;
    const double z22 = z17 * z11;
    const double z23 = z21 + z22;
    const double z24 = z7 * z23;
    const double z25 = z19 * z20 + z23 * z24;
    const double z26 = J_2 * (z14 * z14) + m * (z7 * z25);
    const double z27 = v * z7;
    const double z28 = l * s_p_b;
    const double z29 = z16 + z11 * z28;
    const double z30 = z7 * z7;
    const double z31 = c_p_f * s_p_b;
    const double z32 = k2 * (s_p_f * z31);
    const double z33 = c_p_b * z3 + 2.0 * z32;
    const double z34 = c_p_b * z5 + s_p_b * z33;
    const double z35 = z30 * z34;
    const double z36 = z7 * z29 + z23 * z35;
    const double z37 = v * z36;
    const double z38 = l * s_p_f;
    const double z39 = z18 + c1 * z38;
    const double z40 = c_p_f * s_p_f;
    const double z41 = c_p_b * s_p_f;
    const double z42 = 4.0 * z32 + 2.0 * (k2 * (c_p_f * z4 - s_p_f * z41));
    const double z43 = 2.0 * z40 - 6.0 * (k1 * z40) - s_p_b * z42;
    const double z44 = z30 * z43;
    const double z45 = z7 * z39 + z23 * z44;
    const double z46 = v * z45;
    const double z47 = z21 - z12 * z28;
    const double z48 = z7 * z47 - z19 * z35;
    const double z49 = v * z48;
    const double z50 = z22 - s1 * z38;
    const double z51 = z7 * z50 - z19 * z44;
    const double z52 = v * z51;
    const double z53 = s1 * z12 + c1 * z11;
    const double z54 = z7 * z53;
    const double z55 = z54 - z13 * z35;
    const double z56 = v * z55;
    const double z57 = z54 + z13 * z44;
    const double z58 = v * z57;
    const double z59 = z13 * z14;
    const double z60 = z14 * z53;
    const double z61 = z7 * (z60 + z13 * z55);
    const double z62 = 1.0 / z26;
    const double z64 = p_b_dot * c_p_b;
    const double z65 = p_f_dot * c_p_f;
    const double z66 = s_p_f * z65;
    const double z67 = k1 * z66;
    const double z68 = z66 - z67;
    const double z69 = p_b_dot * s_p_b;
    const double z70 = p_f_dot * s_p_f;
    const double z71 = c_p_f * z69 + c_p_b * z70;
    const double z72 = z3 * z64 - 4.0 * (s_p_b * z68) - 2.0 * (k2 * (z4 * z65 - s_p_f * z71));
    const double z73 = z5 * z64 + s_p_b * z72 + (2.0 * z66 - 6.0 * z67);
    const double z74 = z30 * z73;
    const double z75 = z27 * z13;
    const double z76 = p_b_dot - z75;
    const double z77 = c1 * z76;
    const double z78 = p_f_dot - z75;
    const double z79 = z12 * z78;
    const double z80 = s1 * z76;
    const double z81 = z11 * z78;
    const double z82 = z11 * z77 - s1 * z79 + (z12 * z80 - c1 * z81);
    const double z83 = z74 * z13 - z7 * z82;
    const double z84 = v * z83;
    const double z85 = J_r * z84;
    const double z86 = sigma * c2;
    const double z87 = J_w * z84;
    const double z88 = tau * s2 - z85 + (z85 + (z86 - z87 + (z87 - (z86 + z87 - k5 * z84))));
    const double z89 = m * v;
    const double z90 = l * z70;
    const double z91 = s1 * z90;
    const double z92 = l * z69;
    const double z93 = z92 * z12;
    const double z94 = z91 - z15 * z77 + (z93 - z17 * z81);
    const double z95 = z74 * z19 + z7 * z94;
    const double z96 = z89 * z95;
    const double z97 = c1 * z90;
    const double z98 = z92 * z11;
    const double z99 = z97 + z15 * z80 + (z98 + z17 * z79);
    const double z100 = z74 * z23 + z7 * z99;
    const double z101 = z89 * z100;
    const double z102 = z14 * z88 + z20 * z96 + z24 * z101;
    const double z103 = z62 * z62 * z102;
    const double z104 = J_2 * z14;
    const double z105 = z80 + c1 * z56;
    const double z106 = z12 * z56;
    const double z107 = z77 - s1 * z56;
    const double z108 = z11 * z56;
    const double z109 = z11 * z105 - (s1 * z106 - c1 * z79) - (z12 * z107 + (c1 * z108 + s1 * z81));
    const double z110 = z74 * z53 + z7 * z109;
    const double z111 = k2 * (z31 * z65 - s_p_f * (s_p_b * z70 - c_p_f * z64));
    const double z112 = z64 * z33 - z5 * z69 + (c_p_b * z72 - s_p_b * (z3 * z69 + 4.0 * (c_p_b * z68) - 2.0 *
        z111));
    const double z113 = z73 * (z30 * z7);
    const double z114 = z30 * z112 - 2.0 * (z34 * z113);
    const double z115 = v * (z110 + (z82 * z35 + z13 * z114));
    const double z116 = z20 * z89;
    const double z117 = l * z64;
    const double z118 = z35 * z94 - z7 * (z97 + z15 * z105 + (z12 * z117 + (z17 * z108 + z81 * z28)));
    const double z119 = z55 * z88 + z104 * z115 + (z48 * z96 + z116 * (z74 * z47 + z19 * z114 - z118));
    const double z120 = z24 * z89;
    const double z121 = z35 * z99 + z7 * (z91 - z15 * z107 - (z11 * z117 - (z17 * z106 + z79 * z28)));
    const double z122 = (J_2 * (z59 * z35 - z61) + m * (z61 + z25 * z35)) * z103 + z62 * (z119 - (z36 * z101
        + z120 * (z74 * z29 - z23 * z114 + z121)));
    const double z123 = z7 * (z60 + z13 * z57);
    const double z124 = c_p_f * z65 - s_p_f * z70;
    const double z125 = 2.0 * (k2 * (2.0 * (z41 * z65) + (c_p_f * z71 - s_p_f * (s_p_f * z69 - c_p_b *
        z65))));
    const double z126 = z30 * (2.0 * z124 - 6.0 * (k1 * z124) - (z64 * z42 + s_p_b * (4.0 * z111 - z125)));
    const double z127 = z126 - 2.0 * (z43 * z113);
    const double z128 = v * (z110 - (z82 * z44 + z13 * z127));
    const double z129 = l * z65;
    const double z130 = z7 * (s1 * z129 + (z77 * z38 - z21 * z58) + (z98 + z17 * (z79 - z11 * z58)));
    const double z131 = z57 * z88 + z104 * z128 - (z51 * z96 - z116 * (z44 * z94 - z130 - (z74 * z50 + z19 *
        z127)));
    const double z132 = z7 * (c1 * z129 - (z80 * z38 - z16 * z58) - (z93 - z17 * (z81 + z12 * z58)));
    const double z133 = z62 * (z131 + (z45 * z101 + z120 * (z44 * z99 - z132 + (z74 * z39 - z23 * z127))));
    const double z134 = (J_2 * (z59 * z44 + z123) - m * (z123 - z25 * z44)) * z103 - z133;
    const double z135 = m * z24;
    const double z136 = m * z20;
    const double z137 = (z100 - z27 * (z19 * z14)) * z135 + ((z95 + z27 * (z23 * z14)) * z136 + z83 * z104);
    const double z138 = z62 * z137;
    const double z139 = z62 * (z56 * z104 + z49 * z136 - z37 * z135);
    const double z140 = z62 * (z58 * z104 - z52 * z136 + z46 * z135);
    const double z141 = z62 * z102;
    const double z142 = z115 - (z55 * z141 + z14 * z122);
    const double z143 = z128 - (z57 * z141 - z14 * z134);
    const double z144 = z83 - z14 * z138;
    const double z145 = z56 - z14 * z139;
    const double z146 = z58 - z14 * z140;
    /* (I.2.15) */
    J[2] = -z27 * z19;
    J[4] = -z37;
    J[5] = -z46;
    J[6] = z24;
    J[12] = z27 * z23;
    J[14] = z49;
    J[15] = z52;
    J[16] = z20;
    J[24] = -z56;
    J[25] = z58;
    J[26] = -z14;
    J[37] = 1.0;
    J[48] = 1.0;
    J[59] = 1.0;
    J[64] = z122;
    J[65] = z134;
    J[66] = z138;
    J[68] = -z139;
    J[69] = z140;
    J[74] = -z142;
    J[75] = z143;
    J[76] = -z144;
    J[78] = z145;
    J[79] = -z146;
    J[84] = -z142;
    J[85] = z143;
    J[86] = -z144;
    J[88] = z145;
    J[89] = -z146;
    J[94] = -z142;
    J[95] = z143;
    J[96] = -z144;
    J[98] = z145;
    J[99] = -z146;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (0 times it is NaN then, and nothing is larger) */
    if (!(fabs(J_r * J_w) > 0.0 * (J[2] + J[12] + J[65] + J[68] + J[75] + J[78] + J[94] + J[96] + J[99])
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z26) > 1e-13 * z26)) {
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_r) > 0.0)) {
            return snakeboard_refuse(fabs(J_r), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(J_w) > 0.0)) {
            return snakeboard_refuse(fabs(J_w), 0.0, SNAKEBOARD_SINGULAR_2);
        }
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return snakeboard_refuse(fabs(z6), 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)), SNAKEBOARD_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept are */
        if (!(fabs(z26) > 1e-13 * z26)) {
            return snakeboard_refuse(fabs(z26), 1e-13 * z26, SNAKEBOARD_SINGULAR_2);
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
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);

    /* what else is read */
    const double v = y[6];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* from the parameters alone */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;

    /* from the state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = c_p_b * c_p_f;
    const double z4 = s_p_b * (s_p_b * (1.0 - z2 - k1 * (3.0 - z2)) - 2.0 * (s_p_f * z3 * k2)) + (z1 + k1 *
        (4.0 - 3.0 * z1));
    /* 32:10 */
    out[0] = 2.0 * (l * (z3 * v / z4)); /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
        /* the coframe is singular */
        if (!(fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return snakeboard_refuse(fabs(z4), 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)), SNAKEBOARD_SINGULAR_1);
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
    const double k6 = fixed[13];
    const double k7 = fixed[14];
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
    const snakeboard_lanes s_p_b = sine1;
    snakeboard_lanes sine2, cosine2;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(p_f), &far, &sine2, &cosine2);
    const snakeboard_lanes s_p_f = sine2;
    const snakeboard_lanes z1 = s_p_f * s_p_f;
    const snakeboard_lanes z2 = 2.0 * z1;
    const snakeboard_lanes z3 = 1.0 - z2 - k1 * (3.0 - z2);
    const snakeboard_lanes c_p_b = cosine1;
    const snakeboard_lanes c_p_f = cosine2;
    const snakeboard_lanes z4 = c_p_b * c_p_f;
    const snakeboard_lanes z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2);
    const snakeboard_lanes z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1));
    /* the coframe is singular */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(z6)), SNAKEBOARD_SPREAD(1e-12 * (k4 * ((2.0 +
        4.0 * k3) * k4))));
    const snakeboard_lanes z7 = 1.0 / z6;
    const snakeboard_lanes z8 = theta + p_b;
    snakeboard_lanes sine3, cosine3;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z8), &far, &sine3, &cosine3);
    const snakeboard_lanes s1 = sine3;
    const snakeboard_lanes c1 = cosine3;
    const snakeboard_lanes z9 = c1 * c_p_f - s1 * s_p_f;
    const snakeboard_lanes z10 = s1 * c_p_f + c1 * s_p_f;
    const snakeboard_lanes z11 = c_p_b * z9 + s_p_b * z10;
    const snakeboard_lanes z12 = c_p_b * z10 - s_p_b * z9;
    const snakeboard_lanes z13 = s1 * z11 - c1 * z12;
    const snakeboard_lanes z14 = z7 * z13;
    const snakeboard_lanes z15 = l * c_p_f;
    const snakeboard_lanes z16 = l * c_p_b;
    const snakeboard_lanes z17 = s1 * z15 + z16 * z12;
    const snakeboard_lanes z18 = z7 * z17;
    const snakeboard_lanes z19 = c1 * z15 + z16 * z11;
    const snakeboard_lanes z20 = z7 * z19;
    const snakeboard_lanes z21 = z17 * z18 + z19 * z20;
    const snakeboard_lanes z22 = J * (z14 * z14) + m * (z7 * z21);
    /* the mass matrix is singular, or the velocities that are kept are */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(z22)), 1e-13 * z22);
    const snakeboard_lanes z23 = v * z7;
    const snakeboard_lanes z24 = z23 * z13;
    const snakeboard_lanes z25 = p_b_dot * c_p_b;
    const snakeboard_lanes z26 = p_f_dot * c_p_f;
    const snakeboard_lanes z27 = s_p_f * z26;
    const snakeboard_lanes z28 = k1 * z27;
    const snakeboard_lanes z29 = p_b_dot * s_p_b;
    const snakeboard_lanes z30 = p_f_dot * s_p_f;
    const snakeboard_lanes z31 = z3 * z25 - 4.0 * (s_p_b * (z27 - z28)) - 2.0 * (k2 * (z4 * z26 - s_p_f *
        (c_p_f * z29 + c_p_b * z30)));
    const snakeboard_lanes z32 = z7 * z7 * (z5 * z25 + s_p_b * z31 + (2.0 * z27 - 6.0 * z28));
    const snakeboard_lanes z33 = p_b_dot - z24;
    const snakeboard_lanes z34 = s1 * z33;
    const snakeboard_lanes z35 = l * z29;
    const snakeboard_lanes z36 = l * z30;
    const snakeboard_lanes z37 = p_f_dot - z24;
    const snakeboard_lanes z38 = z12 * z37;
    const snakeboard_lanes z39 = c1 * z33;
    const snakeboard_lanes z40 = z11 * z37;
    const snakeboard_lanes z41 = z20 * (z15 * z34 + (z35 * z11 + (c1 * z36 + z16 * z38))) - z18 * (z15 * z39
        - (z35 * z12 + (s1 * z36 - z16 * z40)));
    const snakeboard_lanes z42 = t_ * nu;
    snakeboard_lanes sine4, cosine4;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z42), &far, &sine4, &cosine4);
    const snakeboard_lanes s2 = sine4;
    const snakeboard_lanes z43 = v * (z32 * z13 - z7 * (z11 * z39 - s1 * z38 + (z12 * z34 - c1 * z40)));
    const snakeboard_lanes z44 = tau * s2 - J_r * z43;
    const snakeboard_lanes z45 = (m * (v * (z32 * z21 + z7 * z41)) + z14 * (z44 + k5 * z43)) / z22;
    const snakeboard_lanes z46 = z14 * z45;
    const snakeboard_lanes c2 = cosine4;
    const snakeboard_lanes z47 = sigma * c2;
    const snakeboard_lanes z48 = J_w * z43;
    /* (I.2.4) */
    const snakeboard_lanes slope1 = z23 * z19;
    sum += slope1;
    snakeboard_put(dydt, slope1);
    const snakeboard_lanes slope2 = z23 * z17;
    sum += slope2;
    snakeboard_put(dydt + 1 * stride, slope2);
    const snakeboard_lanes slope3 = -z24;
    snakeboard_put(dydt + 2 * stride, slope3);
    const snakeboard_lanes slope4 = psi_dot;
    sum += slope4;
    snakeboard_put(dydt + 3 * stride, slope4);
    const snakeboard_lanes slope5 = p_b_dot;
    snakeboard_put(dydt + 4 * stride, slope5);
    const snakeboard_lanes slope6 = p_f_dot;
    snakeboard_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 22:4 */
    const snakeboard_lanes slope7 = z45;
    snakeboard_put(dydt + 6 * stride, slope7);
    const snakeboard_lanes slope8 = k6 * z44 + z46;
    sum += slope8;
    snakeboard_put(dydt + 7 * stride, slope8);
    const snakeboard_lanes slope9 = k7 * (z47 - z48) + z46;
    sum += slope9;
    snakeboard_put(dydt + 8 * stride, slope9);
    const snakeboard_lanes slope10 = z46 - k7 * (z47 + z48);
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
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = J + J_r;
    const double k6 = 1.0 / J_r;
    const double k7 = 1.0 / J_w;
    const double fixed[] = {m, l, J, J_r, J_w, tau, sigma, nu, k1, k2, k3, k4, k5, k6, k7};
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
