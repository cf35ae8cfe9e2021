/*
 * rattleback.c: rattleback, emitted by nhc 0.1.0 (nhc:5b022fc0102d16cb)
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

static int rattleback_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? RATTLEBACK_OK : RATTLEBACK_NOT_FINITE;
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

/* the seeds of the passes from first on: in each lane the seed of its pass is 1 */
static void rattleback_unit(int size, int first, double *seed)
{
    for (int i = 0; i < size; ++i) {
        for (int k = 0; k < RATTLEBACK_LANES; ++k) {
            seed[i * RATTLEBACK_LANES + k] = i == first + k ? 1.0 : 0.0;
        }
    }
}

/* the results of the passes, each to its own entries of the output */
static void rattleback_place(int passes, const int *offset, int count, const int *entry, const double *slope, double *out)
{
    for (int k = 0; k < passes && k < RATTLEBACK_LANES; ++k) {
        for (int i = 0; i < count; ++i) {
            out[offset[k] + entry[i]] = slope[i * RATTLEBACK_LANES + k];
        }
    }
}

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
    double even = 0.0;
    double odd = 0.0;
    for (int k = 0; k < count; k += 2) {
        even += check[k];
        odd += check[k + 1];
    }
    return even + odd <= 1e10;
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
    const double k4 = b * b * b * b;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double z2 = mu2 * mu2;
    const double mu3 = c_beta * c_alpha;
    const double z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3);
    const double z4 = 1.0 / sqrt(z3);
    const double z5 = c_beta * k3;
    const double z6 = z4 * z5;
    const double z7 = 1.0 - z2;
    const double z8 = z2 * k4;
    const double z9 = z4 * (z5 * (z6 * z7 - 2.0 * (h * c_alpha)) + z4 * z8) + k5;
    const double z10 = z1 * k1;
    const double r1 = z10 * z4;
    const double z11 = mu3 * k3;
    const double r3 = h - z4 * z11;
    const double z12 = c_beta * r1 + s_beta * r3;
    const double z13 = c_alpha * z12;
    const double z14 = mu2 * z12;
    const double z15 = s_beta * r1 - c_beta * r3;
    const double z16 = s_gamma * z14 + c_gamma * z15;
    const double z17 = c_gamma * z14 - s_gamma * z15;
    const double z18 = I_b + (z13 * z13 + (z16 * z16 + z17 * z17));
    const double z19 = 1.0 / c_alpha;
    const double z20 = s_beta * z19;
    const double z21 = z1 * z20 + c_beta * c_beta;
    const double z22 = mu2 * k2;
    const double z23 = z4 * z22;
    const double z24 = z23 * z21;
    const double z25 = c_beta * s_beta;
    const double z26 = mu3 * z20 - z25;
    const double z27 = z23 * z26;
    const double z28 = c_beta * z24 - s_beta * z27;
    const double z29 = r3 * z21 + r1 * z26;
    const double z30 = c_alpha * z28 + mu2 * z29;
    const double z31 = mu2 * z28 - c_alpha * z29;
    const double z32 = s_beta * z24 + c_beta * z27;
    const double z33 = s_gamma * z31 + c_gamma * z32;
    const double z34 = c_gamma * z31 - s_gamma * z32;
    const double z35 = I_d * z21 + (z30 * z13 + (z33 * z16 + z34 * z17));
    const double z36 = 1.0 / z9;
    const double z37 = z35 * z36;
    const double z38 = z18 - z35 * z37;
    const double z39 = 1.0 / z3;
    const double z40 = s_beta * s_beta;
    const double z41 = I_c + z39 * (z8 + k6 * (z40 * z7));
    const double z42 = h - c_alpha * z6;
    const double z43 = r1 * z42;
    const double z44 = z36 * z43;
    const double z45 = z23 * z42 + z35 * z44;
    const double z46 = 1.0 / z38;
    const double z47 = z46 * z45;
    const double z48 = z41 - z43 * z44 - z45 * z47;
    const double z49 = s_beta * w1 - c_beta * w3;
    const double z50 = z19 * z49;
    const double z51 = z1 * z50;
    const double z52 = z1 * w3 + mu3 * w1;
    const double z53 = z52 * z19;
    const double omega1 = z51 + c_beta * z53;
    const double z54 = r1 * w2 + z23 * omega1;
    const double z55 = mu3 * z50;
    const double z56 = z55 - s_beta * z53;
    const double z57 = z23 * z56 - r3 * w2;
    const double z58 = c_beta * z54 - s_beta * z57;
    const double z59 = r3 * omega1 + r1 * z56;
    const double e2 = mu2 * z58 - c_alpha * z59;
    const double z60 = s_beta * z54 + c_beta * z57;
    const double z61 = w2 + mu2 * z50;
    const double z62 = s_beta * z61;
    const double z63 = mu2 * z53;
    const double z64 = c_alpha * z62 + c_beta * z63;
    const double z65 = z63 / (c_alpha * c_alpha);
    const double z66 = c_beta * z61;
    const double z67 = z49 * z65 + z19 * (w1 * z66 + w3 * z62);
    const double z68 = s_beta * z63 - c_alpha * z66;
    const double z69 = z19 * (w3 * z68 + w1 * z64) - z52 * z65;
    const double z70 = z50 * z64 - mu3 * z67 + (z53 * z66 - s_beta * z69);
    const double z71 = mu2 * z20;
    const double z72 = c_beta * z71;
    const double z73 = s_beta * z71;
    const double z74 = c_beta * mu2;
    const double z75 = z56 * (c_beta * z66 + z20 * z64 - (z53 * z72 + z50 * (c_alpha * z73 + c_beta * z74)));
    const double z76 = I_d * omega1 + I_b * w2;
    const double z77 = I_d * w2 + I_a * omega1;
    const double z78 = z77 * (c_beta * z62 + z20 * z68 - (z53 * z73 + z50 * (s_beta * z74 - c_alpha * z72)));
    const double z79 = z39 * (z4 * (z10 * z68 - z22 * z52 + z11 * z64));
    const double z80 = k1 * (z4 * z68) - z10 * z79;
    const double z81 = z50 * z68 - z1 * z67 + (z53 * z62 + c_beta * z69);
    const double z82 = z22 * z79 + k2 * (z4 * z52);
    const double z83 = w2 * z80 + (z23 * z81 - omega1 * z82);
    const double z84 = z11 * z79 - k3 * (z4 * z64);
    const double z85 = z23 * z70 - z56 * z82 - w2 * z84;
    const double z86 = z54 * z62 + c_beta * z83 + (z57 * z66 - s_beta * z85);
    const double z87 = r3 * z81 + omega1 * z84 + (r1 * z70 + z56 * z80);
    const double z88 = z58 * z63 + c_alpha * z86 - (z52 * z59 - mu2 * z87);
    const double z89 = c_gamma * z50;
    const double z90 = z52 * z58 - mu2 * z86 + (z59 * z63 + c_alpha * z87);
    const double z91 = s_gamma * z50;
    const double z92 = z54 * z66 - s_beta * z83 - (z57 * z62 + c_beta * z85);
    const double z93 = e2 * z89 - s_gamma * z90 - (z60 * z91 + c_gamma * z92);
    const double z94 = e2 * z91 + c_gamma * z90 + (z60 * z89 - s_gamma * z92);
    const double z95 = I_a * z81;
    const double z96 = z76 * (z55 - z52 * z20) - (z78 + (z30 * z88 + (z33 * z93 - z34 * z94))) - z21 * z95;
    const double z97 = g * z30 - (I_c * (z26 * z70 + z75) - z96);
    const double z98 = I_c * (omega1 * z56) - (I_d * z81 + (z56 * z77 + (z13 * z88 + (z16 * z93 - z17 *
        z94))));
    const double z99 = g * z13 + z98 - z37 * z97;
    const double z100 = c_beta * z19;
    const double z101 = z25 - z1 * z100;
    const double z102 = z23 * z101;
    const double z103 = mu3 * z100 + z40;
    const double z104 = z23 * z103;
    const double z105 = c_beta * z102 + s_beta * z104;
    const double z106 = r3 * z101 - r1 * z103;
    const double z107 = c_alpha * z105 + mu2 * z106;
    const double z108 = mu2 * z100;
    const double z109 = c_beta * z108;
    const double z110 = s_beta * z108;
    const double z111 = s_beta * mu2;
    const double z112 = z56 * (s_beta * z66 - z100 * z64 + (z53 * z109 + z50 * (c_alpha * z110 - c_beta *
        z111)));
    const double z113 = z77 * (s_beta * z62 - z100 * z68 + (z53 * z110 - z50 * (s_beta * z111 + c_alpha *
        z109)));
    const double z114 = mu2 * z105 - c_alpha * z106;
    const double z115 = s_beta * z102 - c_beta * z104;
    const double z116 = z107 * z88 + ((s_gamma * z114 + c_gamma * z115) * z93 - (c_gamma * z114 - s_gamma *
        z115) * z94);
    const double z117 = I_c * (z103 * z70 - z112) + (z76 * (z51 + z52 * z100) - (z113 + z116) - z101 * z95);
    const double z118 = (g * z107 + z117 + z97 * z44 - z47 * z99) / z48;
    const double z119 = z46 * z99 - z47 * z118;
    /* (I.2.15) */
    dydt[0] = -(s_gamma * e2 + c_gamma * z60); /* x' */
    dydt[1] = c_gamma * e2 - s_gamma * z60; /* y' */
    dydt[2] = -(c_alpha * z58 + mu2 * z59); /* z' */
    dydt[3] = z53; /* alpha' */
    dydt[4] = z61; /* beta' */
    dydt[5] = -z50; /* gamma' */
    /* (I.2.15) 41:4 */
    dydt[6] = -(z36 * z97 - z37 * z119 + z44 * z118); /* w1' */
    dydt[7] = -z119; /* w2' */
    dydt[8] = -z118; /* w3' */
    /* the coframe is singular */
    if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(z9) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z38) > 1e-14 * z18)) {
        return RATTLEBACK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z48) > 1e-14 * z41)) {
        return RATTLEBACK_SINGULAR_2;
    }
    return rattleback_finish(9, dydt);
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
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
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
    const double r1 = z1 * k1 * z2;
    const double z3 = z2 * (mu2 * k2);
    const double z4 = 1.0 / c_alpha;
    const double z5 = z4 * (s_beta * w1 - c_beta * w3);
    const double z6 = (z1 * w3 + mu3 * w1) * z4;
    const double omega1 = z1 * z5 + c_beta * z6;
    const double z7 = r1 * w2 + z3 * omega1;
    const double z8 = mu3 * z5 - s_beta * z6;
    const double r3 = h - z2 * (mu3 * k3);
    const double z9 = z3 * z8 - r3 * w2;
    const double z10 = c_beta * z7 - s_beta * z9;
    const double z11 = r3 * omega1 + r1 * z8;
    const double e2 = mu2 * z10 - c_alpha * z11;
    const double z12 = s_beta * z7 + c_beta * z9;
    /* (I.2.4) */
    qdot[0] = -(s_gamma * e2 + c_gamma * z12); /* x' */
    qdot[1] = c_gamma * e2 - s_gamma * z12; /* y' */
    qdot[2] = -(c_alpha * z10 + mu2 * z11); /* z' */
    qdot[3] = z6; /* alpha' */
    qdot[4] = w2 + mu2 * z5; /* beta' */
    qdot[5] = -z5; /* gamma' */
    /* the coframe is singular */
    if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    return rattleback_finish(6, qdot);
}

