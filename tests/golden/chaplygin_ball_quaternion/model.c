/*
 * chaplygin_ball_quaternion.c: chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:b19d96409c2488fb)
 * A ball with three different moments of inertia rolls on a horizontal plane; its orientation is a
 *     quaternion.
 * Source: chaplygin_ball_quaternion.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: angular velocities and quasi-velocities of the spec
 * chaplygin_ball_quaternion.h says what each function does.
 */
#include "chaplygin_ball_quaternion.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const chaplygin_ball_quaternion_coordinate_names[] = {
    "x",
    "y",
    "R_0",
    "R_1",
    "R_2",
    "R_3"
};
const char *const chaplygin_ball_quaternion_state_names[] = {
    "x",
    "y",
    "R_0",
    "R_1",
    "R_2",
    "R_3",
    "w1",
    "w2",
    "w3"
};
const char *const chaplygin_ball_quaternion_parameter_names[] = {
    "m",
    "a",
    "I1",
    "I2",
    "I3"
};
const double chaplygin_ball_quaternion_parameter_defaults[] = {
    1.0,
    1.0,
    0.4,
    0.5,
    0.7
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define CHAPLYGIN_BALL_QUATERNION_SLOW __attribute__((cold, optimize("O1")))
#else
#define CHAPLYGIN_BALL_QUATERNION_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* it is seldom called, and would cost its callers registers */
#endif
static int chaplygin_ball_quaternion_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CHAPLYGIN_BALL_QUATERNION_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CHAPLYGIN_BALL_QUATERNION_NOT_FINITE;
        }
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CHAPLYGIN_BALL_QUATERNION_LANES
#if !defined(__GNUC__)
#define CHAPLYGIN_BALL_QUATERNION_LANES 1
#elif defined(__AVX512F__)
#define CHAPLYGIN_BALL_QUATERNION_LANES 8
#elif defined(__AVX__)
#define CHAPLYGIN_BALL_QUATERNION_LANES 4
#else
#define CHAPLYGIN_BALL_QUATERNION_LANES 2
#endif
#endif
#if CHAPLYGIN_BALL_QUATERNION_LANES > 1
typedef double chaplygin_ball_quaternion_lanes __attribute__((vector_size(8 * CHAPLYGIN_BALL_QUATERNION_LANES)));
#else
typedef double chaplygin_ball_quaternion_lanes;
#endif

#if CHAPLYGIN_BALL_QUATERNION_LANES >= 2
static inline chaplygin_ball_quaternion_lanes chaplygin_ball_quaternion_get(const double *from)
{
    chaplygin_ball_quaternion_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void chaplygin_ball_quaternion_put(double *to, chaplygin_ball_quaternion_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int chaplygin_ball_quaternion_one_by_one(size_t count, size_t first, size_t number, const double *t, const double *y, const double *p, double *dydt)
{
    int status = CHAPLYGIN_BALL_QUATERNION_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CHAPLYGIN_BALL_QUATERNION_NY];
        double slope[CHAPLYGIN_BALL_QUATERNION_NY];
        for (size_t k = 0; k < CHAPLYGIN_BALL_QUATERNION_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = NAN;
        }
        const int one = chaplygin_ball_quaternion_rhs(t[i], state, p, slope);
        status = status == CHAPLYGIN_BALL_QUATERNION_OK ? one : status;
        for (size_t k = 0; k < CHAPLYGIN_BALL_QUATERNION_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CHAPLYGIN_BALL_QUATERNION_LANES >= 2
#define CHAPLYGIN_BALL_QUATERNION_SPREAD(x) ((x) - (chaplygin_ball_quaternion_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long chaplygin_ball_quaternion_bits __attribute__((vector_size(8 * CHAPLYGIN_BALL_QUATERNION_LANES)));

/* all bits where value is not above bound, or is no number */
static inline chaplygin_ball_quaternion_bits chaplygin_ball_quaternion_misses(chaplygin_ball_quaternion_lanes value, chaplygin_ball_quaternion_lanes bound)
{
    return ~(chaplygin_ball_quaternion_bits)(value > bound);
}

/* no number where a bit is set */
static inline chaplygin_ball_quaternion_lanes chaplygin_ball_quaternion_mark(chaplygin_ball_quaternion_lanes value, chaplygin_ball_quaternion_bits bad)
{
    return (chaplygin_ball_quaternion_lanes)((chaplygin_ball_quaternion_bits)value | bad);
}

static inline chaplygin_ball_quaternion_lanes chaplygin_ball_quaternion_size(chaplygin_ball_quaternion_lanes x)
{
    return (chaplygin_ball_quaternion_lanes)((chaplygin_ball_quaternion_bits)x & 0x7fffffffffffffffULL);
}
/* whether none of the states must be asked again: no singular block, no infinity, no angle anywhere near 1e5 */
static inline int chaplygin_ball_quaternion_is_good(int count, const double *check)
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
static inline void chaplygin_ball_quaternion_fill(size_t left, size_t count, const double *t, const double *y, double *time, double *state)
{
    for (size_t l = 0; l < CHAPLYGIN_BALL_QUATERNION_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CHAPLYGIN_BALL_QUATERNION_NY; ++k) {
            state[k * CHAPLYGIN_BALL_QUATERNION_LANES + l] = y[k * count + i];
        }
    }
}

static inline void chaplygin_ball_quaternion_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CHAPLYGIN_BALL_QUATERNION_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CHAPLYGIN_BALL_QUATERNION_LANES + l];
        }
    }
}
#endif

int chaplygin_ball_quaternion_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * a * a;
    const double k2 = a * (m * a);
    const double k3 = I2 - I3;
    const double k4 = I1 - I3;
    const double k5 = I1 - I2;

    /* state */
    const double z1 = R_3 * R_3;
    const double z2 = R_2 * R_2;
    const double z3 = R_1 * R_1;
    const double z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)));
    const double z5 = R_1 * z4;
    const double z6 = R_2 * z5;
    const double z7 = R_0 * z4;
    const double z8 = R_3 * z7;
    const double z9 = z6 + z8;
    const double z10 = R_2 * z4;
    const double z11 = R_3 * z4;
    const double z12 = R_3 * z11;
    const double R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12);
    const double z13 = I1 + k2 * (4.0 * (z9 * z9) + R_x1 * R_x1);
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    const double z14 = z6 - z8;
    const double z15 = I2 + k2 * (R_y2 * R_y2 + 4.0 * (z14 * z14));
    const double z16 = z4 * k1;
    const double z17 = z3 + z2;
    const double z18 = 4.0 * (R_1 * z8);
    const double z19 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z18) + 4.0 * (z2 * z8);
    const double z20 = z16 * z19;
    const double z21 = 1.0 / z13;
    const double z22 = z21 * z20;
    const double z23 = z15 - z20 * z22;
    const double z24 = R_3 * z10 - R_1 * z7;
    const double z25 = R_1 * z11 + R_2 * z7;
    const double z26 = I3 + 4.0 * (k2 * (z24 * z24 + z25 * z25));
    const double z27 = 2.0 - 4.0 * (z4 * z17);
    const double z28 = R_3 * (2.0 - 4.0 * (z1 * z4));
    const double z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28);
    const double z30 = z21 * z29;
    const double z31 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28) + z20 * z30;
    const double z32 = 1.0 / z23;
    const double z33 = z31 * z32;
    const double z34 = z26 - z29 * z30 - z31 * z33;
    const double z35 = w2 * w3 * k3;
    const double z36 = w1 * w3 * k4 + z35 * z22;
    const double z37 = (w1 * w2 * k5 - z35 * z30 - z33 * z36) / z34;
    const double z38 = z32 * z36 - z33 * z37;
    /* (I.2.15) */
    dydt[0] = a * (2.0 * (z24 * w3) + (R_y2 * w2 + 2.0 * (z9 * w1))); /* x' */
    dydt[1] = -a * (2.0 * (z25 * w3) + (2.0 * (z14 * w2) + R_x1 * w1)); /* y' */
    dydt[2] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    dydt[3] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    dydt[4] = -0.5 * (R_1 * w3 - (R_3 * w1 + R_0 * w2)); /* R_2' */
    dydt[5] = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)); /* R_3' */
    /* (I.2.15) 21:4 */
    dydt[6] = z35 * z21 + z22 * z38 - z30 * z37; /* w1' */
    dydt[7] = -z38; /* w2' */
    dydt[8] = z37; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[3] + dydt[4] + dydt[5] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(z23) > 1e-14 * z15
        && fabs(z34) > 1e-14 * z26)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z23) > 1e-14 * z15)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z34) > 1e-14 * z26)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        return chaplygin_ball_quaternion_finish(9, dydt);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

