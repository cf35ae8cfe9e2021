/*
 * chaplygin_ball_quaternion.c: chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:7120d771e24d211c)
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
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int chaplygin_ball_quaternion_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
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

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int chaplygin_ball_quaternion_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CHAPLYGIN_BALL_QUATERNION_NOT_FINITE;
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
static int chaplygin_ball_quaternion_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CHAPLYGIN_BALL_QUATERNION_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CHAPLYGIN_BALL_QUATERNION_NY];
        double slope[CHAPLYGIN_BALL_QUATERNION_NY];
        for (size_t k = 0; k < CHAPLYGIN_BALL_QUATERNION_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
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

/* makes a NaN of each lane whose bits are set */
static inline chaplygin_ball_quaternion_lanes chaplygin_ball_quaternion_mark(chaplygin_ball_quaternion_lanes value, chaplygin_ball_quaternion_bits bad)
{
    return (chaplygin_ball_quaternion_lanes)((chaplygin_ball_quaternion_bits)value | bad);
}

static inline chaplygin_ball_quaternion_lanes chaplygin_ball_quaternion_size(chaplygin_ball_quaternion_lanes x)
{
    return (chaplygin_ball_quaternion_lanes)((chaplygin_ball_quaternion_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
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

/* the last states, fewer than there are lanes; the other lanes repeat the last one */
static inline void chaplygin_ball_quaternion_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CHAPLYGIN_BALL_QUATERNION_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CHAPLYGIN_BALL_QUATERNION_NY; ++k) {
            state[k * CHAPLYGIN_BALL_QUATERNION_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void chaplygin_ball_quaternion_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CHAPLYGIN_BALL_QUATERNION_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CHAPLYGIN_BALL_QUATERNION_LANES + l];
        }
    }
}
#endif

