/*
 * snakeboard.c: snakeboard, emitted by nhc 0.1.0 (nhc:dfcf44f9e1fd8e27)
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
__attribute__((noinline)) /* it is seldom called, and would cost its callers registers */
#endif
static int snakeboard_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
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
static int snakeboard_one_by_one(size_t count, size_t first, size_t number, const double *t, const double *y, const double *p, double *dydt)
{
    int status = SNAKEBOARD_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[SNAKEBOARD_NY];
        double slope[SNAKEBOARD_NY];
        for (size_t k = 0; k < SNAKEBOARD_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = NAN;
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

/* no number where a bit is set */
static inline snakeboard_lanes snakeboard_mark(snakeboard_lanes value, snakeboard_bits bad)
{
    return (snakeboard_lanes)((snakeboard_bits)value | bad);
}

static inline snakeboard_lanes snakeboard_size(snakeboard_lanes x)
{
    return (snakeboard_lanes)((snakeboard_bits)x & 0x7fffffffffffffffULL);
}
/* whether none of the states must be asked again: no singular block, no infinity, no angle anywhere near 1e5 */
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

/* the last states, fewer than there are lanes; the others repeat the last one */
static inline void snakeboard_fill(size_t left, size_t count, const double *t, const double *y, double *time, double *state)
{
    for (size_t l = 0; l < SNAKEBOARD_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < SNAKEBOARD_NY; ++k) {
            state[k * SNAKEBOARD_LANES + l] = y[k * count + i];
        }
    }
}

static inline void snakeboard_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < SNAKEBOARD_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * SNAKEBOARD_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void snakeboard_turn_lanes(snakeboard_lanes x, snakeboard_lanes *far, snakeboard_lanes *sine, snakeboard_lanes *cosine)
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

int snakeboard_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* sines and cosines */
    const double z8 = theta + p_b;
    const double z25 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z8);
    const double c1 = cos(z8);
    const double s2 = sin(z25);
    const double c2 = cos(z25);
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

    /* parameters only */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = 1.0 / J_r;
    const double k6 = 1.0 / J_w;
    const double k7 = J + J_w;

    /* state */
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
    const double z15 = J * z14 * z14;
    const double z16 = l * c_p_f;
    const double z17 = l * c_p_b;
    const double z18 = s1 * z16 + z17 * z12;
    const double z19 = z7 * z18;
    const double z20 = c1 * z16 + z17 * z11;
    const double z21 = z7 * z20;
    const double z22 = z15 + m * (z7 * (z18 * z19 + z20 * z21));
    const double z23 = v * z7;
    const double z24 = z13 * z23;
    const double z26 = p_b_dot * c_p_b;
    const double z27 = p_f_dot * c_p_f;
    const double z28 = s_p_f * z27;
    const double z29 = k1 * z28;
    const double z30 = p_b_dot * s_p_b;
    const double z31 = p_f_dot * s_p_f;
    const double z32 = z3 * z26 - 4.0 * (s_p_b * (z28 - z29)) - 2.0 * (k2 * (z4 * z27 - s_p_f * (c_p_f * z30
        + c_p_b * z31)));
    const double z33 = z7 * z7 * (z5 * z26 + s_p_b * z32 + (2.0 * z28 - 6.0 * z29));
    const double z34 = p_b_dot - z24;
    const double z35 = c1 * z34;
    const double z36 = p_f_dot - z24;
    const double z37 = z12 * z36;
    const double z38 = s1 * z34;
    const double z39 = z11 * z36;
    const double z40 = v * (z33 * z13 - z7 * (z11 * z35 - s1 * z37 + (z12 * z38 - c1 * z39)));
    const double z41 = J_r * z40;
    const double z42 = tau * s2 - z41;
    const double z43 = sigma * c2;
    const double z44 = J_w * z40;
    const double z45 = z43 - z44;
    const double z46 = z43 + z44;
    const double z47 = l * z31;
    const double z48 = l * z30;
    const double z49 = m * v;
    const double z50 = (z33 * z18 + z7 * (s1 * z47 - z16 * z35 + (z48 * z12 - z17 * z39))) * (z19 * z49);
    const double z51 = (z33 * z20 + z7 * (c1 * z47 + z16 * z38 + (z48 * z11 + z17 * z37))) * (z21 * z49);
    const double z52 = (z14 * (z42 + (z41 + (z45 + (z44 - (z46 - k7 * z40))))) + z50 + z51) / z22;
    const double z53 = z14 * z52;
    /* (I.2.15) */
    dydt[0] = z20 * z23; /* x' */
    dydt[1] = z18 * z23; /* y' */
    dydt[2] = -z24; /* theta' */
    dydt[3] = psi_dot; /* psi' */
    dydt[4] = p_b_dot; /* p_b' */
    dydt[5] = p_f_dot; /* p_f' */
    /* (I.2.15) 22:4 */
    dydt[6] = z52; /* v' */
    dydt[7] = z53 + k5 * z42; /* psi'' */
    dydt[8] = z53 + k6 * z45; /* p_b'' */
    dydt[9] = z53 - k6 * z46; /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[7] + dydt[8] + dydt[9]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z22) > 1e-14 * (z15 + m * (z19 * z19) + m * (z21 * z21)))) {
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_r) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * (z15 + m * (z19 * z19) + m * (z21 * z21)))) {
            return SNAKEBOARD_SINGULAR_2;
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
    const double z5 = theta + p_b;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z5);
    const double s1 = sin(z5);
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;

    /* state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = s_p_b * (s_p_b * (1.0 - z2 - k1 * (3.0 - z2)) - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2));
    const double z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z6 = l * c_p_f;
    const double z7 = l * c_p_b;
    const double z8 = c1 * c_p_f - s1 * s_p_f;
    const double z9 = s1 * c_p_f + c1 * s_p_f;
    const double z10 = c_p_b * z8 + s_p_b * z9;
    const double z11 = v / z4;
    const double z12 = c_p_b * z9 - s_p_b * z8;
    /* (I.2.4) */
    qdot[0] = (c1 * z6 + z7 * z10) * z11; /* x' */
    qdot[1] = (s1 * z6 + z7 * z12) * z11; /* y' */
    qdot[2] = (c1 * z12 - s1 * z10) * z11; /* theta' */
    qdot[3] = psi_dot; /* psi' */
    qdot[4] = p_b_dot; /* p_b' */
    qdot[5] = p_f_dot; /* p_f' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4] + qdot[5]) <= DBL_MAX
        && fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
        /* the coframe is singular */
        if (!(fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
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
    const double z41 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z8);
    const double c1 = cos(z8);
    const double s2 = sin(z41);
    const double c2 = cos(z41);
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

    /* parameters only */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = 1.0 / J_r;
    const double k6 = 1.0 / J_w;
    const double k7 = J + J_w;

    /* state */
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
    const double z15 = J * z14 * z14;
    const double z16 = l * c_p_f;
    const double z17 = l * c_p_b;
    const double z18 = s1 * z16 + z17 * z12;
    const double z19 = z7 * z18;
    const double z20 = c1 * z16 + z17 * z11;
    const double z21 = z7 * z20;
    const double z22 = z15 + m * (z7 * (z18 * z19 + z20 * z21));
    const double z23 = p_b_dot * c_p_b;
    const double z24 = p_f_dot * c_p_f;
    const double z25 = s_p_f * z24;
    const double z26 = k1 * z25;
    const double z27 = p_b_dot * s_p_b;
    const double z28 = p_f_dot * s_p_f;
    const double z29 = z3 * z23 - 4.0 * (s_p_b * (z25 - z26)) - 2.0 * (k2 * (z4 * z24 - s_p_f * (c_p_f * z27
        + c_p_b * z28)));
    const double z30 = z7 * z7 * (z5 * z23 + s_p_b * z29 + (2.0 * z25 - 6.0 * z26));
    const double z31 = v * z30;
    const double z32 = l * z28;
    const double z33 = v * z13;
    const double z34 = z7 * z33;
    const double z35 = p_b_dot - z34;
    const double z36 = s1 * z35;
    const double z37 = l * z27;
    const double z38 = p_f_dot - z34;
    const double z39 = z12 * z38;
    const double z40 = c1 * z32 + z16 * z36 + (z37 * z11 + z17 * z39);
    const double z42 = c1 * z35;
    const double z43 = z11 * z38;
    const double z44 = z11 * z42 - s1 * z39 + (z12 * z36 - c1 * z43);
    const double z45 = v * (z7 * z44 - z30 * z13);
    const double z46 = J_r * z45;
    const double z47 = tau * s2 + z46;
    const double z48 = sigma * c2;
    const double z49 = J_w * z45;
    const double z50 = z48 + z49;
    const double z51 = z48 - z49;
    const double z52 = s1 * z32 - z16 * z42 + (z37 * z12 - z17 * z43);
    const double z53 = m * v;
    const double z54 = z14 * (z47 - (z46 - (z50 - (z49 + (z51 + k7 * z45))))) + (z7 * z52 + z30 * z18) * (z19
        * z53);
    const double z55 = (z54 + (z7 * z40 + z30 * z20) * (z21 * z53)) / z22;
    const double z56 = z14 * z55;
    /* (I.2.15) */
    qddot[0] = -(z20 * z31 + z7 * (v * z40 - z20 * z55)); /* x'' */
    qddot[1] = -(z18 * z31 + z7 * (v * z52 - z18 * z55)); /* y'' */
    qddot[2] = z30 * z33 - z7 * (v * z44 + z13 * z55); /* theta'' */
    qddot[3] = k5 * z47 + z56; /* psi'' */
    qddot[4] = k6 * z50 + z56; /* p_b'' */
    qddot[5] = z56 - k6 * z51; /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z22) > 1e-14 * (z15 + m * (z19 * z19) + m * (z21 * z21)))) {
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_r) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * (z15 + m * (z19 * z19) + m * (z21 * z21)))) {
            return SNAKEBOARD_SINGULAR_2;
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

    /* state */
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
    const double z3 = theta + p_f;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_p_b = cos(p_b);
    const double s2 = sin(z3);
    const double c2 = cos(z3);
    const double c_p_f = cos(p_f);
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* state */
    const double z2 = theta_dot * l;
    /* (I.1.1) 28:5 */
    r[0] = -(x_dot * s1 - y_dot * c1 + c_p_b * z2); /* back = 0 */
    /* (I.1.1) 29:5 */
    r[1] = c_p_f * z2 - (x_dot * s2 - y_dot * c2); /* front = 0 */
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
    const double z8 = theta + p_b;
    const double z59 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z8);
    const double c1 = cos(z8);
    const double c2 = cos(z59);
    const double s2 = sin(z59);
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

    /* parameters only */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = 1.0 / J_r;
    const double k6 = 1.0 / J_w;
    const double k7 = J + J_w;

    /* state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = 1.0 - z2 - k1 * (3.0 - z2);
    const double z4 = c_p_b * c_p_f;
    const double z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2);
    const double z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z7 = 1.0 / z6;
    const double z9 = c1 * c_p_f;
    const double z10 = z9 - s1 * s_p_f;
    const double z11 = s1 * c_p_f;
    const double z12 = z11 + c1 * s_p_f;
    const double z13 = c_p_b * z10 + s_p_b * z12;
    const double z14 = c_p_b * z12 - s_p_b * z10;
    const double z15 = s1 * z13 - c1 * z14;
    const double z16 = z7 * z15;
    const double z17 = J * z16 * z16;
    const double z18 = l * c_p_f;
    const double z19 = l * c_p_b;
    const double z20 = s1 * z18 + z19 * z14;
    const double z21 = z7 * z20;
    const double z22 = c1 * z18 + z19 * z13;
    const double z23 = z7 * z22;
    const double z24 = z17 + m * (z7 * (z20 * z21 + z22 * z23));
    const double z25 = l * (z11 + c_p_b * z14);
    const double z26 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z27 = z7 * (z18 * z25 - z26 * z13);
    const double z28 = p_b_dot * c_p_b;
    const double z29 = p_f_dot * c_p_f;
    const double z30 = s_p_f * z29;
    const double z31 = k1 * z30;
    const double z32 = p_b_dot * s_p_b;
    const double z33 = p_f_dot * s_p_f;
    const double z34 = z3 * z28 - 4.0 * (s_p_b * (z30 - z31)) - 2.0 * (k2 * (z4 * z29 - s_p_f * (c_p_f * z32
        + c_p_b * z33)));
    const double z35 = z7 * z7 * (z5 * z28 + s_p_b * z34 + (2.0 * z30 - 6.0 * z31));
    const double z36 = v * z35;
    const double z37 = l * z33;
    const double z38 = v * z15;
    const double z39 = z7 * z38;
    const double z40 = p_b_dot - z39;
    const double z41 = s1 * z40;
    const double z42 = l * z32;
    const double z43 = p_f_dot - z39;
    const double z44 = z14 * z43;
    const double z45 = c1 * z37 + z18 * z41 + (z42 * z13 + z19 * z44);
    const double z46 = v * z7;
    const double z47 = z22 * z36 + z45 * z46;
    const double z48 = l * (z9 + c_p_b * z13);
    const double z49 = z7 * (z18 * z48 + z26 * z14);
    const double z50 = c1 * z40;
    const double z51 = z13 * z43;
    const double z52 = s1 * z37 - z18 * z50 + (z42 * z14 - z19 * z51);
    const double z53 = z20 * z36 + z52 * z46;
    const double z54 = z7 * (z13 * z48 + z14 * z25);
    const double z55 = z13 * z50 - s1 * z44 + (z14 * z41 - c1 * z51);
    const double z56 = z35 * z38 - z55 * z46;
    const double z57 = z54 * z56;
    const double z58 = m * (z27 * z47 - z49 * z53) - J * z57 - J_r * z57 - 2.0 * (J_w * z57);
    const double z60 = sigma * c2;
    const double z61 = v * (z7 * z55 - z35 * z15);
    const double z62 = J_w * z61;
    const double z63 = z60 - z62;
    const double z64 = J_r * z61;
    const double z65 = tau * s2 + z64;
    const double z66 = z60 + z62;
    const double z67 = m * v;
    const double z68 = z16 * (z65 - (z64 - (z66 - (z62 + (z63 + k7 * z61))))) + (z7 * z52 + z35 * z20) * (z21
        * z67);
    const double z69 = (z68 + (z7 * z45 + z35 * z22) * (z23 * z67)) / z24;
    const double z70 = z16 * z69;
    const double z71 = k6 * z63 - z70;
    const double z72 = J_w * z54;
    const double z73 = k6 * z66 + z70;
    const double z74 = z16 * z54;
    const double z75 = m * (z23 * z27 - z21 * z49) - J * z74 - J_r * z74 - 2.0 * (J_w * z74);
    const double z76 = J_r * (k5 * z65 + z70);
    const double z77 = z7 * (c1 * z26 + z19 * z25);
    const double z78 = z7 * (s1 * z26 - z19 * z48);
    const double z79 = z7 * (c1 * z48 + s1 * z25);
    const double z80 = z79 * z56;
    const double z81 = m * (z77 * z47 + z78 * z53) + J * z80 + J_r * z80 + 2.0 * (J_w * z80);
    const double z82 = J_w * z79;
    const double z83 = z16 * z79;
    const double z84 = m * (z23 * z77 + z21 * z78) + J * z83 + J_r * z83 + 2.0 * (J_w * z83);
    /* (I.4.1) 28:5 */
    /* reaction of back: Q_i gains lambda_1 a_1i */
    lambda[0] = z58 + (z71 * z72 - (z73 * z72 + (z69 * z75 + z54 * z76)));
    /* (I.4.1) 29:5 */
    /* reaction of front: Q_i gains lambda_2 a_2i */
    lambda[1] = z81 - (z71 * z82 - (z73 * z82 - (z69 * z84 - z79 * z76)));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z24) > 1e-14 * (z17 + m * (z21 * z21) + m * (z23 * z23)))) {
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_r) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z24) > 1e-14 * (z17 + m * (z21 * z21) + m * (z23 * z23)))) {
            return SNAKEBOARD_SINGULAR_2;
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
    const double z1 = theta + p_b;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double c_p_f = cos(p_f);
    const double s_p_f = sin(p_f);
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;

    /* state */
    const double z2 = l * c_p_f;
    const double z3 = l * c_p_b;
    const double z4 = c1 * c_p_f - s1 * s_p_f;
    const double z5 = s1 * c_p_f + c1 * s_p_f;
    const double z6 = c_p_b * z4 + s_p_b * z5;
    const double z7 = s_p_f * s_p_f;
    const double z8 = 2.0 * z7;
    const double z9 = s_p_b * (s_p_b * (1.0 - z8 - k1 * (3.0 - z8)) - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2));
    const double z10 = v / (z9 + (z7 + k1 * (4.0 - 3.0 * z7)));
    const double z11 = (c1 * z2 + z3 * z6) * z10;
    const double z12 = c_p_b * z5 - s_p_b * z4;
    const double z13 = (s1 * z2 + z3 * z12) * z10;
    const double z14 = (s1 * z6 - c1 * z12) * z10;
    const double z15 = psi_dot - z14;
    const double z16 = p_b_dot - z14;
    const double z17 = p_f_dot - z14;
    const double z18 = m * (z11 * z11 + z13 * z13) + J * (z14 * z14) + J_r * (z15 * z15) + J_w * (z16 * z16 +
        z17 * z17);
    return 0.5 * z18;
}