int chaplygin_ball_quaternion_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[1]; /* radius [m] */

    /* state */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_2 * z1;
    const double z3 = R_0 * z1;
    const double z4 = R_1 * z1;
    const double z5 = R_3 * z1;
    const double z6 = R_3 * z5;
    const double z7 = R_2 * z4;
    const double z8 = R_3 * z3;
    const double omega_y = 2.0 * ((R_3 * z2 - R_1 * z3) * w3) + ((1.0 - 2.0 * (R_1 * z4 + z6)) * w2 + 2.0 *
        ((z7 + z8) * w1));
    const double omega_x = 2.0 * ((R_1 * z5 + R_2 * z3) * w3) + (2.0 * ((z7 - z8) * w2) + (1.0 - 2.0 * (R_2 *
        z2 + z6)) * w1);
    /* (I.2.4) */
    qdot[0] = a * omega_y; /* x' */
    qdot[1] = -a * omega_x; /* y' */
    qdot[2] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    qdot[3] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    qdot[4] = -0.5 * (R_1 * w3 - (R_3 * w1 + R_0 * w2)); /* R_2' */
    qdot[5] = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)); /* R_3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4] + qdot[5]) <= DBL_MAX)) {
        return chaplygin_ball_quaternion_finish(6, qdot);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW
int chaplygin_ball_quaternion_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * a * a;
    const double k2 = a * (m * a);
    const double k3 = I2 - I3;
    const double k4 = I1 - I3;
    const double k5 = I1 - I2;

    /* state */
    const double z1 = R_3 * R_3;
    const double z2 = R_2 * R_2;
    const double z3 = R_1 * R_1;
    const double z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)));
    const double z5 = R_1 * z4;
    const double z6 = R_2 * z5;
    const double z7 = R_0 * z4;
    const double z8 = R_3 * z7;
    const double z9 = z6 + z8;
    const double z10 = R_2 * z4;
    const double z11 = R_3 * z4;
    const double z12 = R_3 * z11;
    const double R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12);
    const double z13 = I1 + (4.0 * (k2 * (z9 * z9)) + k2 * (R_x1 * R_x1));
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    const double z14 = z6 - z8;
    const double z15 = I2 + (k2 * (R_y2 * R_y2) + 4.0 * (k2 * (z14 * z14)));
    const double z16 = z4 * k1;
    const double z17 = z3 + z2;
    const double z18 = 4.0 * (R_1 * z8);
    const double z19 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z18) + 4.0 * (z2 * z8);
    const double z20 = z16 * z19;
    const double z21 = 1.0 / z13;
    const double z22 = z21 * z20;
    const double z23 = z15 - z20 * z22;
    const double z24 = R_3 * z10 - R_1 * z7;
    const double z25 = R_1 * z11 + R_2 * z7;
    const double z26 = I3 + 4.0 * (k2 * (z24 * z24 + z25 * z25));
    const double z27 = 2.0 - 4.0 * (z4 * z17);
    const double z28 = R_3 * (2.0 - 4.0 * (z1 * z4));
    const double z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28);
    const double z30 = z21 * z29;
    const double z31 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28) + z20 * z30;
    const double z32 = 1.0 / z23;
    const double z33 = z31 * z32;
    const double z34 = z26 - z29 * z30 - z31 * z33;
    const double z35 = w2 * w3 * k3;
    const double z36 = w1 * w3 * k4 + z35 * z22;
    const double z37 = (w1 * w2 * k5 - z35 * z30 - z33 * z36) / z34;
    const double z38 = z32 * z36 - z33 * z37;
    const double z39 = z35 * z21 + z22 * z38 - z30 * z37;
    const double z40 = 2.0 * (w2 * (z24 * w1 - z9 * w3)) - R_y2 * z38 + 2.0 * (0.5 * (w1 * (R_y2 * w3 - 2.0 *
        (z24 * w2))) + z9 * z39);
    const double z41 = a * (2.0 * (0.5 * (w3 * (2.0 * (z9 * w2) - R_y2 * w1)) + z24 * z37) + z40);
    const double z42 = 2.0 * (0.5 * (w2 * (2.0 * (z25 * w1) - R_x1 * w3)) - z14 * z38) + (2.0 * (w1 * (z14 *
        w3 - z25 * w2)) + R_x1 * z39);
    const double z43 = a * (2.0 * (0.5 * (w3 * (R_x1 * w2 - 2.0 * (z14 * w1))) + z25 * z37) + z42);
    const double z44 = R_0 * w3 - (R_2 * w1 - R_1 * w2);
    const double z45 = R_2 * w3 + (R_0 * w1 - R_3 * w2);
    const double z46 = R_1 * w3 - (R_3 * w1 + R_0 * w2);
    const double z47 = 0.5 * (w3 * z44) + R_3 * z37 + (0.5 * (w1 * z45) + R_1 * z39 - (0.5 * (w2 * z46) + R_2
        * z38));
    const double z48 = R_3 * w3 + (R_1 * w1 + R_2 * w2);
    const double z49 = 0.5 * (w3 * z46) - R_2 * z37 + (0.5 * (w1 * z48) - R_0 * z39 + (0.5 * (w2 * z44) - R_3
        * z38));
    const double z50 = 0.5 * (w3 * z45) + R_1 * z37 - (0.5 * (w1 * z44) + R_3 * z39 - (0.5 * (w2 * z48) + R_0
        * z38));
    const double z51 = 0.5 * (w3 * z48) - R_0 * z37 - (0.5 * (w1 * z46) - R_2 * z39 + (0.5 * (w2 * z45) - R_1
        * z38));
    /* (I.2.15) */
    qddot[0] = z41; /* x'' */
    qddot[1] = -z43; /* y'' */
    qddot[2] = -0.5 * z47; /* R_0'' */
    qddot[3] = -0.5 * z49; /* R_1'' */
    qddot[4] = -0.5 * z50; /* R_2'' */
    qddot[5] = -0.5 * z51; /* R_3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(z23) > 1e-14 * z15
        && fabs(z34) > 1e-14 * z26)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z23) > 1e-14 * z15)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z34) > 1e-14 * z26)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        return chaplygin_ball_quaternion_finish(6, qddot);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

int chaplygin_ball_quaternion_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* centre [m] */
    const double y_2 = q[1]; /* centre [m] */
    const double R_0 = q[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[3]; /* quaternion of R, along x [1] */
    const double R_2 = q[4]; /* quaternion of R, along y [1] */
    const double R_3 = q[5]; /* quaternion of R, along z [1] */
    const double R_0_dot = qdot[2];
    const double R_1_dot = qdot[3];
    const double R_2_dot = qdot[4];
    const double R_3_dot = qdot[5];

    /* state */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_0 * z1;
    const double z3 = R_1 * z1;
    const double z4 = R_3 * z1;
    const double z5 = R_2 * z1;
    y[0] = x;
    y[1] = y_2;
    y[2] = R_0;
    y[3] = R_1;
    y[4] = R_2;
    y[5] = R_3;
    y[6] = 2.0 * (R_1_dot * z2 - R_0_dot * z3 + (R_2_dot * z4 - R_3_dot * z5));
    y[7] = 2.0 * (R_2_dot * z2 - R_0_dot * z5 + (R_3_dot * z3 - R_1_dot * z4));
    y[8] = 2.0 * (R_3_dot * z2 - R_0_dot * z4 + (R_1_dot * z5 - R_2_dot * z3));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[6] + y[7] + y[8]) <= DBL_MAX)) {
        return chaplygin_ball_quaternion_finish(9, y);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

int chaplygin_ball_quaternion_residuals(double t, const double *q, const double *qdot, const double *p,
    double *r)
{
    (void)t;
    const double R_0 = q[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[3]; /* quaternion of R, along x [1] */
    const double R_2 = q[4]; /* quaternion of R, along y [1] */
    const double R_3 = q[5]; /* quaternion of R, along z [1] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double R_0_dot = qdot[2];
    const double R_1_dot = qdot[3];
    const double R_2_dot = qdot[4];
    const double R_3_dot = qdot[5];
    const double a = p[1]; /* radius [m] */

    /* state */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_0 * z1;
    const double z3 = R_1 * z1;
    const double z4 = R_3 * z1;
    const double z5 = R_2 * z1;
    const double z6 = R_1_dot * z2 - R_0_dot * z3 + (R_2_dot * z4 - R_3_dot * z5);
    const double z7 = R_2 * z3;
    const double z8 = R_3 * z2;
    const double z9 = R_2_dot * z2 - R_0_dot * z5 + (R_3_dot * z3 - R_1_dot * z4);
    const double z10 = R_3 * z4;
    const double z11 = R_3_dot * z2 - R_0_dot * z4 + (R_1_dot * z5 - R_2_dot * z3);
    const double omega_y = 4.0 * (z6 * (z7 + z8)) + 2.0 * (z9 * (1.0 - 2.0 * (R_1 * z3 + z10))) + 4.0 * ((R_3
        * z5 - R_1 * z2) * z11);
    const double omega_x = 2.0 * (z6 * (1.0 - 2.0 * (R_2 * z5 + z10))) + 4.0 * (z9 * (z7 - z8)) + 4.0 * ((R_1
        * z4 + R_2 * z2) * z11);
    /* (I.1.1) 23:5 */
    r[0] = x_dot - a * omega_y; /* roll_x = 0 */
    /* (I.1.1) 24:5 */
    r[1] = y_dot + a * omega_x; /* roll_y = 0 */
    /* (I.1.1) 10:3 */
    r[2] = 2.0 * (R_3 * R_3_dot + (R_2 * R_2_dot + (R_0 * R_0_dot + R_1 * R_1_dot))); /* R_norm = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2]) <= DBL_MAX)) {
        return chaplygin_ball_quaternion_finish(3, r);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

int chaplygin_ball_quaternion_positions(double t, const double *q, const double *p, double *f)
{
    (void)t;
    (void)p;
    const double R_0 = q[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[3]; /* quaternion of R, along x [1] */
    const double R_2 = q[4]; /* quaternion of R, along y [1] */
    const double R_3 = q[5]; /* quaternion of R, along z [1] */

    /* state */
    /* 10:3 */
    f[0] = R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)) - 1.0; /* R_norm = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(f[0]) <= DBL_MAX)) {
        return chaplygin_ball_quaternion_finish(1, f);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW
int chaplygin_ball_quaternion_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * a * a;
    const double k2 = m * a;
    const double k3 = a * k2;
    const double k4 = I2 - I3;
    const double k5 = I1 - I3;
    const double k6 = I1 - I2;

    /* state */
    const double z1 = R_3 * R_3;
    const double z2 = R_2 * R_2;
    const double z3 = R_1 * R_1;
    const double z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)));
    const double z5 = R_1 * z4;
    const double z6 = R_2 * z5;
    const double z7 = R_0 * z4;
    const double z8 = R_3 * z7;
    const double z9 = z6 + z8;
    const double z10 = R_2 * z4;
    const double z11 = R_3 * z4;
    const double z12 = R_3 * z11;
    const double R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12);
    const double z13 = I1 + (4.0 * (k3 * (z9 * z9)) + k3 * (R_x1 * R_x1));
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    const double z14 = z6 - z8;
    const double z15 = I2 + (k3 * (R_y2 * R_y2) + 4.0 * (k3 * (z14 * z14)));
    const double z16 = z4 * k1;
    const double z17 = z3 + z2;
    const double z18 = R_0 * R_1;
    const double z19 = 4.0 * (z11 * z18);
    const double z20 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z19) + 4.0 * (z2 * (R_0 * z11));
    const double z21 = z16 * z20;
    const double z22 = 1.0 / z13;
    const double z23 = z22 * z21;
    const double z24 = z15 - z21 * z23;
    const double z25 = R_3 * z10 - R_1 * z7;
    const double z26 = R_1 * z11 + R_2 * z7;
    const double z27 = I3 + 4.0 * (k3 * (z25 * z25 + z26 * z26));
    const double z28 = R_1 * R_3;
    const double z29 = 2.0 - 4.0 * (z1 * z4);
    const double z30 = 2.0 - 4.0 * (z4 * z17);
    const double z31 = z16 * (z28 * z29 + R_0 * (R_2 * z30 - z19));
    const double z32 = z22 * z31;
    const double z33 = R_2 * R_3;
    const double z34 = R_0 * R_2;
    const double z35 = z16 * (z29 * z33 - R_0 * (R_1 * z30 + 4.0 * (z11 * z34))) - z21 * z32;
    const double z36 = 1.0 / z24;
    const double z37 = z35 * z36;
    const double z38 = z27 - z31 * z32 - z35 * z37;
    const double z39 = z4 * k2;
    const double z40 = w2 * w3 * k4;
    const double z41 = w1 * w3 * k5 + z40 * z23;
    const double z42 = (w1 * w2 * k6 - z40 * z32 + z37 * z41) / z38;
    const double z43 = z39 * z42;
    const double z44 = R_0 * R_3;
    const double z45 = R_1 * R_2;
    const double z46 = z36 * z41 + z37 * z42;
    const double z47 = z40 * z22 + z23 * z46 - z32 * z42;
    const double z48 = 2.0 * ((z44 + z45) * (z39 * z47)) - k2 * ((1.0 - 2.0 * (z4 * (z3 + z1))) * z46);
    const double z49 = k2 * ((1.0 - 2.0 * (z4 * (z2 + z1))) * z47) + 2.0 * ((z44 - z45) * (z39 * z46));
    /* (I.4.1) 23:5 */
    lambda[0] = z48 - 2.0 * ((z18 - z33) * z43); /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 24:5 */
    lambda[1] = -(2.0 * ((z28 + z34) * z43) + z49); /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 10:3 */
    lambda[2] = 0.0; /* reaction of R_norm: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX && fabs(z24) > 1e-14 * z15 && fabs(z38) > 1e-14 * z27)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z24) > 1e-14 * z15)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z38) > 1e-14 * z27)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        return chaplygin_ball_quaternion_finish(3, lambda);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

double chaplygin_ball_quaternion_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* state */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_2 * z1;
    const double z3 = R_0 * z1;
    const double z4 = R_1 * z1;
    const double z5 = R_3 * z1;
    const double z6 = R_3 * z5;
    const double z7 = R_2 * z4;
    const double z8 = R_3 * z3;
    const double omega_y = 2.0 * ((R_3 * z2 - R_1 * z3) * w3) + ((1.0 - 2.0 * (R_1 * z4 + z6)) * w2 + 2.0 *
        ((z7 + z8) * w1));
    const double z9 = a * omega_y;
    const double omega_x = 2.0 * ((R_1 * z5 + R_2 * z3) * w3) + (2.0 * ((z7 - z8) * w2) + (1.0 - 2.0 * (R_2 *
        z2 + z6)) * w1);
    const double z10 = a * omega_x;
    const double z11 = m * (z9 * z9 + z10 * z10) + (I1 * (w1 * w1) + I2 * (w2 * w2) + I3 * (w3 * w3));
    return 0.5 * z11;
}

