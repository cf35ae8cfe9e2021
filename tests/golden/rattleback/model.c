/*
 * rattleback.c: rattleback, emitted by nhc 0.1.0 (nhc:d0098a2fadf3206b)
 * A loaded ellipsoid that rolls on a plane and prefers one sense of spin (celt, wobblestone).
 * Source: rattleback.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * rattleback.h says what each function does.
 */
#include "rattleback.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const rattleback_coordinate_names[] = {
    "x",
    "y",
    "z",
    "alpha",
    "beta",
    "gamma"
};
const char *const rattleback_state_names[] = {
    "x",
    "y",
    "z",
    "alpha",
    "beta",
    "gamma",
    "w1",
    "w2",
    "w3"
};
const char *const rattleback_parameter_names[] = {
    "a",
    "b",
    "c",
    "h",
    "I_a",
    "I_b",
    "I_c",
    "I_d",
    "g"
};
const double rattleback_parameter_defaults[] = {
    20.0,
    3.0,
    2.0,
    1.0,
    2.0,
    16.0,
    17.0,
    -0.2,
    981.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define RATTLEBACK_SLOW __attribute__((cold, optimize("O1")))
#else
#define RATTLEBACK_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* it is seldom called, and would cost its callers registers */
#endif
static int rattleback_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return RATTLEBACK_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return RATTLEBACK_NOT_FINITE;
        }
    }
    return RATTLEBACK_OK;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef RATTLEBACK_LANES
#if !defined(__GNUC__)
#define RATTLEBACK_LANES 1
#elif defined(__AVX512F__)
#define RATTLEBACK_LANES 8
#elif defined(__AVX__)
#define RATTLEBACK_LANES 4
#else
#define RATTLEBACK_LANES 2
#endif
#endif
#if RATTLEBACK_LANES > 1
typedef double rattleback_lanes __attribute__((vector_size(8 * RATTLEBACK_LANES)));
#else
typedef double rattleback_lanes;
#endif

#if RATTLEBACK_LANES >= 2
static inline rattleback_lanes rattleback_get(const double *from)
{
    rattleback_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void rattleback_put(double *to, rattleback_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int rattleback_one_by_one(size_t count, size_t first, size_t number, const double *t, const double *y, const double *p, double *dydt)
{
    int status = RATTLEBACK_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[RATTLEBACK_NY];
        double slope[RATTLEBACK_NY];
        for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = NAN;
        }
        const int one = rattleback_rhs(t[i], state, p, slope);
        status = status == RATTLEBACK_OK ? one : status;
        for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if RATTLEBACK_LANES >= 2
#define RATTLEBACK_SPREAD(x) ((x) - (rattleback_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long rattleback_bits __attribute__((vector_size(8 * RATTLEBACK_LANES)));

/* all bits where value is not above bound, or is no number */
static inline rattleback_bits rattleback_misses(rattleback_lanes value, rattleback_lanes bound)
{
    return ~(rattleback_bits)(value > bound);
}

/* no number where a bit is set */
static inline rattleback_lanes rattleback_mark(rattleback_lanes value, rattleback_bits bad)
{
    return (rattleback_lanes)((rattleback_bits)value | bad);
}

static inline rattleback_lanes rattleback_size(rattleback_lanes x)
{
    return (rattleback_lanes)((rattleback_bits)x & 0x7fffffffffffffffULL);
}
/* whether none of the states must be asked again: no singular block, no infinity, no angle anywhere near 1e5 */
static inline int rattleback_is_good(int count, const double *check)
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
static inline void rattleback_fill(size_t left, size_t count, const double *t, const double *y, double *time, double *state)
{
    for (size_t l = 0; l < RATTLEBACK_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
            state[k * RATTLEBACK_LANES + l] = y[k * count + i];
        }
    }
}

static inline void rattleback_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * RATTLEBACK_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void rattleback_turn_lanes(rattleback_lanes x, rattleback_lanes *far, rattleback_lanes *sine, rattleback_lanes *cosine)
{
    double angle[RATTLEBACK_LANES];
    double up[RATTLEBACK_LANES];
    double along[RATTLEBACK_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < RATTLEBACK_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}

static inline rattleback_lanes rattleback_each_sqrt(rattleback_lanes a)
{
    double value[RATTLEBACK_LANES];
    memcpy(value, &a, sizeof a);
    for (int l = 0; l < RATTLEBACK_LANES; ++l) {
        value[l] = sqrt(value[l]);
    }
    memcpy(&a, value, sizeof a);
    return a;
}
#endif

int rattleback_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3);
    const double z3 = 1.0 / sqrt(z2);
    const double z4 = mu3 * k3;
    const double r3 = h - z3 * z4;
    const double z5 = r3 * r3;
    const double z6 = mu2 * k2;
    const double z7 = z3 * z6;
    const double z8 = z7 * z7;
    const double z9 = I_a + (z5 + z8);
    const double z10 = z1 * k1;
    const double r1 = z10 * z3;
    const double z11 = r1 * r1;
    const double z12 = I_b + (z5 + z11);
    const double z13 = I_d + r1 * z7;
    const double z14 = 1.0 / z9;
    const double z15 = z13 * z14;
    const double z16 = z12 - z13 * z15;
    const double z17 = I_c + (z8 + z11);
    const double z18 = r1 * r3;
    const double z19 = z18 * z14;
    const double z20 = z7 * r3 + z13 * z19;
    const double z21 = 1.0 / z16;
    const double z22 = z20 * z21;
    const double z23 = z17 - z18 * z19 - z20 * z22;
    const double z24 = s_beta * w1 - c_beta * w3;
    const double z25 = 1.0 / c_alpha;
    const double z26 = z1 * w3 + mu3 * w1;
    const double z27 = z25 * z26;
    const double z28 = s_beta * z24 + c_beta * z27;
    const double z29 = c_beta * z24 - s_beta * z27;
    const double z30 = r3 * z28 + r1 * z29;
    const double u1 = r3 * w2 - z7 * z29;
    const double z31 = r1 * w2 + z7 * z28;
    const double z32 = s_beta * u1 + c_beta * z31;
    const double z33 = c_alpha * z30 - mu2 * z32;
    const double z34 = s_beta * z31 - c_beta * u1;
    const double z35 = z25 * z24;
    const double z36 = w2 + mu2 * z35;
    const double z37 = I_c * z29;
    const double z38 = c_beta * z36;
    const double z39 = s_beta * z36;
    const double z40 = z27 * z39;
    const double z41 = mu2 * z27;
    const double z42 = s_beta * z41 - c_alpha * z38;
    const double z43 = z40 + z35 * z42;
    const double z44 = z27 * z38;
    const double z45 = c_alpha * z39 + c_beta * z41;
    const double z46 = z44 + z35 * z45;
    const double z47 = s_beta * z43 + c_beta * z46 - z35 * z41;
    const double z48 = z25 * (z1 * z46 - mu3 * z43);
    const double z49 = z24 * z38 + s_beta * z47 - (z40 + c_beta * z48);
    const double z50 = I_d * z28 + I_b * w2;
    const double z51 = z27 * z50;
    const double z52 = z24 * z50;
    const double z53 = (z10 * z42 - z6 * z26 + z4 * z45) * (z3 * (z3 * z3));
    const double z54 = z4 * z53 - k3 * (z3 * z45);
    const double z55 = z24 * z39 - c_beta * z47 + (z44 - s_beta * z48);
    const double z56 = k1 * (z3 * z42) - z10 * z53;
    const double z57 = z29 * u1 - z28 * z31 + (r3 * z49 - z28 * z54 - (r1 * z55 + z29 * z56));
    const double z58 = g * mu2 + z57;
    const double z59 = z6 * z53 + k2 * (z3 * z26);
    const double z60 = g * mu3 + (z28 * z30 + w2 * u1 + (z7 * z49 + z28 * z59 - w2 * z56));
    const double z61 = w2 * z37 - (I_a * z49 - (s_beta * z51 - (c_beta * z52 + (r3 * z58 + z7 * z60))));
    const double z62 = I_d * w2 + I_a * z28;
    const double z63 = g * z1 - (w2 * z31 + z29 * z30 - (z7 * z55 - z29 * z59 - w2 * z54));
    const double z64 = I_d * z49 - (z29 * z62 - z28 * z37 - (r3 * z63 + r1 * z60)) + z15 * z61;
    const double z65 = w2 * z62 - (I_c * z55 + (c_beta * z51 + (s_beta * z52 + (z7 * z63 - r1 * z58))));
    const double z66 = (z65 + z19 * z61 + z22 * z64) / z23;
    const double z67 = z21 * z64 + z22 * z66;
    /* (I.2.15) */
    dydt[0] = s_gamma * z33 - c_gamma * z34; /* x' */
    dydt[1] = -(s_gamma * z34 + c_gamma * z33); /* y' */
    dydt[2] = -(mu2 * z30 + c_alpha * z32); /* z' */
    dydt[3] = z27; /* alpha' */
    dydt[4] = z36; /* beta' */
    dydt[5] = -z35; /* gamma' */
    /* (I.2.15) 41:4 */
    dydt[6] = z14 * z61 + z15 * z67 + z19 * z66; /* w1' */
    dydt[7] = -z67; /* w2' */
    dydt[8] = z66; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z16) > 1e-14 * z12
        && fabs(z23) > 1e-14 * z17)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z9) > 0.0)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * z12)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z23) > 1e-14 * z17)) {
            return RATTLEBACK_SINGULAR_2;
        }
        return rattleback_finish(9, dydt);
    }
    return RATTLEBACK_OK;
}

