/*
 * chaplygin_ball_quaternion.c: chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:5a3c062de4cc0792)
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
    dydt[4] = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5; /* R_2' */
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
    qdot[4] = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5; /* R_2' */
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
    const double z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)));
    kept[6] = z4;
    const double z5 = R_1 * z4;
    kept[7] = z5;
    const double z6 = R_2 * z5;
    const double z7 = R_0 * z4;
    kept[8] = z7;
    const double z8 = R_3 * z7;
    const double z9 = z6 + z8;
    kept[9] = z9;
    const double z10 = R_2 * z4;
    kept[10] = z10;
    const double z11 = R_3 * z4;
    kept[11] = z11;
    const double z12 = R_3 * z11;
    const double R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12);
    kept[12] = R_x1;
    const double z13 = I1 + (4.0 * (k2 * (z9 * z9)) + k2 * (R_x1 * R_x1));
    kept[13] = z13;
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    kept[14] = R_y2;
    const double z14 = z6 - z8;
    kept[15] = z14;
    const double z15 = I2 + (k2 * (R_y2 * R_y2) + 4.0 * (k2 * (z14 * z14)));
    kept[16] = z15;
    const double z16 = z4 * k1;
    const double z17 = z3 + z2;
    kept[17] = z17;
    const double z18 = 8.0 * z1 + 4.0 * z17;
    const double z19 = 4.0 - z4 * z18;
    kept[18] = z19;
    const double z20 = R_0 * R_1;
    kept[19] = z20;
    const double z21 = R_3 * z20;
    kept[20] = z21;
    const double z22 = 4.0 * (z4 * z21);
    const double z23 = R_2 * z19 - z22;
    kept[21] = z23;
    const double z24 = R_0 * z2;
    kept[22] = z24;
    const double z25 = R_3 * z24;
    const double z26 = R_1 * z23 + 4.0 * (z4 * z25);
    kept[23] = z26;
    const double z27 = z16 * z26;
    const double z28 = 1.0 / z13;
    kept[24] = z28;
    const double z29 = z27 * z28;
    kept[25] = z29;
    const double z30 = z15 - z27 * z29;
    kept[26] = z30;
    const double z31 = R_3 * z10 - R_1 * z7;
    kept[27] = z31;
    const double z32 = R_1 * z11 + R_2 * z7;
    kept[28] = z32;
    const double z33 = I3 + 4.0 * (k2 * (z31 * z31 + z32 * z32));
    kept[29] = z33;
    const double z34 = 2.0 - 4.0 * (z4 * z17);
    kept[30] = z34;
    const double z35 = z22 - R_2 * z34;
    kept[31] = z35;
    const double z36 = R_1 * R_3;
    kept[32] = z36;
    const double z37 = 2.0 - 4.0 * (z1 * z4);
    kept[33] = z37;
    const double z38 = R_0 * z35 - z36 * z37;
    kept[34] = z38;
    const double z39 = z16 * z38;
    const double z40 = z39 * z28;
    kept[35] = z40;
    const double z41 = R_0 * R_2;
    kept[36] = z41;
    const double z42 = R_3 * z41;
    kept[37] = z42;
    const double z43 = R_1 * z34 + 4.0 * (z4 * z42);
    kept[38] = z43;
    const double z44 = R_2 * R_3;
    kept[39] = z44;
    const double z45 = R_0 * z43 - z37 * z44;
    kept[40] = z45;
    const double z46 = z16 * z45 - z27 * z40;
    const double z47 = 1.0 / z30;
    kept[41] = z47;
    const double z48 = z46 * z47;
    kept[42] = z48;
    const double z49 = z33 - z39 * z40 - z46 * z48;
    kept[43] = z49;
    const double w1 = y[6];
    const double z50 = a * w1;
    kept[44] = z50;
    const double w3 = y[8];
    const double z51 = a * w3;
    kept[45] = z51;
    const double z52 = R_3 * z50 - R_1 * z51;
    const double z53 = z4 * z52;
    kept[46] = z53;
    const double z54 = z4 * z4;
    kept[47] = z54;
    const double w2 = y[7];
    const double z55 = a * w2;
    kept[48] = z55;
    const double z56 = R_3 * z55;
    const double z57 = R_3 * z51;
    kept[49] = z57;
    const double z58 = R_2 * z50;
    kept[50] = z58;
    const double z59 = z58 - R_1 * z55;
    kept[51] = z59;
    const double z60 = z54 * (R_3 * z56 - R_2 * z57 - R_1 * z59 - R_0 * z52);
    kept[52] = z60;
    const double z61 = z7 * z51 + z5 * z55;
    kept[53] = z61;
    const double z62 = 2.0 * (z7 * z50 + z10 * z51 - z11 * z55 - z4 * z56) + 4.0 * (R_3 * z60);
    kept[54] = z62;
    const double z63 = z56 - R_2 * z51;
    kept[55] = z63;
    const double z64 = R_2 * z55;
    kept[56] = z64;
    const double z65 = z54 * (R_3 * z52 + R_2 * z58 - R_1 * z64 + R_0 * z63);
    kept[57] = z65;
    const double z66 = 0.5 * w1;
    kept[58] = z66;
    const double z67 = 0.5 * w2;
    kept[59] = z67;
    const double z68 = 0.5 * w3;
    kept[60] = z68;
    const double z69 = 0.5 * R_1;
    kept[61] = z69;
    const double z70 = 0.5 * R_2;
    kept[62] = z70;
    const double z71 = 0.5 * R_3;
    kept[63] = z71;
    const double z72 = 0.5 * R_0;
    kept[64] = z72;
    const double z73 = 1.0 / z49;
    kept[65] = z73;
    const double z74 = w1 * k5;
    kept[66] = z74;
    const double z75 = w2 * k3;
    kept[67] = z75;
    const double z76 = w3 * z75;
    const double z77 = w1 * k4;
    kept[68] = z77;
    const double z78 = w3 * z77 + z29 * z76;
    const double z79 = z73 * (w2 * z74 + z40 * z76 - z48 * z78);
    kept[69] = z79;
    const double z80 = z16 * z79;
    kept[70] = z80;
    const double z81 = z47 * z78 - z48 * z79;
    kept[71] = z81;
    const double z82 = z16 * z81;
    kept[72] = z82;
    const double z83 = z4 * z82;
    kept[73] = z83;
    const double z84 = R_3 * z83;
    kept[74] = z84;
    const double z85 = R_0 * z80;
    kept[75] = z85;
    const double z86 = R_1 * z82;
    kept[76] = z86;
    const double z87 = z85 - z86;
    kept[77] = z87;
    const double z88 = z4 * z87;
    kept[78] = z88;
    const double z89 = R_3 * z88;
    kept[79] = z89;
    const double z90 = z28 * z76 + z29 * z81 + z40 * z79;
    kept[80] = z90;
    const double z91 = k2 * z90;
    const double z92 = z9 * z91;
    kept[81] = z92;
    const double z93 = R_3 * z92;
    const double z94 = z36 * z80;
    kept[82] = z94;
    const double z95 = R_2 * z86;
    kept[83] = z95;
    const double z96 = 4.0 * (z1 * z94 + z85 * (R_2 * z17) + z25 * z82 + z21 * z87) - z18 * z95;
    const double z97 = R_x1 * z91;
    kept[84] = z97;
    const double z98 = R_3 * z97;
    kept[85] = z98;
    const double z99 = R_2 * z97;
    kept[86] = z99;
    const double z100 = z96 + k1 * (z38 * z79 + z26 * z81) + 4.0 * (R_3 * z98) + 4.0 * (R_2 * z99);
    const double z101 = R_2 * z92;
    kept[87] = z101;
    const double z102 = z54 * (z100 - 8.0 * (R_1 * z101) - 8.0 * (R_0 * z93));
    kept[88] = z102;
    const double z103 = z35 * z80 + 4.0 * (z2 * z84) + 4.0 * (R_1 * z89) - 8.0 * (z4 * z93) - 2.0 * (R_0 *
        z102);
    kept[89] = z103;
    const double z104 = z4 * z85;
    kept[90] = z104;
    const double z105 = R_3 * z104;
    kept[91] = z105;
    const double z106 = z16 * z90;
    kept[92] = z106;
    const double z107 = z4 * z106;
    kept[93] = z107;
    const double z108 = R_3 * z107;
    kept[94] = z108;
    const double z109 = R_1 * z106;
    kept[95] = z109;
    const double z110 = z4 * z109;
    kept[96] = z110;
    const double z111 = R_3 * z110;
    kept[97] = z111;
    const double z112 = k2 * z81;
    kept[98] = z112;
    const double z113 = z14 * z112;
    kept[99] = z113;
    const double z114 = R_3 * z113;
    kept[100] = z114;
    const double z115 = z43 * z80 + 4.0 * (R_2 * z105) - 4.0 * (z2 * z108) + 4.0 * (R_1 * z111) - 8.0 * (z4 *
        z114);
    kept[101] = z115;
    const double z116 = z44 * z80;
    kept[102] = z116;
    const double z117 = R_1 * z85;
    kept[103] = z117;
    const double z118 = R_2 * z109;
    kept[104] = z118;
    const double z119 = 4.0 * (z42 * z85 + z1 * z116 - z17 * z117 - z25 * z106 + z21 * z109) + z18 * z118;
    kept[105] = z119;
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW static int chaplygin_ball_quaternion_jacobian_part2(double t, const double *y,
    const double *p, double *kept, double *J)
{
    (void)t;
    const double R_y2 = kept[14];
    const double z112 = kept[98];
    const double z120 = R_y2 * z112;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z121 = R_3 * z120;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z113 = kept[99];
    const double z122 = 8.0 * (R_2 * z113) - 4.0 * (R_1 * z120);
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double k1 = kept[0];
    const double z26 = kept[23];
    const double z45 = kept[40];
    const double z79 = kept[69];
    const double z90 = kept[80];
    const double z114 = kept[100];
    const double z119 = kept[105];
    const double z123 = z119 + k1 * (z45 * z79 - z26 * z90) - 4.0 * (R_3 * z121) + R_1 * z122 - 8.0 * (R_0 *
        z114);
    const double z54 = kept[47];
    const double z124 = z54 * z123;
    const double z29 = kept[25];
    const double z103 = kept[89];
    const double z115 = kept[101];
    const double z125 = z115 - 2.0 * (R_0 * z124) - z29 * z103;
    const double z82 = kept[72];
    const double z126 = R_0 * z82;
    const double z4 = kept[6];
    const double z127 = z4 * z126;
    const double z128 = R_3 * z127;
    const double z106 = kept[92];
    const double z129 = R_0 * z106;
    const double z130 = z4 * z129;
    const double z131 = R_3 * z130;
    const double k2 = kept[1];
    const double z132 = k2 * z79;
    const double z32 = kept[28];
    const double z133 = z32 * z132;
    const double z31 = kept[27];
    const double z134 = z31 * z132;
    const double z135 = R_2 * z133 - R_1 * z134;
    const double z35 = kept[31];
    const double z43 = kept[38];
    const double z136 = z43 * z82 + 4.0 * (R_2 * z128) - z35 * z106 - 4.0 * (R_1 * z131) + 8.0 * (z4 * z135);
    const double z36 = kept[32];
    const double z44 = kept[39];
    const double z137 = z44 * z82 - z36 * z106;
    const double z138 = R_1 * z126 + R_2 * z129;
    const double z1 = kept[5];
    const double z17 = kept[17];
    const double z21 = kept[20];
    const double z38 = kept[34];
    const double z42 = kept[37];
    const double z81 = kept[71];
    const double z139 = 4.0 * (z42 * z126 + z1 * z137 - z17 * z138 - z21 * z129) + k1 * (z45 * z81 - z38 *
        z90);
    const double z140 = R_1 * z133;
    const double z141 = R_3 * z134;
    const double z142 = z54 * (z139 + 8.0 * (R_3 * z140) + 8.0 * (R_2 * z141) + 8.0 * (R_0 * z135));
    const double z40 = kept[35];
    const double z48 = kept[42];
    const double z73 = kept[65];
    const double z143 = z73 * (z136 - 2.0 * (R_0 * z142) - z40 * z103 - z48 * z125);
    const double z47 = kept[41];
    const double z144 = z47 * z125 - z48 * z143;
    const double z37 = kept[33];
    const double z80 = kept[70];
    const double z145 = z37 * z80;
    const double z146 = R_3 * z145;
    const double z10 = kept[10];
    const double z87 = kept[77];
    const double z147 = z10 * z87;
    const double z23 = kept[21];
    const double z89 = kept[79];
    const double z101 = kept[87];
    const double z102 = kept[88];
    const double z148 = z146 - z23 * z82 - 4.0 * (R_0 * z89) + 8.0 * (z4 * z101) + 2.0 * (R_1 * (z102 - 4.0 *
        z147));
    const double z34 = kept[30];
    const double z85 = kept[75];
    const double z149 = z34 * z85;
    const double z117 = kept[103];
    const double z118 = kept[104];
    const double z150 = z4 * (z117 - z118);
    const double z5 = kept[7];
    const double z111 = kept[97];
    const double z151 = z149 - z23 * z106 + 4.0 * (R_0 * z111) - 4.0 * (z5 * z120) + z4 * z122 - 2.0 * (R_1 *
        (z124 + 4.0 * z150));
    const double z152 = z151 + z29 * z148;
    const double z153 = z37 * z106;
    const double z7 = kept[8];
    const double z11 = kept[11];
    const double z154 = z34 * z126 + R_3 * z153 - 4.0 * (R_0 * z131) + 8.0 * (z11 * z133) - 8.0 * (z7 * z134);
    const double z155 = z142 + 4.0 * (z4 * z138);
    const double z156 = z73 * (z154 - 2.0 * (R_1 * z155) + z40 * z148 - z48 * z152);
    const double z157 = z47 * z152 - z48 * z156;
    const double z19 = kept[18];
    const double z86 = kept[76];
    const double z92 = kept[81];
    const double z97 = kept[84];
    const double z99 = kept[86];
    const double z158 = z149 - z19 * z86 + 8.0 * (z5 * z92) - 4.0 * (z10 * z97) - 4.0 * (z4 * z99);
    const double z84 = kept[74];
    const double z159 = z158 + 2.0 * (R_2 * (z102 - 4.0 * (z147 + R_0 * z84)));
    const double z105 = kept[91];
    const double z108 = kept[94];
    const double z109 = kept[95];
    const double z160 = z146 - 4.0 * (R_0 * z105) + z19 * z109 - 8.0 * (z5 * z113) + 2.0 * (R_2 * (z124 + 4.0
        * (z150 + R_0 * z108)));
    const double z161 = z160 - z29 * z159;
    const double z162 = z37 * z82;
    const double z163 = R_3 * z162 - 4.0 * (R_0 * z128) - z34 * z129 - 8.0 * (z7 * z133) - 8.0 * (z4 * z141);
    const double z164 = z73 * (z163 + 2.0 * (R_2 * z155) - z40 * z159 - z48 * z161);
    const double z165 = z47 * z161 - z48 * z164;
    const double z20 = kept[19];
    const double z24 = kept[22];
    const double z83 = kept[73];
    const double z88 = kept[78];
    const double z166 = R_1 * z145 - 4.0 * (z24 * z83) - 4.0 * (z20 * z88) + 8.0 * (z7 * z92) - 4.0 * (z11 *
        z97);
    const double z94 = kept[82];
    const double z95 = kept[83];
    const double z98 = kept[85];
    const double z167 = z166 - 4.0 * (z4 * z98) + 2.0 * (R_3 * (z102 - (4.0 * (z4 * z94) - 8.0 * (z4 *
        z95))));
    const double z41 = kept[36];
    const double z104 = kept[90];
    const double z107 = kept[93];
    const double z110 = kept[96];
    const double z168 = R_2 * z145 - 4.0 * (z41 * z104) + 4.0 * (z24 * z107) - 4.0 * (z20 * z110) + 8.0 * (z7
        * z113);
    const double z116 = kept[102];
    const double z169 = z168 + 4.0 * (z11 * z120) + 4.0 * (z4 * z121) + 2.0 * (R_3 * (z124 - (4.0 * (z4 *
        z116) + 8.0 * (z4 * z118))));
    const double z170 = z169 - z29 * z167;
    const double z171 = R_2 * z162 - 4.0 * (z41 * z127) - R_1 * z153 + 4.0 * (z20 * z130) - 8.0 * (z10 *
        z134);
    const double z172 = z171 - 8.0 * (z4 * z140) + 2.0 * (R_3 * (z142 - 4.0 * (z4 * z137))) - z40 * z167;
    const double z173 = z73 * (z172 - z48 * z170);
    const double z174 = z47 * z170 - z48 * z173;
    const double w3 = y[8];
    const double k4 = kept[3];
    const double z175 = w3 * k4;
    const double w2 = y[7];
    const double k5 = kept[4];
    const double z176 = z73 * (w2 * k5 - z48 * z175);
    const double z177 = z47 * z175 - z48 * z176;
    const double k3 = kept[2];
    const double z178 = w3 * k3;
    const double z179 = z29 * z178;
    const double z74 = kept[66];
    const double z180 = z73 * (z74 + z40 * z178 - z48 * z179);
    const double z181 = z47 * z179 - z48 * z180;
    const double z75 = kept[67];
    const double z77 = kept[68];
    const double z182 = z77 + z29 * z75;
    const double z183 = z73 * (z40 * z75 - z48 * z182);
    const double z184 = z47 * z182 - z48 * z183;
    const double z53 = kept[46];
    const double z60 = kept[52];
    /* (I.2.15) */
    J[2] = 2.0 * z53 + 4.0 * (R_0 * z60);
    const double z59 = kept[51];
    const double z61 = kept[53];
    J[3] = 4.0 * (R_1 * z60) - 2.0 * (z61 - z4 * z59);
    const double z50 = kept[44];
    const double z57 = kept[49];
    J[4] = 2.0 * (z5 * z50 + z4 * z57) + 4.0 * (R_2 * z60);
    const double z62 = kept[54];
    J[5] = z62;
    const double a = p[1]; /* radius [m] */
    const double z9 = kept[9];
    J[6] = 2.0 * (a * z9);
    J[7] = a * R_y2;
    J[8] = 2.0 * (a * z31);
    const double z63 = kept[55];
    const double z65 = kept[57];
    J[11] = 2.0 * (z4 * z63) - 4.0 * (R_0 * z65);
    const double z51 = kept[45];
    const double z64 = kept[56];
    J[12] = -(2.0 * (z11 * z51 + z4 * z64) + 4.0 * (R_1 * z65));
    const double z58 = kept[50];
    J[13] = -(2.0 * (z61 - z10 * z50 - z4 * z58) + 4.0 * (R_2 * z65));
    const double z55 = kept[48];
    J[14] = 2.0 * (z53 + (z7 * z55 + z11 * z50)) - 4.0 * (R_3 * z65);
    const double R_x1 = kept[12];
    J[15] = -a * R_x1;
    const double z14 = kept[15];
    J[16] = -2.0 * (a * z14);
    J[17] = -2.0 * (a * z32);
    const double z66 = kept[58];
    J[21] = -z66;
    const double z67 = kept[59];
    J[22] = -z67;
    const double z68 = kept[60];
    J[23] = -z68;
    const double z69 = kept[61];
    J[24] = -z69;
    const double z70 = kept[62];
    J[25] = -z70;
    const double z71 = kept[63];
    J[26] = -z71;
    J[29] = z66;
    J[31] = z68;
    J[32] = -z67;
    const double z72 = kept[64];
    J[33] = z72;
    J[34] = -z71;
    J[35] = z70;
    J[38] = z67;
    J[39] = -z68;
    J[41] = z66;
    J[42] = z71;
    J[43] = z72;
    J[44] = -z69;
    J[47] = z68;
    J[48] = z67;
    J[49] = -z66;
    J[51] = -z70;
    J[52] = z69;
    J[53] = z72;
    const double z28 = kept[24];
    J[56] = z28 * z103 - z29 * z144 - z40 * z143;
    J[57] = -(z28 * z148 + z29 * z157 + z40 * z156);
    J[58] = z40 * z164 - (z28 * z159 - z29 * z165);
    J[59] = z40 * z173 - (z28 * z167 - z29 * z174);
    J[60] = z29 * z177 + z40 * z176;
    J[61] = z28 * z178 + z29 * z181 + z40 * z180;
    J[62] = z28 * z75 + z29 * z184 + z40 * z183;
    J[65] = z144;
    J[66] = z157;
    J[67] = -z165;
    J[68] = -z174;
    J[69] = -z177;
    J[70] = -z181;
    J[71] = -z184;
    J[74] = -z143;
    J[75] = -z156;
    J[76] = z164;
    J[77] = z173;
    J[78] = z176;
    J[79] = z180;
    J[80] = z183;
    const double z13 = kept[13];
    /* the mass matrix is singular */
    if (!(fabs(z13) > 0.0)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    const double z15 = kept[16];
    const double z30 = kept[26];
    /* the mass matrix is singular */
    if (!(fabs(z30) > 1e-14 * z15)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    const double z33 = kept[29];
    const double z49 = kept[43];
    /* the mass matrix is singular */
    if (!(fabs(z49) > 1e-14 * z33)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW
int chaplygin_ball_quaternion_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[106]; /* what parts of this function leave for others */
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
    const chaplygin_ball_quaternion_lanes slope5 = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5;
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