int rattleback_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    double dydt[9];
    const int status1 = rattleback_rhs(t, y, p, dydt);
    if (status1 != RATTLEBACK_OK) {
        return status1;
    }
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double mu2 = sin(alpha);
    const double c_alpha = cos(alpha);
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double w1_dot = dydt[6]; /* w1' */
    const double w2_dot = dydt[7]; /* w2' */
    const double w3_dot = dydt[8]; /* w3' */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double z2 = z1 * k1;
    const double mu3 = c_beta * c_alpha;
    const double z3 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3);
    const double z4 = 1.0 / sqrt(z3);
    const double r1 = z2 * z4;
    const double z5 = mu2 * k2;
    const double z6 = z4 * z5;
    const double z7 = 1.0 / c_alpha;
    const double z8 = s_beta * w1 - c_beta * w3;
    const double z9 = z7 * z8;
    const double z10 = z1 * w3 + mu3 * w1;
    const double z11 = z10 * z7;
    const double omega1 = z1 * z9 + c_beta * z11;
    const double z12 = r1 * w2 + z6 * omega1;
    const double z13 = mu3 * z9 - s_beta * z11;
    const double z14 = mu3 * k3;
    const double r3 = h - z4 * z14;
    const double z15 = z6 * z13 - r3 * w2;
    const double z16 = c_beta * z12 - s_beta * z15;
    const double z17 = r3 * omega1 + r1 * z13;
    const double e2 = mu2 * z16 - c_alpha * z17;
    const double z18 = c_gamma * z9;
    const double z19 = w2 + mu2 * z9;
    const double z20 = s_beta * z19;
    const double z21 = mu2 * z11;
    const double z22 = c_beta * z19;
    const double z23 = s_beta * z21 - c_alpha * z22;
    const double z24 = c_alpha * z20 + c_beta * z21;
    const double z25 = z4 * (z2 * z23 - z5 * z10 + z14 * z24) / z3;
    const double z26 = k1 * (z4 * z23) - z2 * z25;
    const double z27 = z5 * z25 + k2 * (z4 * z10);
    const double z28 = z21 / (c_alpha * c_alpha);
    const double z29 = z8 * z28 + z7 * (w1 * z22 + s_beta * w1_dot + (w3 * z20 - c_beta * w3_dot));
    const double z30 = z10 * z28 - z7 * (w3 * z23 - z1 * w3_dot + (w1 * z24 - mu3 * w1_dot));
    const double z31 = z9 * z23 - z1 * z29 + (z11 * z20 - c_beta * z30);
    const double z32 = w2 * z26 - r1 * w2_dot - (omega1 * z27 - z6 * z31);
    const double z33 = z9 * z24 - mu3 * z29 + (z11 * z22 + s_beta * z30);
    const double z34 = z14 * z25 - k3 * (z4 * z24);
    const double z35 = z13 * z27 - z6 * z33 + (w2 * z34 - r3 * w2_dot);
    const double z36 = z12 * z20 + c_beta * z32 + (z15 * z22 + s_beta * z35);
    const double z37 = omega1 * z34 + r3 * z31 + (z13 * z26 + r1 * z33);
    const double z38 = z10 * z16 - mu2 * z36 + (z17 * z21 + c_alpha * z37);
    const double z39 = s_beta * z12 + c_beta * z15;
    const double z40 = s_gamma * z9;
    const double z41 = z12 * z22 - s_beta * z32 - (z15 * z20 - c_beta * z35);
    /* (I.2.15) */
    qddot[0] = e2 * z18 - s_gamma * z38 - (z39 * z40 + c_gamma * z41); /* x'' */
    qddot[1] = e2 * z40 + c_gamma * z38 + (z39 * z18 - s_gamma * z41); /* y'' */
    qddot[2] = z16 * z21 + c_alpha * z36 - (z10 * z17 - mu2 * z37); /* z'' */
    qddot[3] = z30; /* alpha'' */
    qddot[4] = w2_dot + (z10 * z9 + mu2 * z29); /* beta'' */
    qddot[5] = -z29; /* gamma'' */
    return rattleback_finish(6, qddot);
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
    return rattleback_finish(9, y);
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
    return rattleback_finish(3, r);
}

