/*
 * veselova.c: veselova, emitted by nhc 0.1.0 (nhc:8aae1dd6d248ba4c)
 * A rigid body with a fixed point that must not turn about the vertical.
 * Source: veselova.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * veselova.h says what each function does.
 */
#include "veselova.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const veselova_coordinate_names[] = {
    "phi",
    "theta",
    "psi"
};
const char *const veselova_state_names[] = {
    "phi",
    "theta",
    "psi",
    "w_x",
    "w_y"
};
const char *const veselova_parameter_names[] = {
    "I1",
    "I2",
    "I3"
};
const double veselova_parameter_defaults[] = {
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
__attribute__((noinline)) /* it is seldom called, and would cost its callers registers */
#endif
static int veselova_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
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
static int veselova_one_by_one(size_t count, size_t first, size_t number, const double *t, const double *y, const double *p, double *dydt)
{
    int status = VESELOVA_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[VESELOVA_NY];
        double slope[VESELOVA_NY];
        for (size_t k = 0; k < VESELOVA_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = NAN;
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

/* no number where a bit is set */
static inline veselova_lanes veselova_mark(veselova_lanes value, veselova_bits bad)
{
    return (veselova_lanes)((veselova_bits)value | bad);
}

static inline veselova_lanes veselova_size(veselova_lanes x)
{
    return (veselova_lanes)((veselova_bits)x & 0x7fffffffffffffffULL);
}
/* whether none of the states must be asked again: no singular block, no infinity, no angle anywhere near 1e5 */
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

/* the last states, fewer than there are lanes; the others repeat the last one */
static inline void veselova_fill(size_t left, size_t count, const double *t, const double *y, double *time, double *state)
{
    for (size_t l = 0; l < VESELOVA_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < VESELOVA_NY; ++k) {
            state[k * VESELOVA_LANES + l] = y[k * count + i];
        }
    }
}

static inline void veselova_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < VESELOVA_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * VESELOVA_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void veselova_turn_lanes(veselova_lanes x, veselova_lanes *far, veselova_lanes *sine, veselova_lanes *cosine)
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

int veselova_rhs(double t, const double *y, const double *p, double *dydt)
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
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* state */
    const double z1 = s_psi * s_psi;
    const double z2 = 1.0 - z1;
    const double z3 = I1 * z2 + I2 * z1;
    const double z4 = s_theta * s_theta;
    const double z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4);
    const double z6 = s_psi * c_theta;
    const double z7 = k1 * (c_psi * z6);
    const double z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7));
    const double z9 = 2.0 * (s_phi * z7);
    const double z10 = c_theta * c_theta;
    const double z11 = z9 + c_phi * (I3 * (1.0 - z10) - (I1 - I2 * z10) + k1 * (z1 * (1.0 + z10)));
    const double z12 = z3 + c_phi * z11;
    const double z13 = z7 + s_phi * (c_phi * z5 - z9);
    const double z14 = 1.0 / z8;
    const double z15 = z13 * z14;
    const double z16 = z12 - z13 * z15;
    const double z17 = 1.0 / s_theta;
    const double z18 = s_phi * w_x - c_phi * w_y;
    const double z19 = z17 * z18;
    const double z20 = s_theta * w_y;
    const double z21 = s_theta * w_x;
    const double z22 = k1 * (s_psi * (z18 * z6 - c_psi * (c_phi * w_x + s_phi * w_y))) + k2 * (c_theta * z18);
    const double z23 = z20 * z22;
    const double z24 = (z21 * z22 + z23 * z15) / z16;
    /* (I.2.15) */
    dydt[0] = -c_theta * z19; /* phi' */
    dydt[1] = z17 * (s_phi * z20 + c_phi * z21); /* theta' */
    dydt[2] = z19; /* psi' */
    /* (I.2.15) 24:4 */
    dydt[3] = z23 * z14 + z15 * z24; /* w_x' */
    dydt[4] = -z24; /* w_y' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[3] + dydt[4]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(z16) > 1e-14 * z12)) {
        /* the coframe is singular */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return VESELOVA_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z8) > 0.0)) {
            return VESELOVA_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * z12)) {
            return VESELOVA_SINGULAR_2;
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
    const double w_x = y[3];
    const double w_y = y[4];

    /* state */
    const double z1 = 1.0 / s_theta;
    const double z2 = z1 * (s_phi * w_x - c_phi * w_y);
    /* (I.2.4) */
    qdot[0] = -c_theta * z2; /* phi' */
    qdot[1] = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1; /* theta' */
    qdot[2] = z2; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return VESELOVA_SINGULAR_1;
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
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* state */
    const double z1 = s_psi * s_psi;
    const double z2 = 1.0 - z1;
    const double z3 = I1 * z2 + I2 * z1;
    const double z4 = s_theta * s_theta;
    const double z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4);
    const double z6 = s_psi * c_theta;
    const double z7 = k1 * (c_psi * z6);
    const double z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7));
    const double z9 = 2.0 * (s_phi * z7);
    const double z10 = c_theta * c_theta;
    const double z11 = z9 + c_phi * (I3 * (1.0 - z10) - (I1 - I2 * z10) + k1 * (z1 * (1.0 + z10)));
    const double z12 = z3 + c_phi * z11;
    const double z13 = z7 + s_phi * (c_phi * z5 - z9);
    const double z14 = 1.0 / z8;
    const double z15 = z13 * z14;
    const double z16 = z12 - z13 * z15;
    const double z17 = s_theta * s_phi;
    const double z18 = s_theta * c_phi;
    const double z19 = z17 * w_y + z18 * w_x;
    const double z20 = 1.0 / s_theta;
    const double z21 = s_phi * w_x - c_phi * w_y;
    const double z22 = z20 * z21;
    const double z23 = z20 * (c_theta * z19);
    const double z24 = z20 * z20 * z23;
    const double z25 = c_theta * z22;
    const double z26 = c_phi * z25;
    const double z27 = k1 * (s_psi * (z21 * z6 - c_psi * (c_phi * w_x + s_phi * w_y))) + k2 * (c_theta * z21);
    const double z28 = s_theta * z27;
    const double z29 = w_y * z28;
    const double z30 = (w_x * z28 + z15 * z29) / z16;
    const double z31 = z14 * z29 + z15 * z30;
    const double z32 = s_phi * z25;
    const double z33 = z21 * z24 + z20 * (w_x * z26 - s_phi * z31 + (w_y * z32 - c_phi * z30));
    const double z34 = w_y * (s_theta * z26 - s_phi * z23) + z17 * z30 - (w_x * (s_theta * z32 + c_phi * z23)
        + z18 * z31);
    /* (I.2.15) */
    qddot[0] = z19 * z22 + c_theta * z33; /* phi'' */
    qddot[1] = -(z19 * z24 + z20 * z34); /* theta'' */
    qddot[2] = -z33; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(z16) > 1e-14 * z12)) {
        /* the coframe is singular */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return VESELOVA_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z8) > 0.0)) {
            return VESELOVA_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * z12)) {
            return VESELOVA_SINGULAR_2;
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
    const double psi = q[2]; /* spin [rad] */
    const double theta_dot = qdot[1];
    const double psi_dot = qdot[2];

    /* state */
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
    const double phi_dot = qdot[0];
    const double psi_dot = qdot[2];

    /* state */
    const double c_theta = cos(theta);
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
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* state */
    const double z1 = s_psi * s_psi;
    const double z2 = 1.0 - z1;
    const double z3 = I1 * z2 + I2 * z1;
    const double z4 = s_theta * s_theta;
    const double z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + (I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4);
    const double z6 = s_psi * c_theta;
    const double z7 = k1 * (c_psi * z6);
    const double z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7));
    const double z9 = 2.0 * (s_phi * z7);
    const double z10 = c_theta * c_theta;
    const double z11 = z9 + c_phi * (I3 * (1.0 - z10) - (I1 - I2 * z10) + k1 * (z1 * (1.0 + z10)));
    const double z12 = z3 + c_phi * z11;
    const double z13 = z7 + s_phi * (c_phi * z5 - z9);
    const double z14 = 1.0 / z8;
    const double z15 = z13 * z14;
    const double z16 = z12 - z13 * z15;
    const double z17 = s_theta * s_psi;
    const double z18 = 1.0 / s_theta;
    const double z19 = s_phi * w_x - c_phi * w_y;
    const double z20 = z18 * z19;
    const double z21 = c_theta * z20;
    const double z22 = c_psi * z20;
    const double z23 = s_theta * w_y;
    const double z24 = s_theta * w_x;
    const double z25 = s_phi * z23 + c_phi * z24;
    const double z26 = z18 * z25;
    const double z27 = c_theta * z26;
    const double z28 = s_theta * z22 + s_psi * z27;
    const double z29 = c_phi * z21;
    const double z30 = s_phi * z21;
    const double z31 = z18 * z18 * z27;
    const double z32 = z18 * (w_x * z29 + w_y * z30) + z19 * z31;
    const double z33 = z20 * z25 + c_theta * z32;
    const double z34 = s_psi * z20;
    const double z35 = z18 * (w_y * (s_theta * z29 - s_phi * z27) - w_x * (s_theta * z30 + c_phi * z27)) +
        z25 * z31;
    const double z36 = z17 * (z21 * z28 - z17 * z33 + (z34 * z26 + c_psi * z35)) + (z17 * z21 - c_psi * z26)
        * z28;
    const double z37 = s_theta * c_psi;
    const double z38 = s_theta * z34 - c_psi * z27;
    const double z39 = z37 * (z21 * z38 + z37 * z33 - (z22 * z26 - s_psi * z35)) + (z37 * z21 + s_psi * z26)
        * z38;
    const double z40 = I1 * z36 - I2 * z39 + I3 * (c_theta * (z32 - (z21 * z25 + c_theta * z33)) + (z20 -
        c_theta * z21) * z25);
    const double z41 = s_psi * k1;
    const double z42 = c_theta * k2;
    const double z43 = (z19 * z6 - c_psi * (c_phi * w_x + s_phi * w_y)) * z41 + z19 * z42;
    const double z44 = z23 * z43;
    const double z45 = (z24 * z43 + z15 * z44) / z16;
    const double z46 = ((c_psi * c_phi - s_phi * z6) * z41 - s_phi * z42) * (s_theta * (z14 * z44 + z15 *
        z45));
    /* (I.4.1) 26:5 */
    /* reaction of no_turn: Q_i gains lambda_1 a_1i */
    lambda[0] = z46 - ((c_psi * s_phi + c_phi * z6) * z41 + c_phi * z42) * (s_theta * z45) - z40;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0 && fabs(z16) > 1e-14 * z12)) {
        /* the coframe is singular */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return VESELOVA_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z8) > 0.0)) {
            return VESELOVA_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * z12)) {
            return VESELOVA_SINGULAR_2;
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
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* state */
    const double z1 = 1.0 / s_theta;
    const double z2 = z1 * (s_phi * w_x - c_phi * w_y);
    const double z3 = c_theta * z2;
    const double omega3 = z2 - c_theta * z3;
    const double z4 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1;
    const double z5 = s_theta * z3;
    const double z6 = c_psi * z4 - s_psi * z5;
    const double z7 = s_psi * z4 + c_psi * z5;
    return 0.5 * (I3 * (omega3 * omega3) + (I1 * (z6 * z6) + I2 * (z7 * z7)));
}