int rattleback_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r3 = h - z2 * (mu3 * k3);
    const double z3 = s_beta * w1 - c_beta * w3;
    const double z4 = 1.0 / c_alpha;
    const double z5 = z4 * (z1 * w3 + mu3 * w1);
    const double z6 = s_beta * z3 + c_beta * z5;
    const double r1 = z1 * k1 * z2;
    const double z7 = c_beta * z3 - s_beta * z5;
    const double z8 = r3 * z6 + r1 * z7;
    const double z9 = z2 * (mu2 * k2);
    const double u1 = r3 * w2 - z9 * z7;
    const double z10 = r1 * w2 + z9 * z6;
    const double z11 = s_beta * u1 + c_beta * z10;
    const double z12 = c_alpha * z8 - mu2 * z11;
    const double z13 = s_beta * z10 - c_beta * u1;
    const double z14 = z4 * z3;
    /* (I.2.4) */
    qdot[0] = s_gamma * z12 - c_gamma * z13; /* x' */
    qdot[1] = -(s_gamma * z13 + c_gamma * z12); /* y' */
    qdot[2] = -(mu2 * z8 + c_alpha * z11); /* z' */
    qdot[3] = z5; /* alpha' */
    qdot[4] = w2 + mu2 * z14; /* beta' */
    qdot[5] = -z14; /* gamma' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[4] + qdot[5]) <= DBL_MAX && fabs(c_alpha) > 1e-12 * 4.0)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        return rattleback_finish(6, qdot);
    }
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW
int rattleback_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3);
    const double z3 = 1.0 / sqrt(z2);
    const double z4 = mu3 * k3;
    const double r3 = h - z3 * z4;
    const double z5 = r3 * r3;
    const double z6 = mu2 * k2;
    const double z7 = z3 * z6;
    const double z8 = z7 * z7;
    const double z9 = I_a + (z5 + z8);
    const double z10 = z1 * k1;
    const double r1 = z10 * z3;
    const double z11 = r1 * r1;
    const double z12 = I_b + (z5 + z11);
    const double z13 = I_d + r1 * z7;
    const double z14 = 1.0 / z9;
    const double z15 = z13 * z14;
    const double z16 = z12 - z13 * z15;
    const double z17 = I_c + (z8 + z11);
    const double z18 = r1 * r3;
    const double z19 = z18 * z14;
    const double z20 = z7 * r3 + z13 * z19;
    const double z21 = 1.0 / z16;
    const double z22 = z20 * z21;
    const double z23 = z17 - z18 * z19 - z20 * z22;
    const double z24 = s_beta * w1 - c_beta * w3;
    const double z25 = 1.0 / c_alpha;
    const double z26 = z1 * w3 + mu3 * w1;
    const double z27 = z25 * z26;
    const double z28 = s_beta * z24 + c_beta * z27;
    const double z29 = c_beta * z24 - s_beta * z27;
    const double z30 = r3 * z28 + r1 * z29;
    const double u1 = r3 * w2 - z7 * z29;
    const double z31 = r1 * w2 + z7 * z28;
    const double z32 = s_beta * u1 + c_beta * z31;
    const double z33 = c_alpha * z30 - mu2 * z32;
    const double z34 = z25 * z24;
    const double z35 = c_gamma * z34;
    const double z36 = mu2 * z27;
    const double z37 = w2 + mu2 * z34;
    const double z38 = c_beta * z37;
    const double z39 = s_beta * z36 - c_alpha * z38;
    const double z40 = s_beta * z37;
    const double z41 = c_alpha * z40 + c_beta * z36;
    const double z42 = (z10 * z39 - z6 * z26 + z4 * z41) * (z3 * (z3 * z3));
    const double z43 = z4 * z42 - k3 * (z3 * z41);
    const double z44 = z28 * z43;
    const double z45 = z24 * z38;
    const double z46 = I_c * z29;
    const double z47 = z27 * z40;
    const double z48 = z47 + z34 * z39;
    const double z49 = z27 * z38;
    const double z50 = z49 + z34 * z41;
    const double z51 = s_beta * z48 + c_beta * z50 - z34 * z36;
    const double z52 = z25 * (z1 * z50 - mu3 * z48);
    const double z53 = z45 + s_beta * z51 - (z47 + c_beta * z52);
    const double z54 = I_d * z28 + I_b * w2;
    const double z55 = z27 * z54;
    const double z56 = z24 * z54;
    const double z57 = z24 * z40;
    const double z58 = z57 - c_beta * z51 + (z49 - s_beta * z52);
    const double z59 = k1 * (z3 * z39) - z10 * z42;
    const double z60 = z29 * z59;
    const double z61 = g * mu2 + (z29 * u1 - z28 * z31 + (r3 * z53 - z44 - (r1 * z58 + z60)));
    const double z62 = z6 * z42 + k2 * (z3 * z26);
    const double z63 = z28 * z62;
    const double z64 = w2 * z59;
    const double z65 = g * mu3 + (z28 * z30 + w2 * u1 + (z7 * z53 + z63 - z64));
    const double z66 = w2 * z46 - (I_a * z53 - (s_beta * z55 - (c_beta * z56 + (r3 * z61 + z7 * z65))));
    const double z67 = I_d * w2 + I_a * z28;
    const double z68 = z29 * z62;
    const double z69 = w2 * z43;
    const double z70 = g * z1 - (w2 * z31 + z29 * z30 - (z7 * z58 - z68 - z69));
    const double z71 = I_d * z53 - (z29 * z67 - z28 * z46 - (r3 * z70 + r1 * z65)) + z15 * z66;
    const double z72 = w2 * z67 - (I_c * z58 + (c_beta * z55 + (s_beta * z56 + (z7 * z70 - r1 * z61))));
    const double z73 = (z72 + z19 * z66 + z22 * z71) / z23;
    const double z74 = z21 * z71 + z22 * z73;
    const double z75 = z14 * z66 + z15 * z74 + z19 * z73;
    const double z76 = w1 * z38 + s_beta * z75 + (w3 * z40 - c_beta * z73);
    const double z77 = z36 / (c_alpha * c_alpha);
    const double z78 = z26 * z77 - z25 * (w3 * z39 - z1 * z73 + (w1 * z41 - mu3 * z75));
    const double z79 = z45 + s_beta * z76 - (z47 - c_beta * z78);
    const double z80 = z57 - c_beta * z76 + (z49 + s_beta * z78);
    const double z81 = z44 - r3 * z79 + (z60 + r1 * z80);
    const double z82 = z69 + r3 * z74 + (z68 - z7 * z80);
    const double z83 = z64 + r1 * z74 - (z63 + z7 * z79);
    const double z84 = u1 * z38 - s_beta * z82 - (z31 * z40 + c_beta * z83);
    const double z85 = z30 * z36 + c_alpha * z81 + (z26 * z32 + mu2 * z84);
    const double z86 = s_beta * z31 - c_beta * u1;
    const double z87 = s_gamma * z34;
    const double z88 = z31 * z38 - s_beta * z83 + (u1 * z40 + c_beta * z82);
    const double z89 = z24 * z77 + z25 * z76;
    /* (I.2.15) */
    qddot[0] = -(z33 * z35 + s_gamma * z85 + (z86 * z87 + c_gamma * z88)); /* x'' */
    qddot[1] = z86 * z35 - s_gamma * z88 - (z33 * z87 - c_gamma * z85); /* y'' */
    qddot[2] = z32 * z36 - c_alpha * z84 - (z26 * z30 - mu2 * z81); /* z'' */
    qddot[3] = z78; /* alpha'' */
    qddot[4] = z26 * z34 + mu2 * z89 - z74; /* beta'' */
    qddot[5] = -z89; /* gamma'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z16) > 1e-14 * z12
        && fabs(z23) > 1e-14 * z17)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z9) > 0.0)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * z12)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z23) > 1e-14 * z17)) {
            return RATTLEBACK_SINGULAR_2;
        }
        return rattleback_finish(6, qddot);
    }
    return RATTLEBACK_OK;
}

int rattleback_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double alpha = q[3]; /* roll about the long axis [rad] */
    const double beta = q[4]; /* pitch [rad] */

    /* sines and cosines */
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double x = q[0]; /* centre of mass [cm] */
    const double y_2 = q[1]; /* centre of mass [cm] */
    const double z = q[2]; /* centre of mass, downwards [cm] */
    const double gamma_ = q[5]; /* heading [rad] */
    const double alpha_dot = qdot[3];
    const double beta_dot = qdot[4];
    const double gamma_dot = qdot[5];

    /* state */
    const double z1 = gamma_dot * c_alpha;
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = alpha;
    y[4] = beta;
    y[5] = gamma_;
    y[6] = alpha_dot * c_beta - s_beta * z1;
    y[7] = beta_dot + gamma_dot * mu2;
    y[8] = alpha_dot * s_beta + c_beta * z1;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[5] + y[6] + y[7] + y[8]) <= DBL_MAX)) {
        return rattleback_finish(9, y);
    }
    return RATTLEBACK_OK;
}

