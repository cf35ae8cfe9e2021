/*
 * snakeboard.c: snakeboard, emitted by nhc 0.1.0 (nhc:6dc586bac0569614)
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
    const double z7 = theta + p_b;
    const double z8 = theta + p_f;
    const double z21 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z7);
    const double c2 = cos(z7);
    const double c1 = cos(z8);
    const double s2 = sin(z8);
    const double s3 = sin(z21);
    const double c3 = cos(z21);
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
    const double z9 = s1 * c1 - c2 * s2;
    const double z10 = 1.0 / z6;
    const double z11 = z9 * z10;
    const double z12 = J * z11 * z11;
    const double z13 = l * c_p_f;
    const double z14 = l * c_p_b;
    const double z15 = s1 * z13 + z14 * s2;
    const double z16 = z15 * z10;
    const double z17 = c2 * z13 + z14 * c1;
    const double z18 = z17 * z10;
    const double z19 = z12 + m * (z10 * (z15 * z16 + z17 * z18));
    const double z20 = v * z11;
    const double z22 = p_b_dot * c_p_b;
    const double z23 = p_f_dot * c_p_f;
    const double z24 = s_p_f * z23;
    const double z25 = k1 * z24;
    const double z26 = p_b_dot * s_p_b;
    const double z27 = p_f_dot * s_p_f;
    const double z28 = z3 * z22 - 4.0 * (s_p_b * (z24 - z25)) - 2.0 * (k2 * (z4 * z23 - s_p_f * (c_p_f * z26
        + c_p_b * z27)));
    const double z29 = (z5 * z22 + s_p_b * z28 + (2.0 * z24 - 6.0 * z25)) / (z6 * z6);
    const double z30 = p_b_dot - z20;
    const double z31 = c2 * z30;
    const double z32 = p_f_dot - z20;
    const double z33 = s2 * z32;
    const double z34 = s1 * z30;
    const double z35 = c1 * z32;
    const double z36 = v * (z9 * z29 - z10 * (c1 * z31 - s1 * z33 + (s2 * z34 - c2 * z35)));
    const double z37 = J_r * z36;
    const double z38 = tau * s3 - z37;
    const double z39 = sigma * c3;
    const double z40 = J_w * z36;
    const double z41 = z39 - z40;
    const double z42 = z39 + z40;
    const double z43 = l * z27;
    const double z44 = l * z26;
    const double z45 = m * v;
    const double z46 = (z15 * z29 + z10 * (s1 * z43 - z13 * z31 + (s2 * z44 - z14 * z35))) * (z16 * z45);
    const double z47 = (z17 * z29 + z10 * (c2 * z43 + z13 * z34 + (c1 * z44 + z14 * z33))) * (z18 * z45);
    const double z48 = (z11 * (z38 + (z37 + (z41 + (z40 - (z42 - k7 * z36))))) + z46 + z47) / z19;
    const double z49 = z11 * z48;
    /* (I.2.15) */
    dydt[0] = v * z18; /* x' */
    dydt[1] = v * z16; /* y' */
    dydt[2] = -z20; /* theta' */
    dydt[3] = psi_dot; /* psi' */
    dydt[4] = p_b_dot; /* p_b' */
    dydt[5] = p_f_dot; /* p_f' */
    /* (I.2.15) 22:4 */
    dydt[6] = z48; /* v' */
    dydt[7] = z49 + k5 * z38; /* psi'' */
    dydt[8] = z49 + k6 * z41; /* p_b'' */
    dydt[9] = z49 - k6 * z42; /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[7] + dydt[8] + dydt[9]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z19) > 1e-14 * (z12 + m * (z16 * z16) + m * (z18 * z18)))) {
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
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
        if (!(fabs(z19) > 1e-14 * (z12 + m * (z16 * z16) + m * (z18 * z18)))) {
            return SNAKEBOARD_SINGULAR_2;
        }
        return SNAKEBOARD_NOT_FINITE;
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
    const double z8 = theta + p_f;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z5);
    const double s1 = sin(z5);
    const double c2 = cos(z8);
    const double s2 = sin(z8);
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
    const double z9 = v / z4;
    /* (I.2.4) */
    qdot[0] = (c1 * z6 + z7 * c2) * z9; /* x' */
    qdot[1] = (s1 * z6 + z7 * s2) * z9; /* y' */
    qdot[2] = -(s1 * c2 - c1 * s2) * z9; /* theta' */
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
        return SNAKEBOARD_NOT_FINITE;
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
    const double z7 = theta + p_b;
    const double z8 = theta + p_f;
    const double z38 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z7);
    const double c2 = cos(z7);
    const double c1 = cos(z8);
    const double s2 = sin(z8);
    const double s3 = sin(z38);
    const double c3 = cos(z38);
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
    const double z9 = s1 * c1 - c2 * s2;
    const double z10 = 1.0 / z6;
    const double z11 = z9 * z10;
    const double z12 = J * z11 * z11;
    const double z13 = l * c_p_f;
    const double z14 = l * c_p_b;
    const double z15 = s1 * z13 + z14 * s2;
    const double z16 = z15 * z10;
    const double z17 = c2 * z13 + z14 * c1;
    const double z18 = z17 * z10;
    const double z19 = z12 + m * (z10 * (z15 * z16 + z17 * z18));
    const double z20 = p_b_dot * c_p_b;
    const double z21 = p_f_dot * c_p_f;
    const double z22 = s_p_f * z21;
    const double z23 = k1 * z22;
    const double z24 = p_b_dot * s_p_b;
    const double z25 = p_f_dot * s_p_f;
    const double z26 = z3 * z20 - 4.0 * (s_p_b * (z22 - z23)) - 2.0 * (k2 * (z4 * z21 - s_p_f * (c_p_f * z24
        + c_p_b * z25)));
    const double z27 = (z5 * z20 + s_p_b * z26 + (2.0 * z22 - 6.0 * z23)) / (z6 * z6);
    const double z28 = z17 * z27;
    const double z29 = z9 * v;
    const double z30 = z10 * z29;
    const double z31 = p_b_dot - z30;
    const double z32 = s1 * z31;
    const double z33 = l * z25;
    const double z34 = l * z24;
    const double z35 = p_f_dot - z30;
    const double z36 = s2 * z35;
    const double z37 = z13 * z32 + c2 * z33 + (c1 * z34 + z14 * z36);
    const double z39 = c2 * z31;
    const double z40 = c1 * z35;
    const double z41 = c1 * z39 - s1 * z36 + (s2 * z32 - c2 * z40);
    const double z42 = v * (z10 * z41 - z9 * z27);
    const double z43 = J_r * z42;
    const double z44 = tau * s3 + z43;
    const double z45 = sigma * c3;
    const double z46 = J_w * z42;
    const double z47 = z45 + z46;
    const double z48 = z45 - z46;
    const double z49 = z13 * z39 - s1 * z33 - (s2 * z34 - z14 * z40);
    const double z50 = z15 * z27;
    const double z51 = m * v;
    const double z52 = z11 * (z44 - (z43 - (z47 - (z46 + (z48 + z42 * k7))))) - (z10 * z49 - z50) * (z16 *
        z51);
    const double z53 = (z52 + (z10 * z37 + z28) * (z18 * z51)) / z19;
    const double z54 = z11 * z53;
    /* (I.2.15) */
    qddot[0] = -(v * z28 + z10 * (v * z37 - z17 * z53)); /* x'' */
    qddot[1] = z10 * (v * z49 + z15 * z53) - v * z50; /* y'' */
    qddot[2] = z29 * z27 - z10 * (v * z41 + z9 * z53); /* theta'' */
    qddot[3] = k5 * z44 + z54; /* psi'' */
    qddot[4] = k6 * z47 + z54; /* p_b'' */
    qddot[5] = z54 - k6 * z48; /* p_f'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z19) > 1e-14 * (z12 + m * (z16 * z16) + m * (z18 * z18)))) {
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
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
        if (!(fabs(z19) > 1e-14 * (z12 + m * (z16 * z16) + m * (z18 * z18)))) {
            return SNAKEBOARD_SINGULAR_2;
        }
        return SNAKEBOARD_NOT_FINITE;
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
    const double z2 = theta + p_f;
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double c2 = cos(z2);
    const double s2 = sin(z2);
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
    const double z3 = x_dot * (l * (c1 * c_p_f + c_p_b * c2)) + y_dot * (l * (s1 * c_p_f + c_p_b * s2));
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = psi;
    y[4] = p_b;
    y[5] = p_f;
    y[6] = theta_dot * (c_p_b * s_p_f - c_p_f * s_p_b) + z3;
    y[7] = psi_dot;
    y[8] = p_b_dot;
    y[9] = p_f_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[6] + y[7] + y[8] + y[9]) <= DBL_MAX)) {
        return SNAKEBOARD_NOT_FINITE;
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
        return SNAKEBOARD_NOT_FINITE;
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
    const double z7 = theta + p_b;
    const double z8 = theta + p_f;
    const double z55 = t * nu;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z7);
    const double c2 = cos(z7);
    const double c1 = cos(z8);
    const double s2 = sin(z8);
    const double c3 = cos(z55);
    const double s3 = sin(z55);
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
    const double z9 = s1 * c1 - c2 * s2;
    const double z10 = 1.0 / z6;
    const double z11 = z9 * z10;
    const double z12 = J * z11 * z11;
    const double z13 = l * c_p_f;
    const double z14 = l * c_p_b;
    const double z15 = s1 * z13 + z14 * s2;
    const double z16 = z15 * z10;
    const double z17 = c2 * z13 + z14 * c1;
    const double z18 = z17 * z10;
    const double z19 = z12 + m * (z10 * (z15 * z16 + z17 * z18));
    const double z20 = l * (s1 * c_p_f + c_p_b * s2);
    const double z21 = c_p_b * s_p_f - c_p_f * s_p_b;
    const double z22 = z10 * (z13 * z20 - c1 * z21);
    const double z23 = p_b_dot * c_p_b;
    const double z24 = p_f_dot * c_p_f;
    const double z25 = s_p_f * z24;
    const double z26 = k1 * z25;
    const double z27 = p_b_dot * s_p_b;
    const double z28 = p_f_dot * s_p_f;
    const double z29 = z3 * z23 - 4.0 * (s_p_b * (z25 - z26)) - 2.0 * (k2 * (z4 * z24 - s_p_f * (c_p_f * z27
        + c_p_b * z28)));
    const double z30 = (z5 * z23 + s_p_b * z29 + (2.0 * z25 - 6.0 * z26)) / (z6 * z6);
    const double z31 = z17 * z30;
    const double z32 = z9 * v;
    const double z33 = z10 * z32;
    const double z34 = p_b_dot - z33;
    const double z35 = s1 * z34;
    const double z36 = l * z28;
    const double z37 = l * z27;
    const double z38 = p_f_dot - z33;
    const double z39 = s2 * z38;
    const double z40 = z13 * z35 + c2 * z36 + (c1 * z37 + z14 * z39);
    const double z41 = v * z10;
    const double z42 = v * z31 + z40 * z41;
    const double z43 = l * (c2 * c_p_f + c_p_b * c1);
    const double z44 = z10 * (z13 * z43 + s2 * z21);
    const double z45 = z15 * z30;
    const double z46 = c2 * z34;
    const double z47 = c1 * z38;
    const double z48 = z13 * z46 - s1 * z36 - (s2 * z37 - z14 * z47);
    const double z49 = v * z45 - z48 * z41;
    const double z50 = z10 * (c1 * z43 + s2 * z20);
    const double z51 = c1 * z46 - s1 * z39 + (s2 * z35 - c2 * z47);
    const double z52 = z32 * z30 - z51 * z41;
    const double z53 = z50 * z52;
    const double z54 = m * (z22 * z42 - z44 * z49) - J * z53 - J_r * z53 - 2.0 * (J_w * z53);
    const double z56 = sigma * c3;
    const double z57 = v * (z10 * z51 - z9 * z30);
    const double z58 = J_w * z57;
    const double z59 = z56 - z58;
    const double z60 = J_r * z57;
    const double z61 = tau * s3 + z60;
    const double z62 = z56 + z58;
    const double z63 = m * v;
    const double z64 = z11 * (z61 - (z60 - (z62 - (z58 + (z59 + z57 * k7))))) - (z10 * z48 - z45) * (z16 *
        z63);
    const double z65 = (z64 + (z10 * z40 + z31) * (z18 * z63)) / z19;
    const double z66 = z11 * z65;
    const double z67 = k6 * z59 - z66;
    const double z68 = J_w * z50;
    const double z69 = k6 * z62 + z66;
    const double z70 = z11 * z50;
    const double z71 = m * (z18 * z22 - z16 * z44) - J * z70 - J_r * z70 - 2.0 * (J_w * z70);
    const double z72 = J_r * (k5 * z61 + z66);
    const double z73 = z10 * (z14 * z20 + c2 * z21);
    const double z74 = z10 * (z14 * z43 - s1 * z21);
    const double z75 = z10 * (c2 * z43 + s1 * z20);
    const double z76 = z75 * z52;
    const double z77 = m * (z73 * z42 - z74 * z49) + J * z76 + J_r * z76 + 2.0 * (J_w * z76);
    const double z78 = J_w * z75;
    const double z79 = z11 * z75;
    const double z80 = m * (z18 * z73 - z16 * z74) + J * z79 + J_r * z79 + 2.0 * (J_w * z79);
    /* (I.4.1) 28:5 */
    /* reaction of back: Q_i gains lambda_1 a_1i */
    lambda[0] = z54 + (z67 * z68 - (z69 * z68 + (z65 * z71 + z50 * z72)));
    /* (I.4.1) 29:5 */
    /* reaction of front: Q_i gains lambda_2 a_2i */
    lambda[1] = z77 - (z67 * z78 - (z69 * z78 - (z65 * z80 - z75 * z72)));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX
        && fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(z19) > 1e-14 * (z12 + m * (z16 * z16) + m * (z18 * z18)))) {
        /* the coframe is singular */
        if (!(fabs(z6) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
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
        if (!(fabs(z19) > 1e-14 * (z12 + m * (z16 * z16) + m * (z18 * z18)))) {
            return SNAKEBOARD_SINGULAR_2;
        }
        return SNAKEBOARD_NOT_FINITE;
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
    const double z4 = theta + p_f;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double c_p_f = cos(p_f);
    const double s_p_f = sin(p_f);
    const double c_p_b = cos(p_b);
    const double s_p_b = sin(p_b);
    const double c2 = cos(z4);
    const double s2 = sin(z4);
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
    const double z5 = s_p_f * s_p_f;
    const double z6 = 2.0 * z5;
    const double z7 = s_p_b * (s_p_b * (1.0 - z6 - k1 * (3.0 - z6)) - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2));
    const double z8 = v / (z7 + (z5 + k1 * (4.0 - 3.0 * z5)));
    const double z9 = (c1 * z2 + z3 * c2) * z8;
    const double z10 = (s1 * z2 + z3 * s2) * z8;
    const double z11 = (s1 * c2 - c1 * s2) * z8;
    const double z12 = psi_dot - z11;
    const double z13 = p_b_dot - z11;
    const double z14 = p_f_dot - z11;
    const double z15 = m * (z9 * z9 + z10 * z10) + J * (z11 * z11) + J_r * (z12 * z12) + J_w * (z13 * z13 +
        z14 * z14);
    return 0.5 * z15;
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
    const double z10 = theta + p_f;
    const double z58 = t * nu;
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s1 = sin(z9);
    const double c2 = cos(z9);
    const double c1 = cos(z10);
    const double s2 = sin(z10);
    const double s3 = sin(z58);
    const double c3 = cos(z58);
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
    const double z11 = s1 * c1 - c2 * s2;
    const double z12 = z11 * z8;
    const double z13 = z11 * z12;
    const double z14 = l * c_p_f;
    const double z15 = s1 * z14;
    const double z16 = l * c_p_b;
    const double z17 = z16 * s2;
    const double z18 = z15 + z17;
    const double z19 = z18 * z8;
    const double z20 = c2 * z14;
    const double z21 = z16 * c1;
    const double z22 = z20 + z21;
    const double z23 = z22 * z8;
    const double z24 = z18 * z19 + z22 * z23;
    const double z25 = J_2 * (z8 * z13) + m * (z8 * z24);
    const double z26 = z18 * v;
    const double z27 = z22 * v;
    const double z28 = 1.0 / (z7 * z7);
    const double z29 = c_p_f * s_p_b;
    const double z30 = c_p_b * z3 + 2.0 * (z29 * z5);
    const double z31 = c_p_b * z6 + s_p_b * z30;
    const double z32 = z28 * z31;
    const double z33 = l * s_p_b;
    const double z34 = z15 + c1 * z33;
    const double z35 = v * z8;
    const double z36 = c_p_f * s_p_f;
    const double z37 = k1 * z36;
    const double z38 = z36 - z37;
    const double z39 = c_p_b * s_p_f;
    const double z40 = 4.0 * (s_p_b * z38) + 2.0 * (k2 * (c_p_f * z4 - s_p_f * z39));
    const double z41 = s_p_b * z40 - (2.0 * z36 - 6.0 * z37);
    const double z42 = z41 * z28;
    const double z43 = l * s_p_f;
    const double z44 = z17 + c2 * z43;
    const double z45 = z20 - s2 * z33;
    const double z46 = z21 - s1 * z43;
    const double z47 = z11 * v;
    const double z48 = s1 * s2 + c2 * c1;
    const double z49 = z48 * z35;
    const double z50 = z47 * z32 - z49;
    const double z51 = z49 - z47 * z42;
    const double z52 = z48 * z12;
    const double z53 = z48 * z8;
    const double z54 = z53 - z11 * z32;
    const double z55 = z45 * z8 - z18 * z32;
    const double z56 = z34 * z8 + z22 * z32;
    const double z57 = m * (z24 * z32 - z8 * (z45 * z19 + z18 * z55 - (z34 * z23 + z22 * z56)));
    const double z59 = z47 * z8;
    const double z60 = p_b_dot - z59;
    const double z61 = c2 * z60;
    const double z62 = p_f_dot - z59;
    const double z63 = s2 * z62;
    const double z64 = s1 * z60;
    const double z65 = c1 * z62;
    const double z66 = c1 * z61 - s1 * z63 + (s2 * z64 - c2 * z65);
    const double z67 = p_f_dot * c_p_f;
    const double z68 = s_p_f * z67;
    const double z69 = k1 * z68;
    const double z70 = p_b_dot * c_p_b;
    const double z71 = z68 - z69;
    const double z72 = p_b_dot * s_p_b;
    const double z73 = p_f_dot * s_p_f;
    const double z74 = c_p_f * z72 + c_p_b * z73;
    const double z75 = z3 * z70 - 4.0 * (s_p_b * z71) - 2.0 * (k2 * (z4 * z67 - s_p_f * z74));
    const double z76 = 2.0 * z68 - 6.0 * z69 + (s_p_b * z75 + z70 * z6);
    const double z77 = z28 * z76;
    const double z78 = z8 * z66 - z11 * z77;
    const double z79 = v * z78;
    const double z80 = J_r * z79;
    const double z81 = sigma * c3;
    const double z82 = J_w * z79;
    const double z83 = tau * s3 + z80 - (z80 - (z81 + z82 - (z82 + (z81 - z82 + k5 * z79))));
    const double z84 = m * v;
    const double z85 = l * z73;
    const double z86 = s1 * z85;
    const double z87 = l * z72;
    const double z88 = s2 * z87;
    const double z89 = z86 - z14 * z61 + (z88 - z16 * z65);
    const double z90 = z8 * z89 + z18 * z77;
    const double z91 = z84 * z90;
    const double z92 = c2 * z85;
    const double z93 = c1 * z87;
    const double z94 = z92 + z14 * z64 + (z93 + z16 * z63);
    const double z95 = z8 * z94 + z22 * z77;
    const double z96 = z84 * z95;
    const double z97 = z12 * z83 + z19 * z91 + z23 * z96;
    const double z98 = z97 / (z25 * z25);
    const double z99 = 1.0 / z25;
    const double z100 = z64 - c2 * z50;
    const double z101 = s2 * z50;
    const double z102 = z61 + s1 * z50;
    const double z103 = c1 * z50;
    const double z104 = c1 * z100 + (c2 * z63 + s1 * z101) - (s2 * z102 + (s1 * z65 - c2 * z103));
    const double z105 = z48 * z77;
    const double z106 = z76 / (z7 * z7 * z7);
    const double z107 = z3 * z72 + 4.0 * (c_p_b * z71) - 2.0 * (k2 * (z29 * z67 - s_p_f * (s_p_b * z73 -
        c_p_f * z70)));
    const double z108 = 2.0 * (z31 * z106) - z28 * (c_p_b * z75 - s_p_b * z107 + (z70 * z30 - z72 * z6));
    const double z109 = v * (z66 * z32 + z8 * z104 + (z105 - z11 * z108));
    const double z110 = J_2 * z12;
    const double z111 = l * z70;
    const double z112 = z89 * z32 - z8 * (z92 + z14 * z100 + (s2 * z111 + (z33 * z65 - z16 * z103)));
    const double z113 = z84 * z19;
    const double z114 = z83 * z54 + z109 * z110 + (z91 * z55 - (z112 - (z45 * z77 - z18 * z108)) * z113);
    const double z115 = z94 * z32 + z8 * (z86 - z14 * z102 - (c1 * z111 - (z33 * z63 - z16 * z101)));
    const double z116 = z84 * z23;
    const double z117 = (J_2 * (z13 * z32 - z8 * (z52 + z11 * z54)) + z57) * z98 + z99 * (z114 - (z96 * z56 +
        (z115 + (z34 * z77 + z22 * z108)) * z116));
    const double z118 = z53 - z11 * z42;
    const double z119 = z46 * z8 + z18 * z42;
    const double z120 = z44 * z8 - z22 * z42;
    const double z121 = m * (z24 * z42 + z8 * (z46 * z19 + z18 * z119 - (z44 * z23 + z22 * z120)));
    const double z122 = c2 * z51;
    const double z123 = z65 + s2 * z51;
    const double z124 = s1 * z51;
    const double z125 = z63 - c1 * z51;
    const double z126 = s2 * z61 - c1 * z122 + s1 * z123 - (c1 * z64 + s2 * z124 + c2 * z125);
    const double z127 = c_p_f * z67 - s_p_f * z73;
    const double z128 = k1 * z127;
    const double z129 = k2 * (z39 * z67 + z4 * z73 + (c_p_f * z74 - s_p_f * (s_p_f * z72 - c_p_b * z67)));
    const double z130 = z70 * z40 + s_p_b * (4.0 * (z70 * z38 + s_p_b * (z127 - z128)) - 2.0 * z129) - (2.0 *
        z127 - 6.0 * z128);
    const double z131 = 2.0 * (z41 * z106) - z130 * z28;
    const double z132 = v * (z66 * z42 - z8 * z126 + (z105 - z11 * z131));
    const double z133 = l * z67;
    const double z134 = z89 * z42 + z8 * (s1 * z133 + (z43 * z61 - z14 * z122) + (z93 + z16 * z125));
    const double z135 = z83 * z118 + z110 * z132 - (z91 * z119 + z113 * (z134 + (z46 * z77 + z18 * z131)));
    const double z136 = z94 * z42 + z8 * (c2 * z133 - (z43 * z64 - z14 * z124) - (z88 - z16 * z123));
    const double z137 = z98 * (J_2 * (z13 * z42 - z8 * (z52 + z11 * z118)) + z121) + z99 * (z135 + (z96 *
        z120 - z116 * (z136 - (z44 * z77 - z22 * z131))));
    const double z138 = c2 * z12;
    const double z139 = s2 * z12;
    const double z140 = s1 * z12;
    const double z141 = c1 * z12;
    const double z142 = z78 - z35 * (c1 * z138 - s1 * z139 + (s2 * z140 - c2 * z141));
    const double z143 = z110 * z142 - m * (z19 * (z90 + z35 * (z14 * z138 + z16 * z141))) - m * (z23 * (z95 -
        z35 * (z14 * z140 + z16 * z139)));
    const double z144 = z99 * z143;
    const double z145 = v * z54;
    const double z146 = z99 * (z110 * z145 + z55 * z113 - z56 * z116);
    const double z147 = v * z118;
    const double z148 = z99 * (z110 * z147 - z113 * z119 + z116 * z120);
    const double z149 = z99 * z97;
    const double z150 = z109 - (z149 * z54 + z12 * z117);
    const double z151 = z132 - (z149 * z118 + z12 * z137);
    const double z152 = z142 - z12 * z144;
    const double z153 = z145 - z12 * z146;
    const double z154 = z147 - z12 * z148;
    /* (I.2.15) */
    J[2] = -z26 * z8;
    J[4] = -(z27 * z32 + z34 * z35);
    J[5] = z27 * z42 - z44 * z35;
    J[6] = z23;
    J[12] = z27 * z8;
    J[14] = z45 * z35 - z26 * z32;
    J[15] = z26 * z42 + z46 * z35;
    J[16] = z19;
    J[24] = z50;
    J[25] = z51;
    J[26] = -z12;
    J[37] = 1.0;
    J[48] = 1.0;
    J[59] = 1.0;
    J[64] = z117;
    J[65] = -z137;
    J[66] = -z144;
    J[68] = -z146;
    J[69] = z148;
    J[74] = -z150;
    J[75] = z151;
    J[76] = z152;
    J[78] = z153;
    J[79] = -z154;
    J[84] = -z150;
    J[85] = z151;
    J[86] = z152;
    J[88] = z153;
    J[89] = -z154;
    J[94] = -z150;
    J[95] = z151;
    J[96] = z152;
    J[98] = z153;
    J[99] = -z154;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[4] + J[5] + J[12] + J[14] + J[15] + J[65] + J[66] + J[68] + J[75] + J[76] + J[78] +
        J[94] + J[99]) <= DBL_MAX
        && fabs(z7) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4))
        && fabs(J_w) > 0.0
        && fabs(J_w) > 0.0
        && fabs(J_r) > 0.0
        && fabs(z25) > 1e-14 * (J_2 * (z12 * z12) + m * (z19 * z19) + m * (z23 * z23)))) {
        /* the coframe is singular */
        if (!(fabs(z7) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(J_w) > 0.0)) {
            return SNAKEBOARD_SINGULAR_2;
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
        if (!(fabs(z25) > 1e-14 * (J_2 * (z12 * z12) + m * (z19 * z19) + m * (z23 * z23)))) {
            return SNAKEBOARD_SINGULAR_2;
        }
        return SNAKEBOARD_NOT_FINITE;
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
    const double z5 = theta + p_f;
    const double z6 = theta + p_b;
    const double s_p_b = sin(p_b);
    const double c_p_b = cos(p_b);
    const double s_p_f = sin(p_f);
    const double c_p_f = cos(p_f);
    const double s1 = sin(z5);
    const double c1 = cos(z5);
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s2 = sin(z6);
    const double c2 = cos(z6);
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
    const double z7 = v / z4 * (c_p_b * (s1 * s_theta + c1 * c_theta) + c_p_f * (s2 * s_theta + c2 *
        c_theta));
    /* 32:10 */
    out[0] = l * z7; /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
        /* the coframe is singular */
        if (!(fabs(z4) > 1e-12 * (k4 * ((2.0 + 4.0 * k3) * k4)))) {
            return SNAKEBOARD_SINGULAR_1;
        }
        return SNAKEBOARD_NOT_FINITE;
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
    const snakeboard_lanes z7 = theta + p_b;
    snakeboard_lanes sine3, cosine3;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z7), &far, &sine3, &cosine3);
    const snakeboard_lanes s1 = sine3;
    const snakeboard_lanes z8 = theta + p_f;
    snakeboard_lanes sine4, cosine4;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z8), &far, &sine4, &cosine4);
    const snakeboard_lanes c1 = cosine4;
    const snakeboard_lanes c2 = cosine3;
    const snakeboard_lanes s2 = sine4;
    const snakeboard_lanes z9 = s1 * c1 - c2 * s2;
    const snakeboard_lanes z10 = 1.0 / z6;
    const snakeboard_lanes z11 = z9 * z10;
    const snakeboard_lanes z12 = J * z11 * z11;
    const snakeboard_lanes z13 = l * c_p_f;
    const snakeboard_lanes z14 = l * c_p_b;
    const snakeboard_lanes z15 = s1 * z13 + z14 * s2;
    const snakeboard_lanes z16 = z15 * z10;
    const snakeboard_lanes z17 = c2 * z13 + z14 * c1;
    const snakeboard_lanes z18 = z17 * z10;
    const snakeboard_lanes z19 = z12 + m * (z10 * (z15 * z16 + z17 * z18));
    /* the mass matrix is singular */
    bad |= snakeboard_misses(snakeboard_size(SNAKEBOARD_SPREAD(z19)), 1e-14 * (z12 + m * (z16 * z16) + m *
        (z18 * z18)));
    const snakeboard_lanes z20 = v * z11;
    const snakeboard_lanes z21 = t_ * nu;
    snakeboard_lanes sine5, cosine5;
    snakeboard_turn_lanes(SNAKEBOARD_SPREAD(z21), &far, &sine5, &cosine5);
    const snakeboard_lanes s3 = sine5;
    const snakeboard_lanes z22 = p_b_dot * c_p_b;
    const snakeboard_lanes z23 = p_f_dot * c_p_f;
    const snakeboard_lanes z24 = s_p_f * z23;
    const snakeboard_lanes z25 = k1 * z24;
    const snakeboard_lanes z26 = p_b_dot * s_p_b;
    const snakeboard_lanes z27 = p_f_dot * s_p_f;
    const snakeboard_lanes z28 = z3 * z22 - 4.0 * (s_p_b * (z24 - z25)) - 2.0 * (k2 * (z4 * z23 - s_p_f *
        (c_p_f * z26 + c_p_b * z27)));
    const snakeboard_lanes z29 = (z5 * z22 + s_p_b * z28 + (2.0 * z24 - 6.0 * z25)) / (z6 * z6);
    const snakeboard_lanes z30 = p_b_dot - z20;
    const snakeboard_lanes z31 = c2 * z30;
    const snakeboard_lanes z32 = p_f_dot - z20;
    const snakeboard_lanes z33 = s2 * z32;
    const snakeboard_lanes z34 = s1 * z30;
    const snakeboard_lanes z35 = c1 * z32;
    const snakeboard_lanes z36 = v * (z9 * z29 - z10 * (c1 * z31 - s1 * z33 + (s2 * z34 - c2 * z35)));
    const snakeboard_lanes z37 = J_r * z36;
    const snakeboard_lanes z38 = tau * s3 - z37;
    const snakeboard_lanes c3 = cosine5;
    const snakeboard_lanes z39 = sigma * c3;
    const snakeboard_lanes z40 = J_w * z36;
    const snakeboard_lanes z41 = z39 - z40;
    const snakeboard_lanes z42 = z39 + z40;
    const snakeboard_lanes z43 = l * z27;
    const snakeboard_lanes z44 = l * z26;
    const snakeboard_lanes z45 = m * v;
    const snakeboard_lanes z46 = (z15 * z29 + z10 * (s1 * z43 - z13 * z31 + (s2 * z44 - z14 * z35))) * (z16 *
        z45);
    const snakeboard_lanes z47 = (z17 * z29 + z10 * (c2 * z43 + z13 * z34 + (c1 * z44 + z14 * z33))) * (z18 *
        z45);
    const snakeboard_lanes z48 = (z11 * (z38 + (z37 + (z41 + (z40 - (z42 - k7 * z36))))) + z46 + z47) / z19;
    const snakeboard_lanes z49 = z11 * z48;
    /* (I.2.15) */
    const snakeboard_lanes slope1 = v * z18;
    sum += slope1;
    snakeboard_put(dydt, slope1);
    const snakeboard_lanes slope2 = v * z16;
    sum += slope2;
    snakeboard_put(dydt + 1 * stride, slope2);
    const snakeboard_lanes slope3 = -z20;
    snakeboard_put(dydt + 2 * stride, slope3);
    const snakeboard_lanes slope4 = psi_dot;
    sum += slope4;
    snakeboard_put(dydt + 3 * stride, slope4);
    const snakeboard_lanes slope5 = p_b_dot;
    snakeboard_put(dydt + 4 * stride, slope5);
    const snakeboard_lanes slope6 = p_f_dot;
    snakeboard_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 22:4 */
    const snakeboard_lanes slope7 = z48;
    snakeboard_put(dydt + 6 * stride, slope7);
    const snakeboard_lanes slope8 = z49 + k5 * z38;
    sum += slope8;
    snakeboard_put(dydt + 7 * stride, slope8);
    const snakeboard_lanes slope9 = z49 + k6 * z41;
    sum += slope9;
    snakeboard_put(dydt + 8 * stride, slope9);
    const snakeboard_lanes slope10 = z49 - k6 * z42;
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