CHAPLYGIN_BALL_QUATERNION_SLOW static int chaplygin_ball_quaternion_jacobian_part1(double t, const double *y,
    const double *p, double *kept, double *J)
{
    (void)J;
    (void)t;

    /* parameters only */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k1 = m * a * a;
    kept[0] = k1;
    const double k2 = a * (m * a);
    kept[1] = k2;
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k3 = I2 - I3;
    kept[2] = k3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k4 = I1 - I3;
    kept[3] = k4;
    const double k5 = I1 - I2;
    kept[4] = k5;

    /* state */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = R_3 * R_3;
    kept[5] = z1;
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z2 = R_2 * R_2;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z3 = R_1 * R_1;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z4 = z1 + (z2 + (R_0 * R_0 + z3));
    const double z5 = 1.0 / z4;
    kept[6] = z5;
    const double z6 = R_1 * z5;
    kept[7] = z6;
    const double z7 = R_2 * z6;
    const double z8 = R_0 * z5;
    kept[8] = z8;
    const double z9 = R_3 * z8;
    const double z10 = z7 + z9;
    kept[9] = z10;
    const double z11 = R_2 * z5;
    kept[10] = z11;
    const double z12 = R_3 * z5;
    kept[11] = z12;
    const double z13 = R_3 * z12;
    const double R_x1 = 1.0 - 2.0 * (R_2 * z11 + z13);
    kept[12] = R_x1;
    const double z14 = I1 + (4.0 * (k2 * (z10 * z10)) + k2 * (R_x1 * R_x1));
    kept[13] = z14;
    const double R_y2 = 1.0 - 2.0 * (R_1 * z6 + z13);
    kept[14] = R_y2;
    const double z15 = z7 - z9;
    kept[15] = z15;
    const double z16 = I2 + (k2 * (R_y2 * R_y2) + 4.0 * (k2 * (z15 * z15)));
    kept[16] = z16;
    const double z17 = z5 * k1;
    const double z18 = z3 + z2;
    kept[17] = z18;
    const double z19 = 8.0 * z1 + 4.0 * z18;
    kept[18] = z19;
    const double z20 = 4.0 - z5 * z19;
    kept[19] = z20;
    const double z21 = R_0 * R_1;
    kept[20] = z21;
    const double z22 = R_3 * z21;
    kept[21] = z22;
    const double z23 = 4.0 * (z5 * z22);
    const double z24 = R_2 * z20 - z23;
    kept[22] = z24;
    const double z25 = R_0 * z2;
    kept[23] = z25;
    const double z26 = R_3 * z25;
    kept[24] = z26;
    const double z27 = R_1 * z24 + 4.0 * (z5 * z26);
    kept[25] = z27;
    const double z28 = z17 * z27;
    const double z29 = 1.0 / z14;
    kept[26] = z29;
    const double z30 = z28 * z29;
    kept[27] = z30;
    const double z31 = z16 - z28 * z30;
    kept[28] = z31;
    const double z32 = R_3 * z11 - R_1 * z8;
    kept[29] = z32;
    const double z33 = R_1 * z12 + R_2 * z8;
    kept[30] = z33;
    const double z34 = I3 + 4.0 * (k2 * (z32 * z32 + z33 * z33));
    kept[31] = z34;
    const double z35 = 2.0 - 4.0 * (z5 * z18);
    kept[32] = z35;
    const double z36 = z23 - R_2 * z35;
    kept[33] = z36;
    const double z37 = R_1 * R_3;
    kept[34] = z37;
    const double z38 = 2.0 - 4.0 * (z1 * z5);
    kept[35] = z38;
    const double z39 = R_0 * z36 - z37 * z38;
    kept[36] = z39;
    const double z40 = z17 * z39;
    const double z41 = z40 * z29;
    kept[37] = z41;
    const double z42 = R_0 * R_2;
    kept[38] = z42;
    const double z43 = R_3 * z42;
    kept[39] = z43;
    const double z44 = R_1 * z35 + 4.0 * (z5 * z43);
    kept[40] = z44;
    const double z45 = R_2 * R_3;
    kept[41] = z45;
    const double z46 = R_0 * z44 - z38 * z45;
    kept[42] = z46;
    const double z47 = z17 * z46 - z28 * z41;
    const double z48 = 1.0 / z31;
    kept[43] = z48;
    const double z49 = z47 * z48;
    kept[44] = z49;
    const double z50 = z34 - z40 * z41 - z47 * z49;
    kept[45] = z50;
    const double w1 = y[6];
    const double z51 = a * w1;
    kept[46] = z51;
    const double w3 = y[8];
    const double z52 = a * w3;
    kept[47] = z52;
    const double z53 = R_3 * z51 - R_1 * z52;
    const double z54 = z5 * z53;
    kept[48] = z54;
    const double z55 = 1.0 / (z4 * z4);
    kept[49] = z55;
    const double w2 = y[7];
    const double z56 = a * w2;
    kept[50] = z56;
    const double z57 = R_3 * z56;
    const double z58 = R_3 * z52;
    kept[51] = z58;
    const double z59 = R_2 * z51;
    kept[52] = z59;
    const double z60 = z59 - R_1 * z56;
    kept[53] = z60;
    const double z61 = z55 * (R_3 * z57 - R_2 * z58 - R_1 * z60 - R_0 * z53);
    kept[54] = z61;
    const double z62 = z8 * z52 + z6 * z56;
    kept[55] = z62;
    const double z63 = 2.0 * (z8 * z51 + z11 * z52 - z12 * z56 - z5 * z57) + 4.0 * (R_3 * z61);
    kept[56] = z63;
    const double z64 = z57 - R_2 * z52;
    kept[57] = z64;
    const double z65 = R_2 * z56;
    kept[58] = z65;
    const double z66 = z55 * (R_3 * z53 + R_2 * z59 - R_1 * z65 + R_0 * z64);
    kept[59] = z66;
    const double z67 = 0.5 * w1;
    kept[60] = z67;
    const double z68 = 0.5 * w2;
    kept[61] = z68;
    const double z69 = 0.5 * w3;
    kept[62] = z69;
    const double z70 = 0.5 * R_1;
    kept[63] = z70;
    const double z71 = 0.5 * R_2;
    kept[64] = z71;
    const double z72 = 0.5 * R_3;
    kept[65] = z72;
    const double z73 = 0.5 * R_0;
    kept[66] = z73;
    const double z74 = 1.0 / z50;
    kept[67] = z74;
    const double z75 = w1 * k5;
    kept[68] = z75;
    const double z76 = w2 * k3;
    kept[69] = z76;
    const double z77 = w3 * z76;
    const double z78 = w1 * k4;
    kept[70] = z78;
    const double z79 = w3 * z78 + z30 * z77;
    const double z80 = z74 * (w2 * z75 + z41 * z77 - z49 * z79);
    kept[71] = z80;
    const double z81 = z17 * z80;
    kept[72] = z81;
    const double z82 = z48 * z79 - z49 * z80;
    kept[73] = z82;
    const double z83 = z17 * z82;
    kept[74] = z83;
    const double z84 = z5 * z83;
    kept[75] = z84;
    const double z85 = R_3 * z84;
    kept[76] = z85;
    const double z86 = R_0 * z81;
    kept[77] = z86;
    const double z87 = R_1 * z83;
    kept[78] = z87;
    const double z88 = z86 - z87;
    kept[79] = z88;
    const double z89 = z5 * z88;
    kept[80] = z89;
    const double z90 = R_3 * z89;
    kept[81] = z90;
    const double z91 = z29 * z77 + z30 * z82 + z41 * z80;
    kept[82] = z91;
    const double z92 = k2 * z91;
    const double z93 = z10 * z92;
    kept[83] = z93;
    const double z94 = R_3 * z93;
    const double z95 = z37 * z81;
    kept[84] = z95;
    const double z96 = R_2 * z87;
    kept[85] = z96;
    const double z97 = 4.0 * (z1 * z95 + z86 * (R_2 * z18) + z26 * z83 + z22 * z88) - z19 * z96;
    const double z98 = R_x1 * z92;
    kept[86] = z98;
    const double z99 = R_3 * z98;
    kept[87] = z99;
    const double z100 = R_2 * z98;
    kept[88] = z100;
    const double z101 = z97 + k1 * (z39 * z80 + z27 * z82) + 4.0 * (R_3 * z99) + 4.0 * (R_2 * z100);
    const double z102 = R_2 * z93;
    kept[89] = z102;
    const double z103 = z55 * (z101 - 8.0 * (R_1 * z102) - 8.0 * (R_0 * z94));
    kept[90] = z103;
    const double z104 = z36 * z81 + 4.0 * (z2 * z85) + 4.0 * (R_1 * z90) - 8.0 * (z5 * z94) - 2.0 * (R_0 *
        z103);
    kept[91] = z104;
    const double z105 = z5 * z86;
    kept[92] = z105;
    const double z106 = R_3 * z105;
    kept[93] = z106;
    const double z107 = z17 * z91;
    kept[94] = z107;
    const double z108 = z5 * z107;
    kept[95] = z108;
    const double z109 = R_3 * z108;
    kept[96] = z109;
    const double z110 = R_1 * z107;
    kept[97] = z110;
    const double z111 = z5 * z110;
    kept[98] = z111;
    const double z112 = R_3 * z111;
    kept[99] = z112;
    const double z113 = k2 * z82;
    kept[100] = z113;
    const double z114 = z15 * z113;
    kept[101] = z114;
    const double z115 = R_3 * z114;
    kept[102] = z115;
    const double z116 = z44 * z81 + 4.0 * (R_2 * z106) - 4.0 * (z2 * z109) + 4.0 * (R_1 * z112) - 8.0 * (z5 *
        z115);
    kept[103] = z116;
    const double z117 = z45 * z81;
    kept[104] = z117;
    const double z118 = R_1 * z86;
    kept[105] = z118;
    const double z119 = R_2 * z110;
    kept[106] = z119;
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW static int chaplygin_ball_quaternion_jacobian_part2(double t, const double *y,
    const double *p, double *kept, double *J)
{
    (void)t;
    const double z1 = kept[5];
    const double z18 = kept[17];
    const double z19 = kept[18];
    const double z22 = kept[21];
    const double z26 = kept[24];
    const double z43 = kept[39];
    const double z86 = kept[77];
    const double z107 = kept[94];
    const double z110 = kept[97];
    const double z117 = kept[104];
    const double z118 = kept[105];
    const double z119 = kept[106];
    const double z120 = 4.0 * (z43 * z86 + z1 * z117 - z18 * z118 - z26 * z107 + z22 * z110) + z19 * z119;
    const double R_y2 = kept[14];
    const double z113 = kept[100];
    const double z121 = R_y2 * z113;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z122 = R_3 * z121;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z114 = kept[101];
    const double z123 = 8.0 * (R_2 * z114) - 4.0 * (R_1 * z121);
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double k1 = kept[0];
    const double z27 = kept[25];
    const double z46 = kept[42];
    const double z80 = kept[71];
    const double z91 = kept[82];
    const double z115 = kept[102];
    const double z124 = z120 + k1 * (z46 * z80 - z27 * z91) - 4.0 * (R_3 * z122) + R_1 * z123 - 8.0 * (R_0 *
        z115);
    const double z55 = kept[49];
    const double z125 = z55 * z124;
    const double z30 = kept[27];
    const double z104 = kept[91];
    const double z116 = kept[103];
    const double z126 = z116 - 2.0 * (R_0 * z125) - z30 * z104;
    const double z83 = kept[74];
    const double z127 = R_0 * z83;
    const double z5 = kept[6];
    const double z128 = z5 * z127;
    const double z129 = R_3 * z128;
    const double z130 = R_0 * z107;
    const double z131 = z5 * z130;
    const double z132 = R_3 * z131;
    const double k2 = kept[1];
    const double z133 = k2 * z80;
    const double z33 = kept[30];
    const double z134 = z33 * z133;
    const double z32 = kept[29];
    const double z135 = z32 * z133;
    const double z136 = R_2 * z134 - R_1 * z135;
    const double z36 = kept[33];
    const double z44 = kept[40];
    const double z137 = z44 * z83 + 4.0 * (R_2 * z129) - z36 * z107 - 4.0 * (R_1 * z132) + 8.0 * (z5 * z136);
    const double z37 = kept[34];
    const double z45 = kept[41];
    const double z138 = z45 * z83 - z37 * z107;
    const double z139 = R_1 * z127 + R_2 * z130;
    const double z39 = kept[36];
    const double z82 = kept[73];
    const double z140 = 4.0 * (z43 * z127 + z1 * z138 - z18 * z139 - z22 * z130) + k1 * (z46 * z82 - z39 *
        z91);
    const double z141 = R_1 * z134;
    const double z142 = R_3 * z135;
    const double z143 = z55 * (z140 + 8.0 * (R_3 * z141) + 8.0 * (R_2 * z142) + 8.0 * (R_0 * z136));
    const double z41 = kept[37];
    const double z49 = kept[44];
    const double z74 = kept[67];
    const double z144 = z74 * (z137 - 2.0 * (R_0 * z143) - z41 * z104 - z49 * z126);
    const double z48 = kept[43];
    const double z145 = z48 * z126 - z49 * z144;
    const double z38 = kept[35];
    const double z81 = kept[72];
    const double z146 = z38 * z81;
    const double z147 = R_3 * z146;
    const double z11 = kept[10];
    const double z88 = kept[79];
    const double z148 = z11 * z88;
    const double z24 = kept[22];
    const double z90 = kept[81];
    const double z102 = kept[89];
    const double z103 = kept[90];
    const double z149 = z147 - z24 * z83 - 4.0 * (R_0 * z90) + 8.0 * (z5 * z102) + 2.0 * (R_1 * (z103 - 4.0 *
        z148));
    const double z35 = kept[32];
    const double z150 = z35 * z86;
    const double z151 = z5 * (z118 - z119);
    const double z6 = kept[7];
    const double z112 = kept[99];
    const double z152 = z150 - z24 * z107 + 4.0 * (R_0 * z112) - 4.0 * (z6 * z121) + z5 * z123 - 2.0 * (R_1 *
        (z125 + 4.0 * z151));
    const double z153 = z152 + z30 * z149;
    const double z154 = z38 * z107;
    const double z8 = kept[8];
    const double z12 = kept[11];
    const double z155 = z35 * z127 + R_3 * z154 - 4.0 * (R_0 * z132) + 8.0 * (z12 * z134) - 8.0 * (z8 * z135);
    const double z156 = z143 + 4.0 * (z5 * z139);
    const double z157 = z74 * (z155 - 2.0 * (R_1 * z156) + z41 * z149 - z49 * z153);
    const double z158 = z48 * z153 - z49 * z157;
    const double z20 = kept[19];
    const double z87 = kept[78];
    const double z93 = kept[83];
    const double z98 = kept[86];
    const double z100 = kept[88];
    const double z159 = z150 - z20 * z87 + 8.0 * (z6 * z93) - 4.0 * (z11 * z98) - 4.0 * (z5 * z100);
    const double z85 = kept[76];
    const double z160 = z159 + 2.0 * (R_2 * (z103 - 4.0 * (z148 + R_0 * z85)));
    const double z106 = kept[93];
    const double z109 = kept[96];
    const double z161 = z147 - 4.0 * (R_0 * z106) + z20 * z110 - 8.0 * (z6 * z114) + 2.0 * (R_2 * (z125 + 4.0
        * (z151 + R_0 * z109)));
    const double z162 = z161 - z30 * z160;
    const double z163 = z38 * z83;
    const double z164 = R_3 * z163 - 4.0 * (R_0 * z129) - z35 * z130 - 8.0 * (z8 * z134) - 8.0 * (z5 * z142);
    const double z165 = z74 * (z164 + 2.0 * (R_2 * z156) - z41 * z160 - z49 * z162);
    const double z166 = z48 * z162 - z49 * z165;
    const double z21 = kept[20];
    const double z25 = kept[23];
    const double z84 = kept[75];
    const double z89 = kept[80];
    const double z167 = R_1 * z146 - 4.0 * (z25 * z84) - 4.0 * (z21 * z89) + 8.0 * (z8 * z93) - 4.0 * (z12 *
        z98);
    const double z95 = kept[84];
    const double z96 = kept[85];
    const double z99 = kept[87];
    const double z168 = z167 - 4.0 * (z5 * z99) + 2.0 * (R_3 * (z103 - (4.0 * (z5 * z95) - 8.0 * (z5 *
        z96))));
    const double z42 = kept[38];
    const double z105 = kept[92];
    const double z108 = kept[95];
    const double z111 = kept[98];
    const double z169 = R_2 * z146 - 4.0 * (z42 * z105) + 4.0 * (z25 * z108) - 4.0 * (z21 * z111) + 8.0 * (z8
        * z114);
    const double z170 = z169 + 4.0 * (z12 * z121) + 4.0 * (z5 * z122) + 2.0 * (R_3 * (z125 - (4.0 * (z5 *
        z117) + 8.0 * (z5 * z119))));
    const double z171 = z170 - z30 * z168;
    const double z172 = R_2 * z163 - 4.0 * (z42 * z128) - R_1 * z154 + 4.0 * (z21 * z131) - 8.0 * (z11 *
        z135);
    const double z173 = z172 - 8.0 * (z5 * z141) + 2.0 * (R_3 * (z143 - 4.0 * (z5 * z138))) - z41 * z168;
    const double z174 = z74 * (z173 - z49 * z171);
    const double z175 = z48 * z171 - z49 * z174;
    const double w3 = y[8];
    const double k4 = kept[3];
    const double z176 = w3 * k4;
    const double w2 = y[7];
    const double k5 = kept[4];
    const double z177 = z74 * (w2 * k5 - z49 * z176);
    const double z178 = z48 * z176 - z49 * z177;
    const double k3 = kept[2];
    const double z179 = w3 * k3;
    const double z180 = z30 * z179;
    const double z75 = kept[68];
    const double z181 = z74 * (z75 + z41 * z179 - z49 * z180);
    const double z182 = z48 * z180 - z49 * z181;
    const double z76 = kept[69];
    const double z78 = kept[70];
    const double z183 = z78 + z30 * z76;
    const double z184 = z74 * (z41 * z76 - z49 * z183);
    const double z185 = z48 * z183 - z49 * z184;
    const double z54 = kept[48];
    const double z61 = kept[54];
    /* (I.2.15) */
    J[2] = 2.0 * z54 + 4.0 * (R_0 * z61);
    const double z60 = kept[53];
    const double z62 = kept[55];
    J[3] = 4.0 * (R_1 * z61) - 2.0 * (z62 - z5 * z60);
    const double z51 = kept[46];
    const double z58 = kept[51];
    J[4] = 2.0 * (z6 * z51 + z5 * z58) + 4.0 * (R_2 * z61);
    const double z63 = kept[56];
    J[5] = z63;
    const double a = p[1]; /* radius [m] */
    const double z10 = kept[9];
    J[6] = 2.0 * (a * z10);
    J[7] = a * R_y2;
    J[8] = 2.0 * (a * z32);
    const double z64 = kept[57];
    const double z66 = kept[59];
    J[11] = 2.0 * (z5 * z64) - 4.0 * (R_0 * z66);
    const double z52 = kept[47];
    const double z65 = kept[58];
    J[12] = -(2.0 * (z12 * z52 + z5 * z65) + 4.0 * (R_1 * z66));
    const double z59 = kept[52];
    J[13] = -(2.0 * (z62 - z11 * z51 - z5 * z59) + 4.0 * (R_2 * z66));
    const double z56 = kept[50];
    J[14] = 2.0 * (z54 + (z8 * z56 + z12 * z51)) - 4.0 * (R_3 * z66);
    const double R_x1 = kept[12];
    J[15] = -a * R_x1;
    const double z15 = kept[15];
    J[16] = -2.0 * (a * z15);
    J[17] = -2.0 * (a * z33);
    const double z67 = kept[60];
    J[21] = -z67;
    const double z68 = kept[61];
    J[22] = -z68;
    const double z69 = kept[62];
    J[23] = -z69;
    const double z70 = kept[63];
    J[24] = -z70;
    const double z71 = kept[64];
    J[25] = -z71;
    const double z72 = kept[65];
    J[26] = -z72;
    J[29] = z67;
    J[31] = z69;
    J[32] = -z68;
    const double z73 = kept[66];
    J[33] = z73;
    J[34] = -z72;
    J[35] = z71;
    J[38] = z68;
    J[39] = -z69;
    J[41] = z67;
    J[42] = z72;
    J[43] = z73;
    J[44] = -z70;
    J[47] = z69;
    J[48] = z68;
    J[49] = -z67;
    J[51] = -z71;
    J[52] = z70;
    J[53] = z73;
    const double z29 = kept[26];
    J[56] = z29 * z104 - z30 * z145 - z41 * z144;
    J[57] = -(z29 * z149 + z30 * z158 + z41 * z157);
    J[58] = z41 * z165 - (z29 * z160 - z30 * z166);
    J[59] = z41 * z174 - (z29 * z168 - z30 * z175);
    J[60] = z30 * z178 + z41 * z177;
    J[61] = z29 * z179 + z30 * z182 + z41 * z181;
    J[62] = z29 * z76 + z30 * z185 + z41 * z184;
    J[65] = z145;
    J[66] = z158;
    J[67] = -z166;
    J[68] = -z175;
    J[69] = -z178;
    J[70] = -z182;
    J[71] = -z185;
    J[74] = -z144;
    J[75] = -z157;
    J[76] = z165;
    J[77] = z174;
    J[78] = z177;
    J[79] = z181;
    J[80] = z184;
    const double z14 = kept[13];
    /* the mass matrix is singular */
    if (!(fabs(z14) > 0.0)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    const double z16 = kept[16];
    const double z31 = kept[28];
    /* the mass matrix is singular */
    if (!(fabs(z31) > 1e-14 * z16)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    const double z34 = kept[31];
    const double z50 = kept[45];
    /* the mass matrix is singular */
    if (!(fabs(z50) > 1e-14 * z34)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW
int chaplygin_ball_quaternion_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[107]; /* what parts of this function leave for others */
    for (int entry = 0; entry < 81; ++entry) {
        J[entry] = 0.0;
    }
    int status = chaplygin_ball_quaternion_jacobian_part1(t, y, p, kept, J);
    if (status == CHAPLYGIN_BALL_QUATERNION_OK) {
        status = chaplygin_ball_quaternion_jacobian_part2(t, y, p, kept, J);
    }
    if (status != CHAPLYGIN_BALL_QUATERNION_OK) {
        return status;
    }
    return chaplygin_ball_quaternion_finish(81, J);
}

int chaplygin_ball_quaternion_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * a * a;
    const double k2 = I1 + k1;
    const double k3 = I2 + k1;

    /* state */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = I1 * w1;
    const double z3 = I3 * w3;
    const double z4 = I2 * w2;
    const double z5 = k1 * (R_2 * w1 - (R_1 * w2 + R_0 * w3)) + (R_2 * z2 - (R_0 * z3 + R_1 * z4));
    const double z6 = R_3 * z2 + (R_0 * z4 - R_1 * z3);
    const double z7 = z1 * (R_2 * z5 + R_3 * (k1 * (R_3 * w1 + (R_0 * w2 - R_1 * w3)) + z6));
    const double z8 = R_3 * z4 - (R_0 * z2 + R_2 * z3);
    const double z9 = z1 * (R_1 * z5 - R_3 * (k1 * (R_3 * w2 - (R_0 * w1 + R_2 * w3)) + z8));
    /* 26:8 */
    out[0] = w1 * k2 - 2.0 * z7; /* K_x */
    /* 27:8 */
    out[1] = w2 * k3 + 2.0 * z9; /* K_y */
    /* 28:8 */
    out[2] = z3 + 2.0 * (z1 * (R_1 * z6 + R_2 * z8)); /* K_z */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1] + out[2]) <= DBL_MAX)) {
        return chaplygin_ball_quaternion_finish(3, out);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

#if CHAPLYGIN_BALL_QUATERNION_LANES >= 2
static __attribute__((noinline)) void chaplygin_ball_quaternion_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    chaplygin_ball_quaternion_lanes far = {0}; /* the squares of the angles */
    chaplygin_ball_quaternion_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    chaplygin_ball_quaternion_bits bad = {0}; /* singular blocks */
    const double a = fixed[0];
    const double I1 = fixed[1];
    const double I2 = fixed[2];
    const double I3 = fixed[3];
    const double k1 = fixed[4];
    const double k2 = fixed[5];
    const double k3 = fixed[6];
    const double k4 = fixed[7];
    const double k5 = fixed[8];
    const chaplygin_ball_quaternion_lanes R_0 = chaplygin_ball_quaternion_get(y + 2 * stride);
    const chaplygin_ball_quaternion_lanes R_1 = chaplygin_ball_quaternion_get(y + 3 * stride);
    const chaplygin_ball_quaternion_lanes R_2 = chaplygin_ball_quaternion_get(y + 4 * stride);
    const chaplygin_ball_quaternion_lanes R_3 = chaplygin_ball_quaternion_get(y + 5 * stride);
    const chaplygin_ball_quaternion_lanes w1 = chaplygin_ball_quaternion_get(y + 6 * stride);
    const chaplygin_ball_quaternion_lanes w2 = chaplygin_ball_quaternion_get(y + 7 * stride);
    const chaplygin_ball_quaternion_lanes w3 = chaplygin_ball_quaternion_get(y + 8 * stride);
    const chaplygin_ball_quaternion_lanes z1 = R_3 * R_3;
    const chaplygin_ball_quaternion_lanes z2 = R_2 * R_2;
    const chaplygin_ball_quaternion_lanes z3 = R_1 * R_1;
    const chaplygin_ball_quaternion_lanes z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)));
    const chaplygin_ball_quaternion_lanes z5 = R_1 * z4;
    const chaplygin_ball_quaternion_lanes z6 = R_2 * z5;
    const chaplygin_ball_quaternion_lanes z7 = R_0 * z4;
    const chaplygin_ball_quaternion_lanes z8 = R_3 * z7;
    const chaplygin_ball_quaternion_lanes z9 = z6 + z8;
    const chaplygin_ball_quaternion_lanes z10 = R_2 * z4;
    const chaplygin_ball_quaternion_lanes z11 = R_3 * z4;
    const chaplygin_ball_quaternion_lanes z12 = R_3 * z11;
    const chaplygin_ball_quaternion_lanes R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12);
    const chaplygin_ball_quaternion_lanes z13 = I1 + k2 * (4.0 * (z9 * z9) + R_x1 * R_x1);
    const chaplygin_ball_quaternion_lanes R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    const chaplygin_ball_quaternion_lanes z14 = z6 - z8;
    const chaplygin_ball_quaternion_lanes z15 = I2 + k2 * (R_y2 * R_y2 + 4.0 * (z14 * z14));
    const chaplygin_ball_quaternion_lanes z16 = z4 * k1;
    const chaplygin_ball_quaternion_lanes z17 = z3 + z2;
    const chaplygin_ball_quaternion_lanes z18 = 4.0 * (R_1 * z8);
    const chaplygin_ball_quaternion_lanes z19 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z18) + 4.0
        * (z2 * z8);
    const chaplygin_ball_quaternion_lanes z20 = z16 * z19;
    const chaplygin_ball_quaternion_lanes z21 = 1.0 / z13;
    const chaplygin_ball_quaternion_lanes z22 = z21 * z20;
    const chaplygin_ball_quaternion_lanes z23 = z15 - z20 * z22;
    /* the mass matrix is singular */
    bad |=
        chaplygin_ball_quaternion_misses(chaplygin_ball_quaternion_size(CHAPLYGIN_BALL_QUATERNION_SPREAD(z23)),
        1e-14 * z15);
    const chaplygin_ball_quaternion_lanes z24 = R_3 * z10 - R_1 * z7;
    const chaplygin_ball_quaternion_lanes z25 = R_1 * z11 + R_2 * z7;
    const chaplygin_ball_quaternion_lanes z26 = I3 + 4.0 * (k2 * (z24 * z24 + z25 * z25));
    const chaplygin_ball_quaternion_lanes z27 = 2.0 - 4.0 * (z4 * z17);
    const chaplygin_ball_quaternion_lanes z28 = R_3 * (2.0 - 4.0 * (z1 * z4));
    const chaplygin_ball_quaternion_lanes z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28);
    const chaplygin_ball_quaternion_lanes z30 = z21 * z29;
    const chaplygin_ball_quaternion_lanes z31 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28) +
        z20 * z30;
    const chaplygin_ball_quaternion_lanes z32 = 1.0 / z23;
    const chaplygin_ball_quaternion_lanes z33 = z31 * z32;
    const chaplygin_ball_quaternion_lanes z34 = z26 - z29 * z30 - z31 * z33;
    /* the mass matrix is singular */
    bad |=
        chaplygin_ball_quaternion_misses(chaplygin_ball_quaternion_size(CHAPLYGIN_BALL_QUATERNION_SPREAD(z34)),
        1e-14 * z26);
    const chaplygin_ball_quaternion_lanes z35 = w2 * w3 * k3;
    const chaplygin_ball_quaternion_lanes z36 = w1 * w3 * k4 + z35 * z22;
    const chaplygin_ball_quaternion_lanes z37 = (w1 * w2 * k5 - z35 * z30 - z33 * z36) / z34;
    const chaplygin_ball_quaternion_lanes z38 = z32 * z36 - z33 * z37;
    /* (I.2.15) */
    const chaplygin_ball_quaternion_lanes slope1 = a * (2.0 * (z24 * w3) + (R_y2 * w2 + 2.0 * (z9 * w1)));
    sum += slope1;
    chaplygin_ball_quaternion_put(dydt, slope1);
    const chaplygin_ball_quaternion_lanes slope2 = -a * (2.0 * (z25 * w3) + (2.0 * (z14 * w2) + R_x1 * w1));
    sum += slope2;
    chaplygin_ball_quaternion_put(dydt + 1 * stride, slope2);
    const chaplygin_ball_quaternion_lanes slope3 = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2));
    sum += slope3;
    chaplygin_ball_quaternion_put(dydt + 2 * stride, slope3);
    const chaplygin_ball_quaternion_lanes slope4 = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2));
    sum += slope4;
    chaplygin_ball_quaternion_put(dydt + 3 * stride, slope4);
    const chaplygin_ball_quaternion_lanes slope5 = -0.5 * (R_1 * w3 - (R_3 * w1 + R_0 * w2));
    sum += slope5;
    chaplygin_ball_quaternion_put(dydt + 4 * stride, slope5);
    const chaplygin_ball_quaternion_lanes slope6 = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2));
    sum += slope6;
    chaplygin_ball_quaternion_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 21:4 */
    const chaplygin_ball_quaternion_lanes slope7 = z35 * z21 + z22 * z38 - z30 * z37;
    sum += slope7;
    chaplygin_ball_quaternion_put(dydt + 6 * stride, slope7);
    const chaplygin_ball_quaternion_lanes slope8 = -z38;
    sum += slope8;
    chaplygin_ball_quaternion_put(dydt + 7 * stride, slope8);
    const chaplygin_ball_quaternion_lanes slope9 = z37;
    chaplygin_ball_quaternion_put(dydt + 8 * stride, slope9);
    chaplygin_ball_quaternion_put(check, chaplygin_ball_quaternion_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void chaplygin_ball_quaternion_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CHAPLYGIN_BALL_QUATERNION_LANES];
    double state[9 * CHAPLYGIN_BALL_QUATERNION_LANES];
    double slope[9 * CHAPLYGIN_BALL_QUATERNION_LANES];
    chaplygin_ball_quaternion_fill(left, count, t, y, time, state);
    chaplygin_ball_quaternion_rhs_lanes(fixed, CHAPLYGIN_BALL_QUATERNION_LANES, time, state, slope, check);
    chaplygin_ball_quaternion_pour(left, count, slope, dydt);
}
#endif