SNAKEBOARD_SLOW
int snakeboard_jacobian(double t, const double *y, const double *p, double *J)
{
    for (int entry = 0; entry < 100; ++entry) {
        J[entry] = 0.0;
    }
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* sines and cosines */
    const double z9 = theta + p_b;
    const double z61 = t * nu;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s1 = sin(z9);
    const double c1 = cos(z9);
    const double s2 = sin(z61);
    const double c2 = cos(z61);
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

    /* parameters only */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;
    const double k5 = J_2 + J_w;

    /* state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = 1.0 - z2 - k1 * (3.0 - z2);
    const double z4 = c_p_b * c_p_f;
    const double z5 = s_p_f * k2;
    const double z6 = s_p_b * z3 - 2.0 * (z4 * z5);
    const double z7 = z1 + k1 * (4.0 - 3.0 * z1) + s_p_b * z6;
    const double z8 = 1.0 / z7;
    const double z10 = c1 * c_p_f - s1 * s_p_f;
    const double z11 = s1 * c_p_f + c1 * s_p_f;
    const double z12 = c_p_b * z10 + s_p_b * z11;
    const double z13 = c_p_b * z11 - s_p_b * z10;
    const double z14 = s1 * z12 - c1 * z13;
    const double z15 = z14 * z8;
    const double z16 = z14 * z15;
    const double z17 = l * c_p_f;
    const double z18 = s1 * z17;
    const double z19 = l * c_p_b;
    const double z20 = z19 * z13;
    const double z21 = z18 + z20;
    const double z22 = z21 * z8;
    const double z23 = c1 * z17;
    const double z24 = z19 * z12;
    const double z25 = z23 + z24;
    const double z26 = z25 * z8;
    const double z27 = z21 * z22 + z25 * z26;
    const double z28 = J_2 * (z8 * z16) + m * (z8 * z27);
    const double z29 = v * z21;
    const double z30 = v * z25;
    const double z31 = z8 * z8;
    const double z32 = c_p_f * s_p_b;
    const double z33 = c_p_b * z3 + 2.0 * (z32 * z5);
    const double z34 = c_p_b * z6 + s_p_b * z33;
    const double z35 = z31 * z34;
    const double z36 = l * s_p_b;
    const double z37 = z18 + z12 * z36;
    const double z38 = v * z8;
    const double z39 = c_p_f * s_p_f;
    const double z40 = k1 * z39;
    const double z41 = z39 - z40;
    const double z42 = c_p_b * s_p_f;
    const double z43 = 4.0 * (s_p_b * z41) + 2.0 * (k2 * (c_p_f * z4 - s_p_f * z42));
    const double z44 = s_p_b * z43 - (2.0 * z39 - 6.0 * z40);
    const double z45 = z44 * z31;
    const double z46 = l * s_p_f;
    const double z47 = z20 + c1 * z46;
    const double z48 = z23 - z13 * z36;
    const double z49 = z24 - s1 * z46;
    const double z50 = v * z14;
    const double z51 = s1 * z13 + c1 * z12;
    const double z52 = z51 * z38;
    const double z53 = z50 * z35 - z52;
    const double z54 = z52 - z50 * z45;
    const double z55 = z51 * z15;
    const double z56 = z51 * z8;
    const double z57 = z56 - z14 * z35;
    const double z58 = z48 * z8 - z21 * z35;
    const double z59 = z37 * z8 + z25 * z35;
    const double z60 = m * (z27 * z35 - z8 * (z48 * z22 + z21 * z58 - (z37 * z26 + z25 * z59)));
    const double z62 = z50 * z8;
    const double z63 = p_b_dot - z62;
    const double z64 = c1 * z63;
    const double z65 = p_f_dot - z62;
    const double z66 = z13 * z65;
    const double z67 = s1 * z63;
    const double z68 = z12 * z65;
    const double z69 = z12 * z64 - s1 * z66 + (z13 * z67 - c1 * z68);
    const double z70 = p_f_dot * c_p_f;
    const double z71 = s_p_f * z70;
    const double z72 = k1 * z71;
    const double z73 = p_b_dot * c_p_b;
    const double z74 = z71 - z72;
    const double z75 = p_b_dot * s_p_b;
    const double z76 = p_f_dot * s_p_f;
    const double z77 = c_p_f * z75 + c_p_b * z76;
    const double z78 = z3 * z73 - 4.0 * (s_p_b * z74) - 2.0 * (k2 * (z4 * z70 - s_p_f * z77));
    const double z79 = 2.0 * z71 - 6.0 * z72 + (s_p_b * z78 + z73 * z6);
    const double z80 = z31 * z79;
    const double z81 = z8 * z69 - z14 * z80;
    const double z82 = v * z81;
    const double z83 = J_r * z82;
    const double z84 = sigma * c2;
    const double z85 = J_w * z82;
    const double z86 = tau * s2 + z83 - (z83 - (z84 + z85 - (z85 + (z84 - z85 + k5 * z82))));
    const double z87 = m * v;
    const double z88 = l * z76;
    const double z89 = s1 * z88;
    const double z90 = l * z75;
    const double z91 = z90 * z13;
    const double z92 = z89 - z17 * z64 + (z91 - z19 * z68);
    const double z93 = z8 * z92 + z21 * z80;
    const double z94 = z87 * z93;
    const double z95 = c1 * z88;
    const double z96 = z90 * z12;
    const double z97 = z95 + z17 * z67 + (z96 + z19 * z66);
    const double z98 = z8 * z97 + z25 * z80;
    const double z99 = z87 * z98;
    const double z100 = z15 * z86 + z22 * z94 + z26 * z99;
    const double z101 = 1.0 / z28;
    const double z102 = z100 * (z101 * z101);
    const double z103 = z67 - c1 * z53;
    const double z104 = z13 * z53;
    const double z105 = z64 + s1 * z53;
    const double z106 = z12 * z53;
    const double z107 = z12 * z103 + (c1 * z66 + s1 * z104) - (z13 * z105 + (s1 * z68 - c1 * z106));
    const double z108 = z51 * z80;
    const double z109 = z79 * (z31 * z8);
    const double z110 = z3 * z75 + 4.0 * (c_p_b * z74) - 2.0 * (k2 * (z32 * z70 - s_p_f * (s_p_b * z76 -
        c_p_f * z73)));
    const double z111 = 2.0 * (z34 * z109) - z31 * (c_p_b * z78 - s_p_b * z110 + (z73 * z33 - z75 * z6));
    const double z112 = v * (z69 * z35 + z8 * z107 + (z108 - z14 * z111));
    const double z113 = J_2 * z15;
    const double z114 = l * z73;
    const double z115 = z92 * z35 - z8 * (z95 + z17 * z103 + (z13 * z114 + (z36 * z68 - z19 * z106)));
    const double z116 = z87 * z22;
    const double z117 = z86 * z57 + z112 * z113 + (z94 * z58 - (z115 - (z48 * z80 - z21 * z111)) * z116);
    const double z118 = z97 * z35 + z8 * (z89 - z17 * z105 - (z12 * z114 - (z36 * z66 - z19 * z104)));
    const double z119 = z87 * z26;
    const double z120 = (J_2 * (z16 * z35 - z8 * (z55 + z14 * z57)) + z60) * z102 + z101 * (z117 - (z99 * z59
        + (z118 + (z37 * z80 + z25 * z111)) * z119));
    const double z121 = z56 - z14 * z45;
    const double z122 = z49 * z8 + z21 * z45;
    const double z123 = z47 * z8 - z25 * z45;
    const double z124 = m * (z27 * z45 + z8 * (z49 * z22 + z21 * z122 - (z47 * z26 + z25 * z123)));
    const double z125 = c1 * z54;
    const double z126 = z68 + z13 * z54;
    const double z127 = s1 * z54;
    const double z128 = z66 - z12 * z54;
    const double z129 = z13 * z64 - z12 * z125 + s1 * z126 - (z12 * z67 + z13 * z127 + c1 * z128);
    const double z130 = c_p_f * z70 - s_p_f * z76;
    const double z131 = k1 * z130;
    const double z132 = k2 * (z42 * z70 + z4 * z76 + (c_p_f * z77 - s_p_f * (s_p_f * z75 - c_p_b * z70)));
    const double z133 = z73 * z43 + s_p_b * (4.0 * (z73 * z41 + s_p_b * (z130 - z131)) - 2.0 * z132) - (2.0 *
        z130 - 6.0 * z131);
    const double z134 = 2.0 * (z44 * z109) - z133 * z31;
    const double z135 = v * (z69 * z45 - z8 * z129 + (z108 - z14 * z134));
    const double z136 = l * z70;
    const double z137 = z92 * z45 + z8 * (s1 * z136 + (z46 * z64 - z17 * z125) + (z96 + z19 * z128));
    const double z138 = z86 * z121 + z113 * z135 - (z94 * z122 + z116 * (z137 + (z49 * z80 + z21 * z134)));
    const double z139 = z97 * z45 + z8 * (c1 * z136 - (z46 * z67 - z17 * z127) - (z91 - z19 * z126));
    const double z140 = z102 * (J_2 * (z16 * z45 - z8 * (z55 + z14 * z121)) + z124) + z101 * (z138 + (z99 *
        z123 - z119 * (z139 - (z47 * z80 - z25 * z134))));
    const double z141 = c1 * z15;
    const double z142 = z13 * z15;
    const double z143 = s1 * z15;
    const double z144 = z12 * z15;
    const double z145 = z81 - z38 * (z12 * z141 - s1 * z142 + (z13 * z143 - c1 * z144));
    const double z146 = z113 * z145 - m * (z22 * (z93 + z38 * (z17 * z141 + z19 * z144))) - m * (z26 * (z98 -
        z38 * (z17 * z143 + z19 * z142)));
    const double z147 = z101 * z146;
    const double z148 = v * z57;
    const double z149 = z101 * (z113 * z148 + z58 * z116 - z59 * z119);
    const double z150 = v * z121;
    const double z151 = z101 * (z113 * z150 - z116 * z122 + z119 * z123);
    const double z152 = z101 * z100;
    const double z153 = z112 - (z152 * z57 + z15 * z120);
    const double z154 = z135 - (z152 * z121 + z15 * z140);
    const double z155 = z145 - z15 * z147;
    const double z156 = z148 - z15 * z149;
    const double z157 = z150 - z15 * z151;
    /* (I.2.15) */
    J[2] = -z29 * z8;
    J[4] = -(z30 * z35 + z37 * z38);
    J[5] = z30 * z45 - z47 * z38;
    J[6] = z26;
    J[12] = z30 * z8;
    J[14] = z48 * z38 - z29 * z35;
    J[15] = z29 * z45 + z49 * z38;
    J[16] = z22;
    J[24] = z53;
    J[25] = z54;
    J[26] = -z15;
    J[37] = 1.0;
    J[48] = 1.0;
    J[59] = 1.0;
    J[64] = z120;
    J[65] = -z140;
    J[66] = -z147;
    J[68] = -z149;
    J[69] = z151;
    J[74] = -z153;
    J[75] = z154;
    J[76] = z155;
    J[78] = z156;
    J[79] = -z157;
    J[84] = -z153;
    J[85] = z154;
    J[86] = z155;
    J[88] = z156;
    J[89] = -z157;
    J[94] = -z153;
    J[95] = z154;
    J[96] = z155;
    J[98] = z156;
    J[99] = -z157;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[4] + J[5] + J[12] + J[14] + J[15] + J[65] + J[66] + J[68] + J[75] + J[76] + J[78] +
        J[94] + J[99]) <= DBL_MAX
        && fabs(z7) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(J_w) > 0.0
        && fabs(J_r) > 0.0
        && fabs(z28) > 1e-14 * (J_2 * (z15 * z15) + m * (z22 * z22) + m * (z26 * z26)))) {
        /* the coframe is singular */
        if (!(fabs(z7) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_r) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z28) > 1e-14 * (J_2 * (z15 * z15) + m * (z22 * z22) + m * (z26 * z26)))) {
            return SNAKEBOARD_SINGULAR_2;
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
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double v = y[6];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = 1.0 - k1;
    const double k3 = fabs(l);
    const double k4 = 2.0 + k3;

    /* state */
    const double z1 = s_p_f * s_p_f;
    const double z2 = 2.0 * z1;
    const double z3 = s_p_b * (s_p_b * (1.0 - z2 - k1 * (3.0 - z2)) - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2));
    const double z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1));
    const double z5 = c_p_f * (c_theta * (c_p_b * c_theta - s_theta * s_p_b) + s_theta * (c_p_b * s_theta +
        c_theta * s_p_b)) + c_p_b * (s_theta * (c_p_f * s_theta + c_theta * s_p_f) + c_theta * (c_p_f *
        c_theta - s_theta * s_p_f));
    /* 32:10 */
    out[0] = l * (v / z4 * z5); /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
        /* the coframe is singular */
        if (!(fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        return snakeboard_finish(1, out);
    }
    return SNAKEBOARD_OK;
}