int rattleback_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    double dydt[9];
    const int status1 = rattleback_rhs(t, y, p, dydt);
    if (status1 != RATTLEBACK_OK) {
        return status1;
    }
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double mu2 = sin(alpha);
    const double c_alpha = cos(alpha);
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double w1_dot = dydt[6]; /* w1' */
    const double w2_dot = dydt[7]; /* w2' */
    const double w3_dot = dydt[8]; /* w3' */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double k4 = k1 - k3;
    const double k5 = k2 - k3;
    const double k6 = k1 - k2;

    /* state */
    const double z1 = c_alpha * s_beta;
    const double z2 = z1 * k1;
    const double z3 = mu2 * mu2;
    const double z4 = k2 * z3;
    const double mu3 = c_beta * c_alpha;
    const double z5 = k1 * (z1 * z1) + z4 + k3 * (mu3 * mu3);
    const double z6 = 1.0 / sqrt(z5);
    const double r1 = z2 * z6;
    const double z7 = mu2 * k2;
    const double z8 = z6 * z7;
    const double z9 = 1.0 / c_alpha;
    const double z10 = s_beta * w1 - c_beta * w3;
    const double z11 = z9 * z10;
    const double z12 = z1 * w3 + mu3 * w1;
    const double z13 = z12 * z9;
    const double omega1 = z1 * z11 + c_beta * z13;
    const double z14 = r1 * w2 + z8 * omega1;
    const double z15 = mu3 * z11 - s_beta * z13;
    const double z16 = mu3 * k3;
    const double r3 = h - z6 * z16;
    const double z17 = z8 * z15 - r3 * w2;
    const double z18 = c_beta * z14 - s_beta * z17;
    const double z19 = r3 * omega1 + r1 * z15;
    const double e2 = mu2 * z18 - c_alpha * z19;
    const double z20 = c_gamma * z11;
    const double z21 = w2 + mu2 * z11;
    const double z22 = s_beta * z21;
    const double z23 = mu2 * z13;
    const double z24 = c_beta * z21;
    const double z25 = s_beta * z23 - c_alpha * z24;
    const double z26 = c_alpha * z22 + c_beta * z23;
    const double z27 = z6 * (z2 * z25 - z7 * z12 + z16 * z26) / z5;
    const double z28 = k1 * (z6 * z25) - z2 * z27;
    const double z29 = z23 / (c_alpha * c_alpha);
    const double z30 = z10 * z29 + z9 * (w1 * z24 + w3 * z22);
    const double z31 = z9 * (w3 * z25 + w1 * z26) - z12 * z29;
    const double z32 = z11 * z25 - z1 * z30 + (z13 * z22 + c_beta * z31);
    const double z33 = z7 * z27 + k2 * (z6 * z12);
    const double z34 = w2 * z28 + (z8 * z32 - omega1 * z33);
    const double z35 = z11 * z26 - mu3 * z30 + (z13 * z24 - s_beta * z31);
    const double z36 = z16 * z27 - k3 * (z6 * z26);
    const double z37 = z8 * z35 - z15 * z33 - w2 * z36;
    const double z38 = z14 * z22 + c_beta * z34 + (z17 * z24 - s_beta * z37);
    const double z39 = r3 * z32 + omega1 * z36 + (r1 * z35 + z15 * z28);
    const double z40 = z12 * z18 - mu2 * z38 + (z19 * z23 + c_alpha * z39);
    const double z41 = s_beta * z14 + c_beta * z17;
    const double z42 = s_gamma * z11;
    const double z43 = z14 * z24 - s_beta * z34 - (z17 * z22 + c_beta * z37);
    const double z44 = s_beta * s_gamma;
    const double z45 = 1.0 - z3;
    const double z46 = z4 + k1 * z45;
    const double z47 = c_beta * z7;
    const double z48 = z6 * w3_dot;
    const double z49 = h * c_alpha;
    const double z50 = c_beta * s_gamma;
    const double z51 = z4 + k3 * z45;
    const double z52 = s_beta * z7;
    const double z53 = c_beta * c_gamma;
    const double z54 = s_beta * mu2;
    const double z55 = c_alpha * z6;
    const double z56 = c_beta * mu2;
    const double z57 = s_beta * c_gamma;
    const double z58 = s_beta * k4;
    const double z59 = w2_dot * (h * (z53 - s_gamma * z54) - z55 * (k3 * c_gamma + (s_gamma * z56 + z57) *
        z58));
    const double z60 = (z44 * z46 - c_gamma * z47) * z48 - (w1_dot * (s_gamma * z49 - z6 * (z50 * z51 +
        c_gamma * z52)) + z59);
    const double z61 = w2_dot * (h * (z50 + c_gamma * z54) - z55 * (k3 * s_gamma + (z44 - c_gamma * z56) *
        z58));
    const double z62 = (z57 * z46 + s_gamma * z47) * z48 - (w1_dot * (c_gamma * z49 - z6 * (z51 * z53 -
        s_gamma * z52)) - z61);
    const double z63 = mu3 * z6;
    const double z64 = k6 * (mu2 * (z1 * z48)) - ((h + z63 * k5) * (mu2 * w1_dot) + (h + k4 * z63) * (z1 *
        w2_dot));
    /* (I.4.1) 44:5 */
    /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    lambda[0] = e2 * z20 - s_gamma * z40 - (z41 * z42 + c_gamma * z43) - z60;
    /* (I.4.1) 45:5 */
    /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    lambda[1] = e2 * z42 + c_gamma * z40 + (z41 * z20 - s_gamma * z43) + z62;
    /* (I.4.1) 46:5 */
    /* reaction of roll_z: Q_i gains lambda_3 a_3i */
    lambda[2] = z64 - (g - (z18 * z23 + c_alpha * z38 - (z12 * z19 - mu2 * z39)));
    return rattleback_finish(3, lambda);
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
    const double mu2 = sin(alpha);
    const double c_alpha = cos(alpha);
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
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
    const double r1 = z1 * k1 * z2;
    const double z3 = z2 * (mu2 * k2);
    const double z4 = 1.0 / c_alpha;
    const double z5 = z4 * (s_beta * w1 - c_beta * w3);
    const double z6 = (z1 * w3 + mu3 * w1) * z4;
    const double omega1 = z1 * z5 + c_beta * z6;
    const double z7 = r1 * w2 + z3 * omega1;
    const double z8 = mu3 * z5 - s_beta * z6;
    const double r3 = h - z2 * (mu3 * k3);
    const double z9 = z3 * z8 - r3 * w2;
    const double z10 = c_beta * z7 - s_beta * z9;
    const double z11 = r3 * omega1 + r1 * z8;
    const double e2 = mu2 * z10 - c_alpha * z11;
    const double z12 = s_beta * z7 + c_beta * z9;
    const double z13 = s_gamma * e2 + c_gamma * z12;
    const double z14 = c_gamma * e2 - s_gamma * z12;
    const double z15 = c_alpha * z10 + mu2 * z11;
    const double z16 = z13 * z13 + z14 * z14 + z15 * z15 + (I_a * (omega1 * omega1) + I_b * (w2 * w2) + I_c *
        (z8 * z8));
    return 0.5 * z16 + w2 * (I_d * omega1) - z * g;
}