int rattleback_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double alpha = q[3]; /* roll about the long axis [rad] */
    const double beta = q[4]; /* pitch [rad] */
    const double gamma_ = q[5]; /* heading [rad] */

    /* sines and cosines */
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
    const double mu2 = sin(alpha);
    const double c_alpha = cos(alpha);
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];
    const double alpha_dot = qdot[3];
    const double beta_dot = qdot[4];
    const double gamma_dot = qdot[5];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double omega2 = beta_dot + gamma_dot * mu2;
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r3 = h - z2 * (mu3 * k3);
    const double omega3 = alpha_dot * s_beta + gamma_dot * mu3;
    const double z3 = z2 * (mu2 * k2);
    const double u1 = omega2 * r3 + omega3 * z3;
    const double omega1 = alpha_dot * c_beta - gamma_dot * z1;
    const double r1 = z1 * k1 * z2;
    const double z4 = omega1 * z3 + omega2 * r1;
    const double v1 = c_beta * u1 - s_beta * z4;
    const double u2 = omega3 * r1 - omega1 * r3;
    const double z5 = s_beta * u1 + c_beta * z4;
    const double e2 = c_alpha * u2 + mu2 * z5;
    /* (I.1.1) 44:5 */
    r[0] = x_dot - v1 * c_gamma + e2 * s_gamma; /* roll_x = 0 */
    /* (I.1.1) 45:5 */
    r[1] = y_dot - v1 * s_gamma - e2 * c_gamma; /* roll_y = 0 */
    /* (I.1.1) 46:5 */
    r[2] = z_dot - (mu2 * u2 - c_alpha * z5); /* roll_z = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2]) <= DBL_MAX)) {
        return rattleback_finish(3, r);
    }
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW
int rattleback_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3);
    const double z3 = 1.0 / sqrt(z2);
    const double z4 = mu3 * k3;
    const double r3 = h - z3 * z4;
    const double z5 = r3 * r3;
    const double z6 = mu2 * k2;
    const double z7 = z3 * z6;
    const double z8 = z7 * z7;
    const double z9 = I_a + (z5 + z8);
    const double z10 = z1 * k1;
    const double r1 = z10 * z3;
    const double z11 = r1 * r1;
    const double z12 = I_b + (z5 + z11);
    const double z13 = I_d + r1 * z7;
    const double z14 = 1.0 / z9;
    const double z15 = z13 * z14;
    const double z16 = z12 - z13 * z15;
    const double z17 = I_c + (z8 + z11);
    const double z18 = r1 * r3;
    const double z19 = z18 * z14;
    const double z20 = z7 * r3 + z13 * z19;
    const double z21 = 1.0 / z16;
    const double z22 = z20 * z21;
    const double z23 = z17 - z18 * z19 - z20 * z22;
    const double z24 = s_beta * w1 - c_beta * w3;
    const double z25 = 1.0 / c_alpha;
    const double z26 = z1 * w3 + mu3 * w1;
    const double z27 = z25 * z26;
    const double z28 = s_beta * z24 + c_beta * z27;
    const double z29 = c_beta * z24 - s_beta * z27;
    const double z30 = r3 * z28 + r1 * z29;
    const double u1 = r3 * w2 - z7 * z29;
    const double z31 = z25 * z24;
    const double z32 = w2 + mu2 * z31;
    const double z33 = c_beta * z32;
    const double z34 = s_beta * z32;
    const double z35 = z27 * z34;
    const double z36 = mu2 * z27;
    const double z37 = s_beta * z36 - c_alpha * z33;
    const double z38 = z35 + z31 * z37;
    const double z39 = z27 * z33;
    const double z40 = c_alpha * z34 + c_beta * z36;
    const double z41 = z39 + z31 * z40;
    const double z42 = s_beta * z38 + c_beta * z41 - z31 * z36;
    const double z43 = z25 * (z1 * z41 - mu3 * z38);
    const double z44 = z24 * z33 + s_beta * z42 - (z35 + c_beta * z43);
    const double z45 = (z10 * z37 - z6 * z26 + z4 * z40) * (z3 * (z3 * z3));
    const double z46 = z6 * z45 + k2 * (z3 * z26);
    const double z47 = k1 * (z3 * z37) - z10 * z45;
    const double z48 = g * mu3 + (z28 * z30 + w2 * u1 + (z7 * z44 + z28 * z46 - w2 * z47));
    const double z49 = mu2 * s_gamma;
    const double z50 = c_beta * z49 + s_beta * c_gamma;
    const double z51 = r1 * w2 + z7 * z28;
    const double z52 = z24 * z34 - c_beta * z42 + (z39 - s_beta * z43);
    const double z53 = z4 * z45 - k3 * (z3 * z40);
    const double z54 = g * z1 - (w2 * z51 + z29 * z30 - (z7 * z52 - z29 * z46 - w2 * z53));
    const double z55 = c_beta * c_gamma - s_beta * z49;
    const double z56 = z29 * u1 - z28 * z51 + (r3 * z44 - z28 * z53 - (r1 * z52 + z29 * z47));
    const double z57 = g * mu2 + z56;
    const double z58 = c_alpha * s_gamma;
    const double z59 = I_d * w2 + I_a * z28;
    const double z60 = I_d * z28 + I_b * w2;
    const double z61 = z27 * z60;
    const double z62 = z24 * z60;
    const double z63 = w2 * z59 - (I_c * z52 + (c_beta * z61 + (s_beta * z62 + (z7 * z54 - r1 * z57))));
    const double z64 = I_c * z29;
    const double z65 = w2 * z64 - (I_a * z44 - (s_beta * z61 - (c_beta * z62 + (r3 * z57 + z7 * z48))));
    const double z66 = I_d * z44 - (z29 * z59 - z28 * z64 - (r3 * z54 + r1 * z48)) + z15 * z65;
    const double z67 = (z63 + z19 * z65 + z22 * z66) / z23;
    const double z68 = z21 * z66 + z22 * z67;
    const double z69 = z14 * z65 + z15 * z68 + z19 * z67;
    const double z70 = z67 * (z7 * z55 - r1 * z58) + (z69 * (r3 * z58 - z7 * z50) - z68 * (r3 * z55 - r1 *
        z50));
    const double z71 = mu2 * c_gamma;
    const double z72 = c_beta * z71 - s_beta * s_gamma;
    const double z73 = c_beta * s_gamma + s_beta * z71;
    const double z74 = c_alpha * c_gamma;
    const double z75 = z67 * (z7 * z73 + r1 * z74) - (z69 * (r3 * z74 - z7 * z72) + z68 * (r3 * z73 + r1 *
        z72));
    const double z76 = z67 * (mu2 * r1 - z1 * z7) - (z69 * (mu2 * r3 + mu3 * z7) - z68 * (z1 * r3 + mu3 *
        r1));
    /* (I.4.1) 44:5 */
    lambda[0] = z70 - (z48 * z50 - (z54 * z55 + z57 * z58)); /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 45:5 */
    lambda[1] = z48 * z72 + (z54 * z73 - z57 * z74) + z75; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 46:5 */
    lambda[2] = z76 - (mu3 * z48 + (z1 * z54 + mu2 * z57)); /* reaction of roll_z: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1] + lambda[2]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z16) > 1e-14 * z12
        && fabs(z23) > 1e-14 * z17)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z9) > 0.0)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * z12)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z23) > 1e-14 * z17)) {
            return RATTLEBACK_SINGULAR_2;
        }
        return rattleback_finish(3, lambda);
    }
    return RATTLEBACK_OK;
}

double rattleback_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double z = y[2]; /* centre of mass, downwards [cm] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r3 = h - z2 * (mu3 * k3);
    const double z3 = s_beta * w1 - c_beta * w3;
    const double z4 = 1.0 / c_alpha;
    const double z5 = z4 * (z1 * w3 + mu3 * w1);
    const double z6 = c_beta * z5;
    const double z7 = s_beta * z3 + z6;
    const double r1 = z1 * k1 * z2;
    const double z8 = s_beta * z5;
    const double z9 = c_beta * z3 - z8;
    const double z10 = r3 * z7 + r1 * z9;
    const double z11 = z2 * (mu2 * k2);
    const double u1 = r3 * w2 - z11 * z9;
    const double z12 = r1 * w2 + z11 * z7;
    const double z13 = s_beta * u1 + c_beta * z12;
    const double z14 = c_alpha * z10 - mu2 * z13;
    const double z15 = s_beta * z12 - c_beta * u1;
    const double z16 = s_gamma * z14 - c_gamma * z15;
    const double z17 = s_gamma * z15 + c_gamma * z14;
    const double z18 = mu2 * z10 + c_alpha * z13;
    const double z19 = z4 * z3;
    const double omega1 = z6 + z1 * z19;
    const double omega3 = z8 - mu3 * z19;
    const double z20 = z16 * z16 + z17 * z17 + z18 * z18 + (I_a * (omega1 * omega1) + I_b * (w2 * w2) + I_c *
        (omega3 * omega3));
    return 0.5 * z20 + w2 * (I_d * omega1) - z * g;
}

RATTLEBACK_SLOW static int rattleback_jacobian_part1(double t, const double *y, const double *p, double
    *kept, double *J)
{
    (void)t;

    /* sines and cosines */
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double c_alpha = cos(alpha);
    kept[0] = c_alpha;
    const double mu2 = sin(alpha);
    kept[1] = mu2;
    const double beta = y[4]; /* pitch [rad] */
    const double s_beta = sin(beta);
    kept[2] = s_beta;
    const double c_beta = cos(beta);
    kept[3] = c_beta;
    const double gamma_ = y[5]; /* heading [rad] */
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);

    /* parameters only */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double k1 = a * a;
    kept[4] = k1;
    const double b = p[1]; /* half axis 2 [cm] */
    const double k2 = b * b;
    kept[5] = k2;
    const double c = p[2]; /* half axis 3 [cm] */
    const double k3 = c * c;
    kept[6] = k3;
    const double k4 = k1 - k3;
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double k5 = I_b - I_c;
    kept[7] = k5;
    const double I_a = p[4]; /* [cm^2] */
    const double k6 = I_a - I_c;
    kept[8] = k6;

    /* state */
    const double z1 = c_alpha * s_beta;
    kept[9] = z1;
    const double mu3 = c_beta * c_alpha;
    kept[10] = mu3;
    const double z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3);
    kept[11] = z2;
    const double z3 = 1.0 / sqrt(z2);
    kept[12] = z3;
    const double z4 = mu3 * k3;
    kept[13] = z4;
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double r3 = h - z3 * z4;
    kept[14] = r3;
    const double z5 = r3 * r3;
    const double z6 = mu2 * k2;
    kept[15] = z6;
    const double z7 = z3 * z6;
    kept[16] = z7;
    const double z8 = z7 * z7;
    kept[17] = z8;
    const double z9 = I_a + (z5 + z8);
    kept[18] = z9;
    const double z10 = z1 * k1;
    kept[19] = z10;
    const double r1 = z10 * z3;
    kept[20] = r1;
    const double z11 = r1 * r1;
    kept[21] = z11;
    const double z12 = I_b + (z5 + z11);
    kept[22] = z12;
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double z13 = I_d + r1 * z7;
    kept[23] = z13;
    const double z14 = 1.0 / z9;
    kept[24] = z14;
    const double z15 = z13 * z14;
    kept[25] = z15;
    const double z16 = z12 - z13 * z15;
    kept[26] = z16;
    const double z17 = I_c + (z8 + z11);
    kept[27] = z17;
    const double z18 = r1 * r3;
    kept[28] = z18;
    const double z19 = z18 * z14;
    kept[29] = z19;
    const double z20 = z7 * r3;
    kept[30] = z20;
    const double z21 = z20 + z13 * z19;
    const double z22 = 1.0 / z16;
    kept[31] = z22;
    const double z23 = z21 * z22;
    kept[32] = z23;
    const double z24 = z17 - z18 * z19 - z21 * z23;
    kept[33] = z24;
    const double w1 = y[6];
    const double w3 = y[8];
    const double z25 = s_beta * w1 - c_beta * w3;
    kept[34] = z25;
    const double z26 = s_beta * z25;
    const double z27 = 1.0 / c_alpha;
    kept[35] = z27;
    const double z28 = z1 * w3 + mu3 * w1;
    kept[36] = z28;
    const double z29 = z27 * z28;
    kept[37] = z29;
    const double z30 = c_beta * z29;
    const double z31 = z26 + z30;
    kept[38] = z31;
    const double z32 = r3 * z31;
    kept[39] = z32;
    const double z33 = c_beta * z25;
    const double z34 = s_beta * z29;
    const double z35 = z33 - z34;
    kept[40] = z35;
    const double z36 = r1 * z35;
    kept[41] = z36;
    const double z37 = z32 + z36;
    kept[42] = z37;
    const double z38 = 1.0 / (c_alpha * c_alpha);
    kept[43] = z38;
    const double z39 = mu2 * z38;
    const double z40 = s_beta * mu2;
    const double z41 = c_beta * mu2;
    const double z42 = z28 * z39 - z27 * (w3 * z40 + w1 * z41);
    const double z43 = c_beta * z42;
    const double z44 = z3 * z3;
    kept[44] = z44;
    const double z45 = z3 * z44;
    kept[45] = z45;
    const double z46 = z45 * (z10 * z40 - c_alpha * z6 + z4 * z41);
    const double z47 = k3 * z3;
    kept[46] = z47;
    const double z48 = z4 * z46 - z41 * z47;
    const double z49 = s_beta * z42;
    const double z50 = k1 * z3;
    kept[47] = z50;
    const double z51 = z40 * z50 - z10 * z46;
    const double z52 = r3 * z43 - z31 * z48 - (r1 * z49 + z35 * z51);
    const double w2 = y[7];
    const double z53 = r3 * w2;
    kept[48] = z53;
    const double z54 = z7 * z35;
    kept[49] = z54;
    const double u1 = z53 - z54;
    kept[50] = u1;
    const double z55 = s_beta * u1;
    const double z56 = r1 * w2;
    kept[51] = z56;
    const double z57 = z7 * z31;
    kept[52] = z57;
    const double z58 = z56 + z57;
    kept[53] = z58;
    const double z59 = c_beta * z58;
    const double z60 = z55 + z59;
    const double z61 = k2 * z3;
    kept[54] = z61;
    const double z62 = z6 * z46 + c_alpha * z61;
    const double z63 = w2 * z48 - (z7 * z49 - z35 * z62);
    const double z64 = w2 * z51 - (z7 * z43 + z31 * z62);
    const double z65 = s_beta * z63 + c_beta * z64;
    const double z66 = mu2 * z37 - c_alpha * z52 + (c_alpha * z60 - mu2 * z65);
    const double z67 = s_beta * z64 - c_beta * z63;
    /* (I.2.15) */
    J[3] = c_gamma * z67 - s_gamma * z66;
    const double z68 = c_beta * w1 + s_beta * w3;
    const double z69 = z27 * (mu3 * w3 - z1 * w1);
    const double z70 = z33 + s_beta * z68 - (z34 - c_beta * z69);
    const double z71 = k4 * (mu3 * (z1 * z45));
    const double z72 = z4 * z71 + z1 * z47;
    const double z73 = z26 - c_beta * z68 + (z30 + s_beta * z69);
    const double z74 = mu3 * z50 - z10 * z71;
    const double z75 = r3 * z70 + z31 * z72 - (r1 * z73 - z35 * z74);
    const double z76 = c_beta * u1;
    const double z77 = z6 * z71;
    const double z78 = w2 * z72 + (z7 * z73 + z35 * z77);
    const double z79 = s_beta * z58;
    const double z80 = w2 * z74 + (z7 * z70 - z31 * z77);
    const double z81 = z76 + s_beta * z78 - (z79 - c_beta * z80);
    const double z82 = c_alpha * z75 - mu2 * z81;
    const double z83 = z59 + s_beta * z80 + (z55 - c_beta * z78);
    J[4] = s_gamma * z82 - c_gamma * z83;
    const double z84 = z79 - z76;
    const double z85 = c_alpha * z37;
    const double z86 = mu2 * z60;
    const double z87 = z85 - z86;
    J[5] = s_gamma * z84 + c_gamma * z87;
    const double z88 = c_beta * z7;
    const double z89 = mu2 * z88 - c_alpha * r3;
    const double z90 = s_beta * z7;
    J[6] = -(s_gamma * z89 + c_gamma * z90);
    const double z91 = s_beta * r3 + c_beta * r1;
    const double z92 = mu2 * z91;
    const double z93 = s_beta * r1 - c_beta * r3;
    J[7] = -(s_gamma * z92 + c_gamma * z93);
    const double z94 = mu2 * z90 + c_alpha * r1;
    J[8] = c_gamma * z88 - s_gamma * z94;
    J[12] = s_gamma * z67 + c_gamma * z66;
    J[13] = -(s_gamma * z83 + c_gamma * z82);
    J[14] = s_gamma * z87 - c_gamma * z84;
    J[15] = c_gamma * z89 - s_gamma * z90;
    J[16] = c_gamma * z92 - s_gamma * z93;
    J[17] = s_gamma * z88 + c_gamma * z94;
    J[21] = z86 + c_alpha * z65 - (z85 + mu2 * z52);
    J[22] = -(mu2 * z75 + c_alpha * z81);
    J[24] = -(mu2 * r3 + c_alpha * z88);
    J[25] = -c_alpha * z91;
    J[26] = mu2 * r1 - c_alpha * z90;
    J[30] = z42;
    J[31] = z69;
    J[33] = c_beta;
    J[35] = s_beta;
    const double z95 = z25 * z39;
    J[39] = z25 + mu2 * z95;
    const double z96 = z27 * z68;
    J[40] = mu2 * z96;
    const double z97 = s_beta * z27;
    J[42] = mu2 * z97;
    J[43] = 1.0;
    const double z98 = c_beta * z27;
    J[44] = -mu2 * z98;
    J[48] = -z95;
    J[49] = -z96;
    J[51] = -z97;
    J[53] = z98;
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double z99 = g * r3;
    kept[55] = z99;
    const double z100 = z7 * w2;
    kept[56] = z100;
    const double z101 = r3 * z35;
    kept[57] = z101;
    const double z102 = z100 + z101;
    kept[58] = z102;
    const double z103 = z4 * z32 - z6 * z57 - z10 * z102;
    kept[59] = z103;
    const double z104 = z44 * z103;
    kept[60] = z104;
    const double z105 = z3 * z104;
    const double z106 = k2 * z105;
    kept[61] = z106;
    const double z107 = z27 * z25;
    kept[62] = z107;
    const double z108 = z8 + (I_a + z5);
    kept[63] = z108;
    const double z109 = c_beta * z18;
    kept[64] = z109;
    const double z110 = s_beta * z108 + z109;
    kept[65] = z110;
    const double z111 = s_beta * z18;
    kept[66] = z111;
    const double z112 = c_beta * z108 - z111;
    kept[67] = z112;
    const double z113 = z27 * z112;
    kept[68] = z113;
    const double z114 = c_beta * z110 - z1 * z113;
    kept[69] = z114;
    const double z115 = k3 * z105;
    kept[70] = z115;
    const double z116 = z107 * z114 - (mu3 * z115 - z32 * z47);
    kept[71] = z116;
    const double z117 = s_beta * z110 + mu3 * z113;
    kept[72] = z117;
    const double z118 = k1 * z105;
    kept[73] = z118;
    const double z119 = z107 * z117 - (z1 * z118 + z102 * z50);
    kept[74] = z119;
    const double z120 = z107 * z110 - c_beta * z116 - s_beta * z119;
    kept[75] = z120;
    const double z121 = z18 - z114;
    kept[76] = z121;
    const double z122 = z25 * z108 - z29 * z121 - c_alpha * z119;
    kept[77] = z122;
    const double z123 = z25 * z18;
    kept[78] = z123;
    const double z124 = z108 - z117;
    kept[79] = z124;
    const double z125 = z123 + z29 * z124 - c_alpha * z116;
    kept[80] = z125;
    const double z126 = c_beta * z122 - s_beta * z125;
    kept[81] = z126;
    const double z127 = mu2 * z29;
    kept[82] = z127;
    const double z128 = w2 + mu2 * z107;
    kept[83] = z128;
    const double z129 = c_beta * z128;
    kept[84] = z129;
    const double z130 = s_beta * z127 - c_alpha * z129;
    kept[85] = z130;
    const double z131 = s_beta * z128;
    kept[86] = z131;
    const double z132 = c_alpha * z131 + c_beta * z127;
    kept[87] = z132;
    const double z133 = z10 * z130 - z6 * z28 + z4 * z132;
    kept[88] = z133;
    const double z134 = z3 * z133;
    kept[89] = z134;
    const double z135 = z44 * z134;
    kept[90] = z135;
    const double z136 = z29 * z131;
    const double z137 = z136 + z107 * z130;
    kept[91] = z137;
    const double z138 = z29 * z129;
    kept[92] = z138;
    const double z139 = z138 + z107 * z132;
    kept[93] = z139;
    const double z140 = s_beta * z137 + c_beta * z139 - z107 * z127;
    kept[94] = z140;
    const double z141 = z1 * z139 - mu3 * z137;
    kept[95] = z141;
    const double z142 = z27 * z141;
    kept[96] = z142;
    const double z143 = z25 * z129 + s_beta * z140 - (z136 + c_beta * z142);
    kept[97] = z143;
    const double z144 = z7 * z143;
    kept[98] = z144;
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW static int rattleback_jacobian_part2(double t, const double *y, const double *p, double
    *kept, double *J)
{
    (void)t;
    const double k2 = kept[5];
    const double z28 = kept[36];
    const double z145 = k2 * z28;
    const double z3 = kept[12];
    const double z6 = kept[15];
    const double z135 = kept[90];
    const double z146 = z3 * z145 + z6 * z135;
    const double k1 = kept[4];
    const double z130 = kept[85];
    const double z147 = k1 * z130;
    const double z10 = kept[19];
    const double z148 = z3 * z147 - z10 * z135;
    const double w2 = y[7];
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double mu3 = kept[10];
    const double z31 = kept[38];
    const double z37 = kept[42];
    const double u1 = kept[50];
    const double z144 = kept[98];
    const double z149 = g * mu3 + (z31 * z37 + w2 * u1 + (z144 + z31 * z146 - w2 * z148));
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double z150 = I_d * w2;
    const double I_a = p[4]; /* [cm^2] */
    const double z151 = z150 + I_a * z31;
    const double I_c = p[6]; /* [cm^2] */
    const double z35 = kept[40];
    const double z152 = I_c * z35;
    const double s_beta = kept[2];
    const double c_beta = kept[3];
    const double z25 = kept[34];
    const double z131 = kept[86];
    const double z138 = kept[92];
    const double z140 = kept[94];
    const double z142 = kept[96];
    const double z153 = z25 * z131 - c_beta * z140 + (z138 - s_beta * z142);
    const double z7 = kept[16];
    const double z154 = z7 * z153;
    const double k3 = kept[6];
    const double z132 = kept[87];
    const double z155 = k3 * z132;
    const double z4 = kept[13];
    const double z156 = z3 * z155 - z4 * z135;
    const double z1 = kept[9];
    const double z58 = kept[53];
    const double z157 = g * z1 - (w2 * z58 + z35 * z37 - (z154 - z35 * z146 + w2 * z156));
    const double z158 = I_d * z31;
    const double I_b = p[5]; /* [cm^2] */
    const double z159 = z158 + I_b * w2;
    const double z29 = kept[37];
    const double z160 = z29 * z159;
    const double z161 = z25 * z159;
    const double r3 = kept[14];
    const double z143 = kept[97];
    const double z162 = r3 * z143;
    const double r1 = kept[20];
    const double z163 = r1 * z153;
    const double mu2 = kept[1];
    const double z164 = g * mu2 + (z35 * u1 - z31 * z58 + (z162 + z31 * z156 - (z163 + z35 * z148)));
    const double z165 = w2 * z152 - (I_a * z143 - (s_beta * z160 - (c_beta * z161 + (r3 * z164 + z7 *
        z149))));
    const double z15 = kept[25];
    const double z166 = I_d * z143 - (z35 * z151 - z31 * z152 - (r3 * z157 + r1 * z149)) + z15 * z165;
    const double z24 = kept[33];
    const double z167 = 1.0 / z24;
    const double z168 = w2 * z151 - (I_c * z153 + (c_beta * z160 + (s_beta * z161 + (z7 * z157 - r1 *
        z164))));
    const double z19 = kept[29];
    const double z23 = kept[32];
    const double z169 = z167 * (z168 + z19 * z165 + z23 * z166);
    const double z22 = kept[31];
    const double z170 = z22 * z166 + z23 * z169;
    const double z171 = r1 * z170;
    const double z14 = kept[24];
    const double z172 = z14 * z165 + z15 * z170 + z19 * z169;
    const double z173 = z7 * z172;
    const double z32 = kept[39];
    const double z102 = kept[58];
    const double z174 = z35 * z102 + (z31 * z32 - (z144 + (z149 - z171 + 2.0 * z173)));
    const double z57 = kept[52];
    const double z99 = kept[55];
    const double z106 = kept[61];
    const double z107 = kept[62];
    const double z120 = kept[75];
    const double z126 = kept[81];
    const double z175 = z99 + (z28 * z106 - z29 * z120 + z107 * z126) + k2 * (z57 * z135 - z3 * z174);
    const double z2 = kept[11];
    const double z134 = kept[89];
    const double z176 = z134 / (z2 * z2);
    const double z177 = r1 * z169;
    const double z178 = r3 * z172;
    const double z179 = w2 * z102 + (z31 * z57 + (z162 + (z164 - z177 + 2.0 * z178)));
    const double z104 = kept[60];
    const double z133 = kept[88];
    const double z180 = z32 * z155 + z57 * z145 - z147 * z102 - z133 * z104 - z4 * z179 - z6 * z174;
    const double z181 = r3 * z153;
    const double z182 = r3 * z169;
    const double z183 = z7 * z170;
    const double z184 = w2 * z32 - (z35 * z57 - (z181 + (z182 + z183)));
    const double z45 = kept[45];
    const double z103 = kept[59];
    const double z185 = z103 * z176 - 0.5 * (z45 * (z180 - z10 * z184));
    const double z110 = kept[65];
    const double z114 = kept[69];
    const double z117 = kept[72];
    const double z127 = kept[82];
    const double z186 = z127 * z110 - z130 * z117 - z132 * z114 - mu2 * z126;
    const double z187 = s_beta * z159;
    const double z188 = I_d * z35;
    const double z189 = z7 * z37;
    const double z190 = r3 * z58;
    const double z191 = r3 * z156;
    const double z192 = z7 * z146;
    const double z193 = z7 * z32 - (r3 * z57 + (z188 + z189 - z190 + z191 + z192));
    const double z194 = z7 * z102 - (r1 * z57 - (I_c * w2 - r3 * u1 + r3 * z148));
    const double z121 = kept[76];
    const double z124 = kept[79];
    const double z129 = kept[84];
    const double z195 = z187 + z131 * z124 + z129 * z121 + mu2 * z120 + c_beta * z193 - s_beta * z194;
    const double z196 = g * z7;
    const double z27 = kept[35];
    const double z61 = kept[54];
    const double z197 = mu2 * z106 + z57 * z61 - z27 * z195;
    const double w1 = y[6];
    const double z113 = kept[68];
    const double z115 = kept[70];
    const double z137 = kept[91];
    const double z198 = z132 * z115 - z137 * z113 - z196 - w1 * z197 + k3 * (z32 * z135 + z3 * z179);
    const double z199 = z198 - 2.0 * (z4 * z185);
    const double z38 = kept[43];
    const double z112 = kept[67];
    const double z116 = kept[71];
    const double z119 = kept[74];
    const double z141 = kept[95];
    const double z200 = z131 * z116 - z129 * z119 + z38 * (z141 * z112 + z25 * z186 + z28 * z195) - c_beta *
        z199;
    const double w3 = y[8];
    const double z118 = kept[73];
    const double z139 = kept[93];
    const double z201 = z130 * z118 + z139 * z113 - w3 * z197 - k1 * (z102 * z135 - z3 * z184) - 2.0 * (z10 *
        z185);
    const double c_alpha = kept[0];
    const double z202 = c_alpha * (z175 + 2.0 * (z6 * z185)) - mu2 * (z200 - s_beta * z201);
    const double z203 = r1 * z31;
    const double z101 = kept[57];
    const double z204 = z101 - z203;
    const double z53 = kept[48];
    const double z56 = kept[51];
    const double z205 = z4 * z53 + z6 * z204 - z10 * z56;
    const double z44 = kept[44];
    const double z206 = z44 * z205;
    const double z207 = z3 * z206;
    const double z208 = k2 * z207;
    const double z13 = kept[23];
    const double z20 = kept[30];
    const double z209 = s_beta * z13 - c_beta * z20;
    const double z210 = c_beta * z13 + s_beta * z20;
    const double z211 = z27 * z210;
    const double z212 = c_beta * z209 - z1 * z211;
    const double z213 = k3 * z207;
    const double z47 = kept[46];
    const double z214 = z107 * z212 - (mu3 * z213 - z53 * z47);
    const double z215 = s_beta * z209 + mu3 * z211;
    const double z216 = k1 * z207;
    const double z50 = kept[47];
    const double z217 = z107 * z215 - (z1 * z216 + z56 * z50);
    const double z218 = z107 * z209 - c_beta * z214 - s_beta * z217;
    const double z219 = z20 + z212;
    const double z220 = z25 * z13 + z29 * z219 - c_alpha * z217;
    const double z221 = z13 - z215;
    const double z222 = z25 * z20 - z29 * z221 + c_alpha * z214;
    const double z223 = c_beta * z220 + s_beta * z222;
    const double z224 = r1 * z143;
    const double z225 = r1 * z172;
    const double z226 = z56 * z35 + (z53 * z31 - (z181 + (z224 + (z182 + z225))));
    const double z227 = r3 * z170;
    const double z228 = z7 * z169;
    const double z229 = w2 * z56 - (z31 * z204 + (2.0 * z227 - (z157 + z228)));
    const double z230 = z53 * z155 - z145 * z204 - z56 * z147 - z133 * z206 - z4 * z229 - z6 * z226;
    const double z231 = w2 * z53 + (z35 * z204 - (z173 + (z149 - 2.0 * z171)));
    const double z232 = z205 * z176 - 0.5 * (z45 * (z230 - z10 * z231));
    const double z233 = z28 * z208 - z29 * z218 + z107 * z223 - k2 * (z204 * z135 + z3 * z226) + 2.0 * (z6 *
        z232);
    const double z234 = z127 * z209 - z130 * z215 - z132 * z212 - mu2 * z223;
    const double k6 = kept[8];
    const double z235 = z7 * z53 + (r3 * z204 + (z35 * k6 - r1 * z37 - r1 * z146));
    const double z236 = z7 * z56 + (r1 * z204 + (z151 - I_c * z31 + r3 * z37 + r3 * z146));
    const double z237 = z131 * z221 - z129 * z219 + mu2 * z218 + c_beta * z235 - s_beta * z236;
    const double z238 = g * r1;
    const double z239 = mu2 * z208 - z204 * z61 - z27 * z237;
    const double z240 = z132 * z213 - z137 * z211 - z238 - w1 * z239 + k3 * (z53 * z135 + z3 * z229);
    const double z241 = z240 - 2.0 * (z4 * z232);
    const double z242 = z131 * z214 - z129 * z217 + z38 * (z141 * z210 + z25 * z234 + z28 * z237) - c_beta *
        z241;
    const double z243 = z99 - (z130 * z216 + z139 * z211) + w3 * z239 + k1 * (z56 * z135 - z3 * z231);
    const double z244 = z243 + 2.0 * (z10 * z232);
    const double z245 = c_alpha * z233 - mu2 * (z242 + s_beta * z244) - z15 * z202;
    const double z100 = kept[56];
    const double z246 = z100 - z203;
    const double z36 = kept[41];
    const double z54 = kept[49];
    const double z247 = z4 * z246 + z6 * z54 + z10 * z36;
    const double z248 = z44 * z247;
    const double z249 = z3 * z248;
    const double z250 = k2 * z249;
    const double z8 = kept[17];
    const double z11 = kept[21];
    const double z251 = z8 + (I_c + z11);
    const double z111 = kept[66];
    const double z252 = z111 + c_beta * z251;
    const double z109 = kept[64];
    const double z253 = z109 - s_beta * z251;
    const double z254 = z27 * z253;
    const double z255 = c_beta * z252 - z1 * z254;
    const double z256 = k3 * z249;
    const double z257 = z107 * z255 + (mu3 * z256 - z246 * z47);
    const double z258 = s_beta * z252 + mu3 * z254;
    const double z259 = k1 * z249;
    const double z260 = z107 * z258 + (z1 * z259 - z36 * z50);
    const double z261 = z107 * z252 - c_beta * z257 - s_beta * z260;
    const double z262 = z251 - z255;
    const double z123 = kept[78];
    const double z263 = z123 - z29 * z262 - c_alpha * z260;
    const double z18 = kept[28];
    const double z264 = z18 - z258;
    const double z265 = z25 * z251 + z29 * z264 - c_alpha * z257;
    const double z266 = c_beta * z263 - s_beta * z265;
    const double z267 = z35 * z36 - (z31 * z246 - (z154 + (2.0 * z228 + (z157 - z227))));
    const double z268 = z238 - (z28 * z250 + z29 * z261 - z107 * z266) + k2 * (z54 * z135 - z3 * z267);
    const double z269 = w2 * z36 + (z54 * z31 + (z224 + (z183 + z225)));
    const double z270 = z155 * z246 - z54 * z145 + z36 * z147 - z133 * z248 + z4 * z269 + z6 * z267;
    const double z271 = w2 * z246 + (z35 * z54 - (z163 - (z178 + (z164 - 2.0 * z177))));
    const double z272 = z247 * z176 - 0.5 * (z45 * (z270 - z10 * z271));
    const double z273 = z127 * z252 - z130 * z258 - z132 * z255 - mu2 * z266;
    const double z274 = c_beta * z159;
    const double z275 = z7 * z246 + (r3 * z54 - (z158 - I_a * w2 + r1 * z58 - r1 * z156));
    const double z276 = r1 * u1;
    const double z277 = r1 * z148;
    const double z278 = z7 * z36 - (r1 * z54 + (z192 + (z189 + z276 - z277)));
    const double z279 = z274 + z131 * z264 + z129 * z262 + mu2 * z261 - c_beta * z275 - s_beta * z278;
    const double z280 = mu2 * z250 - z54 * z61 + z27 * z279;
    const double z281 = z132 * z256 + z137 * z254 - w1 * z280 + k3 * (z246 * z135 - z3 * z269) - 2.0 * (z4 *
        z272);
    const double z282 = z131 * z257 - z129 * z260 + z38 * (z141 * z253 + z25 * z273 + z28 * z279) + c_beta *
        z281;
    const double z283 = z196 - (z130 * z259 - z139 * z254) + w3 * z280 - k1 * (z36 * z135 + z3 * z271);
    const double z284 = z283 + 2.0 * (z10 * z272);
    const double z285 = c_alpha * (z268 - 2.0 * (z6 * z272)) - mu2 * (z282 - s_beta * z284) - z19 * z202 +
        z23 * z245;
    const double z286 = z167 * z285;
    const double z287 = z22 * z245 + z23 * z286;
    /* (I.2.15) */
    J[57] = z19 * z286 - (z14 * z202 - z15 * z287);
    const double z288 = z142 * z18;
    const double z108 = kept[63];
    const double z125 = kept[80];
    const double z128 = kept[83];
    const double z289 = z160 - z140 * z108 - z288 - z137 * z110 - z127 * z119 + z128 * z125 + z25 * z193;
    const double z290 = z274 + z129 * z108 - z131 * z18 - s_beta * z193 - c_beta * z194 - z27 * z186;
    const double z291 = z140 * z18;
    const double z122 = kept[77];
    const double z292 = z161 - z142 * z108 + z291 + z139 * z110 + z127 * z116 + z128 * z122 - z29 * z193;
    const double z293 = c_beta * (z289 - z29 * z194 - w1 * z290 + c_alpha * z201) + s_beta * (z292 - z25 *
        z194 - w3 * z290 - c_alpha * z199);
    const double z294 = z140 * z13 - z142 * z20 + z137 * z209 + z127 * z217 + z128 * z222 - z25 * z235;
    const double z295 = z129 * z13 + z131 * z20 - s_beta * z235 - c_beta * z236 - z27 * z234;
    const double z296 = z142 * z13 + z140 * z20 - z139 * z209 - z127 * z214 - z128 * z220 + z29 * z235;
    const double z297 = c_beta * (z294 + z29 * z236 + w1 * z295 + c_alpha * z244) + s_beta * (z296 + z25 *
        z236 + w3 * z295 + c_alpha * z241);
    const double z298 = z297 + z15 * z293;
    const double z299 = z161 - z291 - z142 * z251 - z137 * z252 - z127 * z260 + z128 * z265 - z25 * z275;
    const double z300 = z187 - z129 * z18 + z131 * z251 - s_beta * z275 + c_beta * z278 + z27 * z273;
    const double z301 = z160 + z288 - z140 * z251 - z139 * z252 - z127 * z257 - z128 * z263 - z29 * z275;
    const double z302 = c_beta * (z299 - z29 * z278 + w1 * z300 + c_alpha * z284) - s_beta * (z301 + z25 *
        z278 - w3 * z300 - c_alpha * z281);
    const double z303 = z167 * (z302 - z19 * z293 - z23 * z298);
    const double z304 = z22 * z298 - z23 * z303;
    J[58] = z14 * z293 + z15 * z304 - z19 * z303;
    const double z305 = s_beta * z290 + mu3 * z197;
    const double z306 = s_beta * z295 + mu3 * z239 - z15 * z305;
    const double z307 = z167 * (s_beta * z300 + mu3 * z280 + z19 * z305 - z23 * z306);
    const double z308 = z22 * z306 - z23 * z307;
    J[60] = -(z14 * z305 - z15 * z308 + z19 * z307);
    const double k5 = kept[7];
    const double z309 = r3 * z102 - (r1 * z32 - (z35 * k5 + z7 * u1 - z7 * z148 + z126));
    const double z310 = r3 * z56 - (r1 * z53 - (z191 - (z190 + (z188 - z276) + z277) + z223)) - z15 * z309;
    const double z311 = r3 * z36 + (r1 * z246 + (z150 + (z151 - I_b * z31) + z7 * z58 - z7 * z156 + z266));
    const double z312 = z167 * (z311 - z19 * z309 + z23 * z310);
    const double z313 = z22 * z310 + z23 * z312;
    J[61] = z19 * z312 - (z14 * z309 - z15 * z313);
    const double z314 = c_beta * z290 - z1 * z197;
    const double z315 = c_beta * z295 - z1 * z239 - z15 * z314;
    const double z316 = z167 * (c_beta * z300 - z1 * z280 + z19 * z314 - z23 * z315);
    const double z317 = z22 * z315 - z23 * z316;
    J[62] = z14 * z314 - z15 * z317 + z19 * z316;
    J[66] = -z287;
    J[67] = -z304;
    J[69] = -z308;
    J[70] = -z313;
    J[71] = z317;
    J[75] = z286;
    J[76] = -z303;
    J[78] = -z307;
    J[79] = z312;
    J[80] = z316;
    /* the coframe is singular */
    if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    const double z9 = kept[18];
    /* the mass matrix is singular */
    if (!(fabs(z9) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z12 = kept[22];
    const double z16 = kept[26];
    /* the mass matrix is singular */
    if (!(fabs(z16) > 1e-14 * z12)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z17 = kept[27];
    /* the mass matrix is singular */
    if (!(fabs(z24) > 1e-14 * z17)) {
        return RATTLEBACK_SINGULAR_2;
    }
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW
int rattleback_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[99]; /* what parts of this function leave for others */
    for (int entry = 0; entry < 81; ++entry) {
        J[entry] = 0.0;
    }
    int status = rattleback_jacobian_part1(t, y, p, kept, J);
    if (status == RATTLEBACK_OK) {
        status = rattleback_jacobian_part2(t, y, p, kept, J);
    }
    if (status != RATTLEBACK_OK) {
        return status;
    }
    return rattleback_finish(81, J);
}

int rattleback_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double w3 = y[8];

    /* state */
    const double c_alpha = cos(alpha);
    /* 53:9 */
    out[0] = w3; /* spin */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(c_alpha) > 1e-12 * 4.0)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        return rattleback_finish(1, out);
    }
    return RATTLEBACK_OK;
}