VESELOVA_SLOW
int veselova_jacobian(double t, const double *y, const double *p, double *J)
{
    J[2] = 0.0;
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
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I1 - I2;
    const double k2 = I2 - I3;

    /* state */
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
    const double z12 = c_theta * c_theta;
    const double z13 = k1 * (1.0 + z12);
    const double z14 = z1 * z13 + (I3 * (1.0 - z12) - (I1 - I2 * z12));
    const double z15 = 2.0 * (s_phi * z9);
    const double z16 = c_phi * z14 + z15;
    const double z17 = z3 + c_phi * z16;
    const double z18 = c_phi * z6 - z15;
    const double z19 = z9 + s_phi * z18;
    const double z20 = 1.0 / z11;
    const double z21 = z19 * z20;
    const double z22 = z17 - z19 * z21;
    const double z23 = 1.0 / s_theta;
    const double z24 = c_phi * w_x + s_phi * w_y;
    const double z25 = z23 * z24;
    const double z26 = s_phi * w_x - c_phi * w_y;
    const double z27 = c_theta * (z23 * z23);
    const double z28 = z26 * z27;
    const double z29 = s_phi * z23;
    const double z30 = c_phi * z23;
    const double z31 = s_theta * c_phi;
    const double z32 = s_theta * s_phi;
    const double z33 = s_theta * w_y;
    const double z34 = c_theta * k2;
    const double z35 = s_psi * c_theta;
    const double z36 = s_psi * k1;
    const double z37 = z33 * z36;
    const double z38 = z33 * z34 + z35 * z37;
    const double z39 = c_psi * z37;
    const double z40 = 1.0 / z22;
    const double z41 = k1 * (z26 * z35 - c_psi * z24);
    const double z42 = z26 * k2;
    const double z43 = s_psi * z41 + c_theta * z42;
    const double z44 = s_theta * w_x;
    const double z45 = z33 * z43;
    const double z46 = z40 * (z43 * z44 + z45 * z21);
    const double z47 = s_phi * z46;
    const double z48 = k1 * z47;
    const double z49 = z45 * z20 + z21 * z46;
    const double z50 = s_phi * z49;
    const double z51 = z6 * z50;
    const double z52 = w_x * z38 - (w_y * z39 - z18 * z46 + 2.0 * (z8 * z48) - z10 * z49 - z51);
    const double z53 = k1 * z50;
    const double z54 = c_phi * z52 + s_phi * (w_y * z38 + (w_x * z39 - z6 * z47 - 2.0 * (z8 * z53)));
    const double z55 = z44 * z36;
    const double z56 = z44 * z34 + z35 * z55;
    const double z57 = c_psi * z55;
    const double z58 = c_phi * z46;
    const double z59 = k1 * (z50 + z58);
    const double z60 = c_phi * (w_x * z56 - (w_y * z57 - z18 * z49 + 2.0 * (z8 * z59))) + s_phi * (w_y * z56
        - (z51 - (w_x * z57 + (z16 * z46 + z14 * z58))));
    const double z61 = z40 * (z60 + z21 * z54);
    const double z62 = z26 * z37;
    const double z63 = k1 * z46 - 2.0 * (s_phi * z48) + 2.0 * (c_phi * z53);
    const double z64 = c_phi * z47 + s_phi * z50;
    const double z65 = I1 * z64;
    const double z66 = I2 * z64;
    const double z67 = s_theta * (z33 * z42 + s_psi * z62 + z7 * z63) - c_theta * (w_y * z43 - 2.0 * (s_theta
        * (I3 * z64 - z1 * z65 - z2 * z66)));
    const double z68 = z26 * z55;
    const double z69 = c_phi * z58;
    const double z70 = k1 * z49 - 2.0 * (s_phi * z59);
    const double z71 = s_psi * z68 + (z42 * z44 - 2.0 * (c_theta * (k1 * (z1 * z69) + k2 * z69))) + z7 * z70;
    const double z72 = c_phi * z50;
    const double z73 = I1 * z72;
    const double z74 = I2 * z72;
    const double z75 = s_theta * z71 - c_theta * (w_x * z43 - 2.0 * (s_theta * (I3 * z72 - z1 * z73 - z2 *
        z74)));
    const double z76 = z40 * (z75 + z21 * z67);
    const double z77 = c_theta * z63;
    const double z78 = 2.0 * (s_psi * (2.0 * z66 - (I2 * z49 + z5 * z65) + (I1 * z49 - z4 * z66)));
    const double z79 = s_psi * (z24 * z37 - s_psi * z77) + c_psi * (z33 * z41 + c_theta * z62 + c_psi * z77 +
        z78);
    const double z80 = c_theta * z70;
    const double z81 = 2.0 * z74 - (z13 * z69 + I2 * z46 + z5 * z73) + (I1 * z46 - z4 * z74);
    const double z82 = s_psi * (z24 * z55 - s_psi * z80) + c_psi * (z41 * z44 + c_theta * z68 + c_psi * z80 +
        2.0 * (s_psi * z81));
    const double z83 = z40 * (z82 + z21 * z79);
    const double z84 = c_phi * z39 - s_phi * z38;
    const double z85 = s_theta * z43;
    const double z86 = z40 * (z85 - c_phi * z57 + s_phi * z56 - z21 * z84);
    const double z87 = z85 - s_phi * z39 - c_phi * z38;
    const double z88 = z40 * (s_phi * z57 + c_phi * z56 - z21 * z87);
    /* (I.2.15) */
    J[0] = -c_theta * z25;
    J[1] = z26 + c_theta * z28;
    J[3] = -c_theta * z29;
    J[4] = c_theta * z30;
    J[5] = z23 * (z31 * w_y - z32 * w_x);
    J[6] = z23 * (c_theta * z24) - (z32 * w_y + z31 * w_x) * z27;
    J[8] = c_phi;
    J[9] = s_phi;
    J[10] = z25;
    J[11] = -z28;
    J[13] = z29;
    J[14] = -z30;
    J[15] = z20 * z54 + z21 * z61;
    J[16] = -(z20 * z67 + z21 * z76);
    J[17] = z20 * z79 + z21 * z83;
    J[18] = z21 * z86 - z20 * z84;
    J[19] = z20 * z87 - z21 * z88;
    J[20] = -z61;
    J[21] = z76;
    J[22] = -z83;
    J[23] = -z86;
    J[24] = z88;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[0] + J[1] + J[5] + J[6] + J[11] + J[14] + J[15] + J[16] + J[17] + J[18] + J[19] + J[20] +
        J[22] + J[23]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0
        && fabs(z22) > 1e-14 * z17)) {
        /* the coframe is singular */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return VESELOVA_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z11) > 0.0)) {
            return VESELOVA_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * z17)) {
            return VESELOVA_SINGULAR_2;
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
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* state */
    const double z1 = 1.0 / s_theta;
    const double z2 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1;
    const double z3 = z1 * (s_phi * w_x - c_phi * w_y);
    const double z4 = c_theta * z3;
    const double z5 = s_theta * z4;
    const double z6 = I1 * (c_psi * z2 - s_psi * z5);
    const double z7 = I2 * (s_psi * z2 + c_psi * z5);
    const double z8 = c_psi * z6 + s_psi * z7;
    const double z9 = c_theta * (s_psi * z6 - c_psi * z7) - I3 * (s_theta * (z3 - c_theta * z4));
    /* 32:8 */
    out[0] = c_phi * z8 - s_phi * z9; /* L_x */
    /* 33:8 */
    out[1] = s_phi * z8 + c_phi * z9; /* L_y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return VESELOVA_SINGULAR_1;
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
    /* the coframe is singular */
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
    const veselova_lanes z9 = 2.0 * (s_phi * z7);
    const veselova_lanes z10 = c_theta * c_theta;
    const veselova_lanes z11 = z9 + c_phi * (I3 * (1.0 - z10) - (I1 - I2 * z10) + k1 * (z1 * (1.0 + z10)));
    const veselova_lanes z12 = z3 + c_phi * z11;
    const veselova_lanes z13 = z7 + s_phi * (c_phi * z5 - z9);
    const veselova_lanes z14 = 1.0 / z8;
    const veselova_lanes z15 = z13 * z14;
    const veselova_lanes z16 = z12 - z13 * z15;
    /* the mass matrix is singular */
    bad |= veselova_misses(veselova_size(VESELOVA_SPREAD(z16)), 1e-14 * z12);
    const veselova_lanes z17 = 1.0 / s_theta;
    const veselova_lanes z18 = s_phi * w_x - c_phi * w_y;
    const veselova_lanes z19 = z17 * z18;
    const veselova_lanes z20 = s_theta * w_y;
    const veselova_lanes z21 = s_theta * w_x;
    const veselova_lanes z22 = k1 * (s_psi * (z18 * z6 - c_psi * (c_phi * w_x + s_phi * w_y))) + k2 *
        (c_theta * z18);
    const veselova_lanes z23 = z20 * z22;
    const veselova_lanes z24 = (z21 * z22 + z23 * z15) / z16;
    /* (I.2.15) */
    const veselova_lanes slope1 = -c_theta * z19;
    sum += slope1;
    veselova_put(dydt, slope1);
    const veselova_lanes slope2 = z17 * (s_phi * z20 + c_phi * z21);
    sum += slope2;
    veselova_put(dydt + 1 * stride, slope2);
    const veselova_lanes slope3 = z19;
    veselova_put(dydt + 2 * stride, slope3);
    /* (I.2.15) 24:4 */
    const veselova_lanes slope4 = z23 * z14 + z15 * z24;
    sum += slope4;
    veselova_put(dydt + 3 * stride, slope4);
    const veselova_lanes slope5 = -z24;
    sum += slope5;
    veselova_put(dydt + 4 * stride, slope5);
    veselova_put(check, veselova_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void veselova_rhs_tail(const double *fixed, size_t left, size_t count, const
    double *t, const double *y, double *restrict dydt, double *check)
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
