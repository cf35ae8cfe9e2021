/*
 * rattleback.c: rattleback, emitted by nhc 0.1.0 (nhc:0ee0fc5daffb0ad5)
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
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double z3 = mu3 * k3;
    const double r3 = h - z2 * z3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    const double z6 = z2 * z5;
    const double z7 = z6 * z6;
    const double z8 = I_a + (z4 + z7);
    const double z9 = z1 * k1;
    const double r1 = z9 * z2;
    const double z10 = r1 * r1;
    const double z11 = I_b + (z4 + z10);
    const double z12 = I_d + r1 * z6;
    const double z13 = 1.0 / z8;
    const double z14 = z12 * z13;
    const double z15 = z11 - z12 * z14;
    const double z16 = I_c + (z7 + z10);
    const double z17 = r1 * r3;
    const double z18 = z17 * z13;
    const double z19 = z6 * r3 + z12 * z18;
    const double z20 = 1.0 / z15;
    const double z21 = z19 * z20;
    const double z22 = z16 - z17 * z18 - z19 * z21;
    const double z23 = s_beta * w1 - c_beta * w3;
    const double z24 = 1.0 / c_alpha;
    const double z25 = z1 * w3 + mu3 * w1;
    const double z26 = z24 * z25;
    const double z27 = s_beta * z23 + c_beta * z26;
    const double z28 = c_beta * z23 - s_beta * z26;
    const double z29 = r3 * z27 + r1 * z28;
    const double u1 = r3 * w2 - z6 * z28;
    const double z30 = r1 * w2 + z6 * z27;
    const double z31 = s_beta * u1 + c_beta * z30;
    const double z32 = c_alpha * z29 - mu2 * z31;
    const double z33 = s_beta * z30 - c_beta * u1;
    const double z34 = z24 * z23;
    const double z35 = w2 + mu2 * z34;
    const double z36 = I_c * z28;
    const double z37 = c_beta * z35;
    const double z38 = s_beta * z35;
    const double z39 = z26 * z38;
    const double z40 = mu2 * z26;
    const double z41 = s_beta * z40 - c_alpha * z37;
    const double z42 = z39 + z34 * z41;
    const double z43 = z26 * z37;
    const double z44 = c_alpha * z38 + c_beta * z40;
    const double z45 = z43 + z34 * z44;
    const double z46 = s_beta * z42 + c_beta * z45 - z34 * z40;
    const double z47 = z24 * (z1 * z45 - mu3 * z42);
    const double z48 = z23 * z37 + s_beta * z46 - (z39 + c_beta * z47);
    const double z49 = I_d * z27 + I_b * w2;
    const double z50 = z26 * z49;
    const double z51 = z23 * z49;
    const double z52 = (z9 * z41 - z5 * z25 + z3 * z44) * (z2 * (z2 * z2));
    const double z53 = z3 * z52 - k3 * (z2 * z44);
    const double z54 = z23 * z38 - c_beta * z46 + (z43 - s_beta * z47);
    const double z55 = k1 * (z2 * z41) - z9 * z52;
    const double z56 = z28 * u1 - z27 * z30 + (r3 * z48 - z27 * z53 - (r1 * z54 + z28 * z55));
    const double z57 = g * mu2 + z56;
    const double z58 = z5 * z52 + k2 * (z2 * z25);
    const double z59 = g * mu3 + (z27 * z29 + w2 * u1 + (z6 * z48 + z27 * z58 - w2 * z55));
    const double z60 = w2 * z36 - (I_a * z48 - (s_beta * z50 - (c_beta * z51 + (r3 * z57 + z6 * z59))));
    const double z61 = I_d * w2 + I_a * z27;
    const double z62 = g * z1 - (w2 * z30 + z28 * z29 - (z6 * z54 - z28 * z58 - w2 * z53));
    const double z63 = I_d * z48 - (z28 * z61 - z27 * z36 - (r3 * z62 + r1 * z59)) + z14 * z60;
    const double z64 = w2 * z61 - (I_c * z54 + (c_beta * z50 + (s_beta * z51 + (z6 * z62 - r1 * z57))));
    const double z65 = (z64 + z18 * z60 + z21 * z63) / z22;
    const double z66 = z20 * z63 + z21 * z65;
    /* (I.2.15) */
    dydt[0] = s_gamma * z32 - c_gamma * z33; /* x' */
    dydt[1] = -(s_gamma * z33 + c_gamma * z32); /* y' */
    dydt[2] = -(mu2 * z29 + c_alpha * z31); /* z' */
    dydt[3] = z26; /* alpha' */
    dydt[4] = z35; /* beta' */
    dydt[5] = -z34; /* gamma' */
    /* (I.2.15) 41:4 */
    dydt[6] = z13 * z60 + z14 * z66 + z18 * z65; /* w1' */
    dydt[7] = -z66; /* w2' */
    dydt[8] = z65; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z15) > 1e-14 * z11
        && fabs(z22) > 1e-14 * z16)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z8) > 0.0)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z15) > 1e-14 * z11)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * z16)) {
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
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double z3 = mu3 * k3;
    const double r3 = h - z2 * z3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    const double z6 = z2 * z5;
    const double z7 = z6 * z6;
    const double z8 = I_a + (z4 + z7);
    const double z9 = z1 * k1;
    const double r1 = z9 * z2;
    const double z10 = r1 * r1;
    const double z11 = I_b + (z4 + z10);
    const double z12 = I_d + r1 * z6;
    const double z13 = 1.0 / z8;
    const double z14 = z12 * z13;
    const double z15 = z11 - z12 * z14;
    const double z16 = I_c + (z7 + z10);
    const double z17 = r1 * r3;
    const double z18 = z17 * z13;
    const double z19 = z6 * r3 + z12 * z18;
    const double z20 = 1.0 / z15;
    const double z21 = z19 * z20;
    const double z22 = z16 - z17 * z18 - z19 * z21;
    const double z23 = s_beta * w1 - c_beta * w3;
    const double z24 = 1.0 / c_alpha;
    const double z25 = z1 * w3 + mu3 * w1;
    const double z26 = z24 * z25;
    const double z27 = s_beta * z23 + c_beta * z26;
    const double z28 = c_beta * z23 - s_beta * z26;
    const double z29 = r3 * z27 + r1 * z28;
    const double u1 = r3 * w2 - z6 * z28;
    const double z30 = r1 * w2 + z6 * z27;
    const double z31 = s_beta * u1 + c_beta * z30;
    const double z32 = c_alpha * z29 - mu2 * z31;
    const double z33 = z24 * z23;
    const double z34 = c_gamma * z33;
    const double z35 = mu2 * z26;
    const double z36 = w2 + mu2 * z33;
    const double z37 = c_beta * z36;
    const double z38 = s_beta * z35 - c_alpha * z37;
    const double z39 = s_beta * z36;
    const double z40 = c_alpha * z39 + c_beta * z35;
    const double z41 = (z9 * z38 - z5 * z25 + z3 * z40) * (z2 * (z2 * z2));
    const double z42 = z3 * z41 - k3 * (z2 * z40);
    const double z43 = z27 * z42;
    const double z44 = z23 * z37;
    const double z45 = I_c * z28;
    const double z46 = z26 * z39;
    const double z47 = z46 + z33 * z38;
    const double z48 = z26 * z37;
    const double z49 = z48 + z33 * z40;
    const double z50 = s_beta * z47 + c_beta * z49 - z33 * z35;
    const double z51 = z24 * (z1 * z49 - mu3 * z47);
    const double z52 = z44 + s_beta * z50 - (z46 + c_beta * z51);
    const double z53 = I_d * z27 + I_b * w2;
    const double z54 = z26 * z53;
    const double z55 = z23 * z53;
    const double z56 = z23 * z39;
    const double z57 = z56 - c_beta * z50 + (z48 - s_beta * z51);
    const double z58 = k1 * (z2 * z38) - z9 * z41;
    const double z59 = z28 * z58;
    const double z60 = g * mu2 + (z28 * u1 - z27 * z30 + (r3 * z52 - z43 - (r1 * z57 + z59)));
    const double z61 = z5 * z41 + k2 * (z2 * z25);
    const double z62 = z27 * z61;
    const double z63 = w2 * z58;
    const double z64 = g * mu3 + (z27 * z29 + w2 * u1 + (z6 * z52 + z62 - z63));
    const double z65 = w2 * z45 - (I_a * z52 - (s_beta * z54 - (c_beta * z55 + (r3 * z60 + z6 * z64))));
    const double z66 = I_d * w2 + I_a * z27;
    const double z67 = z28 * z61;
    const double z68 = w2 * z42;
    const double z69 = g * z1 - (w2 * z30 + z28 * z29 - (z6 * z57 - z67 - z68));
    const double z70 = I_d * z52 - (z28 * z66 - z27 * z45 - (r3 * z69 + r1 * z64)) + z14 * z65;
    const double z71 = w2 * z66 - (I_c * z57 + (c_beta * z54 + (s_beta * z55 + (z6 * z69 - r1 * z60))));
    const double z72 = (z71 + z18 * z65 + z21 * z70) / z22;
    const double z73 = z20 * z70 + z21 * z72;
    const double z74 = z13 * z65 + z14 * z73 + z18 * z72;
    const double z75 = w1 * z37 + s_beta * z74 + (w3 * z39 - c_beta * z72);
    const double z76 = z35 * (z24 * z24);
    const double z77 = z25 * z76 - z24 * (w3 * z38 - z1 * z72 + (w1 * z40 - mu3 * z74));
    const double z78 = z44 + s_beta * z75 - (z46 - c_beta * z77);
    const double z79 = z56 - c_beta * z75 + (z48 + s_beta * z77);
    const double z80 = z43 - r3 * z78 + (z59 + r1 * z79);
    const double z81 = z68 + r3 * z73 + (z67 - z6 * z79);
    const double z82 = z63 + r1 * z73 - (z62 + z6 * z78);
    const double z83 = u1 * z37 - s_beta * z81 - (z30 * z39 + c_beta * z82);
    const double z84 = z29 * z35 + c_alpha * z80 + (z25 * z31 + mu2 * z83);
    const double z85 = s_beta * z30 - c_beta * u1;
    const double z86 = s_gamma * z33;
    const double z87 = z30 * z37 - s_beta * z82 + (u1 * z39 + c_beta * z81);
    const double z88 = z23 * z76 + z24 * z75;
    /* (I.2.15) */
    qddot[0] = -(z32 * z34 + s_gamma * z84 + (z85 * z86 + c_gamma * z87)); /* x'' */
    qddot[1] = z85 * z34 - s_gamma * z87 - (z32 * z86 - c_gamma * z84); /* y'' */
    qddot[2] = z31 * z35 - c_alpha * z83 - (z25 * z29 - mu2 * z80); /* z'' */
    qddot[3] = z77; /* alpha'' */
    qddot[4] = z25 * z33 + mu2 * z88 - z73; /* beta'' */
    qddot[5] = -z88; /* gamma'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z15) > 1e-14 * z11
        && fabs(z22) > 1e-14 * z16)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z8) > 0.0)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z15) > 1e-14 * z11)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * z16)) {
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
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double z3 = mu3 * k3;
    const double r3 = h - z2 * z3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    const double z6 = z2 * z5;
    const double z7 = z6 * z6;
    const double z8 = I_a + (z4 + z7);
    const double z9 = z1 * k1;
    const double r1 = z9 * z2;
    const double z10 = r1 * r1;
    const double z11 = I_b + (z4 + z10);
    const double z12 = I_d + r1 * z6;
    const double z13 = 1.0 / z8;
    const double z14 = z12 * z13;
    const double z15 = z11 - z12 * z14;
    const double z16 = I_c + (z7 + z10);
    const double z17 = r1 * r3;
    const double z18 = z17 * z13;
    const double z19 = z6 * r3 + z12 * z18;
    const double z20 = 1.0 / z15;
    const double z21 = z19 * z20;
    const double z22 = z16 - z17 * z18 - z19 * z21;
    const double z23 = s_beta * w1 - c_beta * w3;
    const double z24 = 1.0 / c_alpha;
    const double z25 = z1 * w3 + mu3 * w1;
    const double z26 = z24 * z25;
    const double z27 = s_beta * z23 + c_beta * z26;
    const double z28 = c_beta * z23 - s_beta * z26;
    const double z29 = r3 * z27 + r1 * z28;
    const double u1 = r3 * w2 - z6 * z28;
    const double z30 = z24 * z23;
    const double z31 = w2 + mu2 * z30;
    const double z32 = c_beta * z31;
    const double z33 = s_beta * z31;
    const double z34 = z26 * z33;
    const double z35 = mu2 * z26;
    const double z36 = s_beta * z35 - c_alpha * z32;
    const double z37 = z34 + z30 * z36;
    const double z38 = z26 * z32;
    const double z39 = c_alpha * z33 + c_beta * z35;
    const double z40 = z38 + z30 * z39;
    const double z41 = s_beta * z37 + c_beta * z40 - z30 * z35;
    const double z42 = z24 * (z1 * z40 - mu3 * z37);
    const double z43 = z23 * z32 + s_beta * z41 - (z34 + c_beta * z42);
    const double z44 = (z9 * z36 - z5 * z25 + z3 * z39) * (z2 * (z2 * z2));
    const double z45 = z5 * z44 + k2 * (z2 * z25);
    const double z46 = k1 * (z2 * z36) - z9 * z44;
    const double z47 = g * mu3 + (z27 * z29 + w2 * u1 + (z6 * z43 + z27 * z45 - w2 * z46));
    const double z48 = mu2 * s_gamma;
    const double z49 = c_beta * z48 + s_beta * c_gamma;
    const double z50 = r1 * w2 + z6 * z27;
    const double z51 = z23 * z33 - c_beta * z41 + (z38 - s_beta * z42);
    const double z52 = z3 * z44 - k3 * (z2 * z39);
    const double z53 = g * z1 - (w2 * z50 + z28 * z29 - (z6 * z51 - z28 * z45 - w2 * z52));
    const double z54 = c_beta * c_gamma - s_beta * z48;
    const double z55 = z28 * u1 - z27 * z50 + (r3 * z43 - z27 * z52 - (r1 * z51 + z28 * z46));
    const double z56 = g * mu2 + z55;
    const double z57 = c_alpha * s_gamma;
    const double z58 = I_d * w2 + I_a * z27;
    const double z59 = I_d * z27 + I_b * w2;
    const double z60 = z26 * z59;
    const double z61 = z23 * z59;
    const double z62 = w2 * z58 - (I_c * z51 + (c_beta * z60 + (s_beta * z61 + (z6 * z53 - r1 * z56))));
    const double z63 = I_c * z28;
    const double z64 = w2 * z63 - (I_a * z43 - (s_beta * z60 - (c_beta * z61 + (r3 * z56 + z6 * z47))));
    const double z65 = I_d * z43 - (z28 * z58 - z27 * z63 - (r3 * z53 + r1 * z47)) + z14 * z64;
    const double z66 = (z62 + z18 * z64 + z21 * z65) / z22;
    const double z67 = z20 * z65 + z21 * z66;
    const double z68 = z13 * z64 + z14 * z67 + z18 * z66;
    const double z69 = z66 * (z6 * z54 - r1 * z57) + (z68 * (r3 * z57 - z6 * z49) - z67 * (r3 * z54 - r1 *
        z49));
    const double z70 = mu2 * c_gamma;
    const double z71 = c_beta * z70 - s_beta * s_gamma;
    const double z72 = c_beta * s_gamma + s_beta * z70;
    const double z73 = c_alpha * c_gamma;
    const double z74 = z66 * (z6 * z72 + r1 * z73) - (z68 * (r3 * z73 - z6 * z71) + z67 * (r3 * z72 + r1 *
        z71));
    const double z75 = z66 * (mu2 * r1 - z1 * z6) - (z68 * (mu2 * r3 + mu3 * z6) - z67 * (z1 * r3 + mu3 *
        r1));
    /* (I.4.1) 44:5 */
    lambda[0] = z69 - (z47 * z49 - (z53 * z54 + z56 * z57)); /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 45:5 */
    lambda[1] = z47 * z71 + (z53 * z72 - z56 * z73) + z74; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 46:5 */
    lambda[2] = z75 - (mu3 * z47 + (z1 * z53 + mu2 * z56)); /* reaction of roll_z: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1] + lambda[2]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z15) > 1e-14 * z11
        && fabs(z22) > 1e-14 * z16)) {
        /* the coframe is singular */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return RATTLEBACK_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z8) > 0.0)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z15) > 1e-14 * z11)) {
            return RATTLEBACK_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * z16)) {
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
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    kept[11] = z2;
    const double z3 = mu3 * k3;
    kept[12] = z3;
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double r3 = h - z2 * z3;
    kept[13] = r3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    kept[14] = z5;
    const double z6 = z2 * z5;
    kept[15] = z6;
    const double z7 = z6 * z6;
    kept[16] = z7;
    const double z8 = I_a + (z4 + z7);
    kept[17] = z8;
    const double z9 = z1 * k1;
    kept[18] = z9;
    const double r1 = z9 * z2;
    kept[19] = r1;
    const double z10 = r1 * r1;
    kept[20] = z10;
    const double z11 = I_b + (z4 + z10);
    kept[21] = z11;
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double z12 = I_d + r1 * z6;
    kept[22] = z12;
    const double z13 = 1.0 / z8;
    kept[23] = z13;
    const double z14 = z12 * z13;
    kept[24] = z14;
    const double z15 = z11 - z12 * z14;
    kept[25] = z15;
    const double z16 = I_c + (z7 + z10);
    kept[26] = z16;
    const double z17 = r1 * r3;
    kept[27] = z17;
    const double z18 = z17 * z13;
    kept[28] = z18;
    const double z19 = z6 * r3;
    kept[29] = z19;
    const double z20 = z19 + z12 * z18;
    const double z21 = 1.0 / z15;
    kept[30] = z21;
    const double z22 = z20 * z21;
    kept[31] = z22;
    const double z23 = z16 - z17 * z18 - z20 * z22;
    kept[32] = z23;
    const double w1 = y[6];
    const double w3 = y[8];
    const double z24 = s_beta * w1 - c_beta * w3;
    kept[33] = z24;
    const double z25 = s_beta * z24;
    const double z26 = 1.0 / c_alpha;
    kept[34] = z26;
    const double z27 = z1 * w3 + mu3 * w1;
    kept[35] = z27;
    const double z28 = z26 * z27;
    kept[36] = z28;
    const double z29 = c_beta * z28;
    const double z30 = z25 + z29;
    kept[37] = z30;
    const double z31 = r3 * z30;
    kept[38] = z31;
    const double z32 = c_beta * z24;
    const double z33 = s_beta * z28;
    const double z34 = z32 - z33;
    kept[39] = z34;
    const double z35 = r1 * z34;
    kept[40] = z35;
    const double z36 = z31 + z35;
    kept[41] = z36;
    const double z37 = z26 * z26;
    kept[42] = z37;
    const double z38 = mu2 * z37;
    const double z39 = s_beta * mu2;
    const double z40 = c_beta * mu2;
    const double z41 = z27 * z38 - z26 * (w3 * z39 + w1 * z40);
    const double z42 = c_beta * z41;
    const double z43 = z2 * z2;
    kept[43] = z43;
    const double z44 = z2 * z43;
    kept[44] = z44;
    const double z45 = z44 * (z9 * z39 - c_alpha * z5 + z3 * z40);
    const double z46 = k3 * z2;
    kept[45] = z46;
    const double z47 = z3 * z45 - z40 * z46;
    const double z48 = s_beta * z41;
    const double z49 = k1 * z2;
    kept[46] = z49;
    const double z50 = z39 * z49 - z9 * z45;
    const double z51 = r3 * z42 - z30 * z47 - (r1 * z48 + z34 * z50);
    const double w2 = y[7];
    const double z52 = r3 * w2;
    kept[47] = z52;
    const double z53 = z6 * z34;
    kept[48] = z53;
    const double u1 = z52 - z53;
    kept[49] = u1;
    const double z54 = s_beta * u1;
    const double z55 = r1 * w2;
    kept[50] = z55;
    const double z56 = z6 * z30;
    kept[51] = z56;
    const double z57 = z55 + z56;
    kept[52] = z57;
    const double z58 = c_beta * z57;
    const double z59 = z54 + z58;
    const double z60 = k2 * z2;
    kept[53] = z60;
    const double z61 = z5 * z45 + c_alpha * z60;
    const double z62 = w2 * z47 - (z6 * z48 - z34 * z61);
    const double z63 = w2 * z50 - (z6 * z42 + z30 * z61);
    const double z64 = s_beta * z62 + c_beta * z63;
    const double z65 = mu2 * z36 - c_alpha * z51 + (c_alpha * z59 - mu2 * z64);
    const double z66 = s_beta * z63 - c_beta * z62;
    /* (I.2.15) */
    J[3] = c_gamma * z66 - s_gamma * z65;
    const double z67 = c_beta * w1 + s_beta * w3;
    const double z68 = z26 * (mu3 * w3 - z1 * w1);
    const double z69 = z32 + s_beta * z67 - (z33 - c_beta * z68);
    const double z70 = k4 * (mu3 * (z1 * z44));
    const double z71 = z3 * z70 + z1 * z46;
    const double z72 = z25 - c_beta * z67 + (z29 + s_beta * z68);
    const double z73 = mu3 * z49 - z9 * z70;
    const double z74 = r3 * z69 + z30 * z71 - (r1 * z72 - z34 * z73);
    const double z75 = c_beta * u1;
    const double z76 = z5 * z70;
    const double z77 = w2 * z71 + (z6 * z72 + z34 * z76);
    const double z78 = s_beta * z57;
    const double z79 = w2 * z73 + (z6 * z69 - z30 * z76);
    const double z80 = z75 + s_beta * z77 - (z78 - c_beta * z79);
    const double z81 = c_alpha * z74 - mu2 * z80;
    const double z82 = z58 + s_beta * z79 + (z54 - c_beta * z77);
    J[4] = s_gamma * z81 - c_gamma * z82;
    const double z83 = z78 - z75;
    const double z84 = c_alpha * z36;
    const double z85 = mu2 * z59;
    const double z86 = z84 - z85;
    J[5] = s_gamma * z83 + c_gamma * z86;
    const double z87 = c_beta * z6;
    const double z88 = mu2 * z87 - c_alpha * r3;
    const double z89 = s_beta * z6;
    J[6] = -(s_gamma * z88 + c_gamma * z89);
    const double z90 = s_beta * r3 + c_beta * r1;
    const double z91 = mu2 * z90;
    const double z92 = s_beta * r1 - c_beta * r3;
    J[7] = -(s_gamma * z91 + c_gamma * z92);
    const double z93 = mu2 * z89 + c_alpha * r1;
    J[8] = c_gamma * z87 - s_gamma * z93;
    J[12] = s_gamma * z66 + c_gamma * z65;
    J[13] = -(s_gamma * z82 + c_gamma * z81);
    J[14] = s_gamma * z86 - c_gamma * z83;
    J[15] = c_gamma * z88 - s_gamma * z89;
    J[16] = c_gamma * z91 - s_gamma * z92;
    J[17] = s_gamma * z87 + c_gamma * z93;
    J[21] = z85 + c_alpha * z64 - (z84 + mu2 * z51);
    J[22] = -(mu2 * z74 + c_alpha * z80);
    J[24] = -(mu2 * r3 + c_alpha * z87);
    J[25] = -c_alpha * z90;
    J[26] = mu2 * r1 - c_alpha * z89;
    J[30] = z41;
    J[31] = z68;
    J[33] = c_beta;
    J[35] = s_beta;
    const double z94 = z24 * z38;
    J[39] = z24 + mu2 * z94;
    const double z95 = z26 * z67;
    J[40] = mu2 * z95;
    const double z96 = s_beta * z26;
    J[42] = mu2 * z96;
    J[43] = 1.0;
    const double z97 = c_beta * z26;
    J[44] = -mu2 * z97;
    J[48] = -z94;
    J[49] = -z95;
    J[51] = -z96;
    J[53] = z97;
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double z98 = g * r3;
    kept[54] = z98;
    const double z99 = z6 * w2;
    kept[55] = z99;
    const double z100 = r3 * z34;
    kept[56] = z100;
    const double z101 = z99 + z100;
    kept[57] = z101;
    const double z102 = z3 * z31 - z5 * z56 - z9 * z101;
    kept[58] = z102;
    const double z103 = z43 * z102;
    kept[59] = z103;
    const double z104 = z2 * z103;
    const double z105 = k2 * z104;
    kept[60] = z105;
    const double z106 = z26 * z24;
    kept[61] = z106;
    const double z107 = z7 + (I_a + z4);
    kept[62] = z107;
    const double z108 = c_beta * z17;
    kept[63] = z108;
    const double z109 = s_beta * z107 + z108;
    kept[64] = z109;
    const double z110 = s_beta * z17;
    kept[65] = z110;
    const double z111 = c_beta * z107 - z110;
    kept[66] = z111;
    const double z112 = z26 * z111;
    kept[67] = z112;
    const double z113 = c_beta * z109 - z1 * z112;
    kept[68] = z113;
    const double z114 = k3 * z104;
    kept[69] = z114;
    const double z115 = z106 * z113 - (mu3 * z114 - z31 * z46);
    kept[70] = z115;
    const double z116 = s_beta * z109 + mu3 * z112;
    kept[71] = z116;
    const double z117 = k1 * z104;
    kept[72] = z117;
    const double z118 = z106 * z116 - (z1 * z117 + z101 * z49);
    kept[73] = z118;
    const double z119 = z106 * z109 - c_beta * z115 - s_beta * z118;
    kept[74] = z119;
    const double z120 = z17 - z113;
    kept[75] = z120;
    const double z121 = z24 * z107 - z28 * z120 - c_alpha * z118;
    kept[76] = z121;
    const double z122 = z24 * z17;
    kept[77] = z122;
    const double z123 = z107 - z116;
    kept[78] = z123;
    const double z124 = z122 + z28 * z123 - c_alpha * z115;
    kept[79] = z124;
    const double z125 = c_beta * z121 - s_beta * z124;
    kept[80] = z125;
    const double z126 = mu2 * z28;
    kept[81] = z126;
    const double z127 = w2 + mu2 * z106;
    kept[82] = z127;
    const double z128 = c_beta * z127;
    kept[83] = z128;
    const double z129 = s_beta * z126 - c_alpha * z128;
    kept[84] = z129;
    const double z130 = s_beta * z127;
    kept[85] = z130;
    const double z131 = c_alpha * z130 + c_beta * z126;
    kept[86] = z131;
    const double z132 = z9 * z129 - z5 * z27 + z3 * z131;
    kept[87] = z132;
    const double z133 = z2 * z132;
    kept[88] = z133;
    const double z134 = z43 * z133;
    kept[89] = z134;
    const double z135 = z28 * z130;
    const double z136 = z135 + z106 * z129;
    kept[90] = z136;
    const double z137 = z28 * z128;
    kept[91] = z137;
    const double z138 = z137 + z106 * z131;
    kept[92] = z138;
    const double z139 = s_beta * z136 + c_beta * z138 - z106 * z126;
    kept[93] = z139;
    const double z140 = z1 * z138 - mu3 * z136;
    kept[94] = z140;
    const double z141 = z26 * z140;
    kept[95] = z141;
    const double z142 = z24 * z128 + s_beta * z139 - (z135 + c_beta * z141);
    kept[96] = z142;
    const double z143 = z6 * z142;
    kept[97] = z143;
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW static int rattleback_jacobian_part2(double t, const double *y, const double *p, double
    *kept, double *J)
{
    (void)t;
    const double k2 = kept[5];
    const double z27 = kept[35];
    const double z144 = k2 * z27;
    const double z2 = kept[11];
    const double z5 = kept[14];
    const double z134 = kept[89];
    const double z145 = z2 * z144 + z5 * z134;
    const double k1 = kept[4];
    const double z129 = kept[84];
    const double z146 = k1 * z129;
    const double z9 = kept[18];
    const double z147 = z2 * z146 - z9 * z134;
    const double w2 = y[7];
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double mu3 = kept[10];
    const double z30 = kept[37];
    const double z36 = kept[41];
    const double u1 = kept[49];
    const double z143 = kept[97];
    const double z148 = g * mu3 + (z30 * z36 + w2 * u1 + (z143 + z30 * z145 - w2 * z147));
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double z149 = I_d * w2;
    const double I_a = p[4]; /* [cm^2] */
    const double z150 = z149 + I_a * z30;
    const double I_c = p[6]; /* [cm^2] */
    const double z34 = kept[39];
    const double z151 = I_c * z34;
    const double s_beta = kept[2];
    const double c_beta = kept[3];
    const double z24 = kept[33];
    const double z130 = kept[85];
    const double z137 = kept[91];
    const double z139 = kept[93];
    const double z141 = kept[95];
    const double z152 = z24 * z130 - c_beta * z139 + (z137 - s_beta * z141);
    const double z6 = kept[15];
    const double z153 = z6 * z152;
    const double k3 = kept[6];
    const double z131 = kept[86];
    const double z154 = k3 * z131;
    const double z3 = kept[12];
    const double z155 = z2 * z154 - z3 * z134;
    const double z1 = kept[9];
    const double z57 = kept[52];
    const double z156 = g * z1 - (w2 * z57 + z34 * z36 - (z153 - z34 * z145 + w2 * z155));
    const double z157 = I_d * z30;
    const double I_b = p[5]; /* [cm^2] */
    const double z158 = z157 + I_b * w2;
    const double z28 = kept[36];
    const double z159 = z28 * z158;
    const double z160 = z24 * z158;
    const double r3 = kept[13];
    const double z142 = kept[96];
    const double z161 = r3 * z142;
    const double r1 = kept[19];
    const double z162 = r1 * z152;
    const double mu2 = kept[1];
    const double z163 = g * mu2 + (z34 * u1 - z30 * z57 + (z161 + z30 * z155 - (z162 + z34 * z147)));
    const double z164 = w2 * z151 - (I_a * z142 - (s_beta * z159 - (c_beta * z160 + (r3 * z163 + z6 *
        z148))));
    const double z14 = kept[24];
    const double z165 = I_d * z142 - (z34 * z150 - z30 * z151 - (r3 * z156 + r1 * z148)) + z14 * z164;
    const double z23 = kept[32];
    const double z166 = 1.0 / z23;
    const double z167 = w2 * z150 - (I_c * z152 + (c_beta * z159 + (s_beta * z160 + (z6 * z156 - r1 *
        z163))));
    const double z18 = kept[28];
    const double z22 = kept[31];
    const double z168 = z166 * (z167 + z18 * z164 + z22 * z165);
    const double z21 = kept[30];
    const double z169 = z21 * z165 + z22 * z168;
    const double z170 = r1 * z169;
    const double z13 = kept[23];
    const double z171 = z13 * z164 + z14 * z169 + z18 * z168;
    const double z172 = z6 * z171;
    const double z31 = kept[38];
    const double z101 = kept[57];
    const double z173 = z34 * z101 + (z30 * z31 - (z143 + (z148 - z170 + 2.0 * z172)));
    const double z56 = kept[51];
    const double z98 = kept[54];
    const double z105 = kept[60];
    const double z106 = kept[61];
    const double z119 = kept[74];
    const double z125 = kept[80];
    const double z174 = z98 + (z27 * z105 - z28 * z119 + z106 * z125) + k2 * (z56 * z134 - z2 * z173);
    const double z43 = kept[43];
    const double z133 = kept[88];
    const double z175 = z43 * z43 * z133;
    const double z176 = r1 * z168;
    const double z177 = r3 * z171;
    const double z178 = w2 * z101 + (z30 * z56 + (z161 + (z163 - z176 + 2.0 * z177)));
    const double z103 = kept[59];
    const double z132 = kept[87];
    const double z179 = z31 * z154 + z56 * z144 - z146 * z101 - z132 * z103 - z3 * z178 - z5 * z173;
    const double z180 = r3 * z152;
    const double z181 = r3 * z168;
    const double z182 = z6 * z169;
    const double z183 = w2 * z31 - (z34 * z56 - (z180 + (z181 + z182)));
    const double z44 = kept[44];
    const double z102 = kept[58];
    const double z184 = z102 * z175 - 0.5 * (z44 * (z179 - z9 * z183));
    const double z109 = kept[64];
    const double z113 = kept[68];
    const double z116 = kept[71];
    const double z126 = kept[81];
    const double z185 = z126 * z109 - z129 * z116 - z131 * z113 - mu2 * z125;
    const double z186 = s_beta * z158;
    const double z187 = I_d * z34;
    const double z188 = z6 * z36;
    const double z189 = r3 * z57;
    const double z190 = r3 * z155;
    const double z191 = z6 * z145;
    const double z192 = z6 * z31 - (r3 * z56 + (z187 + z188 - z189 + z190 + z191));
    const double z193 = z6 * z101 - (r1 * z56 - (I_c * w2 - r3 * u1 + r3 * z147));
    const double z120 = kept[75];
    const double z123 = kept[78];
    const double z128 = kept[83];
    const double z194 = z186 + z130 * z123 + z128 * z120 + mu2 * z119 + c_beta * z192 - s_beta * z193;
    const double z195 = g * z6;
    const double z26 = kept[34];
    const double z60 = kept[53];
    const double z196 = mu2 * z105 + z56 * z60 - z26 * z194;
    const double w1 = y[6];
    const double z112 = kept[67];
    const double z114 = kept[69];
    const double z136 = kept[90];
    const double z197 = z131 * z114 - z136 * z112 - z195 - w1 * z196 + k3 * (z31 * z134 + z2 * z178);
    const double z198 = z197 - 2.0 * (z3 * z184);
    const double z37 = kept[42];
    const double z111 = kept[66];
    const double z115 = kept[70];
    const double z118 = kept[73];
    const double z140 = kept[94];
    const double z199 = z130 * z115 - z128 * z118 + z37 * (z140 * z111 + z24 * z185 + z27 * z194) - c_beta *
        z198;
    const double w3 = y[8];
    const double z117 = kept[72];
    const double z138 = kept[92];
    const double z200 = z129 * z117 + z138 * z112 - w3 * z196 - k1 * (z101 * z134 - z2 * z183) - 2.0 * (z9 *
        z184);
    const double c_alpha = kept[0];
    const double z201 = c_alpha * (z174 + 2.0 * (z5 * z184)) - mu2 * (z199 - s_beta * z200);
    const double z202 = r1 * z30;
    const double z100 = kept[56];
    const double z203 = z100 - z202;
    const double z52 = kept[47];
    const double z55 = kept[50];
    const double z204 = z3 * z52 + z5 * z203 - z9 * z55;
    const double z205 = z43 * z204;
    const double z206 = z2 * z205;
    const double z207 = k2 * z206;
    const double z12 = kept[22];
    const double z19 = kept[29];
    const double z208 = s_beta * z12 - c_beta * z19;
    const double z209 = c_beta * z12 + s_beta * z19;
    const double z210 = z26 * z209;
    const double z211 = c_beta * z208 - z1 * z210;
    const double z212 = k3 * z206;
    const double z46 = kept[45];
    const double z213 = z106 * z211 - (mu3 * z212 - z52 * z46);
    const double z214 = s_beta * z208 + mu3 * z210;
    const double z215 = k1 * z206;
    const double z49 = kept[46];
    const double z216 = z106 * z214 - (z1 * z215 + z55 * z49);
    const double z217 = z106 * z208 - c_beta * z213 - s_beta * z216;
    const double z218 = z19 + z211;
    const double z219 = z24 * z12 + z28 * z218 - c_alpha * z216;
    const double z220 = z12 - z214;
    const double z221 = z24 * z19 - z28 * z220 + c_alpha * z213;
    const double z222 = c_beta * z219 + s_beta * z221;
    const double z223 = r1 * z142;
    const double z224 = r1 * z171;
    const double z225 = z55 * z34 + (z52 * z30 - (z180 + (z223 + (z181 + z224))));
    const double z226 = r3 * z169;
    const double z227 = z6 * z168;
    const double z228 = w2 * z55 - (z30 * z203 + (2.0 * z226 - (z156 + z227)));
    const double z229 = z52 * z154 - z144 * z203 - z55 * z146 - z132 * z205 - z3 * z228 - z5 * z225;
    const double z230 = w2 * z52 + (z34 * z203 - (z172 + (z148 - 2.0 * z170)));
    const double z231 = z204 * z175 - 0.5 * (z44 * (z229 - z9 * z230));
    const double z232 = z27 * z207 - z28 * z217 + z106 * z222 - k2 * (z203 * z134 + z2 * z225) + 2.0 * (z5 *
        z231);
    const double z233 = z126 * z208 - z129 * z214 - z131 * z211 - mu2 * z222;
    const double k6 = kept[8];
    const double z234 = z6 * z52 + (r3 * z203 + (z34 * k6 - r1 * z36 - r1 * z145));
    const double z235 = z6 * z55 + (r1 * z203 + (z150 - I_c * z30 + r3 * z36 + r3 * z145));
    const double z236 = z130 * z220 - z128 * z218 + mu2 * z217 + c_beta * z234 - s_beta * z235;
    const double z237 = g * r1;
    const double z238 = mu2 * z207 - z203 * z60 - z26 * z236;
    const double z239 = z131 * z212 - z136 * z210 - z237 - w1 * z238 + k3 * (z52 * z134 + z2 * z228);
    const double z240 = z239 - 2.0 * (z3 * z231);
    const double z241 = z130 * z213 - z128 * z216 + z37 * (z140 * z209 + z24 * z233 + z27 * z236) - c_beta *
        z240;
    const double z242 = z98 - (z129 * z215 + z138 * z210) + w3 * z238 + k1 * (z55 * z134 - z2 * z230);
    const double z243 = z242 + 2.0 * (z9 * z231);
    const double z244 = c_alpha * z232 - mu2 * (z241 + s_beta * z243) - z14 * z201;
    const double z99 = kept[55];
    const double z245 = z99 - z202;
    const double z35 = kept[40];
    const double z53 = kept[48];
    const double z246 = z3 * z245 + z5 * z53 + z9 * z35;
    const double z247 = z43 * z246;
    const double z248 = z2 * z247;
    const double z249 = k2 * z248;
    const double z7 = kept[16];
    const double z10 = kept[20];
    const double z250 = z7 + (I_c + z10);
    const double z110 = kept[65];
    const double z251 = z110 + c_beta * z250;
    const double z108 = kept[63];
    const double z252 = z108 - s_beta * z250;
    const double z253 = z26 * z252;
    const double z254 = c_beta * z251 - z1 * z253;
    const double z255 = k3 * z248;
    const double z256 = z106 * z254 + (mu3 * z255 - z245 * z46);
    const double z257 = s_beta * z251 + mu3 * z253;
    const double z258 = k1 * z248;
    const double z259 = z106 * z257 + (z1 * z258 - z35 * z49);
    const double z260 = z106 * z251 - c_beta * z256 - s_beta * z259;
    const double z261 = z250 - z254;
    const double z122 = kept[77];
    const double z262 = z122 - z28 * z261 - c_alpha * z259;
    const double z17 = kept[27];
    const double z263 = z17 - z257;
    const double z264 = z24 * z250 + z28 * z263 - c_alpha * z256;
    const double z265 = c_beta * z262 - s_beta * z264;
    const double z266 = z34 * z35 - (z30 * z245 - (z153 + (2.0 * z227 + (z156 - z226))));
    const double z267 = z237 - (z27 * z249 + z28 * z260 - z106 * z265) + k2 * (z53 * z134 - z2 * z266);
    const double z268 = w2 * z35 + (z53 * z30 + (z223 + (z182 + z224)));
    const double z269 = z154 * z245 - z53 * z144 + z35 * z146 - z132 * z247 + z3 * z268 + z5 * z266;
    const double z270 = w2 * z245 + (z34 * z53 - (z162 - (z177 + (z163 - 2.0 * z176))));
    const double z271 = z246 * z175 - 0.5 * (z44 * (z269 - z9 * z270));
    const double z272 = z126 * z251 - z129 * z257 - z131 * z254 - mu2 * z265;
    const double z273 = c_beta * z158;
    const double z274 = z6 * z245 + (r3 * z53 - (z157 - I_a * w2 + r1 * z57 - r1 * z155));
    const double z275 = r1 * u1;
    const double z276 = r1 * z147;
    const double z277 = z6 * z35 - (r1 * z53 + (z191 + (z188 + z275 - z276)));
    const double z278 = z273 + z130 * z263 + z128 * z261 + mu2 * z260 - c_beta * z274 - s_beta * z277;
    const double z279 = mu2 * z249 - z53 * z60 + z26 * z278;
    const double z280 = z131 * z255 + z136 * z253 - w1 * z279 + k3 * (z245 * z134 - z2 * z268) - 2.0 * (z3 *
        z271);
    const double z281 = z130 * z256 - z128 * z259 + z37 * (z140 * z252 + z24 * z272 + z27 * z278) + c_beta *
        z280;
    const double z282 = z195 - (z129 * z258 - z138 * z253) + w3 * z279 - k1 * (z35 * z134 + z2 * z270);
    const double z283 = z282 + 2.0 * (z9 * z271);
    const double z284 = c_alpha * (z267 - 2.0 * (z5 * z271)) - mu2 * (z281 - s_beta * z283) - z18 * z201 +
        z22 * z244;
    const double z285 = z166 * z284;
    const double z286 = z21 * z244 + z22 * z285;
    /* (I.2.15) */
    J[57] = z18 * z285 - (z13 * z201 - z14 * z286);
    const double z287 = z141 * z17;
    const double z107 = kept[62];
    const double z124 = kept[79];
    const double z127 = kept[82];
    const double z288 = z159 - z139 * z107 - z287 - z136 * z109 - z126 * z118 + z127 * z124 + z24 * z192;
    const double z289 = z273 + z128 * z107 - z130 * z17 - s_beta * z192 - c_beta * z193 - z26 * z185;
    const double z290 = z139 * z17;
    const double z121 = kept[76];
    const double z291 = z160 - z141 * z107 + z290 + z138 * z109 + z126 * z115 + z127 * z121 - z28 * z192;
    const double z292 = c_beta * (z288 - z28 * z193 - w1 * z289 + c_alpha * z200) + s_beta * (z291 - z24 *
        z193 - w3 * z289 - c_alpha * z198);
    const double z293 = z139 * z12 - z141 * z19 + z136 * z208 + z126 * z216 + z127 * z221 - z24 * z234;
    const double z294 = z128 * z12 + z130 * z19 - s_beta * z234 - c_beta * z235 - z26 * z233;
    const double z295 = z141 * z12 + z139 * z19 - z138 * z208 - z126 * z213 - z127 * z219 + z28 * z234;
    const double z296 = c_beta * (z293 + z28 * z235 + w1 * z294 + c_alpha * z243) + s_beta * (z295 + z24 *
        z235 + w3 * z294 + c_alpha * z240);
    const double z297 = z296 + z14 * z292;
    const double z298 = z160 - z290 - z141 * z250 - z136 * z251 - z126 * z259 + z127 * z264 - z24 * z274;
    const double z299 = z186 - z128 * z17 + z130 * z250 - s_beta * z274 + c_beta * z277 + z26 * z272;
    const double z300 = z159 + z287 - z139 * z250 - z138 * z251 - z126 * z256 - z127 * z262 - z28 * z274;
    const double z301 = c_beta * (z298 - z28 * z277 + w1 * z299 + c_alpha * z283) - s_beta * (z300 + z24 *
        z277 - w3 * z299 - c_alpha * z280);
    const double z302 = z166 * (z301 - z18 * z292 - z22 * z297);
    const double z303 = z21 * z297 - z22 * z302;
    J[58] = z13 * z292 + z14 * z303 - z18 * z302;
    const double z304 = s_beta * z289 + mu3 * z196;
    const double z305 = s_beta * z294 + mu3 * z238 - z14 * z304;
    const double z306 = z166 * (s_beta * z299 + mu3 * z279 + z18 * z304 - z22 * z305);
    const double z307 = z21 * z305 - z22 * z306;
    J[60] = -(z13 * z304 - z14 * z307 + z18 * z306);
    const double k5 = kept[7];
    const double z308 = r3 * z101 - (r1 * z31 - (z34 * k5 + z6 * u1 - z6 * z147 + z125));
    const double z309 = r3 * z55 - (r1 * z52 - (z190 - (z189 + (z187 - z275) + z276) + z222)) - z14 * z308;
    const double z310 = r3 * z35 + (r1 * z245 + (z149 + (z150 - I_b * z30) + z6 * z57 - z6 * z155 + z265));
    const double z311 = z166 * (z310 - z18 * z308 + z22 * z309);
    const double z312 = z21 * z309 + z22 * z311;
    J[61] = z18 * z311 - (z13 * z308 - z14 * z312);
    const double z313 = c_beta * z289 - z1 * z196;
    const double z314 = c_beta * z294 - z1 * z238 - z14 * z313;
    const double z315 = z166 * (c_beta * z299 - z1 * z279 + z18 * z313 - z22 * z314);
    const double z316 = z21 * z314 - z22 * z315;
    J[62] = z13 * z313 - z14 * z316 + z18 * z315;
    J[66] = -z286;
    J[67] = -z303;
    J[69] = -z307;
    J[70] = -z312;
    J[71] = z316;
    J[75] = z285;
    J[76] = -z302;
    J[78] = -z306;
    J[79] = z311;
    J[80] = z315;
    /* the coframe is singular */
    if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    const double z8 = kept[17];
    /* the mass matrix is singular */
    if (!(fabs(z8) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z11 = kept[21];
    const double z15 = kept[25];
    /* the mass matrix is singular */
    if (!(fabs(z15) > 1e-14 * z11)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z16 = kept[26];
    /* the mass matrix is singular */
    if (!(fabs(z23) > 1e-14 * z16)) {
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
    const rattleback_lanes z2 = 1.0 / rattleback_each_sqrt(RATTLEBACK_SPREAD(k1 * (z1 * z1) + k2 * (mu2 *
        mu2) + k3 * (mu3 * mu3)));
    const rattleback_lanes z3 = mu3 * k3;
    const rattleback_lanes r3 = h - z2 * z3;
    const rattleback_lanes z4 = r3 * r3;
    const rattleback_lanes z5 = mu2 * k2;
    const rattleback_lanes z6 = z2 * z5;
    const rattleback_lanes z7 = z6 * z6;
    const rattleback_lanes z8 = I_a + (z4 + z7);
    const rattleback_lanes z9 = z1 * k1;
    const rattleback_lanes r1 = z9 * z2;
    const rattleback_lanes z10 = r1 * r1;
    const rattleback_lanes z11 = I_b + (z4 + z10);
    const rattleback_lanes z12 = I_d + r1 * z6;
    const rattleback_lanes z13 = 1.0 / z8;
    const rattleback_lanes z14 = z12 * z13;
    const rattleback_lanes z15 = z11 - z12 * z14;
    /* the mass matrix is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z15)), 1e-14 * z11);
    const rattleback_lanes z16 = I_c + (z7 + z10);
    const rattleback_lanes z17 = r1 * r3;
    const rattleback_lanes z18 = z17 * z13;
    const rattleback_lanes z19 = z6 * r3 + z12 * z18;
    const rattleback_lanes z20 = 1.0 / z15;
    const rattleback_lanes z21 = z19 * z20;
    const rattleback_lanes z22 = z16 - z17 * z18 - z19 * z21;
    /* the mass matrix is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z22)), 1e-14 * z16);
    rattleback_lanes sine3, cosine3;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(gamma_), &far, &sine3, &cosine3);
    const rattleback_lanes s_gamma = sine3;
    const rattleback_lanes z23 = s_beta * w1 - c_beta * w3;
    const rattleback_lanes z24 = 1.0 / c_alpha;
    const rattleback_lanes z25 = z1 * w3 + mu3 * w1;
    const rattleback_lanes z26 = z24 * z25;
    const rattleback_lanes z27 = s_beta * z23 + c_beta * z26;
    const rattleback_lanes z28 = c_beta * z23 - s_beta * z26;
    const rattleback_lanes z29 = r3 * z27 + r1 * z28;
    const rattleback_lanes u1 = r3 * w2 - z6 * z28;
    const rattleback_lanes z30 = r1 * w2 + z6 * z27;
    const rattleback_lanes z31 = s_beta * u1 + c_beta * z30;
    const rattleback_lanes z32 = c_alpha * z29 - mu2 * z31;
    const rattleback_lanes c_gamma = cosine3;
    const rattleback_lanes z33 = s_beta * z30 - c_beta * u1;
    const rattleback_lanes z34 = z24 * z23;
    const rattleback_lanes z35 = w2 + mu2 * z34;
    const rattleback_lanes z36 = I_c * z28;
    const rattleback_lanes z37 = c_beta * z35;
    const rattleback_lanes z38 = s_beta * z35;
    const rattleback_lanes z39 = z26 * z38;
    const rattleback_lanes z40 = mu2 * z26;
    const rattleback_lanes z41 = s_beta * z40 - c_alpha * z37;
    const rattleback_lanes z42 = z39 + z34 * z41;
    const rattleback_lanes z43 = z26 * z37;
    const rattleback_lanes z44 = c_alpha * z38 + c_beta * z40;
    const rattleback_lanes z45 = z43 + z34 * z44;
    const rattleback_lanes z46 = s_beta * z42 + c_beta * z45 - z34 * z40;
    const rattleback_lanes z47 = z24 * (z1 * z45 - mu3 * z42);
    const rattleback_lanes z48 = z23 * z37 + s_beta * z46 - (z39 + c_beta * z47);
    const rattleback_lanes z49 = I_d * z27 + I_b * w2;
    const rattleback_lanes z50 = z26 * z49;
    const rattleback_lanes z51 = z23 * z49;
    const rattleback_lanes z52 = (z9 * z41 - z5 * z25 + z3 * z44) * (z2 * (z2 * z2));
    const rattleback_lanes z53 = z3 * z52 - k3 * (z2 * z44);
    const rattleback_lanes z54 = z23 * z38 - c_beta * z46 + (z43 - s_beta * z47);
    const rattleback_lanes z55 = k1 * (z2 * z41) - z9 * z52;
    const rattleback_lanes z56 = z28 * u1 - z27 * z30 + (r3 * z48 - z27 * z53 - (r1 * z54 + z28 * z55));
    const rattleback_lanes z57 = g * mu2 + z56;
    const rattleback_lanes z58 = z5 * z52 + k2 * (z2 * z25);
    const rattleback_lanes z59 = g * mu3 + (z27 * z29 + w2 * u1 + (z6 * z48 + z27 * z58 - w2 * z55));
    const rattleback_lanes z60 = w2 * z36 - (I_a * z48 - (s_beta * z50 - (c_beta * z51 + (r3 * z57 + z6 *
        z59))));
    const rattleback_lanes z61 = I_d * w2 + I_a * z27;
    const rattleback_lanes z62 = g * z1 - (w2 * z30 + z28 * z29 - (z6 * z54 - z28 * z58 - w2 * z53));
    const rattleback_lanes z63 = I_d * z48 - (z28 * z61 - z27 * z36 - (r3 * z62 + r1 * z59)) + z14 * z60;
    const rattleback_lanes z64 = w2 * z61 - (I_c * z54 + (c_beta * z50 + (s_beta * z51 + (z6 * z62 - r1 *
        z57))));
    const rattleback_lanes z65 = (z64 + z18 * z60 + z21 * z63) / z22;
    const rattleback_lanes z66 = z20 * z63 + z21 * z65;
    /* (I.2.15) */
    const rattleback_lanes slope1 = s_gamma * z32 - c_gamma * z33;
    sum += slope1;
    rattleback_put(dydt, slope1);
    const rattleback_lanes slope2 = -(s_gamma * z33 + c_gamma * z32);
    sum += slope2;
    rattleback_put(dydt + 1 * stride, slope2);
    const rattleback_lanes slope3 = -(mu2 * z29 + c_alpha * z31);
    sum += slope3;
    rattleback_put(dydt + 2 * stride, slope3);
    const rattleback_lanes slope4 = z26;
    rattleback_put(dydt + 3 * stride, slope4);
    const rattleback_lanes slope5 = z35;
    rattleback_put(dydt + 4 * stride, slope5);
    const rattleback_lanes slope6 = -z34;
    rattleback_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 41:4 */
    const rattleback_lanes slope7 = z13 * z60 + z14 * z66 + z18 * z65;
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