static void rattleback_jacobian_sweep1(double t, const double *y, const double *p, const double *kept, const
    double *seed, double *slope)
{
    (void)t;
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double c_alpha = kept[0];
    const double mu2 = kept[1];
    const double s_beta = kept[2];
    const double c_beta = kept[3];
    const double s_gamma = kept[4];
    const double c_gamma = kept[5];
    const double k1 = kept[6];
    const double k2 = kept[7];
    const double k3 = kept[8];
    const double k4 = kept[9];
    const double k6 = kept[10];
    const double z1 = kept[11];
    const double mu3 = kept[12];
    const double z4 = kept[13];
    const double z5 = kept[14];
    const double z6 = kept[15];
    const double z7 = kept[16];
    const double z8 = kept[17];
    const double z9 = kept[18];
    const double z10 = kept[19];
    const double z12 = kept[20];
    const double r1 = kept[21];
    const double z13 = kept[22];
    const double r3 = kept[23];
    const double z14 = kept[24];
    const double z15 = kept[25];
    const double z16 = kept[26];
    const double z17 = kept[27];
    const double z18 = kept[28];
    const double z19 = kept[29];
    const double z21 = kept[30];
    const double z22 = kept[31];
    const double z23 = kept[32];
    const double z24 = kept[33];
    const double z25 = kept[34];
    const double z26 = kept[35];
    const double z28 = kept[36];
    const double z29 = kept[37];
    const double z30 = kept[38];
    const double z31 = kept[39];
    const double z32 = kept[40];
    const double z33 = kept[41];
    const double z34 = kept[42];
    const double z35 = kept[43];
    const double z36 = kept[44];
    const double z38 = kept[45];
    const double z39 = kept[46];
    const double z41 = kept[47];
    const double z43 = kept[48];
    const double z44 = kept[49];
    const double z46 = kept[50];
    const double z47 = kept[51];
    const double z48 = kept[52];
    const double z49 = kept[53];
    const double z50 = kept[54];
    const double z52 = kept[55];
    const double z54 = kept[56];
    const double z55 = kept[57];
    const double z57 = kept[58];
    const double z58 = kept[59];
    const double z60 = kept[60];
    const double z61 = kept[61];
    const double omega1 = kept[62];
    const double z63 = kept[63];
    const double z67 = kept[64];
    const double z68 = kept[65];
    const double z70 = kept[66];
    const double z71 = kept[67];
    const double z72 = kept[68];
    const double z76 = kept[69];
    const double z86 = kept[70];
    const double e2 = kept[71];
    const double z108 = kept[72];
    const double z109 = kept[73];
    const double z110 = kept[74];
    const double z111 = kept[75];
    const double z112 = kept[76];
    const double z113 = kept[77];
    const double z114 = kept[78];
    const double z115 = kept[79];
    const double z116 = kept[80];
    const double z117 = kept[81];
    const double z118 = kept[82];
    const double z119 = kept[83];
    const double z120 = kept[84];
    const double z121 = kept[85];
    const double z122 = kept[86];
    const double z123 = kept[87];
    const double z124 = kept[88];
    const double z125 = kept[89];
    const double z126 = kept[90];
    const double z127 = kept[91];
    const double z128 = kept[92];
    const double z129 = kept[93];
    const double z130 = kept[94];
    const double z131 = kept[95];
    const double z132 = kept[96];
    const double z133 = kept[97];
    const double z134 = kept[98];
    const double z135 = kept[99];
    const double z136 = kept[100];
    const double z137 = kept[101];
    const double z138 = kept[102];
    const double z139 = kept[103];
    const double z140 = kept[104];
    const double z141 = kept[105];
    const double z142 = kept[106];
    const double z143 = kept[107];
    const double z144 = kept[108];
    const double z145 = kept[109];
    const double z146 = kept[110];
    const double z147 = kept[111];
    const double z148 = kept[112];
    const double z149 = kept[113];
    const double z150 = kept[114];
    const double z151 = kept[115];
    const double z152 = kept[116];
    const double z153 = kept[117];
    const double z154 = kept[118];
    const double z155 = kept[119];
    const double z156 = kept[120];
    const double z157 = kept[121];
    const double z158 = kept[122];
    const double z160 = kept[123];
    const double z161 = kept[124];
    const double z162 = kept[125];
    const double z163 = kept[126];
    const double z164 = kept[127];
    const double z165 = kept[128];
    const double z166 = kept[129];
    const double z167 = kept[130];
    const double z168 = kept[131];
    const double z169 = kept[132];
    const double z170 = kept[133];
    const double z171 = kept[134];
    const double z172 = kept[135];
    const double z173 = kept[136];
    const double z174 = kept[137];
    const double z181 = kept[138];
    const double z182 = kept[139];
    const double z183 = kept[140];
    const double z184 = kept[141];
    const rattleback_lanes row_0 = rattleback_get(seed + 0 * RATTLEBACK_LANES);
    const rattleback_lanes row_1 = rattleback_get(seed + 1 * RATTLEBACK_LANES);
    const rattleback_lanes row_2 = rattleback_get(seed + 2 * RATTLEBACK_LANES);
    const rattleback_lanes z185 = row_1 - z39 * row_0;
    const rattleback_lanes z186 = z123 * (row_2 + z52 * row_0 - z55 * z185);
    const rattleback_lanes z187 = I_c * z186;
    const rattleback_lanes z188 = z67 * z187;
    const rattleback_lanes z189 = z54 * z185 - z55 * z186;
    const rattleback_lanes z190 = z38 * row_0 - z39 * z189 + z52 * z186;
    const rattleback_lanes z191 = I_c * z190;
    const rattleback_lanes z192 = z67 * z191;
    const rattleback_lanes z193 = z119 * z186 + z19 * z189 + z36 * z190;
    const rattleback_lanes z194 = z118 * z186 + z18 * z189 + z35 * z190;
    const rattleback_lanes z195 = s_gamma * z193 - c_gamma * z194;
    const rattleback_lanes z196 = z120 * z186 + z15 * z189 + z32 * z190;
    const rattleback_lanes z197 = c_gamma * z193 + s_gamma * z194;
    const rattleback_lanes z198 = c_alpha * z196 + mu2 * z197;
    const rattleback_lanes z199 = mu2 * z196 - c_alpha * z197;
    const rattleback_lanes z200 = c_beta * z195 + s_beta * z198;
    const rattleback_lanes z201 = z112 * z187 - z28 * z191 - r1 * z199 + z25 * z200;
    const rattleback_lanes z202 = I_a * z186;
    const rattleback_lanes z203 = I_a * z190;
    const rattleback_lanes z204 = s_beta * z195 - c_beta * z198;
    const rattleback_lanes z205 = z110 * z202 + z23 * z203 + I_d * z189 + r3 * z199 - z25 * z204;
    const rattleback_lanes z206 = mu3 * z201 - z1 * z205;
    const rattleback_lanes z207 = z21 * z206;
    const rattleback_lanes z208 = s_beta * z188 + c_beta * z192 + z63 * z195 + z68 * z198 - z61 * z201 + w1 *
        z207;
    const rattleback_lanes z209 = z144 * z186;
    const rattleback_lanes z210 = z144 * z190;
    const rattleback_lanes z211 = s_beta * z201 + c_beta * z205;
    const rattleback_lanes z212 = z21 * z211;
    const rattleback_lanes z213 = z67 * z199 - w2 * z204;
    const rattleback_lanes z214 = omega1 * z199 + w2 * z200;
    const rattleback_lanes z215 = z67 * z200 + omega1 * z204;
    const rattleback_lanes z216 = z13 * z214 + z24 * z215 - z12 * z213;
    const rattleback_lanes z217 = z41 * z216;
    const rattleback_lanes z218 = z4 * z217;
    const rattleback_lanes z219 = k1 * z218;
    const rattleback_lanes z220 = z109 * z209 - z22 * z210 - z58 * z205 - w3 * z212 - k1 * (z4 * z213) - z1 *
        z219;
    const rattleback_lanes z221 = z208 + c_alpha * z220;
    const rattleback_lanes z222 = s_beta * z209 + c_beta * z210 - z68 * z195 + z63 * z198 + z61 * z205 + w3 *
        z207;
    const rattleback_lanes z223 = k3 * z218;
    const rattleback_lanes z224 = z109 * z188 - z22 * z192 + z58 * z201 - w1 * z212 + k3 * (z4 * z214) - mu3
        * z223;
    const rattleback_lanes z225 = z222 - c_alpha * z224;
    const rattleback_lanes z226 = c_beta * z221 + s_beta * z225;
    const rattleback_lanes z227 = z161 * z193 - z163 * z194;
    const rattleback_lanes z228 = z58 * z210;
    const rattleback_lanes z229 = z61 * z192 - c_alpha * z228;
    const rattleback_lanes z230 = z58 * z192;
    const rattleback_lanes z231 = c_alpha * z230 + z61 * z210;
    const rattleback_lanes z232 = c_beta * z229 + s_beta * z231;
    const rattleback_lanes z233 = z58 * z188;
    const rattleback_lanes z234 = z58 * z209;
    const rattleback_lanes z235 = c_beta * z233 + s_beta * z234;
    const rattleback_lanes z236 = c_beta * z230 + s_beta * z228;
    const rattleback_lanes z237 = k2 * z218;
    const rattleback_lanes z238 = z57 * z206 - z60 * z211;
    const rattleback_lanes z239 = z70 * z196 - z86 * z197 + z76 * z238 - c_beta * z224 - s_beta * z220;
    const rattleback_lanes z240 = s_beta * z235 + c_beta * z236 - z158 * z196 - z157 * z197 + z60 * z237 -
        z61 * z239;
    const rattleback_lanes z241 = z160 * z186;
    const rattleback_lanes z242 = z165 * z186;
    const rattleback_lanes z243 = z166 * z186;
    const rattleback_lanes z244 = c_gamma * z242 - s_gamma * z243;
    const rattleback_lanes z245 = z61 * z188 - c_alpha * z234;
    const rattleback_lanes z246 = c_alpha * z233 + z61 * z209;
    const rattleback_lanes z247 = c_beta * z245 + s_beta * z246;
    const rattleback_lanes z248 = z182 * z189;
    const rattleback_lanes z249 = z183 * z189 - z182 * z190;
    const rattleback_lanes z250 = z165 * z189 + 2.0 * (z19 * z248) - z36 * z249;
    const rattleback_lanes z251 = z166 * z189 - 2.0 * (z18 * z248) + z35 * z249;
    const rattleback_lanes z252 = c_gamma * z250 - s_gamma * z251;
    const rattleback_lanes z253 = z160 * z190 - z15 * z249;
    const rattleback_lanes z254 = z165 * z190 - z19 * z249;
    const rattleback_lanes z255 = z166 * z190 + z18 * z249;
    const rattleback_lanes z256 = c_gamma * z254 - s_gamma * z255;
    const rattleback_lanes z257 = z240 + z115 * z241 + z114 * z244 - z109 * z247 + z14 * z252 + z31 * z253 +
        z30 * z256;
    const rattleback_lanes z258 = z163 * z193 + z161 * z194;
    const rattleback_lanes z259 = z127 * z196 - z60 * z197 - mu2 * z227;
    const rattleback_lanes z260 = z125 * z195 + z126 * z198 - s_beta * z258 + c_beta * z259;
    const rattleback_lanes z261 = z126 * z195 - z125 * z198 + c_beta * z258 + s_beta * z259;
    const rattleback_lanes z262 = s_gamma * z242 + c_gamma * z243;
    const rattleback_lanes z263 = c_alpha * z241 + mu2 * z244;
    const rattleback_lanes z264 = s_beta * z262 - c_beta * z263;
    const rattleback_lanes z265 = c_beta * z262 + s_beta * z263;
    const rattleback_lanes z266 = z182 * z186 - z181 * z189;
    const rattleback_lanes z267 = s_gamma * z254 + c_gamma * z255;
    const rattleback_lanes z268 = c_alpha * z253 + mu2 * z256;
    const rattleback_lanes z269 = c_beta * z267 + s_beta * z268;
    const rattleback_lanes z270 = z110 * z264 - (z112 * z265 + (z145 * z204 + (z139 * z200 + z50 * z266))) +
        z28 * z269;
    const rattleback_lanes z271 = s_beta * z267 - c_beta * z268;
    const rattleback_lanes z272 = omega1 * z260 - (z67 * z261 - (z270 + z23 * z271));
    const rattleback_lanes z273 = z58 * z226 - (z70 * z227 + (z22 * z232 + z257)) + k2 * (z149 * z215 + z4 *
        z272);
    const rattleback_lanes z274 = z181 * z186;
    const rattleback_lanes z275 = z41 * z274;
    const rattleback_lanes z276 = z183 * z190;
    const rattleback_lanes z277 = z4 * z276;
    const rattleback_lanes z278 = z5 * z277;
    const rattleback_lanes z279 = z183 * z186 + z181 * z190;
    const rattleback_lanes z280 = z25 * z266 + z48 * z279;
    const rattleback_lanes z281 = z50 * z279;
    const rattleback_lanes z282 = z7 * z278;
    const rattleback_lanes z283 = z154 * z214 - (z49 * z280 - z47 * z281 + z10 * z276 + z9 * z277 + z5 *
        z282);
    const rattleback_lanes z284 = z60 * z196 + z127 * z197 - c_alpha * z227;
    const rattleback_lanes z285 = mu2 * z241 - c_alpha * z244;
    const rattleback_lanes z286 = s_gamma * z250 + c_gamma * z251;
    const rattleback_lanes z287 = z160 * z189 + 2.0 * (z15 * z248) - z32 * z249;
    const rattleback_lanes z288 = c_alpha * z287 + mu2 * z252;
    const rattleback_lanes z289 = mu2 * z253 - c_alpha * z256;
    const rattleback_lanes z290 = omega1 * z284 - (z145 * z199 - z110 * z285 - c_beta * z286 - s_beta * z288
        - z23 * z289);
    const rattleback_lanes z291 = w2 * z261 - z290;
    const rattleback_lanes z292 = z67 * z284 - (z139 * z199 + z112 * z285 + s_beta * z286 - c_beta * z288 -
        z28 * z289);
    const rattleback_lanes z293 = w2 * z260 - z292;
    const rattleback_lanes z294 = z147 * z217 + (z146 * z213 + (z151 * z215 - z283)) - z13 * z291 + z24 *
        z272 + z12 * z293;
    const rattleback_lanes z295 = z184 * (z148 * z216 + z44 * z274) + 0.5 * (z4 * (z41 * z294));
    const rattleback_lanes z296 = 2.0 * (mu2 * (k4 * (z275 + z4 * z277) - (z43 * z275 + z6 * z278) - k2 *
        z295));
    const rattleback_lanes z297 = z4 * z280;
    const rattleback_lanes z298 = z4 * z281;
    const rattleback_lanes z299 = z129 * z234 - (z130 * z233 + (z5 * z297 - k1 * (s_beta * z298) - 2.0 * (h *
        z278)));
    const rattleback_lanes z300 = 2.0 * (z127 * z238 * z174) + (z158 * z197 - (z157 * z196 + (z167 * z228 -
        (z168 * z230 + z299))));
    const rattleback_lanes z301 = z115 * z244 - (z114 * z241 - (z125 * z220 - (z126 * z224 + z300))) - z14 *
        z287 - z30 * z253;
    const rattleback_lanes z302 = z129 * z188 + z130 * z209 - z167 * z192 - z168 * z210 - z125 * z201 + z126
        * z205;
    const rattleback_lanes z303 = I_c * z189;
    const rattleback_lanes z304 = z132 * z187 - omega1 * z303 + z144 * z189 + z170 * z191 + z150 * z199 +
        z152 * z200;
    const rattleback_lanes z305 = z304 - r1 * z284 - z25 * z261;
    const rattleback_lanes z306 = z143 * z186 + z67 * z189 + z173 * z190;
    const rattleback_lanes z307 = z140 * z186 + z171 * z190;
    const rattleback_lanes z308 = z67 * z303 - z155 * z199 - z152 * z204 - I_a * z306 + I_d * z307 + r3 *
        z284;
    const rattleback_lanes z309 = z308 - z25 * z260;
    const rattleback_lanes z310 = z302 + mu2 * z239 - s_beta * z305 - c_beta * z309;
    const rattleback_lanes z311 = z131 * z188 - z142 * z209 - z169 * z192 - z172 * z210 - z128 * z201 + z136
        * z205;
    const rattleback_lanes z312 = z108 * z193 - e2 * z194;
    const rattleback_lanes z313 = e2 * z193 + z108 * z194;
    const rattleback_lanes z314 = z141 * z190;
    const rattleback_lanes z315 = z314 - z305;
    const rattleback_lanes z316 = z141 * z186;
    const rattleback_lanes z317 = z316 + z309;
    const rattleback_lanes z318 = z311 - c_gamma * z312 - s_gamma * z313 - mu3 * z315 - z1 * z317 + mu2 *
        z226;
    const rattleback_lanes z319 = z139 * z187 - r1 * z285 + z25 * z265;
    const rattleback_lanes z320 = z145 * z202 - r3 * z285 + z25 * z264;
    const rattleback_lanes z321 = z128 * z188 + z60 * z316 + z136 * z209 + mu3 * z319 + z1 * z320 - mu2 *
        z247;
    const rattleback_lanes z322 = z139 * z191 - r1 * z289 + z25 * z269;
    const rattleback_lanes z323 = z145 * z203 + I_d * z249 - r3 * z289 + z25 * z271;
    const rattleback_lanes z324 = mu2 * z232 - (z128 * z192 + z60 * z314 + z136 * z210 + mu3 * z322 + z1 *
        z323);
    const rattleback_lanes z325 = z60 * z310 + (z57 * z318 + (z134 * z206 + z137 * z211 - c_beta * z321 -
        s_beta * z324));
    const rattleback_lanes z326 = z109 * z316 - z22 * z314 + z86 * z196 + z70 * z197 + z133 * z211 - k2 * (z4
        * z215);
    const rattleback_lanes z327 = z326 + mu2 * z237 - z21 * z310;
    const rattleback_lanes z328 = w1 * z327 + (z58 * z315 - (z135 * z201 + z128 * z223 - z109 * z319 + z22 *
        z322));
    const rattleback_lanes z329 = z328 - k3 * (z149 * z214 - z4 * z291) + 2.0 * (mu3 * (k3 * z295));
    const rattleback_lanes z330 = w3 * z327 + (z58 * z317 + (z135 * z205 - z136 * z219 + z109 * z320 - z22 *
        z323));
    const rattleback_lanes z331 = z330 + k1 * (z149 * z213 - z4 * z293) + 2.0 * (z1 * (k1 * z295));
    const rattleback_lanes z332 = mu2 * (z86 * z227 + (z301 + z31 * z256) - z76 * z325 - c_beta * z329 -
        s_beta * z331);
    rattleback_put(slope + 0 * RATTLEBACK_LANES, c_alpha * (z273 + z296) - z332);
    const rattleback_lanes z333 = z133 * z206 + z21 * z318;
    const rattleback_lanes z334 = z122 * z246 - (mu2 * z235 + (z71 * z234 - (z126 * z209 + (z125 * z188 - z46
        * z298))));
    const rattleback_lanes z335 = z127 * z220 - (z138 * z201 + (z156 * z198 - (z153 * z195 + (z121 * z231 +
        (z72 * z228 - z334)))));
    const rattleback_lanes z336 = z113 * z263 - (z111 * z262 + (z124 * z225 - z335)) + 2.0 * (s_beta * (z319
        - k6 * (z7 * z275)));
    const rattleback_lanes z337 = z320 - z322;
    const rattleback_lanes z338 = z336 - r1 * z286 + r3 * z288 - z26 * z267 - z29 * z268 - c_beta * z337 +
        z21 * z324;
    const rattleback_lanes z339 = c_beta * (w1 * z333 - (z61 * z305 + (z68 * z259 + (z63 * z258 + z338))) -
        c_alpha * z331);
    const rattleback_lanes z340 = z125 * z192 + (z122 * z245 - (z71 * z233 - k3 * (c_alpha * z297 + z8 * z277
        + z4 * z282)));
    const rattleback_lanes z341 = z153 * z198 + (z156 * z195 - (mu2 * z236 + (z121 * z229 - (z126 * z210 -
        (z72 * z230 - z340)))));
    const rattleback_lanes z342 = z21 * z321 + (z111 * z263 + (z113 * z262 - (z124 * z221 - (z127 * z224 -
        (z138 * z205 + z341)))));
    const rattleback_lanes z343 = z342 + r3 * z286 + r1 * z288 - z29 * z267 - s_beta * z337 + z26 * z268 -
        2.0 * (c_beta * z323);
    const rattleback_lanes z344 = s_beta * (w3 * z333 + (z61 * z309 - (z63 * z259 - (z68 * z258 + z343))) +
        c_alpha * z329);
    rattleback_put(slope + 1 * RATTLEBACK_LANES, z339 + z344);
    const rattleback_lanes z345 = z164 * z193 - z162 * z194 - z58 * z313 + z117 * z242 + z116 * z243 + z17 *
        z250;
    const rattleback_lanes z346 = z162 * z193 + z164 * z194 + z58 * z312 + z116 * z242 - z117 * z243 + z16 *
        z250;
    const rattleback_lanes z347 = c_gamma * (z345 + z16 * z251 + z34 * z254 + z33 * z255) + s_gamma * (z346 -
        z17 * z251 + z33 * z254 - z34 * z255);
    rattleback_put(slope + 2 * RATTLEBACK_LANES, z347);
    rattleback_put(slope + 3 * RATTLEBACK_LANES, z125 * z207 + z128 * z212 + s_beta * z333 - mu3 * z327);
    const rattleback_lanes z348 = z155 * z200 - z150 * z204 - I_b * z307 + I_d * z306 + r3 * z261 + r1 * z260;
    rattleback_put(slope + 4 * RATTLEBACK_LANES, z226 + z348);
    rattleback_put(slope + 5 * RATTLEBACK_LANES, z126 * z207 + z136 * z212 - c_beta * z333 - z1 * z327);
}

