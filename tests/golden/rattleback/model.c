/*
 * rattleback.c: rattleback, emitted by nhc 0.1.0 (nhc:486d25f19c9491e6)
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
    const double z54 = z31 + (z4 * z53 - k3 * (z3 * z45));
    const double z55 = z24 * z39 - c_beta * z47 + (z44 - s_beta * z48);
    const double z56 = u1 - (k1 * (z3 * z42) - z10 * z53);
    const double z57 = z28 * z54 - (r3 * z49 + (g * mu2 - r1 * z55) + z29 * z56);
    const double z58 = z30 + (z6 * z53 + k2 * (z3 * z26));
    const double z59 = w2 * z56 + (g * mu3 + z7 * z49 + z28 * z58);
    const double z60 = w2 * z37 - (I_a * z49 - (s_beta * z51 - (c_beta * z52 - (r3 * z57 - z7 * z59))));
    const double z61 = I_d * w2 + I_a * z28;
    const double z62 = w2 * z54 - (g * z1 + z7 * z55 - z29 * z58);
    const double z63 = I_d * z49 - (z29 * z61 - z28 * z37 + (r3 * z62 - r1 * z59)) + z15 * z60;
    const double z64 = w2 * z61 - (I_c * z55 + (c_beta * z51 + (s_beta * z52 - (z7 * z62 - r1 * z57))));
    const double z65 = (z64 + z19 * z60 + z22 * z63) / z23;
    const double z66 = z21 * z63 + z22 * z65;
    /* (I.2.15) */
    dydt[0] = s_gamma * z33 - c_gamma * z34; /* x' */
    dydt[1] = -(s_gamma * z34 + c_gamma * z33); /* y' */
    dydt[2] = -(mu2 * z30 + c_alpha * z32); /* z' */
    dydt[3] = z27; /* alpha' */
    dydt[4] = z36; /* beta' */
    dydt[5] = -z35; /* gamma' */
    /* (I.2.15) 41:4 */
    dydt[6] = z14 * z60 + z15 * z66 + z19 * z65; /* w1' */
    dydt[7] = -z66; /* w2' */
    dydt[8] = z65; /* w3' */
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
    const double z28 = c_beta * z24 - s_beta * z27;
    const double z29 = mu2 * z27;
    const double z30 = z25 * z24;
    const double z31 = w2 + mu2 * z30;
    const double z32 = c_beta * z31;
    const double z33 = s_beta * z29 - c_alpha * z32;
    const double z34 = s_beta * z31;
    const double z35 = c_alpha * z34 + c_beta * z29;
    const double z36 = (z10 * z33 - z6 * z26 + z4 * z35) * (z3 * (z3 * z3));
    const double z37 = r3 * w2 - z7 * z28 - (k1 * (z3 * z33) - z10 * z36);
    const double z38 = z27 * z34;
    const double z39 = z38 + z30 * z33;
    const double z40 = z27 * z32;
    const double z41 = z40 + z30 * z35;
    const double z42 = s_beta * z39 + c_beta * z41 - z30 * z29;
    const double z43 = z25 * (z1 * z41 - mu3 * z39);
    const double z44 = z24 * z32 + s_beta * z42 - (z38 + c_beta * z43);
    const double z45 = s_beta * z24 + c_beta * z27;
    const double z46 = r3 * z45 + r1 * z28 + (z6 * z36 + k2 * (z3 * z26));
    const double z47 = w2 * z37 + (g * mu3 + z7 * z44 + z45 * z46);
    const double z48 = mu2 * s_gamma;
    const double z49 = c_beta * z48 + s_beta * c_gamma;
    const double z50 = r1 * w2 + z7 * z45 + (z4 * z36 - k3 * (z3 * z35));
    const double z51 = z24 * z34 - c_beta * z42 + (z40 - s_beta * z43);
    const double z52 = w2 * z50 - (g * z1 + z7 * z51 - z28 * z46);
    const double z53 = c_beta * c_gamma - s_beta * z48;
    const double z54 = z45 * z50 - (r3 * z44 + (g * mu2 - r1 * z51) + z28 * z37);
    const double z55 = c_alpha * s_gamma;
    const double z56 = I_d * w2 + I_a * z45;
    const double z57 = I_d * z45 + I_b * w2;
    const double z58 = z27 * z57;
    const double z59 = z24 * z57;
    const double z60 = w2 * z56 - (I_c * z51 + (c_beta * z58 + (s_beta * z59 - (z7 * z52 - r1 * z54))));
    const double z61 = I_c * z28;
    const double z62 = w2 * z61 - (I_a * z44 - (s_beta * z58 - (c_beta * z59 - (r3 * z54 - z7 * z47))));
    const double z63 = I_d * z44 - (z28 * z56 - z45 * z61 + (r3 * z52 - r1 * z47)) + z15 * z62;
    const double z64 = (z60 + z19 * z62 + z22 * z63) / z23;
    const double z65 = z21 * z63 + z22 * z64;
    const double z66 = z14 * z62 + z15 * z65 + z19 * z64;
    const double z67 = z64 * (z7 * z53 - r1 * z55) + (z66 * (r3 * z55 - z7 * z49) - z65 * (r3 * z53 - r1 *
        z49));
    const double z68 = mu2 * c_gamma;
    const double z69 = c_beta * z68 - s_beta * s_gamma;
    const double z70 = c_beta * s_gamma + s_beta * z68;
    const double z71 = c_alpha * c_gamma;
    const double z72 = z64 * (z7 * z70 + r1 * z71) - (z66 * (r3 * z71 - z7 * z69) + z65 * (r3 * z70 + r1 *
        z69));
    const double z73 = z64 * (mu2 * r1 - z1 * z7) - (z66 * (mu2 * r3 + mu3 * z7) - z65 * (z1 * r3 + mu3 *
        r1));
    /* (I.4.1) 44:5 */
    lambda[0] = z67 - (z47 * z49 + (z52 * z53 + z54 * z55)); /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 45:5 */
    lambda[1] = z47 * z69 - (z52 * z70 - z54 * z71) + z72; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 46:5 */
    lambda[2] = z73 - (mu3 * z47 - (z1 * z52 + mu2 * z54)); /* reaction of roll_z: Q_i gains lambda_3 a_3i */
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
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);

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
    const double z25 = s_beta * mu2;
    const double z26 = k1 * z3;
    kept[34] = z26;
    const double z27 = z3 * z3;
    kept[35] = z27;
    const double z28 = z3 * z27;
    kept[36] = z28;
    const double z29 = c_beta * mu2;
    const double z30 = z28 * (z10 * z25 - c_alpha * z6 + z4 * z29);
    const double z31 = z25 * z26 - z10 * z30;
    const double w1 = y[6];
    const double w3 = y[8];
    const double z32 = z1 * w3 + mu3 * w1;
    kept[37] = z32;
    const double z33 = 1.0 / (c_alpha * c_alpha);
    kept[38] = z33;
    const double z34 = mu2 * z33;
    const double z35 = 1.0 / c_alpha;
    kept[39] = z35;
    const double z36 = z32 * z34 - z35 * (w3 * z25 + w1 * z29);
    const double z37 = c_beta * z36;
    const double z38 = s_beta * w1 - c_beta * w3;
    kept[40] = z38;
    const double z39 = s_beta * z38;
    const double z40 = z35 * z32;
    kept[41] = z40;
    const double z41 = c_beta * z40;
    const double z42 = z39 + z41;
    kept[42] = z42;
    const double z43 = k2 * z3;
    kept[43] = z43;
    const double z44 = z6 * z30 + c_alpha * z43;
    const double w2 = y[7];
    const double z45 = w2 * z31 - (z7 * z37 + z42 * z44);
    const double z46 = k3 * z3;
    kept[44] = z46;
    const double z47 = z4 * z30 - z29 * z46;
    const double z48 = s_beta * z36;
    const double z49 = c_beta * z38;
    const double z50 = s_beta * z40;
    const double z51 = z49 - z50;
    kept[45] = z51;
    const double z52 = w2 * z47 - (z7 * z48 - z51 * z44);
    const double z53 = s_beta * z45 - c_beta * z52;
    const double z54 = r3 * w2;
    kept[46] = z54;
    const double z55 = z7 * z51;
    kept[47] = z55;
    const double u1 = z54 - z55;
    kept[48] = u1;
    const double z56 = s_beta * u1;
    const double z57 = r1 * w2;
    kept[49] = z57;
    const double z58 = z7 * z42;
    kept[50] = z58;
    const double z59 = z57 + z58;
    kept[51] = z59;
    const double z60 = c_beta * z59;
    const double z61 = z56 + z60;
    const double z62 = r3 * z37 - z42 * z47 - (r1 * z48 + z51 * z31);
    const double z63 = r3 * z42;
    kept[52] = z63;
    const double z64 = r1 * z51;
    kept[53] = z64;
    const double z65 = z63 + z64;
    kept[54] = z65;
    const double z66 = s_beta * z52 + c_beta * z45;
    const double z67 = c_alpha * (z61 - z62) + mu2 * (z65 - z66);
    /* (I.2.15) */
    J[3] = c_gamma * z53 - s_gamma * z67;
    const double z68 = c_beta * w1 + s_beta * w3;
    const double z69 = z35 * (mu3 * w3 - z1 * w1);
    const double z70 = z49 + s_beta * z68 - (z50 - c_beta * z69);
    const double z71 = k4 * (mu3 * (z1 * z28));
    const double z72 = z4 * z71 + z1 * z46;
    const double z73 = z39 - c_beta * z68 + (z41 + s_beta * z69);
    const double z74 = mu3 * z26 - z10 * z71;
    const double z75 = r3 * z70 + z42 * z72 - (r1 * z73 - z51 * z74);
    const double z76 = c_beta * u1;
    const double z77 = z6 * z71;
    const double z78 = w2 * z72 + (z7 * z73 + z51 * z77);
    const double z79 = s_beta * z59;
    const double z80 = w2 * z74 + (z7 * z70 - z42 * z77);
    const double z81 = z76 + s_beta * z78 - (z79 - c_beta * z80);
    const double z82 = c_alpha * z75 - mu2 * z81;
    const double z83 = z60 + s_beta * z80 + (z56 - c_beta * z78);
    J[4] = s_gamma * z82 - c_gamma * z83;
    const double z84 = z79 - z76;
    const double z85 = c_alpha * z65;
    const double z86 = mu2 * z61;
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
    J[12] = s_gamma * z53 + c_gamma * z67;
    J[13] = -(s_gamma * z83 + c_gamma * z82);
    J[14] = s_gamma * z87 - c_gamma * z84;
    J[15] = c_gamma * z89 - s_gamma * z90;
    J[16] = c_gamma * z92 - s_gamma * z93;
    J[17] = s_gamma * z88 + c_gamma * z94;
    J[21] = z86 + c_alpha * z66 - (z85 + mu2 * z62);
    J[22] = -(mu2 * z75 + c_alpha * z81);
    J[24] = -(mu2 * r3 + c_alpha * z88);
    J[25] = -c_alpha * z91;
    J[26] = mu2 * r1 - c_alpha * z90;
    J[30] = z36;
    J[31] = z69;
    J[33] = c_beta;
    J[35] = s_beta;
    const double z95 = z38 * z34;
    J[39] = z38 + mu2 * z95;
    const double z96 = z35 * z68;
    J[40] = mu2 * z96;
    const double z97 = s_beta * z35;
    J[42] = mu2 * z97;
    J[43] = 1.0;
    const double z98 = c_beta * z35;
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
    const double z101 = r3 * z51;
    kept[57] = z101;
    const double z102 = z100 + z101;
    kept[58] = z102;
    const double z103 = z4 * z63 - z6 * z58 - z10 * z102;
    kept[59] = z103;
    const double z104 = z27 * z103;
    kept[60] = z104;
    const double z105 = z3 * z104;
    const double z106 = k2 * z105;
    kept[61] = z106;
    const double z107 = z35 * z38;
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
    const double z113 = z35 * z112;
    kept[68] = z113;
    const double z114 = c_beta * z110 - z1 * z113;
    kept[69] = z114;
    const double z115 = k3 * z105;
    kept[70] = z115;
    const double z116 = z107 * z114 - (mu3 * z115 - z63 * z46);
    kept[71] = z116;
    const double z117 = s_beta * z110 + mu3 * z113;
    kept[72] = z117;
    const double z118 = k1 * z105;
    kept[73] = z118;
    const double z119 = z107 * z117 - (z1 * z118 + z102 * z26);
    kept[74] = z119;
    const double z120 = z107 * z110 - c_beta * z116 - s_beta * z119;
    kept[75] = z120;
    const double z121 = z18 - z114;
    kept[76] = z121;
    const double z122 = z38 * z108 - z40 * z121 - c_alpha * z119;
    kept[77] = z122;
    const double z123 = z38 * z18;
    kept[78] = z123;
    const double z124 = z108 - z117;
    kept[79] = z124;
    const double z125 = z123 + z40 * z124 - c_alpha * z116;
    kept[80] = z125;
    const double z126 = c_beta * z122 - s_beta * z125;
    kept[81] = z126;
    const double z127 = mu2 * z40;
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
    const double z133 = z10 * z130 - z6 * z32 + z4 * z132;
    kept[88] = z133;
    const double z134 = z3 * z133;
    kept[89] = z134;
    const double z135 = z27 * z134;
    kept[90] = z135;
    const double z136 = z40 * z131;
    const double z137 = z136 + z107 * z130;
    kept[91] = z137;
    const double z138 = z40 * z129;
    kept[92] = z138;
    const double z139 = z138 + z107 * z132;
    kept[93] = z139;
    const double z140 = s_beta * z137 + c_beta * z139 - z107 * z127;
    kept[94] = z140;
    const double z141 = z1 * z139 - mu3 * z137;
    kept[95] = z141;
    const double z142 = z35 * z141;
    kept[96] = z142;
    const double z143 = z38 * z129 + s_beta * z140 - (z136 + c_beta * z142);
    kept[97] = z143;
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW static int rattleback_jacobian_part2(double t, const double *y, const double *p, double
    *kept, double *J)
{
    (void)t;
    const double z7 = kept[16];
    const double z143 = kept[97];
    const double z144 = z7 * z143;
    const double k1 = kept[4];
    const double z130 = kept[85];
    const double z145 = k1 * z130;
    const double z3 = kept[12];
    const double z10 = kept[19];
    const double z135 = kept[90];
    const double z146 = z3 * z145 - z10 * z135;
    const double u1 = kept[48];
    const double z147 = u1 - z146;
    const double k2 = kept[5];
    const double z32 = kept[37];
    const double z148 = k2 * z32;
    const double z6 = kept[15];
    const double z149 = z3 * z148 + z6 * z135;
    const double z65 = kept[54];
    const double z150 = z65 + z149;
    const double w2 = y[7];
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double mu3 = kept[10];
    const double z42 = kept[42];
    const double z151 = w2 * z147 + (g * mu3 + z144 + z42 * z150);
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double z152 = I_d * w2;
    const double I_a = p[4]; /* [cm^2] */
    const double z153 = z152 + I_a * z42;
    const double I_c = p[6]; /* [cm^2] */
    const double z51 = kept[45];
    const double z154 = I_c * z51;
    const double k3 = kept[6];
    const double z132 = kept[87];
    const double z155 = k3 * z132;
    const double z4 = kept[13];
    const double z156 = z3 * z155 - z4 * z135;
    const double z59 = kept[51];
    const double z157 = z59 - z156;
    const double s_beta = kept[2];
    const double c_beta = kept[3];
    const double z38 = kept[40];
    const double z131 = kept[86];
    const double z138 = kept[92];
    const double z140 = kept[94];
    const double z142 = kept[96];
    const double z158 = z38 * z131 - c_beta * z140 + (z138 - s_beta * z142);
    const double z159 = z7 * z158;
    const double z1 = kept[9];
    const double z160 = w2 * z157 - (g * z1 + z159 - z51 * z150);
    const double z161 = I_d * z42;
    const double I_b = p[5]; /* [cm^2] */
    const double z162 = z161 + I_b * w2;
    const double z40 = kept[41];
    const double z163 = z40 * z162;
    const double z164 = z38 * z162;
    const double r3 = kept[14];
    const double z165 = r3 * z143;
    const double r1 = kept[20];
    const double z166 = r1 * z158;
    const double mu2 = kept[1];
    const double z167 = z42 * z157 - (z165 + (g * mu2 - z166) + z51 * z147);
    const double z168 = w2 * z154 - (I_a * z143 - (s_beta * z163 - (c_beta * z164 - (r3 * z167 - z7 *
        z151))));
    const double z15 = kept[25];
    const double z169 = I_d * z143 - (z51 * z153 - z42 * z154 + (r3 * z160 - r1 * z151)) + z15 * z168;
    const double z24 = kept[33];
    const double z170 = 1.0 / z24;
    const double z171 = w2 * z153 - (I_c * z158 + (c_beta * z163 + (s_beta * z164 - (z7 * z160 - r1 *
        z167))));
    const double z19 = kept[29];
    const double z23 = kept[32];
    const double z172 = z170 * (z171 + z19 * z168 + z23 * z169);
    const double z22 = kept[31];
    const double z173 = z22 * z169 + z23 * z172;
    const double z174 = r1 * z173;
    const double z14 = kept[24];
    const double z175 = z14 * z168 + z15 * z173 + z19 * z172;
    const double z176 = z7 * z175;
    const double z63 = kept[52];
    const double z102 = kept[58];
    const double z177 = z51 * z102 + (z42 * z63 - (z144 + (z151 - z174 + 2.0 * z176)));
    const double z58 = kept[50];
    const double z99 = kept[55];
    const double z106 = kept[61];
    const double z107 = kept[62];
    const double z120 = kept[75];
    const double z126 = kept[81];
    const double z178 = z99 + (z32 * z106 - z40 * z120 + z107 * z126) + k2 * (z58 * z135 - z3 * z177);
    const double z2 = kept[11];
    const double z134 = kept[89];
    const double z179 = z134 / (z2 * z2);
    const double z180 = r1 * z172;
    const double z181 = r3 * z175;
    const double z182 = w2 * z102 + (z42 * z58 + (z165 - (z167 + z180 - 2.0 * z181)));
    const double z104 = kept[60];
    const double z133 = kept[88];
    const double z183 = z63 * z155 + z58 * z148 - z145 * z102 - z133 * z104 - z4 * z182 - z6 * z177;
    const double z184 = r3 * z158;
    const double z185 = r3 * z172;
    const double z186 = z7 * z173;
    const double z187 = w2 * z63 - (z51 * z58 - (z184 + (z185 + z186)));
    const double z28 = kept[36];
    const double z103 = kept[59];
    const double z188 = z103 * z179 - 0.5 * (z28 * (z183 - z10 * z187));
    const double z110 = kept[65];
    const double z114 = kept[69];
    const double z117 = kept[72];
    const double z127 = kept[82];
    const double z189 = z127 * z110 - z130 * z117 - z132 * z114 - mu2 * z126;
    const double z190 = s_beta * z162;
    const double z191 = I_d * z51;
    const double z192 = z7 * z65;
    const double z193 = r3 * z59;
    const double z194 = r3 * z156;
    const double z195 = z7 * z149;
    const double z196 = z7 * z63 - (r3 * z58 + (z191 + z192 - z193 + z194 + z195));
    const double z197 = r1 * z58 - (I_c * w2 + z7 * z102) + r3 * z147;
    const double z121 = kept[76];
    const double z124 = kept[79];
    const double z129 = kept[84];
    const double z198 = z190 + z131 * z124 + z129 * z121 + mu2 * z120 + c_beta * z196 + s_beta * z197;
    const double z199 = g * z7;
    const double z35 = kept[39];
    const double z43 = kept[43];
    const double z200 = mu2 * z106 + z58 * z43 - z35 * z198;
    const double w1 = y[6];
    const double z113 = kept[68];
    const double z115 = kept[70];
    const double z137 = kept[91];
    const double z201 = k3 * (z63 * z135 + (z3 * z182 - 2.0 * (mu3 * z188))) + (z132 * z115 - (z137 * z113 +
        (z199 + w1 * z200)));
    const double z33 = kept[38];
    const double z112 = kept[67];
    const double z116 = kept[71];
    const double z119 = kept[74];
    const double z141 = kept[95];
    const double z202 = z131 * z116 - z129 * z119 + z33 * (z141 * z112 + z38 * z189 + z32 * z198) - c_beta *
        z201;
    const double w3 = y[8];
    const double z118 = kept[73];
    const double z139 = kept[93];
    const double z203 = k1 * (z102 * z135 - (z3 * z187 - 2.0 * (z1 * z188))) - (z130 * z118 + (z139 * z113 -
        w3 * z200));
    const double c_alpha = kept[0];
    const double z204 = c_alpha * (z178 + 2.0 * (z6 * z188)) - mu2 * (z202 + s_beta * z203);
    const double z205 = r1 * z42;
    const double z101 = kept[57];
    const double z206 = z101 - z205;
    const double z54 = kept[46];
    const double z57 = kept[49];
    const double z207 = z4 * z54 + z6 * z206 - z10 * z57;
    const double z27 = kept[35];
    const double z208 = z27 * z207;
    const double z209 = z3 * z208;
    const double z210 = k2 * z209;
    const double z13 = kept[23];
    const double z20 = kept[30];
    const double z211 = s_beta * z13 - c_beta * z20;
    const double z212 = c_beta * z13 + s_beta * z20;
    const double z213 = z35 * z212;
    const double z214 = c_beta * z211 - z1 * z213;
    const double z215 = k3 * z209;
    const double z46 = kept[44];
    const double z216 = z107 * z214 - (mu3 * z215 - z54 * z46);
    const double z217 = s_beta * z211 + mu3 * z213;
    const double z218 = k1 * z209;
    const double z26 = kept[34];
    const double z219 = z107 * z217 - (z1 * z218 + z57 * z26);
    const double z220 = z107 * z211 - c_beta * z216 - s_beta * z219;
    const double z221 = z20 + z214;
    const double z222 = z38 * z13 + z40 * z221 - c_alpha * z219;
    const double z223 = z13 - z217;
    const double z224 = z38 * z20 - z40 * z223 + c_alpha * z216;
    const double z225 = c_beta * z222 + s_beta * z224;
    const double z226 = r1 * z143;
    const double z227 = r1 * z175;
    const double z228 = z57 * z51 + (z54 * z42 - (z184 + (z226 + (z185 + z227))));
    const double z229 = r3 * z173;
    const double z230 = z7 * z172;
    const double z231 = w2 * z57 - (z42 * z206 + (2.0 * z229 + (z160 - z230)));
    const double z232 = z54 * z155 - z148 * z206 - z57 * z145 - z133 * z208 - z4 * z231 - z6 * z228;
    const double z233 = w2 * z54 + (z51 * z206 - (z176 + (z151 - 2.0 * z174)));
    const double z234 = z207 * z179 - 0.5 * (z28 * (z232 - z10 * z233));
    const double z235 = z32 * z210 - z40 * z220 + z107 * z225 - k2 * (z206 * z135 + z3 * z228) + 2.0 * (z6 *
        z234);
    const double z236 = z127 * z211 - z130 * z217 - z132 * z214 - mu2 * z225;
    const double k6 = kept[8];
    const double z237 = z51 * k6 + (r3 * z206 + z7 * z54) - r1 * z150;
    const double z238 = z153 + (r1 * z206 - (I_c * z42 - z7 * z57)) + r3 * z150;
    const double z239 = z131 * z223 - z129 * z221 + mu2 * z220 + c_beta * z237 - s_beta * z238;
    const double z240 = g * r1;
    const double z241 = mu2 * z210 - z206 * z43 - z35 * z239;
    const double z242 = k3 * (z54 * z135 + (z3 * z231 - 2.0 * (mu3 * z234))) + (z132 * z215 - (z137 * z213 +
        (z240 + w1 * z241)));
    const double z243 = z131 * z216 - z129 * z219 + z33 * (z141 * z212 + z38 * z236 + z32 * z239) - c_beta *
        z242;
    const double z244 = k1 * (z57 * z135 - (z3 * z233 - 2.0 * (z1 * z234))) + (z99 - (z130 * z218 + (z139 *
        z213 - w3 * z241)));
    const double z245 = c_alpha * z235 - mu2 * (z243 + s_beta * z244) - z15 * z204;
    const double z100 = kept[56];
    const double z246 = z100 - z205;
    const double z55 = kept[47];
    const double z64 = kept[53];
    const double z247 = z4 * z246 + z6 * z55 + z10 * z64;
    const double z248 = z27 * z247;
    const double z249 = z3 * z248;
    const double z250 = k2 * z249;
    const double z8 = kept[17];
    const double z11 = kept[21];
    const double z251 = z8 + (I_c + z11);
    const double z111 = kept[66];
    const double z252 = z111 + c_beta * z251;
    const double z109 = kept[64];
    const double z253 = z109 - s_beta * z251;
    const double z254 = z35 * z253;
    const double z255 = c_beta * z252 - z1 * z254;
    const double z256 = k3 * z249;
    const double z257 = z107 * z255 + (mu3 * z256 - z246 * z46);
    const double z258 = s_beta * z252 + mu3 * z254;
    const double z259 = k1 * z249;
    const double z260 = z107 * z258 + (z1 * z259 - z64 * z26);
    const double z261 = z107 * z252 - c_beta * z257 - s_beta * z260;
    const double z262 = z251 - z255;
    const double z123 = kept[78];
    const double z263 = z123 - z40 * z262 - c_alpha * z260;
    const double z18 = kept[28];
    const double z264 = z18 - z258;
    const double z265 = z38 * z251 + z40 * z264 - c_alpha * z257;
    const double z266 = c_beta * z263 - s_beta * z265;
    const double z267 = z51 * z64 - (z42 * z246 - (z159 + (2.0 * z230 - (z160 + z229))));
    const double z268 = z240 - (z32 * z250 + z40 * z261 - z107 * z266) + k2 * (z55 * z135 - z3 * z267);
    const double z269 = w2 * z64 + (z55 * z42 + (z226 + (z186 + z227)));
    const double z270 = z155 * z246 - z55 * z148 + z64 * z145 - z133 * z248 + z4 * z269 + z6 * z267;
    const double z271 = w2 * z246 + (z51 * z55 - (z166 - (z181 - (z167 + 2.0 * z180))));
    const double z272 = z247 * z179 - 0.5 * (z28 * (z270 - z10 * z271));
    const double z273 = z127 * z252 - z130 * z258 - z132 * z255 - mu2 * z266;
    const double z274 = r1 * u1;
    const double z275 = r1 * z146;
    const double z276 = z7 * z64 - (r1 * z55 + (z195 + (z192 + z274 - z275)));
    const double z277 = c_beta * z162;
    const double z278 = z161 - (r3 * z55 + (I_a * w2 + z7 * z246)) + r1 * z157;
    const double z279 = s_beta * z276 - (z277 + z131 * z264 + z129 * z262 + mu2 * z261 + c_beta * z278);
    const double z280 = mu2 * z250 - z55 * z43 - z35 * z279;
    const double z281 = k3 * (z246 * z135 - (z3 * z269 + 2.0 * (mu3 * z272))) + (z132 * z256 + (z137 * z254 -
        w1 * z280));
    const double z282 = z131 * z257 - z129 * z260 + z33 * (z141 * z253 + z38 * z273 - z32 * z279) + c_beta *
        z281;
    const double z283 = k1 * (z64 * z135 + (z3 * z271 - 2.0 * (z1 * z272))) - (z199 - (z130 * z259 - (z139 *
        z254 + w3 * z280)));
    const double z284 = c_alpha * (z268 - 2.0 * (z6 * z272)) - mu2 * (z282 + s_beta * z283) - z19 * z204 +
        z23 * z245;
    const double z285 = z170 * z284;
    const double z286 = z22 * z245 + z23 * z285;
    /* (I.2.15) */
    J[57] = z19 * z285 - (z14 * z204 - z15 * z286);
    const double z287 = z142 * z18;
    const double z108 = kept[63];
    const double z125 = kept[80];
    const double z128 = kept[83];
    const double z288 = z163 - z140 * z108 - z287 - z137 * z110 - z127 * z119 + z128 * z125 + z38 * z196;
    const double z289 = z35 * z189 - (z277 + z129 * z108 - z131 * z18 - s_beta * z196 + c_beta * z197);
    const double z290 = z140 * z18;
    const double z122 = kept[77];
    const double z291 = z164 - z142 * z108 + z290 + z139 * z110 + z127 * z116 + z128 * z122 - z40 * z196;
    const double z292 = c_beta * (z288 + z40 * z197 + w1 * z289 - c_alpha * z203) + s_beta * (z291 + z38 *
        z197 + w3 * z289 - c_alpha * z201);
    const double z293 = z140 * z13 - z142 * z20 + z137 * z211 + z127 * z219 + z128 * z224 - z38 * z237;
    const double z294 = z35 * z236 - (z129 * z13 + z131 * z20 - s_beta * z237 - c_beta * z238);
    const double z295 = z142 * z13 + z140 * z20 - z139 * z211 - z127 * z216 - z128 * z222 + z40 * z237;
    const double z296 = c_beta * (z293 + z40 * z238 - w1 * z294 + c_alpha * z244) + s_beta * (z295 + z38 *
        z238 - w3 * z294 + c_alpha * z242);
    const double z297 = z296 + z15 * z292;
    const double z298 = z164 - z290 - z142 * z251 - z137 * z252 - z127 * z260 + z128 * z265 + z38 * z278;
    const double z299 = z35 * z273 + (c_beta * z276 + (z190 - z129 * z18 + z131 * z251 + s_beta * z278));
    const double z300 = z163 + z287 - z140 * z251 - z139 * z252 - z127 * z257 - z128 * z263 + z40 * z278;
    const double z301 = c_beta * (z40 * z276 - z298 - w1 * z299 + c_alpha * z283) + s_beta * (z38 * z276 +
        z300 - w3 * z299 - c_alpha * z281);
    const double z302 = z170 * (z301 + z19 * z292 + z23 * z297);
    const double z303 = z22 * z297 + z23 * z302;
    J[58] = z14 * z292 + z15 * z303 + z19 * z302;
    const double z304 = s_beta * z289 - mu3 * z200;
    const double z305 = s_beta * z294 - mu3 * z241 - z15 * z304;
    const double z306 = z170 * (s_beta * z299 + mu3 * z280 - z19 * z304 + z23 * z305);
    const double z307 = z22 * z305 + z23 * z306;
    J[60] = z14 * z304 - z15 * z307 - z19 * z306;
    const double k5 = kept[7];
    const double z308 = z7 * z147 + (z51 * k5 - (r1 * z63 - r3 * z102 - z126));
    const double z309 = r3 * z57 - (r1 * z54 - (z194 - (z193 + (z191 - z274) + z275) + z225)) - z15 * z308;
    const double z310 = z153 + (z266 + (r1 * z246 + (r3 * z64 - (z19 * z308 + (I_b * z42 - z23 * z309)))));
    const double z311 = z170 * (z7 * z157 + (z152 + z310));
    const double z312 = z22 * z309 + z23 * z311;
    J[61] = z19 * z311 - (z14 * z308 - z15 * z312);
    const double z313 = c_beta * z289 + z1 * z200;
    const double z314 = c_beta * z294 + z1 * z241 - z15 * z313;
    const double z315 = z170 * (c_beta * z299 - z1 * z280 - z19 * z313 + z23 * z314);
    const double z316 = z22 * z314 + z23 * z315;
    J[62] = z19 * z315 - (z14 * z313 - z15 * z316);
    J[66] = -z286;
    J[67] = -z303;
    J[69] = z307;
    J[70] = -z312;
    J[71] = -z316;
    J[75] = z285;
    J[76] = z302;
    J[78] = -z306;
    J[79] = z311;
    J[80] = z315;
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
    double kept[98]; /* what parts of this function leave for others */
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
    const rattleback_lanes z54 = z31 + (z4 * z53 - k3 * (z3 * z45));
    const rattleback_lanes z55 = z24 * z39 - c_beta * z47 + (z44 - s_beta * z48);
    const rattleback_lanes z56 = u1 - (k1 * (z3 * z42) - z10 * z53);
    const rattleback_lanes z57 = z28 * z54 - (r3 * z49 + (g * mu2 - r1 * z55) + z29 * z56);
    const rattleback_lanes z58 = z30 + (z6 * z53 + k2 * (z3 * z26));
    const rattleback_lanes z59 = w2 * z56 + (g * mu3 + z7 * z49 + z28 * z58);
    const rattleback_lanes z60 = w2 * z37 - (I_a * z49 - (s_beta * z51 - (c_beta * z52 - (r3 * z57 - z7 *
        z59))));
    const rattleback_lanes z61 = I_d * w2 + I_a * z28;
    const rattleback_lanes z62 = w2 * z54 - (g * z1 + z7 * z55 - z29 * z58);
    const rattleback_lanes z63 = I_d * z49 - (z29 * z61 - z28 * z37 + (r3 * z62 - r1 * z59)) + z15 * z60;
    const rattleback_lanes z64 = w2 * z61 - (I_c * z55 + (c_beta * z51 + (s_beta * z52 - (z7 * z62 - r1 *
        z57))));
    const rattleback_lanes z65 = (z64 + z19 * z60 + z22 * z63) / z23;
    const rattleback_lanes z66 = z21 * z63 + z22 * z65;
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
    const rattleback_lanes slope7 = z14 * z60 + z15 * z66 + z19 * z65;
    sum += slope7;
    rattleback_put(dydt + 6 * stride, slope7);
    const rattleback_lanes slope8 = -z66;
    sum += slope8;
    rattleback_put(dydt + 7 * stride, slope8);
    const rattleback_lanes slope9 = z65;
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
