/*
 * chaplygin_ball_quaternion.c: chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:80ccba07d2e5ff94)
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
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

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
    const double z13 = I1 + k1 * (4.0 * (z9 * z9) + R_x1 * R_x1);
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    const double z14 = z6 - z8;
    const double z15 = I2 + k1 * (R_y2 * R_y2 + 4.0 * (z14 * z14));
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
    const double z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25));
    const double z27 = 2.0 - 4.0 * (z4 * z17);
    const double z28 = R_3 * (2.0 - 4.0 * z12);
    const double z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28);
    const double z30 = z21 * z29;
    const double z31 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28) + z20 * z30;
    const double z32 = 1.0 / z23;
    const double z33 = z31 * z32;
    const double z34 = z26 - z29 * z30 - z31 * z33;
    const double z35 = w2 * w3 * k2;
    const double z36 = w1 * w3 * k3 + z35 * z22;
    const double z37 = (w1 * w2 * k4 - z35 * z30 - z33 * z36) / z34;
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
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

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
    const double z13 = I1 + (4.0 * (k1 * (z9 * z9)) + k1 * (R_x1 * R_x1));
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    const double z14 = z6 - z8;
    const double z15 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z14 * z14)));
    const double z16 = z4 * k1;
    const double z17 = z3 + z2;
    const double z18 = 4.0 * (R_1 * z8);
    const double z19 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z18) + 4.0 * (z2 * z8);
    const double z20 = z16 * z19;
    const double z21 = 1.0 / z13;
    const double z22 = z20 * z21;
    const double z23 = z15 - z20 * z22;
    const double z24 = R_3 * z10 - R_1 * z7;
    const double z25 = R_1 * z11 + R_2 * z7;
    const double z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25));
    const double z27 = 2.0 - 4.0 * (z4 * z17);
    const double z28 = R_3 * (2.0 - 4.0 * z12);
    const double z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28);
    const double z30 = z29 * z21;
    const double z31 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28) + z20 * z30;
    const double z32 = 1.0 / z23;
    const double z33 = z31 * z32;
    const double z34 = z26 - z29 * z30 - z31 * z33;
    const double z35 = w2 * w3 * k2;
    const double z36 = w1 * w3 * k3 + z35 * z22;
    const double z37 = (w1 * w2 * k4 - z35 * z30 - z33 * z36) / z34;
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
    const double k3 = I2 - I3;
    const double k4 = I1 - I3;
    const double k5 = I1 - I2;

    /* state */
    const double z1 = R_3 * R_3;
    const double z2 = R_2 * R_2;
    const double z3 = R_1 * R_1;
    const double z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)));
    const double R_x1 = 1.0 - 2.0 * (z4 * (z2 + z1));
    const double z5 = R_0 * z4;
    const double z6 = R_3 * z5;
    const double z7 = R_1 * R_2;
    const double z8 = z4 * z7;
    const double z9 = z6 + z8;
    const double z10 = I1 + (k1 * (R_x1 * R_x1) + 4.0 * (k1 * (z9 * z9)));
    const double R_y2 = 1.0 - 2.0 * (z4 * (z3 + z1));
    const double z11 = z6 - z8;
    const double z12 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z11 * z11)));
    const double z13 = z4 * k1;
    const double z14 = z3 + z2;
    const double z15 = R_3 * z4;
    const double z16 = R_0 * R_1;
    const double z17 = 4.0 * (z15 * z16);
    const double z18 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z14)) - z17) + 4.0 * (z2 * (R_0 * z15));
    const double z19 = z13 * z18;
    const double z20 = 1.0 / z10;
    const double z21 = z19 * z20;
    const double z22 = z12 - z19 * z21;
    const double z23 = R_1 * z15 + R_2 * z5;
    const double z24 = R_1 * z5 - R_2 * z15;
    const double z25 = I3 + 4.0 * (k1 * (z23 * z23 + z24 * z24));
    const double z26 = R_1 * R_3;
    const double z27 = 2.0 - 4.0 * (R_3 * z15);
    const double z28 = 2.0 - 4.0 * (z4 * z14);
    const double z29 = z13 * (z26 * z27 + R_0 * (R_2 * z28 - z17));
    const double z30 = z29 * z20;
    const double z31 = R_2 * R_3;
    const double z32 = R_0 * R_2;
    const double z33 = z13 * (z31 * z27 - R_0 * (R_1 * z28 + 4.0 * (z15 * z32))) - z19 * z30;
    const double z34 = 1.0 / z22;
    const double z35 = z33 * z34;
    const double z36 = z25 - z29 * z30 - z33 * z35;
    const double z37 = z4 * k2;
    const double z38 = w2 * w3 * k3;
    const double z39 = w1 * w3 * k4 + z38 * z21;
    const double z40 = (w1 * w2 * k5 - z38 * z30 + z35 * z39) / z36;
    const double z41 = z37 * z40;
    const double z42 = R_0 * R_3;
    const double z43 = z34 * z39 + z35 * z40;
    const double z44 = z38 * z20 + z21 * z43 - z30 * z40;
    const double z45 = 2.0 * ((z16 - z31) * z41) - (2.0 * (z37 * (z42 + z7) * z44) - k2 * (R_y2 * z43));
    const double z46 = 2.0 * ((z26 + z32) * z41) + (k2 * (R_x1 * z44) + 2.0 * (z37 * (z42 - z7) * z43));
    /* (I.4.1) 23:5 */
    lambda[0] = -z45; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 24:5 */
    lambda[1] = -z46; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 10:3 */
    lambda[2] = 0.0; /* reaction of R_norm: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX && fabs(z22) > 1e-14 * z12 && fabs(z36) > 1e-14 * z25)) {
        /* the mass matrix is singular */
        if (!(fabs(z10) > 0.0)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * z12)) {
            return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z36) > 1e-14 * z25)) {
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
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k2 = I2 - I3;
    kept[1] = k2;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k3 = I1 - I3;
    kept[2] = k3;
    const double k4 = I1 - I2;
    kept[3] = k4;

    /* state */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = R_3 * R_3;
    kept[4] = z1;
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z2 = R_2 * R_2;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z3 = R_1 * R_1;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)));
    kept[5] = z4;
    const double z5 = R_1 * z4;
    kept[6] = z5;
    const double z6 = R_2 * z5;
    const double z7 = R_0 * z4;
    kept[7] = z7;
    const double z8 = R_3 * z7;
    const double z9 = z6 + z8;
    kept[8] = z9;
    const double z10 = R_2 * z4;
    kept[9] = z10;
    const double z11 = R_3 * z4;
    kept[10] = z11;
    const double z12 = R_3 * z11;
    const double R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12);
    kept[11] = R_x1;
    const double z13 = I1 + (4.0 * (k1 * (z9 * z9)) + k1 * (R_x1 * R_x1));
    kept[12] = z13;
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    kept[13] = R_y2;
    const double z14 = z6 - z8;
    kept[14] = z14;
    const double z15 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z14 * z14)));
    kept[15] = z15;
    const double z16 = z4 * k1;
    const double z17 = z3 + z2;
    kept[16] = z17;
    const double z18 = 8.0 * z1 + 4.0 * z17;
    const double z19 = 4.0 - z4 * z18;
    kept[17] = z19;
    const double z20 = R_0 * R_1;
    kept[18] = z20;
    const double z21 = R_3 * z20;
    kept[19] = z21;
    const double z22 = 4.0 * (z4 * z21);
    const double z23 = R_2 * z19 - z22;
    kept[20] = z23;
    const double z24 = R_0 * z2;
    kept[21] = z24;
    const double z25 = R_3 * z24;
    const double z26 = R_1 * z23 + 4.0 * (z4 * z25);
    const double z27 = z16 * z26;
    const double z28 = 1.0 / z13;
    kept[22] = z28;
    const double z29 = z27 * z28;
    kept[23] = z29;
    const double z30 = z15 - z27 * z29;
    kept[24] = z30;
    const double z31 = R_3 * z10 - R_1 * z7;
    kept[25] = z31;
    const double z32 = R_1 * z11 + R_2 * z7;
    kept[26] = z32;
    const double z33 = I3 + 4.0 * (k1 * (z31 * z31 + z32 * z32));
    kept[27] = z33;
    const double z34 = 2.0 - 4.0 * (z4 * z17);
    kept[28] = z34;
    const double z35 = z22 - R_2 * z34;
    kept[29] = z35;
    const double z36 = R_1 * R_3;
    kept[30] = z36;
    const double z37 = 2.0 - 4.0 * z12;
    kept[31] = z37;
    const double z38 = R_0 * z35 - z36 * z37;
    kept[32] = z38;
    const double z39 = z16 * z38;
    const double z40 = z39 * z28;
    kept[33] = z40;
    const double z41 = R_0 * R_2;
    kept[34] = z41;
    const double z42 = R_3 * z41;
    kept[35] = z42;
    const double z43 = R_1 * z34 + 4.0 * (z4 * z42);
    kept[36] = z43;
    const double z44 = R_2 * R_3;
    kept[37] = z44;
    const double z45 = R_0 * z43 - z44 * z37;
    kept[38] = z45;
    const double z46 = z16 * z45 - z27 * z40;
    const double z47 = 1.0 / z30;
    kept[39] = z47;
    const double z48 = z46 * z47;
    kept[40] = z48;
    const double z49 = z33 - z39 * z40 - z46 * z48;
    kept[41] = z49;
    const double w1 = y[6];
    const double z50 = a * w1;
    kept[42] = z50;
    const double w3 = y[8];
    const double z51 = a * w3;
    kept[43] = z51;
    const double z52 = R_3 * z50 - R_1 * z51;
    const double z53 = z4 * z52;
    kept[44] = z53;
    const double z54 = z4 * z4;
    kept[45] = z54;
    const double w2 = y[7];
    const double z55 = a * w2;
    kept[46] = z55;
    const double z56 = R_3 * z55;
    const double z57 = R_3 * z51;
    kept[47] = z57;
    const double z58 = R_2 * z50;
    const double z59 = z58 - R_1 * z55;
    kept[48] = z59;
    const double z60 = z54 * (R_3 * z56 - R_2 * z57 - R_1 * z59 - R_0 * z52);
    kept[49] = z60;
    const double z61 = z7 * z51 + z5 * z55;
    kept[50] = z61;
    const double z62 = z11 * z55;
    kept[51] = z62;
    const double z63 = z56 - R_2 * z51;
    kept[52] = z63;
    const double z64 = R_2 * z55;
    kept[53] = z64;
    const double z65 = z54 * (R_3 * z52 + R_2 * z58 - R_1 * z64 + R_0 * z63);
    kept[54] = z65;
    const double z66 = z10 * z50;
    kept[55] = z66;
    const double z67 = 0.5 * w1;
    kept[56] = z67;
    const double z68 = 0.5 * w2;
    kept[57] = z68;
    const double z69 = 0.5 * w3;
    kept[58] = z69;
    const double z70 = 0.5 * R_1;
    kept[59] = z70;
    const double z71 = 0.5 * R_2;
    kept[60] = z71;
    const double z72 = 0.5 * R_3;
    kept[61] = z72;
    const double z73 = 0.5 * R_0;
    kept[62] = z73;
    const double z74 = 1.0 / z49;
    kept[63] = z74;
    const double z75 = w1 * k4;
    kept[64] = z75;
    const double z76 = w2 * k2;
    kept[65] = z76;
    const double z77 = w3 * z76;
    const double z78 = w1 * k3;
    kept[66] = z78;
    const double z79 = w3 * z78 + z29 * z77;
    const double z80 = z74 * (w2 * z75 + z40 * z77 - z48 * z79);
    kept[67] = z80;
    const double z81 = z16 * z80;
    kept[68] = z81;
    const double z82 = z47 * z79 - z48 * z80;
    kept[69] = z82;
    const double z83 = z16 * z82;
    kept[70] = z83;
    const double z84 = z4 * z83;
    kept[71] = z84;
    const double z85 = R_3 * z2;
    const double z86 = R_0 * z81;
    kept[72] = z86;
    const double z87 = R_1 * z83;
    kept[73] = z87;
    const double z88 = z86 - z87;
    kept[74] = z88;
    const double z89 = z4 * z88;
    kept[75] = z89;
    const double z90 = R_3 * z89;
    kept[76] = z90;
    const double z91 = z28 * z77 + z29 * z82 + z40 * z80;
    kept[77] = z91;
    const double z92 = k1 * z91;
    const double z93 = z9 * z92;
    kept[78] = z93;
    const double z94 = R_3 * z93;
    const double z95 = z36 * z81;
    kept[79] = z95;
    const double z96 = R_2 * z87;
    kept[80] = z96;
    const double z97 = 4.0 * (z1 * z95 + z86 * (R_2 * z17) + z25 * z83 + z21 * z88) - z18 * z96;
    const double z98 = R_x1 * z92;
    kept[81] = z98;
    const double z99 = z97 + k1 * (z38 * z80 + z26 * z82) + 4.0 * (z1 * z98) + 4.0 * (z2 * z98);
    const double z100 = R_2 * z93;
    kept[82] = z100;
    const double z101 = z54 * (z99 - 8.0 * (R_1 * z100) - 8.0 * (R_0 * z94));
    kept[83] = z101;
    const double z102 = z35 * z81 + 4.0 * (z84 * z85) + 4.0 * (R_1 * z90) - 8.0 * (z4 * z94) - 2.0 * (R_0 *
        z101);
    kept[84] = z102;
    const double z103 = z4 * z86;
    kept[85] = z103;
    const double z104 = R_3 * z103;
    kept[86] = z104;
    const double z105 = z16 * z91;
    kept[87] = z105;
    const double z106 = z4 * z105;
    kept[88] = z106;
    const double z107 = R_1 * z105;
    kept[89] = z107;
    const double z108 = z4 * z107;
    kept[90] = z108;
    const double z109 = k1 * z82;
    const double z110 = z14 * z109;
    kept[91] = z110;
    const double z111 = R_3 * z110;
    const double z112 = z43 * z81 + 4.0 * (R_2 * z104) - 4.0 * (z85 * z106) + 4.0 * (z36 * z108) - 8.0 * (z4
        * z111);
    kept[92] = z112;
    const double z113 = z44 * z81;
    kept[93] = z113;
    const double z114 = R_1 * z86;
    kept[94] = z114;
    const double z115 = R_2 * z107;
    kept[95] = z115;
    const double z116 = 4.0 * (z42 * z86 + z1 * z113 - z17 * z114 - z25 * z105 + z21 * z107) + z18 * z115;
    const double z117 = R_y2 * z109;
    kept[96] = z117;
    const double z118 = 8.0 * (R_2 * z110) - 4.0 * (R_1 * z117);
    kept[97] = z118;
    const double z119 = z116 + k1 * (z45 * z80 - z26 * z91) - 4.0 * (z1 * z117) + R_1 * z118 - 8.0 * (R_0 *
        z111);
    kept[98] = z119;
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW static int chaplygin_ball_quaternion_jacobian_part2(double t, const double *y,
    const double *p, double *kept, double *J)
{
    (void)t;
    const double z54 = kept[45];
    const double z119 = kept[98];
    const double z120 = z54 * z119;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z29 = kept[23];
    const double z102 = kept[84];
    const double z112 = kept[92];
    const double z121 = z112 - 2.0 * (R_0 * z120) - z29 * z102;
    const double z83 = kept[70];
    const double z122 = R_0 * z83;
    const double z4 = kept[5];
    const double z123 = z4 * z122;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z124 = R_3 * z123;
    const double z105 = kept[87];
    const double z125 = R_0 * z105;
    const double z126 = z4 * z125;
    const double z127 = R_3 * z126;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z128 = 4.0 * (R_1 * z127);
    const double k1 = kept[0];
    const double z80 = kept[67];
    const double z129 = k1 * z80;
    const double z32 = kept[26];
    const double z130 = z32 * z129;
    const double z31 = kept[25];
    const double z131 = z31 * z129;
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z132 = R_2 * z130 - R_1 * z131;
    const double z36 = kept[30];
    const double z44 = kept[37];
    const double z133 = z44 * z83 - z36 * z105;
    const double z134 = R_1 * z122 + R_2 * z125;
    const double z1 = kept[4];
    const double z17 = kept[16];
    const double z21 = kept[19];
    const double z38 = kept[32];
    const double z42 = kept[35];
    const double z45 = kept[38];
    const double z82 = kept[69];
    const double z91 = kept[77];
    const double z135 = 4.0 * (z42 * z122 + z1 * z133 - z17 * z134 - z21 * z125) + k1 * (z45 * z82 - z38 *
        z91);
    const double z136 = R_1 * z130;
    const double z137 = R_3 * z131;
    const double z138 = z54 * (z135 + 8.0 * (R_3 * z136) + 8.0 * (R_2 * z137) + 8.0 * (R_0 * z132));
    const double z35 = kept[29];
    const double z43 = kept[36];
    const double z139 = z43 * z83 + 4.0 * (R_2 * z124) - z35 * z105 - z128 + 8.0 * (z4 * z132) - 2.0 * (R_0 *
        z138);
    const double z40 = kept[33];
    const double z48 = kept[40];
    const double z74 = kept[63];
    const double z140 = z74 * (z139 - z40 * z102 - z48 * z121);
    const double z47 = kept[39];
    const double z141 = z47 * z121 - z48 * z140;
    const double z37 = kept[31];
    const double z81 = kept[68];
    const double z142 = z37 * z81;
    const double z143 = R_3 * z142;
    const double z10 = kept[9];
    const double z88 = kept[74];
    const double z144 = z10 * z88;
    const double z23 = kept[20];
    const double z90 = kept[76];
    const double z100 = kept[82];
    const double z101 = kept[83];
    const double z145 = z143 - z23 * z83 - 4.0 * (R_0 * z90) + 8.0 * (z4 * z100) + 2.0 * (R_1 * (z101 - 4.0 *
        z144));
    const double z34 = kept[28];
    const double z86 = kept[72];
    const double z146 = z34 * z86;
    const double z114 = kept[94];
    const double z115 = kept[95];
    const double z147 = z4 * (z114 - z115);
    const double z5 = kept[6];
    const double z117 = kept[96];
    const double z118 = kept[97];
    const double z148 = z128 + (z146 - z23 * z105) - 4.0 * (z5 * z117) + z4 * z118 - 2.0 * (R_1 * (z120 + 4.0
        * z147));
    const double z149 = z148 + z29 * z145;
    const double z150 = z37 * z105;
    const double z7 = kept[7];
    const double z11 = kept[10];
    const double z151 = z34 * z122 + R_3 * z150 - 4.0 * (R_0 * z127) + 8.0 * (z11 * z130) - 8.0 * (z7 * z131);
    const double z152 = z138 + 4.0 * (z4 * z134);
    const double z153 = z74 * (z151 - 2.0 * (R_1 * z152) + z40 * z145 - z48 * z149);
    const double z154 = z47 * z149 - z48 * z153;
    const double z98 = kept[81];
    const double z155 = 4.0 * (z10 * z98);
    const double z19 = kept[17];
    const double z87 = kept[73];
    const double z93 = kept[78];
    const double z156 = z155 - (z146 - z19 * z87 + 8.0 * (z5 * z93) - z155) - 2.0 * (R_2 * (z101 - 4.0 *
        (z124 + z144)));
    const double z104 = kept[86];
    const double z107 = kept[89];
    const double z110 = kept[91];
    const double z157 = z143 - 4.0 * (R_0 * z104) + z19 * z107 - 8.0 * (z5 * z110) + 2.0 * (R_2 * (z120 + 4.0
        * (z127 + z147)));
    const double z158 = z157 + z29 * z156;
    const double z159 = z37 * z83;
    const double z160 = R_3 * z159 - 4.0 * (R_0 * z124) - z34 * z125 - 8.0 * (z7 * z130) - 8.0 * (z4 * z137);
    const double z161 = z74 * (z160 + 2.0 * (R_2 * z152) + z40 * z156 - z48 * z158);
    const double z162 = z47 * z158 - z48 * z161;
    const double z163 = 4.0 * (z11 * z98);
    const double z20 = kept[18];
    const double z24 = kept[21];
    const double z84 = kept[71];
    const double z89 = kept[75];
    const double z164 = R_1 * z142 - 4.0 * (z24 * z84) - 4.0 * (z20 * z89) + 8.0 * (z7 * z93) - z163;
    const double z95 = kept[79];
    const double z96 = kept[80];
    const double z165 = z163 - z164 - 2.0 * (R_3 * (z101 - (4.0 * (z4 * z95) - 8.0 * (z4 * z96))));
    const double z166 = 4.0 * (z11 * z117);
    const double z41 = kept[34];
    const double z103 = kept[85];
    const double z106 = kept[88];
    const double z108 = kept[90];
    const double z167 = R_2 * z142 - 4.0 * (z41 * z103) + 4.0 * (z24 * z106) - 4.0 * (z20 * z108) + 8.0 * (z7
        * z110);
    const double z113 = kept[93];
    const double z168 = z166 + (z167 + z166) + 2.0 * (R_3 * (z120 - (4.0 * (z4 * z113) + 8.0 * (z4 * z115))));
    const double z169 = z168 + z29 * z165;
    const double z170 = R_2 * z159 - 4.0 * (z41 * z123) - R_1 * z150 + 4.0 * (z20 * z126) - 8.0 * (z10 *
        z131);
    const double z171 = z170 - 8.0 * (z4 * z136) + 2.0 * (R_3 * (z138 - 4.0 * (z4 * z133))) + z40 * z165;
    const double z172 = z74 * (z171 - z48 * z169);
    const double z173 = z47 * z169 - z48 * z172;
    const double w3 = y[8];
    const double k3 = kept[2];
    const double z174 = w3 * k3;
    const double w2 = y[7];
    const double k4 = kept[3];
    const double z175 = z74 * (w2 * k4 - z48 * z174);
    const double z176 = z47 * z174 - z48 * z175;
    const double k2 = kept[1];
    const double z177 = w3 * k2;
    const double z178 = z29 * z177;
    const double z75 = kept[64];
    const double z179 = z74 * (z75 + z40 * z177 - z48 * z178);
    const double z180 = z47 * z178 - z48 * z179;
    const double z76 = kept[65];
    const double z78 = kept[66];
    const double z181 = z78 + z29 * z76;
    const double z182 = z74 * (z40 * z76 - z48 * z181);
    const double z183 = z47 * z181 - z48 * z182;
    const double z53 = kept[44];
    const double z60 = kept[49];
    /* (I.2.15) */
    J[2] = 2.0 * z53 + 4.0 * (R_0 * z60);
    const double z59 = kept[48];
    const double z61 = kept[50];
    J[3] = 4.0 * (R_1 * z60) - 2.0 * (z61 - z4 * z59);
    const double z50 = kept[42];
    const double z57 = kept[47];
    J[4] = 2.0 * (z5 * z50 + z4 * z57) + 4.0 * (R_2 * z60);
    const double z51 = kept[43];
    const double z62 = kept[51];
    J[5] = 4.0 * (R_3 * z60) - 2.0 * (z62 - (z7 * z50 + z10 * z51 - z62));
    const double a = p[1]; /* radius [m] */
    const double z9 = kept[8];
    J[6] = 2.0 * (a * z9);
    const double R_y2 = kept[13];
    J[7] = a * R_y2;
    J[8] = 2.0 * (a * z31);
    const double z63 = kept[52];
    const double z65 = kept[54];
    J[11] = 2.0 * (z4 * z63) - 4.0 * (R_0 * z65);
    const double z64 = kept[53];
    J[12] = -(4.0 * (R_1 * z65) + 2.0 * (z4 * (z57 + z64)));
    const double z66 = kept[55];
    J[13] = 2.0 * (z66 - (z61 - z66)) - 4.0 * (R_2 * z65);
    const double z55 = kept[46];
    J[14] = 2.0 * (z53 + (z7 * z55 + z11 * z50)) - 4.0 * (R_3 * z65);
    const double R_x1 = kept[11];
    J[15] = -a * R_x1;
    const double z14 = kept[14];
    J[16] = -2.0 * (a * z14);
    J[17] = -2.0 * (a * z32);
    const double z67 = kept[56];
    J[21] = -z67;
    const double z68 = kept[57];
    J[22] = -z68;
    const double z69 = kept[58];
    J[23] = -z69;
    const double z70 = kept[59];
    J[24] = -z70;
    const double z71 = kept[60];
    J[25] = -z71;
    const double z72 = kept[61];
    J[26] = -z72;
    J[29] = z67;
    J[31] = z69;
    J[32] = -z68;
    const double z73 = kept[62];
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
    const double z28 = kept[22];
    J[56] = z28 * z102 - z29 * z141 - z40 * z140;
    J[57] = -(z28 * z145 + z29 * z154 + z40 * z153);
    J[58] = z28 * z156 + z29 * z162 + z40 * z161;
    J[59] = z28 * z165 + z29 * z173 + z40 * z172;
    J[60] = z29 * z176 + z40 * z175;
    J[61] = z28 * z177 + z29 * z180 + z40 * z179;
    J[62] = z28 * z76 + z29 * z183 + z40 * z182;
    J[65] = z141;
    J[66] = z154;
    J[67] = -z162;
    J[68] = -z173;
    J[69] = -z176;
    J[70] = -z180;
    J[71] = -z183;
    J[74] = -z140;
    J[75] = -z153;
    J[76] = z161;
    J[77] = z172;
    J[78] = z175;
    J[79] = z179;
    J[80] = z182;
    const double z13 = kept[12];
    /* the mass matrix is singular */
    if (!(fabs(z13) > 0.0)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    const double z15 = kept[15];
    const double z30 = kept[24];
    /* the mass matrix is singular */
    if (!(fabs(z30) > 1e-14 * z15)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    const double z33 = kept[27];
    const double z49 = kept[41];
    /* the mass matrix is singular */
    if (!(fabs(z49) > 1e-14 * z33)) {
        return CHAPLYGIN_BALL_QUATERNION_SINGULAR_2;
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW
int chaplygin_ball_quaternion_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[99]; /* what parts of this function leave for others */
    memset(J, 0, 81 * sizeof *J);
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
    const chaplygin_ball_quaternion_lanes z13 = I1 + k1 * (4.0 * (z9 * z9) + R_x1 * R_x1);
    const chaplygin_ball_quaternion_lanes R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    const chaplygin_ball_quaternion_lanes z14 = z6 - z8;
    const chaplygin_ball_quaternion_lanes z15 = I2 + k1 * (R_y2 * R_y2 + 4.0 * (z14 * z14));
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
    const chaplygin_ball_quaternion_lanes z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25));
    const chaplygin_ball_quaternion_lanes z27 = 2.0 - 4.0 * (z4 * z17);
    const chaplygin_ball_quaternion_lanes z28 = R_3 * (2.0 - 4.0 * z12);
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
    const chaplygin_ball_quaternion_lanes z35 = w2 * w3 * k2;
    const chaplygin_ball_quaternion_lanes z36 = w1 * w3 * k3 + z35 * z22;
    const chaplygin_ball_quaternion_lanes z37 = (w1 * w2 * k4 - z35 * z30 - z33 * z36) / z34;
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
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;
    const double fixed[] = {a, I1, I2, I3, k1, k2, k3, k4};
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