#if SNAKEBOARD_LANES >= 2
static __attribute__((noinline)) void snakeboard_rhs_lanes(const double *fixed, size_t stride, const double
    *t, const double *y, double *restrict dydt, double *check)
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
    const snakeboard_lanes z15 = J * z14 * z14;
    const snakeboard_lanes z16 = l * c_p_f;
    const snakeboard_lanes z17 = l * c_p_b;
    const snakeboard_lanes z18 = s1 * z16 + z17 * z12;
    const snakeboard_lanes z19 = z7 * z18;
    const snakeboard_lanes z20 = c1 * z16 + z17 * z11;
    const snakeboard_lanes z21 = z7 * z20;
    const snakeboard_lanes z22 = z15 + m * (z7 * (z18 * z19 + z20 * z21));
    /* the mass matrix is singular */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(z22)), 1e-14 * (z15 + m * (z19 * z19) + m *
        (z21 * z21)));
    const snakeboard_lanes z23 = v * z7;
    const snakeboard_lanes z24 = z13 * z23;
    const snakeboard_lanes z25 = t_ * nu;
    snakeboard_lanes sine4, cosine4;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z25), &far, &sine4, &cosine4);
    const snakeboard_lanes s2 = sine4;
    const snakeboard_lanes z26 = p_b_dot * c_p_b;
    const snakeboard_lanes z27 = p_f_dot * c_p_f;
    const snakeboard_lanes z28 = s_p_f * z27;
    const snakeboard_lanes z29 = k1 * z28;
    const snakeboard_lanes z30 = p_b_dot * s_p_b;
    const snakeboard_lanes z31 = p_f_dot * s_p_f;
    const snakeboard_lanes z32 = z3 * z26 - 4.0 * (s_p_b * (z28 - z29)) - 2.0 * (k2 * (z4 * z27 - s_p_f *
        (c_p_f * z30 + c_p_b * z31)));
    const snakeboard_lanes z33 = z7 * z7 * (z5 * z26 + s_p_b * z32 + (2.0 * z28 - 6.0 * z29));
    const snakeboard_lanes z34 = p_b_dot - z24;
    const snakeboard_lanes z35 = c1 * z34;
    const snakeboard_lanes z36 = p_f_dot - z24;
    const snakeboard_lanes z37 = z12 * z36;
    const snakeboard_lanes z38 = s1 * z34;
    const snakeboard_lanes z39 = z11 * z36;
    const snakeboard_lanes z40 = v * (z33 * z13 - z7 * (z11 * z35 - s1 * z37 + (z12 * z38 - c1 * z39)));
    const snakeboard_lanes z41 = J_r * z40;
    const snakeboard_lanes z42 = tau * s2 - z41;
    const snakeboard_lanes c2 = cosine4;
    const snakeboard_lanes z43 = sigma * c2;
    const snakeboard_lanes z44 = J_w * z40;
    const snakeboard_lanes z45 = z43 - z44;
    const snakeboard_lanes z46 = z43 + z44;
    const snakeboard_lanes z47 = l * z31;
    const snakeboard_lanes z48 = l * z30;
    const snakeboard_lanes z49 = m * v;
    const snakeboard_lanes z50 = (z33 * z18 + z7 * (s1 * z47 - z16 * z35 + (z48 * z12 - z17 * z39))) * (z19 *
        z49);
    const snakeboard_lanes z51 = (z33 * z20 + z7 * (c1 * z47 + z16 * z38 + (z48 * z11 + z17 * z37))) * (z21 *
        z49);
    const snakeboard_lanes z52 = (z14 * (z42 + (z41 + (z45 + (z44 - (z46 - k7 * z40))))) + z50 + z51) / z22;
    const snakeboard_lanes z53 = z14 * z52;
    /* (I.2.15) */
    const snakeboard_lanes slope1 = z20 * z23;
    sum += slope1;
    snakeboard_put(dydt, slope1);
    const snakeboard_lanes slope2 = z18 * z23;
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
    const snakeboard_lanes slope7 = z52;
    snakeboard_put(dydt + 6 * stride, slope7);
    const snakeboard_lanes slope8 = z53 + k5 * z42;
    sum += slope8;
    snakeboard_put(dydt + 7 * stride, slope8);
    const snakeboard_lanes slope9 = z53 + k6 * z45;
    sum += slope9;
    snakeboard_put(dydt + 8 * stride, slope9);
    const snakeboard_lanes slope10 = z53 - k6 * z46;
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

int snakeboard_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
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
    const double k5 = 1.0 / J_r;
    const double k6 = 1.0 / J_w;
    const double k7 = J + J_w;
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