int chaplygin_ball_quaternion_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k1 = m * a * a;
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k2 = I2 - I3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* from the state */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z1 = R_2 * R_2;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z2 = R_1 * R_1 + z1;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z3 = R_3 * R_3;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z4 = 1.0 / (z2 + (R_0 * R_0 + z3));
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
    const double z16 = k1 * z4;
    const double z17 = R_1 * z11;
    const double z18 = R_0 * z17;
    const double z19 = z16 * (R_1 * (R_2 * (1.0 - (2.0 * z3 + z2) * z4) - z18) + z1 * z8);
    const double z20 = 1.0 / z13;
    const double z21 = z20 * z19;
    const double z22 = z15 - 16.0 * (z19 * z21);
    const double z23 = R_3 * z10;
    const double z24 = z23 - R_1 * z7;
    const double z25 = z17 + R_2 * z7;
    const double z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25));
    const double z27 = R_3 * (1.0 - 2.0 * z12);
    const double z28 = 1.0 - 2.0 * (z2 * z4);
    const double z29 = z16 * (R_1 * z27 + R_0 * (R_2 * z28 - 2.0 * z18));
    const double z30 = z20 * z29;
    const double z31 = 2.0 * (z16 * (R_2 * z27 - R_0 * (R_1 * z28 + 2.0 * (R_0 * z23)))) - 8.0 * (z19 * z30);
    const double z32 = 1.0 / z22;
    const double z33 = z31 * z32;
    const double z34 = z26 - 4.0 * (z29 * z30) - z31 * z33;
    const double w2 = y[7];
    const double w3 = y[8];
    const double z35 = w2 * w3 * k2;
    const double w1 = y[6];
    const double z36 = w1 * w3 * k3 + 4.0 * (z35 * z21);
    const double z37 = (w1 * w2 * k4 - 2.0 * (z35 * z30) + z33 * z36) / z34;
    const double z38 = z32 * z36 + z33 * z37;
    /* (I.2.4) */
    dydt[0] = a * (2.0 * (w3 * z24) + (w2 * R_y2 + 2.0 * (w1 * z9))); /* x' */
    dydt[1] = -a * (2.0 * (w3 * z25) + (2.0 * (w2 * z14) + w1 * R_x1)); /* y' */
    dydt[2] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    dydt[3] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    dydt[4] = (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5; /* R_2' */
    dydt[5] = 0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1)); /* R_3' */
    /* (I.2.15) 21:4 */
    dydt[6] = z35 * z20 + 4.0 * (z21 * z38) - 2.0 * (z30 * z37); /* w1' */
    dydt[7] = -z38; /* w2' */
    dydt[8] = z37; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[3] + dydt[4] + dydt[5] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(z22) > 1e-13 * z15
        && fabs(z34) > 1e-13 * z26)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return chaplygin_ball_quaternion_refuse(fabs(z13), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-13 * z15)) {
            return chaplygin_ball_quaternion_refuse(fabs(z22), 1e-13 * z15,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z34) > 1e-13 * z26)) {
            return chaplygin_ball_quaternion_refuse(fabs(z34), 1e-13 * z26,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        return chaplygin_ball_quaternion_finish(9, dydt);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

int chaplygin_ball_quaternion_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;

    /* from the state */
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_2 * z1;
    const double z3 = R_0 * z1;
    const double z4 = R_1 * z1;
    const double z5 = R_3 * z1;
    const double z6 = R_3 * z5;
    const double z7 = R_2 * z4;
    const double z8 = R_3 * z3;
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double omega_y = 2.0 * ((R_3 * z2 - R_1 * z3) * w3) + ((1.0 - 2.0 * (R_1 * z4 + z6)) * w2 + 2.0 *
        ((z7 + z8) * w1));
    const double omega_x = 2.0 * ((R_1 * z5 + R_2 * z3) * w3) + (2.0 * ((z7 - z8) * w2) + (1.0 - 2.0 * (R_2 *
        z2 + z6)) * w1);
    const double a = p[1]; /* radius [m] */
    /* (I.2.4) */
    qdot[0] = a * omega_y; /* x' */
    qdot[1] = -a * omega_x; /* y' */
    qdot[2] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    qdot[3] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    qdot[4] = (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5; /* R_2' */
    qdot[5] = 0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1)); /* R_3' */
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

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k1 = m * a * a;
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k2 = I2 - I3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* from the state */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z1 = R_2 * R_2;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z2 = R_1 * R_1 + z1;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z3 = R_3 * R_3;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z4 = 1.0 / (z2 + (R_0 * R_0 + z3));
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
    const double z16 = k1 * z4;
    const double z17 = R_1 * z8;
    const double z18 = z16 * (z1 * z8 + R_1 * (R_2 * (1.0 - (2.0 * z3 + z2) * z4) - z17));
    const double z19 = 1.0 / z13;
    const double z20 = z18 * z19;
    const double z21 = z15 - 16.0 * (z18 * z20);
    const double z22 = R_3 * z10 - R_1 * z7;
    const double z23 = R_1 * z11 + R_2 * z7;
    const double z24 = I3 + 4.0 * (k1 * (z22 * z22 + z23 * z23));
    const double z25 = R_3 * (1.0 - 2.0 * z12);
    const double z26 = 1.0 - 2.0 * (z2 * z4);
    const double z27 = z16 * (R_1 * z25 + R_0 * (R_2 * z26 - 2.0 * z17));
    const double z28 = z27 * z19;
    const double z29 = 2.0 * (z16 * (R_2 * z25 - R_0 * (R_1 * z26 + 2.0 * (R_2 * z8)))) - 8.0 * (z18 * z28);
    const double z30 = 1.0 / z21;
    const double z31 = z29 * z30;
    const double z32 = z24 - 4.0 * (z27 * z28) - z29 * z31;
    const double w2 = y[7];
    const double w3 = y[8];
    const double z33 = w2 * w3 * k2;
    const double w1 = y[6];
    const double z34 = w1 * w3 * k3 + 4.0 * (z33 * z20);
    const double z35 = (w1 * w2 * k4 - 2.0 * (z33 * z28) + z31 * z34) / z32;
    const double z36 = z30 * z34 + z31 * z35;
    const double z37 = z33 * z19 + 4.0 * (z20 * z36) - 2.0 * (z28 * z35);
    const double z38 = 2.0 * (w2 * (w1 * z22 - w3 * z9)) - R_y2 * z36 + 2.0 * (0.5 * (w1 * (w3 * R_y2 - 2.0 *
        (w2 * z22))) + z9 * z37);
    const double z39 = a * (2.0 * (0.5 * (w3 * (2.0 * (w2 * z9) - w1 * R_y2)) + z22 * z35) + z38);
    const double z40 = 2.0 * (0.5 * (w2 * (2.0 * (w1 * z23) - w3 * R_x1)) - z14 * z36) + (2.0 * (w1 * (w3 *
        z14 - w2 * z23)) + R_x1 * z37);
    const double z41 = a * (2.0 * (0.5 * (w3 * (w2 * R_x1 - 2.0 * (w1 * z14))) + z23 * z35) + z40);
    const double z42 = R_0 * w3 + (R_1 * w2 - R_2 * w1);
    const double z43 = R_2 * w3 + (R_0 * w1 - R_3 * w2);
    const double z44 = R_1 * w3 - (R_0 * w2 + R_3 * w1);
    const double z45 = 0.5 * (w3 * z42) + R_3 * z35 + (0.5 * (w1 * z43) + R_1 * z37 - (0.5 * (w2 * z44) + R_2
        * z36));
    const double z46 = R_3 * w3 + (R_1 * w1 + R_2 * w2);
    const double z47 = 0.5 * (w3 * z44) - R_2 * z35 + (0.5 * (w1 * z46) - R_0 * z37 + (0.5 * (w2 * z42) - R_3
        * z36));
    const double z48 = 0.5 * (w3 * z43) + R_1 * z35 + (0.5 * (w2 * z46) + R_0 * z36 - (0.5 * (w1 * z42) + R_3
        * z37));
    const double z49 = 0.5 * (w3 * z46) - R_0 * z35 - (0.5 * (w2 * z43) - R_1 * z36 + (0.5 * (w1 * z44) - R_2
        * z37));
    /* (I.2.15) */
    qddot[0] = z39; /* x'' */
    qddot[1] = -z41; /* y'' */
    qddot[2] = -0.5 * z45; /* R_0'' */
    qddot[3] = -0.5 * z47; /* R_1'' */
    qddot[4] = -0.5 * z48; /* R_2'' */
    qddot[5] = -0.5 * z49; /* R_3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(z21) > 1e-13 * z15
        && fabs(z32) > 1e-13 * z24)) {
        /* the mass matrix is singular */
        if (!(fabs(z13) > 0.0)) {
            return chaplygin_ball_quaternion_refuse(fabs(z13), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z21) > 1e-13 * z15)) {
            return chaplygin_ball_quaternion_refuse(fabs(z21), 1e-13 * z15,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z32) > 1e-13 * z24)) {
            return chaplygin_ball_quaternion_refuse(fabs(z32), 1e-13 * z24,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        return chaplygin_ball_quaternion_finish(6, qddot);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

int chaplygin_ball_quaternion_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the state */
    const double R_0 = q[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[3]; /* quaternion of R, along x [1] */
    const double R_2 = q[4]; /* quaternion of R, along y [1] */
    const double R_3 = q[5]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_0 * z1;
    const double z3 = R_1 * z1;
    const double z4 = R_3 * z1;
    const double z5 = R_2 * z1;
    const double x = q[0]; /* centre [m] */
    y[0] = x;
    const double y_2 = q[1]; /* centre [m] */
    y[1] = y_2;
    y[2] = R_0;
    y[3] = R_1;
    y[4] = R_2;
    y[5] = R_3;
    const double R_0_dot = qdot[2];
    const double R_1_dot = qdot[3];
    const double R_2_dot = qdot[4];
    const double R_3_dot = qdot[5];
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

    /* from the state */
    const double R_0 = q[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[3]; /* quaternion of R, along x [1] */
    const double R_2 = q[4]; /* quaternion of R, along y [1] */
    const double R_3 = q[5]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_0 * z1;
    const double z3 = R_1 * z1;
    const double z4 = R_3 * z1;
    const double z5 = R_2 * z1;
    const double R_0_dot = qdot[2];
    const double R_1_dot = qdot[3];
    const double R_2_dot = qdot[4];
    const double R_3_dot = qdot[5];
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
    const double x_dot = qdot[0];
    const double a = p[1]; /* radius [m] */
    /* (I.1.1) 23:5 */
    r[0] = x_dot - a * omega_y; /* roll_x = 0 */
    const double y_dot = qdot[1];
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

    /* from the state */
    const double R_0 = q[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[3]; /* quaternion of R, along x [1] */
    const double R_2 = q[4]; /* quaternion of R, along y [1] */
    const double R_3 = q[5]; /* quaternion of R, along z [1] */
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

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k1 = m * a * a;
    const double k2 = m * a;
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k3 = I2 - I3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k4 = I1 - I3;
    const double k5 = I1 - I2;

    /* from the state */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z1 = R_1 * R_1;
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z2 = R_2 * R_2;
    const double z3 = z1 + z2;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z4 = R_3 * R_3;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z5 = 1.0 / (z3 + (R_0 * R_0 + z4));
    const double z6 = R_0 * z5;
    const double z7 = R_3 * z6;
    const double z8 = R_1 * R_2;
    const double z9 = z5 * z8;
    const double z10 = z7 + z9;
    const double R_x1 = 1.0 - 2.0 * ((z2 + z4) * z5);
    const double z11 = I1 + (4.0 * (k1 * (z10 * z10)) + k1 * (R_x1 * R_x1));
    const double z12 = z7 - z9;
    const double R_y2 = 1.0 - 2.0 * ((z1 + z4) * z5);
    const double z13 = I2 + (4.0 * (k1 * (z12 * z12)) + k1 * (R_y2 * R_y2));
    const double z14 = k1 * z5;
    const double z15 = R_0 * R_1;
    const double z16 = R_3 * z5;
    const double z17 = z15 * z16;
    const double z18 = z14 * (R_1 * (R_2 * (1.0 - (2.0 * z4 + z3) * z5) - z17) + R_0 * z2 * z16);
    const double z19 = 1.0 / z11;
    const double z20 = z18 * z19;
    const double z21 = z13 - 16.0 * (z18 * z20);
    const double z22 = R_1 * z16 + R_2 * z6;
    const double z23 = R_1 * z6 - R_2 * z16;
    const double z24 = I3 + 4.0 * (k1 * (z22 * z22 + z23 * z23));
    const double z25 = 1.0 - 2.0 * (z3 * z5);
    const double z26 = R_1 * R_3;
    const double z27 = 1.0 - 2.0 * (R_3 * z16);
    const double z28 = z14 * (R_0 * (R_2 * z25 - 2.0 * z17) + z26 * z27);
    const double z29 = z28 * z19;
    const double z30 = R_0 * R_2;
    const double z31 = R_2 * R_3;
    const double z32 = 2.0 * (z14 * (R_0 * (R_1 * z25 + 2.0 * (z30 * z16)) - z31 * z27)) + 8.0 * (z18 * z29);
    const double z33 = 1.0 / z21;
    const double z34 = z32 * z33;
    const double z35 = z24 - 4.0 * (z28 * z29) - z32 * z34;
    const double z36 = k2 * z5;
    const double w2 = y[7];
    const double w3 = y[8];
    const double z37 = w2 * w3 * k3;
    const double w1 = y[6];
    const double z38 = w1 * w3 * k4 + 4.0 * (z37 * z20);
    const double z39 = (w1 * w2 * k5 - 2.0 * (z37 * z29) - z34 * z38) / z35;
    const double z40 = z36 * z39;
    const double z41 = z33 * z38 - z34 * z39;
    const double z42 = z37 * z19 + 4.0 * (z20 * z41) - 2.0 * (z29 * z39);
    const double z43 = R_0 * R_3;
    const double z44 = 2.0 * ((z15 - z31) * z40) - (2.0 * (z42 * ((z43 + z8) * z36)) - k2 * (R_y2 * z41));
    const double z45 = 2.0 * ((z26 + z30) * z40) + (k2 * (R_x1 * z42) + 2.0 * (z41 * ((z43 - z8) * z36)));
    /* (I.4.1) 23:5 */
    lambda[0] = -z44; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 24:5 */
    lambda[1] = -z45; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 10:3 */
    lambda[2] = 0.0; /* reaction of R_norm: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX && fabs(z21) > 1e-13 * z13 && fabs(z35) > 1e-13 * z24)) {
        /* the mass matrix is singular */
        if (!(fabs(z11) > 0.0)) {
            return chaplygin_ball_quaternion_refuse(fabs(z11), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z21) > 1e-13 * z13)) {
            return chaplygin_ball_quaternion_refuse(fabs(z21), 1e-13 * z13,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z35) > 1e-13 * z24)) {
            return chaplygin_ball_quaternion_refuse(fabs(z35), 1e-13 * z24,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        return chaplygin_ball_quaternion_finish(3, lambda);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

double chaplygin_ball_quaternion_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_2 * z1;
    const double z3 = R_0 * z1;
    const double z4 = R_1 * z1;
    const double z5 = R_3 * z1;
    const double z6 = R_3 * z5;
    const double z7 = R_2 * z4;
    const double z8 = R_3 * z3;
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double omega_y = 2.0 * ((R_3 * z2 - R_1 * z3) * w3) + ((1.0 - 2.0 * (R_1 * z4 + z6)) * w2 + 2.0 *
        ((z7 + z8) * w1));
    const double a = p[1]; /* radius [m] */
    const double z9 = a * omega_y;
    const double omega_x = 2.0 * ((R_1 * z5 + R_2 * z3) * w3) + (2.0 * ((z7 - z8) * w2) + (1.0 - 2.0 * (R_2 *
        z2 + z6)) * w1);
    const double z10 = a * omega_x;
    const double m = p[0]; /* mass [kg] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double z11 = m * (z9 * z9 + z10 * z10) + (I1 * (w1 * w1) + I2 * (w2 * w2) + I3 * (w3 * w3));
    return 0.5 * z11;
}

CHAPLYGIN_BALL_QUATERNION_SLOW static int chaplygin_ball_quaternion_jacobian_part1(double t, const double *y,
    const double *p, double *kept, double *J)
{
    (void)J;
    (void)t;

    /* from the parameters alone */
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

    /* from the state */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z1 = R_2 * R_2;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z2 = R_1 * R_1 + z1;
    kept[4] = z2;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z3 = R_3 * R_3;
    kept[5] = z3;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z4 = 1.0 / (z2 + (R_0 * R_0 + z3));
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
    const double z13 = I1 + (4.0 * (k1 * (z9 * z9)) + k1 * (R_x1 * R_x1));
    kept[13] = z13;
    const double R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12);
    kept[14] = R_y2;
    const double z14 = z6 - z8;
    kept[15] = z14;
    const double z15 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z14 * z14)));
    kept[16] = z15;
    const double z16 = k1 * z4;
    const double z17 = 2.0 * z3 + z2;
    const double z18 = 1.0 - z17 * z4;
    kept[17] = z18;
    const double z19 = R_0 * R_1;
    kept[18] = z19;
    const double z20 = R_3 * z19;
    kept[19] = z20;
    const double z21 = z20 * z4;
    const double z22 = R_2 * z18 - z21;
    kept[20] = z22;
    const double z23 = R_0 * z1;
    kept[21] = z23;
    const double z24 = R_3 * z23;
    const double z25 = R_1 * z22 + z24 * z4;
    const double z26 = z16 * z25;
    const double z27 = 1.0 / z13;
    kept[22] = z27;
    const double z28 = z27 * z26;
    kept[23] = z28;
    const double z29 = z15 - 16.0 * (z26 * z28);
    kept[24] = z29;
    const double z30 = R_3 * z10 - R_1 * z7;
    kept[25] = z30;
    const double z31 = R_1 * z11 + R_2 * z7;
    kept[26] = z31;
    const double z32 = I3 + 4.0 * (k1 * (z30 * z30 + z31 * z31));
    kept[27] = z32;
    const double z33 = R_1 * R_3;
    kept[28] = z33;
    const double z34 = 1.0 - 2.0 * z12;
    kept[29] = z34;
    const double z35 = 1.0 - 2.0 * (z2 * z4);
    kept[30] = z35;
    const double z36 = R_2 * z35 - 2.0 * z21;
    kept[31] = z36;
    const double z37 = z33 * z34 + R_0 * z36;
    kept[32] = z37;
    const double z38 = z16 * z37;
    const double z39 = z27 * z38;
    kept[33] = z39;
    const double z40 = R_2 * R_3;
    kept[34] = z40;
    const double z41 = R_0 * R_2;
    kept[35] = z41;
    const double z42 = R_3 * z41;
    kept[36] = z42;
    const double z43 = R_1 * z35 + 2.0 * (z42 * z4);
    kept[37] = z43;
    const double z44 = z40 * z34 - R_0 * z43;
    kept[38] = z44;
    const double z45 = 2.0 * (z16 * z44) - 8.0 * (z26 * z39);
    const double z46 = 1.0 / z29;
    kept[39] = z46;
    const double z47 = z45 * z46;
    kept[40] = z47;
    const double z48 = z32 - 4.0 * (z38 * z39) - z45 * z47;
    kept[41] = z48;
    const double w1 = y[6];
    const double z49 = a * w1;
    kept[42] = z49;
    const double w3 = y[8];
    const double z50 = a * w3;
    kept[43] = z50;
    const double z51 = R_3 * z49 - R_1 * z50;
    const double z52 = z4 * z51;
    kept[44] = z52;
    const double w2 = y[7];
    const double z53 = a * w2;
    kept[45] = z53;
    const double z54 = R_3 * z53;
    const double z55 = R_3 * z50;
    kept[46] = z55;
    const double z56 = R_2 * z49;
    const double z57 = z56 - R_1 * z53;
    kept[47] = z57;
    const double z58 = z4 * z4;
    kept[48] = z58;
    const double z59 = (R_3 * z54 - R_2 * z55 - R_1 * z57 - R_0 * z51) * z58;
    kept[49] = z59;
    const double z60 = z7 * z50 + z5 * z53;
    kept[50] = z60;
    const double z61 = z11 * z53;
    kept[51] = z61;
    const double z62 = z54 - R_2 * z50;
    kept[52] = z62;
    const double z63 = R_2 * z53;
    kept[53] = z63;
    const double z64 = (R_3 * z51 + R_2 * z56 - R_1 * z63 + R_0 * z62) * z58;
    kept[54] = z64;
    const double z65 = z10 * z49;
    kept[55] = z65;
    const double z66 = 0.5 * w1;
    kept[56] = z66;
    const double z67 = 0.5 * w2;
    kept[57] = z67;
    const double z68 = 0.5 * w3;
    kept[58] = z68;
    const double z69 = 0.5 * R_1;
    kept[59] = z69;
    const double z70 = 0.5 * R_2;
    kept[60] = z70;
    const double z71 = 0.5 * R_3;
    kept[61] = z71;
    const double z72 = 0.5 * R_0;
    kept[62] = z72;
    const double z73 = 1.0 / z48;
    kept[63] = z73;
    const double z74 = w1 * k4;
    kept[64] = z74;
    const double z75 = w2 * k2;
    kept[65] = z75;
    const double z76 = w3 * z75;
    const double z77 = w1 * k3;
    kept[66] = z77;
    const double z78 = w3 * z77 + 4.0 * (z76 * z28);
    const double z79 = z73 * (w2 * z74 - 2.0 * (z76 * z39) + z47 * z78);
    kept[67] = z79;
    const double z80 = z16 * z79;
    kept[68] = z80;
    const double z81 = z46 * z78 + z47 * z79;
    kept[69] = z81;
    const double z82 = z16 * z81;
    kept[70] = z82;
    const double z83 = z4 * z82;
    kept[71] = z83;
    const double z84 = R_3 * z1;
    const double z85 = R_0 * z80;
    kept[72] = z85;
    const double z86 = R_1 * z82;
    kept[73] = z86;
    const double z87 = z85 - z86;
    kept[74] = z87;
    const double z88 = z4 * z87;
    kept[75] = z88;
    const double z89 = R_3 * z88;
    kept[76] = z89;
    const double z90 = z27 * z76 + 4.0 * (z28 * z81) - 2.0 * (z39 * z79);
    kept[77] = z90;
    const double z91 = k1 * z90;
    const double z92 = z9 * z91;
    kept[78] = z92;
    const double z93 = R_3 * z92;
    const double z94 = 2.0 * (z36 * z80) - 4.0 * (z83 * z84) - 4.0 * (R_1 * z89) + 8.0 * (z4 * z93);
    const double z95 = z33 * z80;
    kept[79] = z95;
    const double z96 = R_2 * z86;
    kept[80] = z96;
    const double z97 = 4.0 * (z3 * z95 + z85 * (R_2 * z2) + z24 * z82 + z20 * z87 - z17 * z96);
    const double z98 = R_x1 * z91;
    kept[81] = z98;
    const double z99 = z97 - k1 * (2.0 * (z37 * z79) - 4.0 * (z25 * z81)) + 4.0 * (z3 * z98) + 4.0 * (z1 *
        z98);
    const double z100 = R_2 * z92;
    kept[82] = z100;
    const double z101 = z58 * (z99 - 8.0 * (R_1 * z100) - 8.0 * (R_0 * z93));
    kept[83] = z101;
    const double z102 = z94 + 2.0 * (R_0 * z101);
    kept[84] = z102;
    const double z103 = z4 * z85;
    kept[85] = z103;
    const double z104 = R_3 * z103;
    kept[86] = z104;
    const double z105 = z16 * z90;
    kept[87] = z105;
    const double z106 = z4 * z105;
    kept[88] = z106;
    const double z107 = R_1 * z105;
    kept[89] = z107;
    const double z108 = z4 * z107;
    kept[90] = z108;
    const double z109 = 2.0 * (z43 * z80) + 4.0 * (R_2 * z104) - 4.0 * (z84 * z106) + 4.0 * (z33 * z108);
    kept[91] = z109;
    const double z110 = k1 * z81;
    const double z111 = z14 * z110;
    kept[92] = z111;
    const double z112 = R_3 * z111;
    kept[93] = z112;
    const double z113 = z40 * z80;
    kept[94] = z113;
    const double z114 = R_1 * z85;
    kept[95] = z114;
    const double z115 = R_2 * z107;
    kept[96] = z115;
    const double z116 = z42 * z85 + z3 * z113 - z2 * z114 - z24 * z105 + z20 * z107 + z17 * z115;
    const double z117 = R_y2 * z110;
    kept[97] = z117;
    const double z118 = 4.0 * z116 - k1 * (2.0 * (z44 * z79) + 4.0 * (z25 * z90)) - 4.0 * (z3 * z117);
    kept[98] = z118;
    const double z119 = 8.0 * (R_2 * z111) - 4.0 * (R_1 * z117);
    kept[99] = z119;
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW static int chaplygin_ball_quaternion_jacobian_part2(double t, const double *y,
    const double *p, double *kept, double *J)
{
    (void)t;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z58 = kept[48];
    const double z112 = kept[93];
    const double z118 = kept[98];
    const double z119 = kept[99];
    const double z120 = z58 * (z118 + R_1 * z119 - 8.0 * (R_0 * z112));
    const double z4 = kept[6];
    const double z28 = kept[23];
    const double z102 = kept[84];
    const double z109 = kept[91];
    const double z121 = z109 - 8.0 * (z4 * z112) - 2.0 * (R_0 * z120) + 4.0 * (z28 * z102);
    const double z82 = kept[70];
    const double z122 = R_0 * z82;
    const double z123 = z4 * z122;
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z124 = R_3 * z123;
    const double z105 = kept[87];
    const double z125 = R_0 * z105;
    const double z126 = z4 * z125;
    const double z127 = R_3 * z126;
    const double z128 = 4.0 * (R_1 * z127);
    const double k1 = kept[0];
    const double z79 = kept[67];
    const double z129 = k1 * z79;
    const double z31 = kept[26];
    const double z130 = z31 * z129;
    const double z30 = kept[25];
    const double z131 = z30 * z129;
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z132 = R_2 * z130 - R_1 * z131;
    const double z36 = kept[31];
    const double z43 = kept[37];
    const double z133 = 2.0 * (z43 * z82) + 4.0 * (R_2 * z124) + 2.0 * (z36 * z105) - z128 + 8.0 * (z4 *
        z132);
    const double z33 = kept[28];
    const double z40 = kept[34];
    const double z134 = z40 * z82 - z33 * z105;
    const double z135 = R_1 * z122 + R_2 * z125;
    const double z2 = kept[4];
    const double z3 = kept[5];
    const double z20 = kept[19];
    const double z37 = kept[32];
    const double z42 = kept[36];
    const double z44 = kept[38];
    const double z81 = kept[69];
    const double z90 = kept[77];
    const double z136 = 4.0 * (z42 * z122 + z3 * z134 - z2 * z135 - z20 * z125) - 2.0 * (k1 * (z44 * z81 -
        z37 * z90));
    const double z137 = R_1 * z130;
    const double z138 = R_3 * z131;
    const double z139 = z58 * (z136 + 8.0 * (R_3 * z137) + 8.0 * (R_2 * z138) + 8.0 * (R_0 * z132));
    const double z39 = kept[33];
    const double z47 = kept[40];
    const double z73 = kept[63];
    const double z140 = z73 * (z133 - 2.0 * (R_0 * z139) - 2.0 * (z39 * z102) + z47 * z121);
    const double z46 = kept[39];
    const double z141 = z46 * z121 + z47 * z140;
    const double z34 = kept[29];
    const double z80 = kept[68];
    const double z142 = z34 * z80;
    const double z143 = 2.0 * (R_3 * z142);
    const double z10 = kept[10];
    const double z87 = kept[74];
    const double z144 = z10 * z87;
    const double z22 = kept[20];
    const double z89 = kept[76];
    const double z100 = kept[82];
    const double z101 = kept[83];
    const double z145 = z143 - 4.0 * (z22 * z82) - 4.0 * (R_0 * z89) + 8.0 * (z4 * z100) + 2.0 * (R_1 * (z101
        - 4.0 * z144));
    const double z35 = kept[30];
    const double z85 = kept[72];
    const double z146 = 2.0 * (z35 * z85);
    const double z114 = kept[95];
    const double z115 = kept[96];
    const double z147 = z4 * (z114 - z115);
    const double z5 = kept[7];
    const double z117 = kept[97];
    const double z148 = z128 + (z146 - 4.0 * (z22 * z105)) - 4.0 * (z5 * z117) + z4 * z119 - 2.0 * (R_1 *
        (z120 + 4.0 * z147));
    const double z149 = z148 + 4.0 * (z28 * z145);
    const double z150 = z34 * z105;
    const double z7 = kept[8];
    const double z11 = kept[11];
    const double z151 = 2.0 * (z35 * z122 + R_3 * z150) - 4.0 * (R_0 * z127) + 8.0 * (z11 * z130) - 8.0 * (z7
        * z131);
    const double z152 = z139 + 4.0 * (z4 * z135);
    const double z153 = z73 * (z151 - 2.0 * (R_1 * z152) - 2.0 * (z39 * z145) + z47 * z149);
    const double z154 = z46 * z149 + z47 * z153;
    const double z98 = kept[81];
    const double z155 = 4.0 * (z10 * z98);
    const double z18 = kept[17];
    const double z86 = kept[73];
    const double z92 = kept[78];
    const double z156 = z155 - (z146 - 4.0 * (z18 * z86) + 8.0 * (z5 * z92) - z155) - 2.0 * (R_2 * (z101 -
        4.0 * (z124 + z144)));
    const double z104 = kept[86];
    const double z107 = kept[89];
    const double z111 = kept[92];
    const double z157 = z143 - 4.0 * (R_0 * z104) + 4.0 * (z18 * z107) - 8.0 * (z5 * z111) + 2.0 * (R_2 *
        (z120 + 4.0 * (z127 + z147)));
    const double z158 = z157 + 4.0 * (z28 * z156);
    const double z159 = z34 * z82;
    const double z160 = 2.0 * (R_3 * z159) - 4.0 * (R_0 * z124) - 2.0 * (z35 * z125) - 8.0 * (z7 * z130);
    const double z161 = z160 - 8.0 * (z4 * z138) + 2.0 * (R_2 * z152) - 2.0 * (z39 * z156) + z47 * z158;
    const double z162 = z73 * z161;
    const double z163 = z46 * z158 + z47 * z162;
    const double z164 = 4.0 * (z11 * z98);
    const double z19 = kept[18];
    const double z23 = kept[21];
    const double z83 = kept[71];
    const double z88 = kept[75];
    const double z165 = 2.0 * (R_1 * z142) - 4.0 * (z23 * z83) - 4.0 * (z19 * z88) + 8.0 * (z7 * z92);
    const double z95 = kept[79];
    const double z96 = kept[80];
    const double z166 = z164 - (z165 - z164) - 2.0 * (R_3 * (z101 - (4.0 * (z4 * z95) - 8.0 * (z4 * z96))));
    const double z167 = 4.0 * (z11 * z117);
    const double z41 = kept[35];
    const double z103 = kept[85];
    const double z106 = kept[88];
    const double z108 = kept[90];
    const double z168 = 2.0 * (R_2 * z142) - 4.0 * (z41 * z103) + 4.0 * (z23 * z106) - 4.0 * (z19 * z108);
    const double z113 = kept[94];
    const double z169 = z167 + (z168 + 8.0 * (z7 * z111) + z167) + 2.0 * (R_3 * (z120 - (4.0 * (z4 * z113) +
        8.0 * (z4 * z115))));
    const double z170 = z169 + 4.0 * (z28 * z166);
    const double z171 = 2.0 * (R_2 * z159) - 4.0 * (z41 * z123) - 2.0 * (R_1 * z150) + 4.0 * (z19 * z126);
    const double z172 = z171 - 8.0 * (z10 * z131) - 8.0 * (z4 * z137) + 2.0 * (R_3 * (z139 - 4.0 * (z4 *
        z134)));
    const double z173 = z73 * (z172 - 2.0 * (z39 * z166) + z47 * z170);
    const double z174 = z46 * z170 + z47 * z173;
    const double w3 = y[8];
    const double k3 = kept[2];
    const double z175 = w3 * k3;
    const double w2 = y[7];
    const double k4 = kept[3];
    const double z176 = z73 * (w2 * k4 + z175 * z47);
    const double z177 = z175 * z46 + z47 * z176;
    const double k2 = kept[1];
    const double z178 = w3 * k2;
    const double z179 = z178 * z28;
    const double z74 = kept[64];
    const double z180 = z73 * (z74 - 2.0 * (z178 * z39) + 4.0 * (z47 * z179));
    const double z181 = 4.0 * (z46 * z179) + z47 * z180;
    const double z75 = kept[65];
    const double z77 = kept[66];
    const double z182 = z77 + 4.0 * (z75 * z28);
    const double z183 = z73 * (2.0 * (z75 * z39) - z47 * z182);
    const double z184 = z46 * z182 - z47 * z183;
    const double z52 = kept[44];
    const double z59 = kept[49];
    /* (I.2.15) */
    J[2] = 2.0 * z52 + 4.0 * (R_0 * z59);
    const double z57 = kept[47];
    const double z60 = kept[50];
    J[3] = 4.0 * (R_1 * z59) - 2.0 * (z60 - z4 * z57);
    const double z49 = kept[42];
    const double z55 = kept[46];
    J[4] = 2.0 * (z5 * z49 + z4 * z55) + 4.0 * (R_2 * z59);
    const double z50 = kept[43];
    const double z61 = kept[51];
    J[5] = 4.0 * (R_3 * z59) - 2.0 * (z61 - (z7 * z49 + z10 * z50 - z61));
    const double a = p[1]; /* radius [m] */
    const double z9 = kept[9];
    J[6] = 2.0 * (a * z9);
    const double R_y2 = kept[14];
    J[7] = a * R_y2;
    J[8] = 2.0 * (a * z30);
    const double z62 = kept[52];
    const double z64 = kept[54];
    J[11] = 2.0 * (z4 * z62) - 4.0 * (R_0 * z64);
    const double z63 = kept[53];
    J[12] = -(4.0 * (R_1 * z64) + 2.0 * (z4 * (z55 + z63)));
    const double z65 = kept[55];
    J[13] = 2.0 * (z65 - (z60 - z65)) - 4.0 * (R_2 * z64);
    const double z53 = kept[45];
    J[14] = 2.0 * (z52 + (z7 * z53 + z11 * z49)) - 4.0 * (R_3 * z64);
    const double R_x1 = kept[12];
    J[15] = -a * R_x1;
    const double z14 = kept[15];
    J[16] = -2.0 * (a * z14);
    J[17] = -2.0 * (a * z31);
    const double z66 = kept[56];
    J[21] = -z66;
    const double z67 = kept[57];
    J[22] = -z67;
    const double z68 = kept[58];
    J[23] = -z68;
    const double z69 = kept[59];
    J[24] = -z69;
    const double z70 = kept[60];
    J[25] = -z70;
    const double z71 = kept[61];
    J[26] = -z71;
    J[29] = z66;
    J[31] = z68;
    J[32] = -z67;
    const double z72 = kept[62];
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
    const double z27 = kept[22];
    J[56] = 2.0 * (z39 * z140) - (z27 * z102 + 4.0 * (z28 * z141));
    J[57] = 2.0 * (z39 * z153) - (z27 * z145 + 4.0 * (z28 * z154));
    J[58] = z27 * z156 + 4.0 * (z28 * z163) - 2.0 * (z39 * z162);
    J[59] = z27 * z166 + 4.0 * (z28 * z174) - 2.0 * (z39 * z173);
    J[60] = 4.0 * (z28 * z177) - 2.0 * (z39 * z176);
    J[61] = z27 * z178 + 4.0 * (z28 * z181) - 2.0 * (z39 * z180);
    J[62] = z27 * z75 + 4.0 * (z28 * z184) + 2.0 * (z39 * z183);
    J[65] = z141;
    J[66] = z154;
    J[67] = -z163;
    J[68] = -z174;
    J[69] = -z177;
    J[70] = -z181;
    J[71] = -z184;
    J[74] = -z140;
    J[75] = -z153;
    J[76] = z162;
    J[77] = z173;
    J[78] = z176;
    J[79] = z180;
    J[80] = -z183;
    const double z13 = kept[13];
    /* the mass matrix is singular */
    if (!(fabs(z13) > 0.0)) {
        return chaplygin_ball_quaternion_refuse(fabs(z13), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
    }
    const double z15 = kept[16];
    const double z29 = kept[24];
    /* the mass matrix is singular */
    if (!(fabs(z29) > 1e-13 * z15)) {
        return chaplygin_ball_quaternion_refuse(fabs(z29), 1e-13 * z15, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
    }
    const double z32 = kept[27];
    const double z48 = kept[41];
    /* the mass matrix is singular */
    if (!(fabs(z48) > 1e-13 * z32)) {
        return chaplygin_ball_quaternion_refuse(fabs(z48), 1e-13 * z32, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
}

CHAPLYGIN_BALL_QUATERNION_SLOW
int chaplygin_ball_quaternion_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[100]; /* what parts of this function leave for others */
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

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k1 = m * a * a;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k2 = I1 + k1;
    const double I2 = p[3]; /* [kg*m^2] */
    const double k3 = I2 + k1;

    /* from the state */
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double w1 = y[6];
    const double z2 = I1 * w1;
    const double w3 = y[8];
    const double I3 = p[4]; /* [kg*m^2] */
    const double z3 = I3 * w3;
    const double w2 = y[7];
    const double z4 = I2 * w2;
    const double z5 = k1 * (R_2 * w1 - (R_0 * w3 + R_1 * w2)) + (R_2 * z2 - (R_0 * z3 + R_1 * z4));
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
    const chaplygin_ball_quaternion_lanes z1 = R_2 * R_2;
    const chaplygin_ball_quaternion_lanes z2 = R_1 * R_1 + z1;
    const chaplygin_ball_quaternion_lanes z3 = R_3 * R_3;
    const chaplygin_ball_quaternion_lanes z4 = 1.0 / (z2 + (R_0 * R_0 + z3));
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
    const chaplygin_ball_quaternion_lanes z16 = k1 * z4;
    const chaplygin_ball_quaternion_lanes z17 = R_1 * z11;
    const chaplygin_ball_quaternion_lanes z18 = R_0 * z17;
    const chaplygin_ball_quaternion_lanes z19 = z16 * (R_1 * (R_2 * (1.0 - (2.0 * z3 + z2) * z4) - z18) + z1
        * z8);
    const chaplygin_ball_quaternion_lanes z20 = 1.0 / z13;
    const chaplygin_ball_quaternion_lanes z21 = z20 * z19;
    const chaplygin_ball_quaternion_lanes z22 = z15 - 16.0 * (z19 * z21);
    /* the mass matrix is singular */
    bad |=
        chaplygin_ball_quaternion_misses(chaplygin_ball_quaternion_size(CHAPLYGIN_BALL_QUATERNION_SPREAD(z22)),
        1e-13 * z15);
    const chaplygin_ball_quaternion_lanes z23 = R_3 * z10;
    const chaplygin_ball_quaternion_lanes z24 = z23 - R_1 * z7;
    const chaplygin_ball_quaternion_lanes z25 = z17 + R_2 * z7;
    const chaplygin_ball_quaternion_lanes z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25));
    const chaplygin_ball_quaternion_lanes z27 = R_3 * (1.0 - 2.0 * z12);
    const chaplygin_ball_quaternion_lanes z28 = 1.0 - 2.0 * (z2 * z4);
    const chaplygin_ball_quaternion_lanes z29 = z16 * (R_1 * z27 + R_0 * (R_2 * z28 - 2.0 * z18));
    const chaplygin_ball_quaternion_lanes z30 = z20 * z29;
    const chaplygin_ball_quaternion_lanes z31 = 2.0 * (z16 * (R_2 * z27 - R_0 * (R_1 * z28 + 2.0 * (R_0 *
        z23)))) - 8.0 * (z19 * z30);
    const chaplygin_ball_quaternion_lanes z32 = 1.0 / z22;
    const chaplygin_ball_quaternion_lanes z33 = z31 * z32;
    const chaplygin_ball_quaternion_lanes z34 = z26 - 4.0 * (z29 * z30) - z31 * z33;
    /* the mass matrix is singular */
    bad |=
        chaplygin_ball_quaternion_misses(chaplygin_ball_quaternion_size(CHAPLYGIN_BALL_QUATERNION_SPREAD(z34)),
        1e-13 * z26);
    const chaplygin_ball_quaternion_lanes z35 = w2 * w3 * k2;
    const chaplygin_ball_quaternion_lanes z36 = w1 * w3 * k3 + 4.0 * (z35 * z21);
    const chaplygin_ball_quaternion_lanes z37 = (w1 * w2 * k4 - 2.0 * (z35 * z30) + z33 * z36) / z34;
    const chaplygin_ball_quaternion_lanes z38 = z32 * z36 + z33 * z37;
    /* (I.2.4) */
    const chaplygin_ball_quaternion_lanes slope1 = a * (2.0 * (w3 * z24) + (w2 * R_y2 + 2.0 * (w1 * z9)));
    sum += slope1;
    chaplygin_ball_quaternion_put(dydt, slope1);
    const chaplygin_ball_quaternion_lanes slope2 = -a * (2.0 * (w3 * z25) + (2.0 * (w2 * z14) + w1 * R_x1));
    sum += slope2;
    chaplygin_ball_quaternion_put(dydt + 1 * stride, slope2);
    const chaplygin_ball_quaternion_lanes slope3 = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2));
    sum += slope3;
    chaplygin_ball_quaternion_put(dydt + 2 * stride, slope3);
    const chaplygin_ball_quaternion_lanes slope4 = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2));
    sum += slope4;
    chaplygin_ball_quaternion_put(dydt + 3 * stride, slope4);
    const chaplygin_ball_quaternion_lanes slope5 = (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5;
    sum += slope5;
    chaplygin_ball_quaternion_put(dydt + 4 * stride, slope5);
    const chaplygin_ball_quaternion_lanes slope6 = 0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1));
    sum += slope6;
    chaplygin_ball_quaternion_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 21:4 */
    const chaplygin_ball_quaternion_lanes slope7 = z35 * z20 + 4.0 * (z21 * z38) - 2.0 * (z30 * z37);
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