#if RATTLEBACK_LANES >= 2
static __attribute__((noinline)) void rattleback_rhs_lanes(const double *fixed, size_t stride, const double
    *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    rattleback_lanes far = {0}; /* the squares of the angles */
    rattleback_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    rattleback_bits bad = {0}; /* singular blocks */
    const double h = fixed[0];
    const double I_a = fixed[1];
    const double I_b = fixed[2];
    const double I_c = fixed[3];
    const double I_d = fixed[4];
    const double g = fixed[5];
    const double k1 = fixed[6];
    const double k2 = fixed[7];
    const double k3 = fixed[8];
    const rattleback_lanes alpha = rattleback_get(y + 3 * stride);
    const rattleback_lanes beta = rattleback_get(y + 4 * stride);
    const rattleback_lanes gamma_ = rattleback_get(y + 5 * stride);
    const rattleback_lanes w1 = rattleback_get(y + 6 * stride);
    const rattleback_lanes w2 = rattleback_get(y + 7 * stride);
    const rattleback_lanes w3 = rattleback_get(y + 8 * stride);
    rattleback_lanes sine1, cosine1;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(alpha), &far, &sine1, &cosine1);
    const rattleback_lanes c_alpha = cosine1;
    /* the coframe is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(c_alpha)), RATTLEBACK_SPREAD(1e-12 * 4.0));
    rattleback_lanes sine2, cosine2;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(beta), &far, &sine2, &cosine2);
    const rattleback_lanes s_beta = sine2;
    const rattleback_lanes z1 = c_alpha * s_beta;
    const rattleback_lanes mu2 = sine1;
    const rattleback_lanes c_beta = cosine2;
    const rattleback_lanes mu3 = c_beta * c_alpha;
    const rattleback_lanes z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3);
    const rattleback_lanes z3 = 1.0 / rattleback_each_sqrt(RATTLEBACK_SPREAD(z2));
    const rattleback_lanes z4 = mu3 * k3;
    const rattleback_lanes r3 = h - z3 * z4;
    const rattleback_lanes z5 = r3 * r3;
    const rattleback_lanes z6 = mu2 * k2;
    const rattleback_lanes z7 = z3 * z6;
    const rattleback_lanes z8 = z7 * z7;
    const rattleback_lanes z9 = I_a + (z5 + z8);
    const rattleback_lanes z10 = z1 * k1;
    const rattleback_lanes r1 = z10 * z3;
    const rattleback_lanes z11 = r1 * r1;
    const rattleback_lanes z12 = I_b + (z5 + z11);
    const rattleback_lanes z13 = I_d + r1 * z7;
    const rattleback_lanes z14 = 1.0 / z9;
    const rattleback_lanes z15 = z13 * z14;
    const rattleback_lanes z16 = z12 - z13 * z15;
    /* the mass matrix is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z16)), 1e-14 * z12);
    const rattleback_lanes z17 = I_c + (z8 + z11);
    const rattleback_lanes z18 = r1 * r3;
    const rattleback_lanes z19 = z18 * z14;
    const rattleback_lanes z20 = z7 * r3 + z13 * z19;
    const rattleback_lanes z21 = 1.0 / z16;
    const rattleback_lanes z22 = z20 * z21;
    const rattleback_lanes z23 = z17 - z18 * z19 - z20 * z22;
    /* the mass matrix is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z23)), 1e-14 * z17);
    rattleback_lanes sine3, cosine3;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(gamma_), &far, &sine3, &cosine3);
    const rattleback_lanes s_gamma = sine3;
    const rattleback_lanes z24 = s_beta * w1 - c_beta * w3;
    const rattleback_lanes z25 = 1.0 / c_alpha;
    const rattleback_lanes z26 = z1 * w3 + mu3 * w1;
    const rattleback_lanes z27 = z25 * z26;
    const rattleback_lanes z28 = s_beta * z24 + c_beta * z27;
    const rattleback_lanes z29 = c_beta * z24 - s_beta * z27;
    const rattleback_lanes z30 = r3 * z28 + r1 * z29;
    const rattleback_lanes u1 = r3 * w2 - z7 * z29;
    const rattleback_lanes z31 = r1 * w2 + z7 * z28;
    const rattleback_lanes z32 = s_beta * u1 + c_beta * z31;
    const rattleback_lanes z33 = c_alpha * z30 - mu2 * z32;
    const rattleback_lanes c_gamma = cosine3;
    const rattleback_lanes z34 = s_beta * z31 - c_beta * u1;
    const rattleback_lanes z35 = z25 * z24;
    const rattleback_lanes z36 = w2 + mu2 * z35;
    const rattleback_lanes z37 = I_c * z29;
    const rattleback_lanes z38 = c_beta * z36;
    const rattleback_lanes z39 = s_beta * z36;
    const rattleback_lanes z40 = z27 * z39;
    const rattleback_lanes z41 = mu2 * z27;
    const rattleback_lanes z42 = s_beta * z41 - c_alpha * z38;
    const rattleback_lanes z43 = z40 + z35 * z42;
    const rattleback_lanes z44 = z27 * z38;
    const rattleback_lanes z45 = c_alpha * z39 + c_beta * z41;
    const rattleback_lanes z46 = z44 + z35 * z45;
    const rattleback_lanes z47 = s_beta * z43 + c_beta * z46 - z35 * z41;
    const rattleback_lanes z48 = z25 * (z1 * z46 - mu3 * z43);
    const rattleback_lanes z49 = z24 * z38 + s_beta * z47 - (z40 + c_beta * z48);
    const rattleback_lanes z50 = I_d * z28 + I_b * w2;
    const rattleback_lanes z51 = z27 * z50;
    const rattleback_lanes z52 = z24 * z50;
    const rattleback_lanes z53 = (z10 * z42 - z6 * z26 + z4 * z45) * (z3 * (z3 * z3));
    const rattleback_lanes z54 = z4 * z53 - k3 * (z3 * z45);
    const rattleback_lanes z55 = z24 * z39 - c_beta * z47 + (z44 - s_beta * z48);
    const rattleback_lanes z56 = k1 * (z3 * z42) - z10 * z53;
    const rattleback_lanes z57 = z29 * u1 - z28 * z31 + (r3 * z49 - z28 * z54 - (r1 * z55 + z29 * z56));
    const rattleback_lanes z58 = g * mu2 + z57;
    const rattleback_lanes z59 = z6 * z53 + k2 * (z3 * z26);
    const rattleback_lanes z60 = g * mu3 + (z28 * z30 + w2 * u1 + (z7 * z49 + z28 * z59 - w2 * z56));
    const rattleback_lanes z61 = w2 * z37 - (I_a * z49 - (s_beta * z51 - (c_beta * z52 + (r3 * z58 + z7 *
        z60))));
    const rattleback_lanes z62 = I_d * w2 + I_a * z28;
    const rattleback_lanes z63 = g * z1 - (w2 * z31 + z29 * z30 - (z7 * z55 - z29 * z59 - w2 * z54));
    const rattleback_lanes z64 = I_d * z49 - (z29 * z62 - z28 * z37 - (r3 * z63 + r1 * z60)) + z15 * z61;
    const rattleback_lanes z65 = w2 * z62 - (I_c * z55 + (c_beta * z51 + (s_beta * z52 + (z7 * z63 - r1 *
        z58))));
    const rattleback_lanes z66 = (z65 + z19 * z61 + z22 * z64) / z23;
    const rattleback_lanes z67 = z21 * z64 + z22 * z66;
    /* (I.2.15) */
    const rattleback_lanes slope1 = s_gamma * z33 - c_gamma * z34;
    sum += slope1;
    rattleback_put(dydt, slope1);
    const rattleback_lanes slope2 = -(s_gamma * z34 + c_gamma * z33);
    sum += slope2;
    rattleback_put(dydt + 1 * stride, slope2);
    const rattleback_lanes slope3 = -(mu2 * z30 + c_alpha * z32);
    sum += slope3;
    rattleback_put(dydt + 2 * stride, slope3);
    const rattleback_lanes slope4 = z27;
    rattleback_put(dydt + 3 * stride, slope4);
    const rattleback_lanes slope5 = z36;
    rattleback_put(dydt + 4 * stride, slope5);
    const rattleback_lanes slope6 = -z35;
    rattleback_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 41:4 */
    const rattleback_lanes slope7 = z14 * z61 + z15 * z67 + z19 * z66;
    sum += slope7;
    rattleback_put(dydt + 6 * stride, slope7);
    const rattleback_lanes slope8 = -z67;
    sum += slope8;
    rattleback_put(dydt + 7 * stride, slope8);
    const rattleback_lanes slope9 = z66;
    rattleback_put(dydt + 8 * stride, slope9);
    rattleback_put(check, rattleback_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void rattleback_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[RATTLEBACK_LANES];
    double state[9 * RATTLEBACK_LANES];
    double slope[9 * RATTLEBACK_LANES];
    rattleback_fill(left, count, t, y, time, state);
    rattleback_rhs_lanes(fixed, RATTLEBACK_LANES, time, state, slope, check);
    rattleback_pour(left, count, slope, dydt);
}
#endif

int rattleback_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
#if RATTLEBACK_LANES >= 2
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double fixed[] = {h, I_a, I_b, I_c, I_d, g, k1, k2, k3};
    double check[1 * RATTLEBACK_LANES];
    int status = RATTLEBACK_OK;
    for (size_t i = 0; i < count; i += RATTLEBACK_LANES) {
        const size_t left = count - i < RATTLEBACK_LANES ? count - i : RATTLEBACK_LANES;
        if (left == RATTLEBACK_LANES) {
            rattleback_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            rattleback_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!rattleback_is_good(1 * RATTLEBACK_LANES, check)) {
            const int one = rattleback_one_by_one(count, i, left, t, y, p, dydt);
            status = status == RATTLEBACK_OK ? one : status;
        }
    }
    return status;
#else
    return rattleback_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