int chaplygin_ball_quaternion_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if CHAPLYGIN_BALL_QUATERNION_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k1 = m * a * a;
    const double k2 = a * (m * a);
    const double k3 = I2 - I3;
    const double k4 = I1 - I3;
    const double k5 = I1 - I2;
    const double fixed[] = {a, I1, I2, I3, k1, k2, k3, k4, k5};
    double check[1 * CHAPLYGIN_BALL_QUATERNION_LANES];
    int status = CHAPLYGIN_BALL_QUATERNION_OK;
    for (size_t i = 0; i < count; i += CHAPLYGIN_BALL_QUATERNION_LANES) {
        const size_t left = count - i < CHAPLYGIN_BALL_QUATERNION_LANES ? count - i : CHAPLYGIN_BALL_QUATERNION_LANES;
        if (left == CHAPLYGIN_BALL_QUATERNION_LANES) {
            chaplygin_ball_quaternion_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            chaplygin_ball_quaternion_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!chaplygin_ball_quaternion_is_good(1 * CHAPLYGIN_BALL_QUATERNION_LANES, check)) {
            const int one = chaplygin_ball_quaternion_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CHAPLYGIN_BALL_QUATERNION_OK ? one : status;
        }
    }
    return status;
#else
    return chaplygin_ball_quaternion_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