int rattleback_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[142]; /* what parts of this function leave for others */
    for (int entry = 0; entry < 81; ++entry) {
        J[entry] = 0.0;
    }
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    kept[0] = c_alpha;
    const double mu2 = sin(alpha);
    kept[1] = mu2;
    const double s_beta = sin(beta);
    kept[2] = s_beta;
    const double c_beta = cos(beta);
    kept[3] = c_beta;
    const double s_gamma = sin(gamma_);
    kept[4] = s_gamma;
    const double c_gamma = cos(gamma_);
    kept[5] = c_gamma;
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
    kept[6] = k1;
    const double k2 = b * b;
    kept[7] = k2;
    const double k3 = c * c;
    kept[8] = k3;
    const double k4 = b * b * b * b;
    kept[9] = k4;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;
    kept[10] = k6;
    const double k7 = k1 - k3;

    /* state */
    const double z1 = c_alpha * s_beta;
    kept[11] = z1;
    const double z2 = mu2 * mu2;
    const double mu3 = c_beta * c_alpha;
    kept[12] = mu3;
    const double z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3);
    const double z4 = 1.0 / sqrt(z3);
    kept[13] = z4;
    const double z5 = c_beta * k3;
    kept[14] = z5;
    const double z6 = z4 * z5;
    kept[15] = z6;
    const double z7 = 1.0 - z2;
    kept[16] = z7;
    const double z8 = z6 * z7 - 2.0 * (h * c_alpha);
    kept[17] = z8;
    const double z9 = z2 * k4;
    kept[18] = z9;
    const double z10 = z5 * z8 + z4 * z9;
    kept[19] = z10;
    const double z11 = z4 * z10 + k5;
    const double z12 = z1 * k1;
    kept[20] = z12;
    const double r1 = z12 * z4;
    kept[21] = r1;
    const double z13 = mu3 * k3;
    kept[22] = z13;
    const double r3 = h - z4 * z13;
    kept[23] = r3;
    const double z14 = c_beta * r1 + s_beta * r3;
    kept[24] = z14;
    const double z15 = c_alpha * z14;
    kept[25] = z15;
    const double z16 = mu2 * z14;
    kept[26] = z16;
    const double z17 = s_beta * r1 - c_beta * r3;
    kept[27] = z17;
    const double z18 = s_gamma * z16 + c_gamma * z17;
    kept[28] = z18;
    const double z19 = c_gamma * z16 - s_gamma * z17;
    kept[29] = z19;
    const double z20 = I_b + (z15 * z15 + (z18 * z18 + z19 * z19));
    const double z21 = 1.0 / c_alpha;
    kept[30] = z21;
    const double z22 = s_beta * z21;
    kept[31] = z22;
    const double z23 = z1 * z22 + c_beta * c_beta;
    kept[32] = z23;
    const double z24 = mu2 * k2;
    kept[33] = z24;
    const double z25 = z4 * z24;
    kept[34] = z25;
    const double z26 = z25 * z23;
    kept[35] = z26;
    const double z27 = c_beta * s_beta;
    const double z28 = mu3 * z22 - z27;
    kept[36] = z28;
    const double z29 = z25 * z28;
    kept[37] = z29;
    const double z30 = c_beta * z26 - s_beta * z29;
    kept[38] = z30;
    const double z31 = r3 * z23 + r1 * z28;
    kept[39] = z31;
    const double z32 = c_alpha * z30 + mu2 * z31;
    kept[40] = z32;
    const double z33 = mu2 * z30 - c_alpha * z31;
    kept[41] = z33;
    const double z34 = s_beta * z26 + c_beta * z29;
    kept[42] = z34;
    const double z35 = s_gamma * z33 + c_gamma * z34;
    kept[43] = z35;
    const double z36 = c_gamma * z33 - s_gamma * z34;
    kept[44] = z36;
    const double z37 = I_d * z23 + (z32 * z15 + (z35 * z18 + z36 * z19));
    const double z38 = 1.0 / z11;
    kept[45] = z38;
    const double z39 = z37 * z38;
    kept[46] = z39;
    const double z40 = z20 - z37 * z39;
    const double z41 = 1.0 / z3;
    kept[47] = z41;
    const double z42 = s_beta * s_beta;
    const double z43 = z42 * k6;
    kept[48] = z43;
    const double z44 = z9 + z7 * z43;
    kept[49] = z44;
    const double z45 = I_c + z41 * z44;
    const double z46 = c_alpha * k1;
    kept[50] = z46;
    const double z47 = s_beta * z46;
    kept[51] = z47;
    const double z48 = z4 * z47;
    kept[52] = z48;
    const double z49 = c_alpha * z5;
    kept[53] = z49;
    const double z50 = h - z4 * z49;
    kept[54] = z50;
    const double z51 = z48 * z50;
    const double z52 = z51 * z38;
    kept[55] = z52;
    const double z53 = z25 * z50 + z37 * z52;
    const double z54 = 1.0 / z40;
    kept[56] = z54;
    const double z55 = z53 * z54;
    kept[57] = z55;
    const double z56 = z45 - z51 * z52 - z53 * z55;
    const double z57 = s_beta * w1 - c_beta * w3;
    kept[58] = z57;
    const double z58 = z21 * z57;
    kept[59] = z58;
    const double z59 = z1 * z58;
    const double z60 = z1 * w3 + mu3 * w1;
    kept[60] = z60;
    const double z61 = z60 * z21;
    kept[61] = z61;
    const double z62 = c_beta * z61;
    const double omega1 = z59 + z62;
    kept[62] = omega1;
    const double z63 = r1 * w2 + z25 * omega1;
    kept[63] = z63;
    const double z64 = c_beta * z63;
    const double z65 = mu3 * z58;
    const double z66 = s_beta * z61;
    const double z67 = z65 - z66;
    kept[64] = z67;
    const double z68 = z25 * z67 - r3 * w2;
    kept[65] = z68;
    const double z69 = s_beta * z68;
    const double z70 = z64 - z69;
    kept[66] = z70;
    const double z71 = s_beta * mu2;
    kept[67] = z71;
    const double z72 = c_beta * mu2;
    kept[68] = z72;
    const double z73 = z41 * (z4 * (k1 * (z1 * z71) - k2 * (c_alpha * mu2) + k3 * (mu3 * z72)));
    const double z74 = z4 * (k1 * z71) - z12 * z73;
    const double z75 = z24 * z73 + z4 * (c_alpha * k2);
    const double z76 = 1.0 / (c_alpha * c_alpha);
    kept[69] = z76;
    const double z77 = mu2 * z76;
    const double z78 = z57 * z77;
    const double z79 = z21 * (w3 * z71 + w1 * z72) - z60 * z77;
    const double z80 = z58 * z71 - z1 * z78 + c_beta * z79;
    const double z81 = w2 * z74 - (omega1 * z75 - z25 * z80);
    const double z82 = z58 * z72 - mu3 * z78 - s_beta * z79;
    const double z83 = z13 * z73 - z4 * (k3 * z72);
    const double z84 = z67 * z75 - z25 * z82 + w2 * z83;
    const double z85 = c_beta * z81 + s_beta * z84;
    const double z86 = r3 * omega1 + r1 * z67;
    kept[70] = z86;
    const double z87 = omega1 * z83 + r3 * z80 + (z67 * z74 + r1 * z82);
    const double z88 = c_alpha * z70 - mu2 * z85 + (mu2 * z86 + c_alpha * z87);
    const double z89 = s_beta * z81 - c_beta * z84;
    /* (I.2.15) */
    J[3] = c_gamma * z89 - s_gamma * z88;
    const double z90 = s_beta * z63;
    const double z91 = z41 * (z4 * (k7 * (z1 * mu3)));
    const double z92 = z4 * (mu3 * k1) - z12 * z91;
    const double z93 = z24 * z91;
    const double z94 = z21 * (c_beta * w1 + s_beta * w3);
    const double z95 = z21 * (mu3 * w3 - z1 * w1);
    const double z96 = z65 + z1 * z94 - (z66 - c_beta * z95);
    const double z97 = w2 * z92 - (omega1 * z93 - z25 * z96);
    const double z98 = c_beta * z68;
    const double z99 = z59 - mu3 * z94 + (z62 + s_beta * z95);
    const double z100 = z13 * z91 + z4 * (z1 * k3);
    const double z101 = z67 * z93 + z25 * z99 + w2 * z100;
    const double z102 = z90 - c_beta * z97 + (z98 - s_beta * z101);
    const double z103 = omega1 * z100 + r3 * z96 + (z67 * z92 - r1 * z99);
    const double z104 = mu2 * z102 + c_alpha * z103;
    const double z105 = z64 + s_beta * z97 - (z69 + c_beta * z101);
    J[4] = s_gamma * z104 - c_gamma * z105;
    const double z106 = mu2 * z70;
    const double z107 = c_alpha * z86;
    const double e2 = z106 - z107;
    kept[71] = e2;
    const double z108 = z90 + z98;
    kept[72] = z108;
    J[5] = s_gamma * z108 - c_gamma * e2;
    J[6] = -z35;
    J[7] = -z18;
    const double z109 = c_beta * z21;
    kept[73] = z109;
    const double z110 = z27 - z1 * z109;
    kept[74] = z110;
    const double z111 = z25 * z110;
    kept[75] = z111;
    const double z112 = mu3 * z109 + z42;
    kept[76] = z112;
    const double z113 = z25 * z112;
    kept[77] = z113;
    const double z114 = c_beta * z111 + s_beta * z113;
    kept[78] = z114;
    const double z115 = r3 * z110 - r1 * z112;
    kept[79] = z115;
    const double z116 = mu2 * z114 - c_alpha * z115;
    kept[80] = z116;
    const double z117 = s_beta * z111 - c_beta * z113;
    kept[81] = z117;
    const double z118 = s_gamma * z116 + c_gamma * z117;
    kept[82] = z118;
    J[8] = -z118;
    J[12] = c_gamma * z88 + s_gamma * z89;
    J[13] = -(c_gamma * z104 + s_gamma * z105);
    J[14] = -(s_gamma * e2 + c_gamma * z108);
    J[15] = z36;
    J[16] = z19;
    const double z119 = c_gamma * z116 - s_gamma * z117;
    kept[83] = z119;
    J[17] = z119;
    J[21] = z106 + c_alpha * z85 - (z107 - mu2 * z87);
    J[22] = c_alpha * z102 - mu2 * z103;
    J[24] = -z32;
    J[25] = -z15;
    const double z120 = c_alpha * z114 + mu2 * z115;
    kept[84] = z120;
    J[26] = -z120;
    J[30] = -z79;
    J[31] = z95;
    J[33] = c_beta;
    J[35] = s_beta;
    J[39] = z57 + mu2 * z78;
    J[40] = mu2 * z94;
    const double z121 = mu2 * z22;
    kept[85] = z121;
    J[42] = z121;
    J[43] = 1.0;
    const double z122 = mu2 * z109;
    kept[86] = z122;
    J[44] = -z122;
    J[48] = -z78;
    J[49] = -z94;
    J[51] = -z22;
    J[53] = z109;
    const double z123 = 1.0 / z56;
    kept[87] = z123;
    const double z124 = w2 + mu2 * z58;
    kept[88] = z124;
    const double z125 = c_beta * z124;
    kept[89] = z125;
    const double z126 = s_beta * z124;
    kept[90] = z126;
    const double z127 = mu2 * z61;
    kept[91] = z127;
    const double z128 = c_alpha * z126 + c_beta * z127;
    kept[92] = z128;
    const double z129 = c_beta * z122;
    kept[93] = z129;
    const double z130 = s_beta * z122;
    kept[94] = z130;
    const double z131 = c_alpha * z130 - c_beta * z71;
    kept[95] = z131;
    const double z132 = s_beta * z125 - z109 * z128 + (z61 * z129 + z58 * z131);
    kept[96] = z132;
    const double z133 = z127 * z76;
    kept[97] = z133;
    const double z134 = w1 * z125 + w3 * z126;
    kept[98] = z134;
    const double z135 = z57 * z133 + z21 * z134;
    kept[99] = z135;
    const double z136 = s_beta * z127 - c_alpha * z125;
    kept[100] = z136;
    const double z137 = w3 * z136 + w1 * z128;
    kept[101] = z137;
    const double z138 = z21 * z137 - z60 * z133;
    kept[102] = z138;
    const double z139 = z58 * z128 - mu3 * z135 + (z61 * z125 - s_beta * z138);
    kept[103] = z139;
    const double z140 = z59 + z60 * z109;
    kept[104] = z140;
    const double z141 = I_d * omega1 + I_b * w2;
    kept[105] = z141;
    const double z142 = s_beta * z71 + c_alpha * z129;
    kept[106] = z142;
    const double z143 = s_beta * z126 - z109 * z136 + (z61 * z130 - z58 * z142);
    kept[107] = z143;
    const double z144 = I_d * w2 + I_a * omega1;
    kept[108] = z144;
    const double z145 = z58 * z136 - z1 * z135 + (z61 * z126 + c_beta * z138);
    kept[109] = z145;
    const double z146 = k1 * z136;
    kept[110] = z146;
    const double z147 = k1 * (z1 * z136) - k2 * (mu2 * z60) + k3 * (mu3 * z128);
    kept[111] = z147;
    const double z148 = z4 * z147;
    kept[112] = z148;
    const double z149 = z148 * z41;
    kept[113] = z149;
    const double z150 = z4 * z146 - z12 * z149;
    kept[114] = z150;
    const double z151 = k2 * z60;
    kept[115] = z151;
    const double z152 = z24 * z149 + z4 * z151;
    kept[116] = z152;
    const double z153 = w2 * z150 - (omega1 * z152 - z25 * z145);
    kept[117] = z153;
    const double z154 = k3 * z128;
    kept[118] = z154;
    const double z155 = z13 * z149 - z4 * z154;
    kept[119] = z155;
    const double z156 = z67 * z152 - z25 * z139 + w2 * z155;
    kept[120] = z156;
    const double z157 = z63 * z126 + c_beta * z153 + (z68 * z125 + s_beta * z156);
    kept[121] = z157;
    const double z158 = omega1 * z155 + r3 * z145 + (z67 * z150 + r1 * z139);
    kept[122] = z158;
    const double z159 = z70 * z127 + c_alpha * z157 - (z60 * z86 - mu2 * z158);
    const double z160 = g - z159;
    kept[123] = z160;
    const double z161 = s_gamma * z58;
    kept[124] = z161;
    const double z162 = z60 * z70 - mu2 * z157 + (z86 * z127 + c_alpha * z158);
    kept[125] = z162;
    const double z163 = c_gamma * z58;
    kept[126] = z163;
    const double z164 = z63 * z125 - s_beta * z153 - (z68 * z126 - c_beta * z156);
    kept[127] = z164;
    const double z165 = e2 * z161 + c_gamma * z162 + (z108 * z163 - s_gamma * z164);
    kept[128] = z165;
    const double z166 = e2 * z163 - s_gamma * z162 - (z108 * z161 + c_gamma * z164);
    kept[129] = z166;
    const double z167 = c_beta * z121;
    kept[130] = z167;
    const double z168 = s_beta * z121;
    kept[131] = z168;
    const double z169 = c_alpha * z168 + c_beta * z72;
    kept[132] = z169;
    const double z170 = c_beta * z125 + z22 * z128 - (z61 * z167 + z58 * z169);
    kept[133] = z170;
    const double z171 = z65 - z60 * z22;
    kept[134] = z171;
    const double z172 = s_beta * z72 - c_alpha * z167;
    kept[135] = z172;
    const double z173 = c_beta * z126 + z22 * z136 - (z61 * z168 + z58 * z172);
    kept[136] = z173;
    const double z174 = 1.0 / (c_alpha * c_alpha * c_alpha);
    kept[137] = z174;
    const double z175 = z141 * z140 - (z144 * z143 + (z120 * z159 + (z118 * z166 - z119 * z165))) - I_a *
        (z110 * z145);
    const double z176 = z141 * z171 - (z144 * z173 + (z32 * z159 + (z35 * z166 - z36 * z165))) - I_a * (z23 *
        z145);
    const double z177 = z176 - I_c * (z28 * z139 + z67 * z170) + g * z32;
    const double z178 = I_d * z145 + (z67 * z144 + (z15 * z159 + (z18 * z166 - z19 * z165))) - I_c * (omega1
        * z67);
    const double z179 = z178 - g * z15 + z177 * z39;
    const double z180 = z175 + I_c * (z112 * z139 - z67 * z132) + g * z120 + z177 * z52 + z55 * z179;
    const double z181 = z123 * z180;
    kept[138] = z181;
    const double z182 = z54 * z179 + z55 * z181;
    kept[139] = z182;
    const double z183 = z177 * z38 + z39 * z182 + z52 * z181;
    kept[140] = z183;
    const double z184 = 1.0 / (z3 * z3);
    kept[141] = z184;
    /* the coframe is singular */
    if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(z11) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z40) > 1e-14 * z20)) {
        return RATTLEBACK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z56) > 1e-14 * z45)) {
        return RATTLEBACK_SINGULAR_2;
    }

    /* one rate in each pass: its row of the matrix */
    for (int first = 0; first < 3; first += RATTLEBACK_LANES) {
        static const int offset[] = {54, 63, 72};
        static const int entry[] = {3, 4, 5, 6, 7, 8};
        double seed[3 * RATTLEBACK_LANES];
        double slope[6 * RATTLEBACK_LANES];
        rattleback_unit(3, first, seed);
        rattleback_jacobian_sweep1(t, y, p, kept, seed, slope);
        rattleback_place(3 - first, offset + first, 6, entry, slope, J);
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
    /* the coframe is singular */
    if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    return rattleback_finish(1, out);
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
    const double k4 = fixed[9];
    const double k5 = fixed[10];
    const double k6 = fixed[11];
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
    const rattleback_lanes z2 = mu2 * mu2;
    const rattleback_lanes c_beta = cosine2;
    const rattleback_lanes mu3 = c_beta * c_alpha;
    const rattleback_lanes z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3);
    const rattleback_lanes z4 = 1.0 / rattleback_each_sqrt(RATTLEBACK_SPREAD(z3));
    const rattleback_lanes z5 = c_beta * k3;
    const rattleback_lanes z6 = z4 * z5;
    const rattleback_lanes z7 = 1.0 - z2;
    const rattleback_lanes z8 = z2 * k4;
    const rattleback_lanes z9 = z4 * (z5 * (z6 * z7 - 2.0 * (h * c_alpha)) + z4 * z8) + k5;
    /* the mass matrix is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z9)), RATTLEBACK_SPREAD(0.0));
    const rattleback_lanes z10 = z1 * k1;
    const rattleback_lanes r1 = z10 * z4;
    const rattleback_lanes z11 = mu3 * k3;
    const rattleback_lanes r3 = h - z4 * z11;
    const rattleback_lanes z12 = c_beta * r1 + s_beta * r3;
    const rattleback_lanes z13 = c_alpha * z12;
    rattleback_lanes sine3, cosine3;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(gamma_), &far, &sine3, &cosine3);
    const rattleback_lanes s_gamma = sine3;
    const rattleback_lanes z14 = mu2 * z12;
    const rattleback_lanes c_gamma = cosine3;
    const rattleback_lanes z15 = s_beta * r1 - c_beta * r3;
    const rattleback_lanes z16 = s_gamma * z14 + c_gamma * z15;
    const rattleback_lanes z17 = c_gamma * z14 - s_gamma * z15;
    const rattleback_lanes z18 = I_b + (z13 * z13 + (z16 * z16 + z17 * z17));
    const rattleback_lanes z19 = 1.0 / c_alpha;
    const rattleback_lanes z20 = s_beta * z19;
    const rattleback_lanes z21 = z1 * z20 + c_beta * c_beta;
    const rattleback_lanes z22 = mu2 * k2;
    const rattleback_lanes z23 = z4 * z22;
    const rattleback_lanes z24 = z23 * z21;
    const rattleback_lanes z25 = c_beta * s_beta;
    const rattleback_lanes z26 = mu3 * z20 - z25;
    const rattleback_lanes z27 = z23 * z26;
    const rattleback_lanes z28 = c_beta * z24 - s_beta * z27;
    const rattleback_lanes z29 = r3 * z21 + r1 * z26;
    const rattleback_lanes z30 = c_alpha * z28 + mu2 * z29;
    const rattleback_lanes z31 = mu2 * z28 - c_alpha * z29;
    const rattleback_lanes z32 = s_beta * z24 + c_beta * z27;
    const rattleback_lanes z33 = s_gamma * z31 + c_gamma * z32;
    const rattleback_lanes z34 = c_gamma * z31 - s_gamma * z32;
    const rattleback_lanes z35 = I_d * z21 + (z30 * z13 + (z33 * z16 + z34 * z17));
    const rattleback_lanes z36 = 1.0 / z9;
    const rattleback_lanes z37 = z35 * z36;
    const rattleback_lanes z38 = z18 - z35 * z37;
    /* the mass matrix is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z38)), 1e-14 * z18);
    const rattleback_lanes z39 = 1.0 / z3;
    const rattleback_lanes z40 = s_beta * s_beta;
    const rattleback_lanes z41 = I_c + z39 * (z8 + k6 * (z40 * z7));
    const rattleback_lanes z42 = h - c_alpha * z6;
    const rattleback_lanes z43 = r1 * z42;
    const rattleback_lanes z44 = z36 * z43;
    const rattleback_lanes z45 = z23 * z42 + z35 * z44;
    const rattleback_lanes z46 = 1.0 / z38;
    const rattleback_lanes z47 = z46 * z45;
    const rattleback_lanes z48 = z41 - z43 * z44 - z45 * z47;
    /* the mass matrix is singular */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z48)), 1e-14 * z41);
    const rattleback_lanes z49 = s_beta * w1 - c_beta * w3;
    const rattleback_lanes z50 = z19 * z49;
    const rattleback_lanes z51 = z1 * z50;
    const rattleback_lanes z52 = z1 * w3 + mu3 * w1;
    const rattleback_lanes z53 = z52 * z19;
    const rattleback_lanes omega1 = z51 + c_beta * z53;
    const rattleback_lanes z54 = r1 * w2 + z23 * omega1;
    const rattleback_lanes z55 = mu3 * z50;
    const rattleback_lanes z56 = z55 - s_beta * z53;
    const rattleback_lanes z57 = z23 * z56 - r3 * w2;
    const rattleback_lanes z58 = c_beta * z54 - s_beta * z57;
    const rattleback_lanes z59 = r3 * omega1 + r1 * z56;
    const rattleback_lanes e2 = mu2 * z58 - c_alpha * z59;
    const rattleback_lanes z60 = s_beta * z54 + c_beta * z57;
    const rattleback_lanes z61 = w2 + mu2 * z50;
    const rattleback_lanes z62 = s_beta * z61;
    const rattleback_lanes z63 = mu2 * z53;
    const rattleback_lanes z64 = c_alpha * z62 + c_beta * z63;
    const rattleback_lanes z65 = z63 / (c_alpha * c_alpha);
    const rattleback_lanes z66 = c_beta * z61;
    const rattleback_lanes z67 = z49 * z65 + z19 * (w1 * z66 + w3 * z62);
    const rattleback_lanes z68 = s_beta * z63 - c_alpha * z66;
    const rattleback_lanes z69 = z19 * (w3 * z68 + w1 * z64) - z52 * z65;
    const rattleback_lanes z70 = z50 * z64 - mu3 * z67 + (z53 * z66 - s_beta * z69);
    const rattleback_lanes z71 = mu2 * z20;
    const rattleback_lanes z72 = c_beta * z71;
    const rattleback_lanes z73 = s_beta * z71;
    const rattleback_lanes z74 = c_beta * mu2;
    const rattleback_lanes z75 = z56 * (c_beta * z66 + z20 * z64 - (z53 * z72 + z50 * (c_alpha * z73 + c_beta
        * z74)));
    const rattleback_lanes z76 = I_d * omega1 + I_b * w2;
    const rattleback_lanes z77 = I_d * w2 + I_a * omega1;
    const rattleback_lanes z78 = z77 * (c_beta * z62 + z20 * z68 - (z53 * z73 + z50 * (s_beta * z74 - c_alpha
        * z72)));
    const rattleback_lanes z79 = z39 * (z4 * (z10 * z68 - z22 * z52 + z11 * z64));
    const rattleback_lanes z80 = k1 * (z4 * z68) - z10 * z79;
    const rattleback_lanes z81 = z50 * z68 - z1 * z67 + (z53 * z62 + c_beta * z69);
    const rattleback_lanes z82 = z22 * z79 + k2 * (z4 * z52);
    const rattleback_lanes z83 = w2 * z80 + (z23 * z81 - omega1 * z82);
    const rattleback_lanes z84 = z11 * z79 - k3 * (z4 * z64);
    const rattleback_lanes z85 = z23 * z70 - z56 * z82 - w2 * z84;
    const rattleback_lanes z86 = z54 * z62 + c_beta * z83 + (z57 * z66 - s_beta * z85);
    const rattleback_lanes z87 = r3 * z81 + omega1 * z84 + (r1 * z70 + z56 * z80);
    const rattleback_lanes z88 = z58 * z63 + c_alpha * z86 - (z52 * z59 - mu2 * z87);
    const rattleback_lanes z89 = c_gamma * z50;
    const rattleback_lanes z90 = z52 * z58 - mu2 * z86 + (z59 * z63 + c_alpha * z87);
    const rattleback_lanes z91 = s_gamma * z50;
    const rattleback_lanes z92 = z54 * z66 - s_beta * z83 - (z57 * z62 + c_beta * z85);
    const rattleback_lanes z93 = e2 * z89 - s_gamma * z90 - (z60 * z91 + c_gamma * z92);
    const rattleback_lanes z94 = e2 * z91 + c_gamma * z90 + (z60 * z89 - s_gamma * z92);
    const rattleback_lanes z95 = I_a * z81;
    const rattleback_lanes z96 = z76 * (z55 - z52 * z20) - (z78 + (z30 * z88 + (z33 * z93 - z34 * z94))) -
        z21 * z95;
    const rattleback_lanes z97 = g * z30 - (I_c * (z26 * z70 + z75) - z96);
    const rattleback_lanes z98 = I_c * (omega1 * z56) - (I_d * z81 + (z56 * z77 + (z13 * z88 + (z16 * z93 -
        z17 * z94))));
    const rattleback_lanes z99 = g * z13 + z98 - z37 * z97;
    const rattleback_lanes z100 = c_beta * z19;
    const rattleback_lanes z101 = z25 - z1 * z100;
    const rattleback_lanes z102 = z23 * z101;
    const rattleback_lanes z103 = mu3 * z100 + z40;
    const rattleback_lanes z104 = z23 * z103;
    const rattleback_lanes z105 = c_beta * z102 + s_beta * z104;
    const rattleback_lanes z106 = r3 * z101 - r1 * z103;
    const rattleback_lanes z107 = c_alpha * z105 + mu2 * z106;
    const rattleback_lanes z108 = mu2 * z100;
    const rattleback_lanes z109 = c_beta * z108;
    const rattleback_lanes z110 = s_beta * z108;
    const rattleback_lanes z111 = s_beta * mu2;
    const rattleback_lanes z112 = z56 * (s_beta * z66 - z100 * z64 + (z53 * z109 + z50 * (c_alpha * z110 -
        c_beta * z111)));
    const rattleback_lanes z113 = z77 * (s_beta * z62 - z100 * z68 + (z53 * z110 - z50 * (s_beta * z111 +
        c_alpha * z109)));
    const rattleback_lanes z114 = mu2 * z105 - c_alpha * z106;
    const rattleback_lanes z115 = s_beta * z102 - c_beta * z104;
    const rattleback_lanes z116 = z107 * z88 + ((s_gamma * z114 + c_gamma * z115) * z93 - (c_gamma * z114 -
        s_gamma * z115) * z94);
    const rattleback_lanes z117 = I_c * (z103 * z70 - z112) + (z76 * (z51 + z52 * z100) - (z113 + z116) -
        z101 * z95);
    const rattleback_lanes z118 = (g * z107 + z117 + z97 * z44 - z47 * z99) / z48;
    const rattleback_lanes z119 = z46 * z99 - z47 * z118;
    /* (I.2.15) */
    const rattleback_lanes slope1 = -(s_gamma * e2 + c_gamma * z60);
    sum += slope1;
    rattleback_put(dydt, slope1);
    const rattleback_lanes slope2 = c_gamma * e2 - s_gamma * z60;
    sum += slope2;
    rattleback_put(dydt + 1 * stride, slope2);
    const rattleback_lanes slope3 = -(c_alpha * z58 + mu2 * z59);
    sum += slope3;
    rattleback_put(dydt + 2 * stride, slope3);
    const rattleback_lanes slope4 = z53;
    sum += slope4;
    rattleback_put(dydt + 3 * stride, slope4);
    const rattleback_lanes slope5 = z61;
    sum += slope5;
    rattleback_put(dydt + 4 * stride, slope5);
    const rattleback_lanes slope6 = -z50;
    sum += slope6;
    rattleback_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 41:4 */
    const rattleback_lanes slope7 = -(z36 * z97 - z37 * z119 + z44 * z118);
    sum += slope7;
    rattleback_put(dydt + 6 * stride, slope7);
    const rattleback_lanes slope8 = -z119;
    sum += slope8;
    rattleback_put(dydt + 7 * stride, slope8);
    const rattleback_lanes slope9 = -z118;
    sum += slope9;
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
    const double k4 = b * b * b * b;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;
    const double fixed[] = {h, I_a, I_b, I_c, I_d, g, k1, k2, k3, k4, k5, k6};
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
