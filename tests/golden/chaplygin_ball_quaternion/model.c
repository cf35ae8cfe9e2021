/*
 * chaplygin_ball_quaternion.c: chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:259b6a4b65f2e8ac)
 * A ball with three different moments of inertia rolls on a horizontal plane; its orientation is a
 *     quaternion.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: angular velocities and quasi-velocities of the spec
 * chaplygin_ball_quaternion.h says what each function does.
 */
#include "chaplygin_ball_quaternion.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const chaplygin_ball_quaternion_coordinate_names[CHAPLYGIN_BALL_QUATERNION_NQ] = {
    "x",
    "y",
    "R_0",
    "R_1",
    "R_2",
    "R_3"
};
const char *const chaplygin_ball_quaternion_state_names[CHAPLYGIN_BALL_QUATERNION_NY] = {
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
const char *const chaplygin_ball_quaternion_parameter_names[CHAPLYGIN_BALL_QUATERNION_NP] = {
    "m",
    "a",
    "I1",
    "I2",
    "I3"
};
const char *const chaplygin_ball_quaternion_constraint_names[CHAPLYGIN_BALL_QUATERNION_NC] = {
    "roll_x",
    "roll_y",
    "R_norm"
};
const char *const chaplygin_ball_quaternion_output_names[CHAPLYGIN_BALL_QUATERNION_NOUT] = {
    "K_x",
    "K_y",
    "K_z"
};
const double chaplygin_ball_quaternion_parameter_defaults[CHAPLYGIN_BALL_QUATERNION_NP] = {
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
    const double k1 = a * (m * a);
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k2 = I2 - I3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* from the state */
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = 2.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_1 * z1;
    const double z3 = R_1 * z2;
    const double z4 = R_2 * z1;
    const double z5 = R_2 * z4;
    const double R_z3 = 1.0 - (z3 + z5);
    const double z6 = k1 * R_z3 * R_z3;
    const double z7 = R_3 * z4;
    const double z8 = R_0 * z1;
    const double z9 = R_1 * z8;
    const double R_z2 = z7 + z9;
    const double z10 = R_z2 * R_z2;
    const double z11 = I1 + z6 + k1 * z10;
    const double z12 = R_3 * z1;
    const double z13 = R_1 * z12;
    const double z14 = R_2 * z8;
    const double R_z1 = z13 - z14;
    const double z15 = R_z1 * R_z1;
    const double z16 = I2 + z6 + k1 * z15;
    const double z17 = R_z2 * k1;
    const double z18 = R_z1 * z17;
    const double z19 = 1.0 / z11;
    const double z20 = z19 * z18;
    const double z21 = z16 - z18 * z20;
    const double z22 = I3 + k1 * (z10 + z15);
    const double z23 = k1 * (R_z1 * R_z3);
    const double z24 = z23 * z19;
    const double z25 = R_z3 * z17 + z24 * z18;
    const double z26 = 1.0 / z21;
    const double z27 = z25 * z26;
    const double z28 = z22 - z23 * z24 - z25 * z27;
    const double z29 = R_3 * z12;
    const double z30 = R_2 * z2;
    const double z31 = R_3 * z8;
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double z32 = w2 * w3 * k2;
    const double w1 = y[6]; /* [rad/s] */
    const double z33 = w1 * w3 * k3 - z32 * z20;
    const double z34 = (w1 * w2 * k4 + z32 * z24 - z27 * z33) / z28;
    const double z35 = z26 * z33 - z27 * z34;
    /* (I.2.4) */
    dydt[0] = a * ((z7 - z9) * w3 + ((1.0 - (z3 + z29)) * w2 + (z30 + z31) * w1)); /* x' */
    dydt[1] = -a * ((z13 + z14) * w3 + ((z30 - z31) * w2 + (1.0 - (z5 + z29)) * w1)); /* y' */
    dydt[2] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    dydt[3] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    dydt[4] = (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5; /* R_2' */
    dydt[5] = 0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1)); /* R_3' */
    /* (I.2.15) 21:4 */
    dydt[6] = z32 * z19 - z20 * z35 + z24 * z34; /* w1' */
    dydt[7] = -z35; /* w2' */
    dydt[8] = z34; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[3] + dydt[4] + dydt[5] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(z21) > 1e-13 * z16
        && fabs(z28) > 1e-13 * z22)) {
        /* the mass matrix is singular, if z11 is 0 */
        if (!(fabs(z11) > 0.0)) {
            return chaplygin_ball_quaternion_refuse(fabs(z11), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z21 is nearly 0 */
        if (!(fabs(z21) > 1e-13 * z16)) {
            return chaplygin_ball_quaternion_refuse(fabs(z21), 1e-13 * z16,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z28 is nearly 0 */
        if (!(fabs(z28) > 1e-13 * z22)) {
            return chaplygin_ball_quaternion_refuse(fabs(z28), 1e-13 * z22,
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
    const double w1 = y[6]; /* [rad/s] */
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
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
    const double k1 = a * (m * a);
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k2 = I2 - I3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* from the state */
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_1 * z1;
    const double z3 = R_1 * z2;
    const double z4 = R_2 * z1;
    const double z5 = R_2 * z4;
    const double R_z3 = 1.0 - 2.0 * (z3 + z5);
    const double z6 = k1 * R_z3 * R_z3;
    const double z7 = R_3 * z4;
    const double z8 = R_0 * z1;
    const double z9 = R_1 * z8;
    const double z10 = z7 + z9;
    const double z11 = z10 * z10;
    const double z12 = I1 + z6 + 4.0 * (k1 * z11);
    const double z13 = R_3 * z1;
    const double z14 = R_1 * z13;
    const double z15 = R_2 * z8;
    const double z16 = z14 - z15;
    const double z17 = z16 * z16;
    const double z18 = I2 + z6 + 4.0 * (k1 * z17);
    const double z19 = z10 * k1;
    const double z20 = z16 * z19;
    const double z21 = 1.0 / z12;
    const double z22 = z21 * z20;
    const double z23 = z18 - 16.0 * (z20 * z22);
    const double z24 = I3 + 4.0 * (k1 * (z11 + z17));
    const double z25 = k1 * (z16 * R_z3);
    const double z26 = z25 * z21;
    const double z27 = 2.0 * (R_z3 * z19) + 8.0 * (z26 * z20);
    const double z28 = 1.0 / z23;
    const double z29 = z27 * z28;
    const double z30 = z24 - 4.0 * (z25 * z26) - z27 * z29;
    const double z31 = R_2 * z2;
    const double z32 = R_3 * z8;
    const double z33 = z31 + z32;
    const double z34 = R_3 * z13;
    const double R_y2 = 1.0 - 2.0 * (z3 + z34);
    const double z35 = z7 - z9;
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double z36 = w2 * w3 * k2;
    const double w1 = y[6]; /* [rad/s] */
    const double z37 = w1 * w3 * k3 - 4.0 * (z36 * z22);
    const double z38 = (w1 * w2 * k4 + 2.0 * (z36 * z26) - z29 * z37) / z30;
    const double z39 = z28 * z37 - z29 * z38;
    const double z40 = z36 * z21 - 4.0 * (z22 * z39) + 2.0 * (z26 * z38);
    const double z41 = 2.0 * (w2 * (z35 * w1 - z33 * w3)) - R_y2 * z39 + 2.0 * (0.5 * (w1 * (R_y2 * w3 - 2.0
        * (z35 * w2))) + z33 * z40);
    const double z42 = a * (2.0 * (0.5 * (w3 * (2.0 * (z33 * w2) - R_y2 * w1)) + z35 * z38) + z41);
    const double R_x1 = 1.0 - 2.0 * (z5 + z34);
    const double z43 = z31 - z32;
    const double z44 = z14 + z15;
    const double z45 = 2.0 * (0.5 * (w2 * (2.0 * (z44 * w1) - R_x1 * w3)) - z43 * z39) + (2.0 * (w1 * (z43 *
        w3 - z44 * w2)) + R_x1 * z40);
    const double z46 = a * (2.0 * (0.5 * (w3 * (R_x1 * w2 - 2.0 * (z43 * w1))) + z44 * z38) + z45);
    const double z47 = R_0 * w3 + (R_1 * w2 - R_2 * w1);
    const double z48 = R_2 * w3 + (R_0 * w1 - R_3 * w2);
    const double z49 = R_1 * w3 - (R_0 * w2 + R_3 * w1);
    const double z50 = 0.5 * (w3 * z47) + R_3 * z38 + (0.5 * (w1 * z48) + R_1 * z40 - (0.5 * (w2 * z49) + R_2
        * z39));
    const double z51 = R_3 * w3 + (R_1 * w1 + R_2 * w2);
    const double z52 = 0.5 * (w3 * z49) - R_2 * z38 + (0.5 * (w1 * z51) - R_0 * z40 + (0.5 * (w2 * z47) - R_3
        * z39));
    const double z53 = 0.5 * (w3 * z48) + R_1 * z38 + (0.5 * (w2 * z51) + R_0 * z39 - (0.5 * (w1 * z47) + R_3
        * z40));
    const double z54 = 0.5 * (w3 * z51) - R_0 * z38 - (0.5 * (w2 * z48) - R_1 * z39 + (0.5 * (w1 * z49) - R_2
        * z40));
    /* (I.2.15) */
    qddot[0] = z42; /* x'' */
    qddot[1] = -z46; /* y'' */
    qddot[2] = -0.5 * z50; /* R_0'' */
    qddot[3] = -0.5 * z52; /* R_1'' */
    qddot[4] = -0.5 * z53; /* R_2'' */
    qddot[5] = -0.5 * z54; /* R_3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(z23) > 1e-13 * z18
        && fabs(z30) > 1e-13 * z24)) {
        /* the mass matrix is singular, if z12 is 0 */
        if (!(fabs(z12) > 0.0)) {
            return chaplygin_ball_quaternion_refuse(fabs(z12), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z23 is nearly 0 */
        if (!(fabs(z23) > 1e-13 * z18)) {
            return chaplygin_ball_quaternion_refuse(fabs(z23), 1e-13 * z18,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z30 is nearly 0 */
        if (!(fabs(z30) > 1e-13 * z24)) {
            return chaplygin_ball_quaternion_refuse(fabs(z30), 1e-13 * z24,
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

    /* from the coordinates and velocities */
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
    const double y_2 = q[1]; /* y: centre [m] */
    y[1] = y_2;
    y[2] = R_0;
    y[3] = R_1;
    y[4] = R_2;
    y[5] = R_3;
    const double R_0_dot = qdot[2]; /* R_0' [1/s] */
    const double R_1_dot = qdot[3]; /* R_1' [1/s] */
    const double R_2_dot = qdot[4]; /* R_2' [1/s] */
    const double R_3_dot = qdot[5]; /* R_3' [1/s] */
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

    /* from the coordinates and velocities */
    const double R_0 = q[2]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[3]; /* quaternion of R, along x [1] */
    const double R_2 = q[4]; /* quaternion of R, along y [1] */
    const double R_3 = q[5]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_0 * z1;
    const double z3 = R_1 * z1;
    const double z4 = R_3 * z1;
    const double z5 = R_2 * z1;
    const double R_0_dot = qdot[2]; /* R_0' [1/s] */
    const double R_1_dot = qdot[3]; /* R_1' [1/s] */
    const double R_2_dot = qdot[4]; /* R_2' [1/s] */
    const double R_3_dot = qdot[5]; /* R_3' [1/s] */
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
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double a = p[1]; /* radius [m] */
    /* (I.1.1) 23:5 */
    r[0] = x_dot - a * omega_y; /* roll_x = 0 */
    const double y_dot = qdot[1]; /* y' [m/s] */
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

    /* from the coordinates */
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
    const double k1 = m * a;
    const double k2 = a * k1;
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k3 = I2 - I3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k4 = I1 - I3;
    const double k5 = I1 - I2;

    /* from the state */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z1 = R_3 * R_3;
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z2 = R_1 * R_1;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double z3 = R_0 * R_0 + z2;
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double z4 = 1.0 / (z1 + (R_2 * R_2 + z3));
    const double z5 = R_2 * z4;
    const double z6 = R_0 * z4;
    const double z7 = R_3 * z5 + R_1 * z6;
    const double z8 = z7 * z7;
    const double R_z3 = 1.0 - 2.0 * (R_2 * z5 + z2 * z4);
    const double z9 = k2 * R_z3 * R_z3;
    const double z10 = 4.0 * (k2 * z8) + (I1 + z9);
    const double z11 = R_1 * R_3;
    const double z12 = R_2 * z6 - z4 * z11;
    const double z13 = z12 * z12;
    const double z14 = I2 + z9 + 4.0 * (k2 * z13);
    const double z15 = z7 * k2;
    const double z16 = z15 * z12;
    const double z17 = 1.0 / z10;
    const double z18 = z16 * z17;
    const double z19 = z14 - 16.0 * (z16 * z18);
    const double z20 = I3 + 4.0 * (k2 * (z8 + z13));
    const double z21 = k2 * (z12 * R_z3);
    const double z22 = z21 * z17;
    const double z23 = 2.0 * (z15 * R_z3) + 8.0 * (z16 * z22);
    const double z24 = 1.0 / z19;
    const double z25 = z23 * z24;
    const double z26 = z20 - 4.0 * (z21 * z22) - z23 * z25;
    const double z27 = z4 * k1;
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double z28 = w2 * w3 * k3;
    const double w1 = y[6]; /* [rad/s] */
    const double z29 = w1 * w3 * k4 + 4.0 * (z28 * z18);
    const double z30 = (w1 * w2 * k5 - 2.0 * (z28 * z22) - z25 * z29) / z26;
    const double z31 = z27 * z30;
    const double z32 = R_1 * R_2;
    const double z33 = R_0 * R_3;
    const double z34 = z24 * z29 - z25 * z30;
    const double z35 = z28 * z17 + 4.0 * (z18 * z34) - 2.0 * (z22 * z30);
    const double z36 = 2.0 * ((z32 + z33) * (z27 * z35)) - k1 * ((1.0 - 2.0 * (z4 * (z2 + z1))) * z34);
    const double z37 = 2.0 * ((z11 + R_0 * R_2) * z31) - (k1 * ((1.0 - 2.0 * (z3 * z4)) * z35) + 2.0 * ((z32
        - z33) * (z27 * z34)));
    /* (I.4.1) 23:5 */
    lambda[0] = 2.0 * ((R_2 * R_3 - R_0 * R_1) * z31) + z36; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 24:5 */
    lambda[1] = -z37; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 10:3 */
    lambda[2] = 0.0; /* reaction of R_norm: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX && fabs(z19) > 1e-13 * z14 && fabs(z26) > 1e-13 * z20)) {
        /* the mass matrix is singular, if z10 is 0 */
        if (!(fabs(z10) > 0.0)) {
            return chaplygin_ball_quaternion_refuse(fabs(z10), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z19 is nearly 0 */
        if (!(fabs(z19) > 1e-13 * z14)) {
            return chaplygin_ball_quaternion_refuse(fabs(z19), 1e-13 * z14,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z26 is nearly 0 */
        if (!(fabs(z26) > 1e-13 * z20)) {
            return chaplygin_ball_quaternion_refuse(fabs(z26), 1e-13 * z20,
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
    const double z2 = R_1 * z1;
    const double z3 = R_2 * z1;
    const double R_z3 = 1.0 - 2.0 * (R_1 * z2 + R_2 * z3);
    const double w2 = y[7]; /* [rad/s] */
    const double a = p[1]; /* radius [m] */
    const double z4 = a * w2;
    const double z5 = R_0 * z1;
    const double z6 = R_3 * z3 + R_1 * z5;
    const double w3 = y[8]; /* [rad/s] */
    const double z7 = a * w3;
    const double z8 = R_z3 * z4 - 2.0 * (z6 * z7);
    const double w1 = y[6]; /* [rad/s] */
    const double z9 = a * w1;
    const double z10 = R_2 * z5 - R_3 * z2;
    const double z11 = R_z3 * z9 + 2.0 * (z7 * z10);
    const double z12 = z6 * z9 + z4 * z10;
    const double m = p[0]; /* mass [kg] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double z13 = I1 * (w1 * w1) + I2 * (w2 * w2) + I3 * (w3 * w3) + m * (z8 * z8 + z11 * z11 + 4.0 *
        (z12 * z12));
    return 0.5 * z13;
}

CHAPLYGIN_BALL_QUATERNION_SLOW
int chaplygin_ball_quaternion_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 81 * sizeof *J);
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k1 = a * (m * a);
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k2 = I2 - I3;
    const double I1 = p[2]; /* [kg*m^2] */
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* from the state */
    const double R_1 = y[3]; /* quaternion of R, along x [1] */
    const double z1 = R_1 * R_1;
    const double R_0 = y[2]; /* quaternion of R, scalar part [1] */
    const double R_2 = y[4]; /* quaternion of R, along y [1] */
    const double R_3 = y[5]; /* quaternion of R, along z [1] */
    const double z2 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + z1)));
    const double z3 = R_1 * z2;
    const double z4 = R_1 * z3;
    const double z5 = R_2 * z2;
    const double z6 = R_2 * z5;
    const double R_z3 = 1.0 - 2.0 * (z4 + z6);
    const double z7 = k1 * R_z3 * R_z3;
    const double z8 = R_3 * z5;
    const double z9 = R_0 * z2;
    const double z10 = R_1 * z9;
    const double z11 = z8 + z10;
    const double z12 = z11 * z11;
    const double z13 = I1 + z7 + 4.0 * (k1 * z12);
    const double z14 = R_3 * z2;
    const double z15 = R_1 * z14;
    const double z16 = R_2 * z9;
    const double z17 = z15 - z16;
    const double z18 = z17 * z17;
    const double z19 = I2 + z7 + 4.0 * (k1 * z18);
    const double z20 = z11 * k1;
    const double z21 = z17 * z20;
    const double z22 = 1.0 / z13;
    const double z23 = z22 * z21;
    const double z24 = z19 - 16.0 * (z21 * z23);
    const double z25 = I3 + 4.0 * (k1 * (z12 + z18));
    const double z26 = k1 * (z17 * R_z3);
    const double z27 = z26 * z22;
    const double z28 = 2.0 * (R_z3 * z20) + 8.0 * (z27 * z21);
    const double z29 = 1.0 / z24;
    const double z30 = z28 * z29;
    const double z31 = z25 - 4.0 * (z26 * z27) - z28 * z30;
    const double w1 = y[6]; /* [rad/s] */
    const double z32 = a * w1;
    const double w3 = y[8]; /* [rad/s] */
    const double z33 = a * w3;
    const double z34 = R_3 * z32 - R_1 * z33;
    const double z35 = z2 * z34;
    const double z36 = z2 * z2;
    const double w2 = y[7]; /* [rad/s] */
    const double z37 = a * w2;
    const double z38 = R_3 * z37;
    const double z39 = R_3 * z33;
    const double z40 = R_2 * z32;
    const double z41 = z40 - R_1 * z37;
    const double z42 = z36 * (R_3 * z38 - R_2 * z39 - R_1 * z41 - R_0 * z34);
    const double z43 = z9 * z33 + z3 * z37;
    const double z44 = z14 * z37;
    const double z45 = R_2 * z3;
    const double z46 = R_3 * z9;
    const double z47 = R_3 * z14;
    const double z48 = z38 - R_2 * z33;
    const double z49 = R_2 * z37;
    const double z50 = z36 * (R_3 * z34 + R_2 * z40 - R_1 * z49 + R_0 * z48);
    const double z51 = z5 * z32;
    const double z52 = 0.5 * w1;
    const double z53 = 0.5 * w2;
    const double z54 = 0.5 * w3;
    const double z55 = 0.5 * R_1;
    const double z56 = 0.5 * R_2;
    const double z57 = 0.5 * R_3;
    const double z58 = 0.5 * R_0;
    const double z59 = 1.0 / z31;
    const double z60 = w1 * k4;
    const double z61 = w2 * k2;
    const double z62 = w3 * z61;
    const double z63 = w1 * k3;
    const double z64 = w3 * z63 - 4.0 * (z23 * z62);
    const double z65 = z59 * (w2 * z60 + 2.0 * (z27 * z62) - z30 * z64);
    const double z66 = k1 * z65;
    const double z67 = 2.0 * (R_z3 * z66);
    const double z68 = z29 * z64 - z30 * z65;
    const double z69 = k1 * z68;
    const double z70 = z11 * z69;
    const double z71 = z67 - 4.0 * z70;
    const double z72 = z17 * z69;
    const double z73 = k1 * (z22 * z62 - 4.0 * (z23 * z68) + 2.0 * (z27 * z65));
    const double z74 = z11 * z73;
    const double z75 = 4.0 * z72 + 8.0 * z74;
    const double z76 = R_2 * z71 + R_1 * z75;
    const double z77 = R_1 * z71;
    const double z78 = z17 * z66;
    const double z79 = R_z3 * z73;
    const double z80 = z78 - z79;
    const double z81 = R_3 * z75 + 4.0 * (R_2 * z80);
    const double z82 = z36 * (R_3 * z77 - R_2 * z81 - 4.0 * (z1 * z80) - R_0 * z76);
    const double z83 = z2 * z76 + 2.0 * (R_0 * z82);
    const double z84 = 8.0 * z72 + 4.0 * z74;
    const double z85 = z17 * z73;
    const double z86 = z67 + 4.0 * z85;
    const double z87 = R_2 * z84 - R_1 * z86;
    const double z88 = R_1 * z84;
    const double z89 = z11 * z66;
    const double z90 = R_z3 * z69;
    const double z91 = z89 + z90;
    const double z92 = R_3 * z86 - 4.0 * (R_2 * z91);
    const double z93 = z36 * (R_3 * z88 + R_2 * z92 - 4.0 * (z1 * z91) - R_0 * z87);
    const double z94 = z2 * z87 + 2.0 * (R_0 * z93) + 4.0 * (z23 * z83);
    const double z95 = 8.0 * z78 - 2.0 * z79;
    const double z96 = 8.0 * z89 + 2.0 * z90;
    const double z97 = R_2 * z95 - R_1 * z96;
    const double z98 = R_1 * z95;
    const double z99 = z70 - z85;
    const double z100 = R_3 * z96 - 4.0 * (R_2 * z99);
    const double z101 = z36 * (R_3 * z98 + R_2 * z100 - 4.0 * (z1 * z99) - R_0 * z97);
    const double z102 = z59 * (z2 * z97 + 2.0 * (R_0 * z101) - 2.0 * (z27 * z83) - z30 * z94);
    const double z103 = z29 * z94 - z30 * z102;
    const double z104 = 4.0 * (z3 * z80);
    const double z105 = 2.0 * (R_1 * z82) + (z104 - (z14 * z71 - z9 * z75 - z104));
    const double z106 = 4.0 * (z3 * z91);
    const double z107 = 2.0 * (R_1 * z93) + (z106 - (z14 * z84 + z9 * z86 - z106)) + 4.0 * (z23 * z105);
    const double z108 = 4.0 * (z3 * z99);
    const double z109 = 2.0 * (R_1 * z101) + (z108 - (z14 * z95 + z9 * z96 - z108)) - 2.0 * (z27 * z105);
    const double z110 = z59 * (z109 - z30 * z107);
    const double z111 = z29 * z107 - z30 * z110;
    const double z112 = z9 * z71 + 4.0 * (z5 * z80) + z2 * z81 + 2.0 * (R_2 * z82);
    const double z113 = z9 * z84 + 4.0 * (z5 * z91) - z2 * z92 + 2.0 * (R_2 * z93) + 4.0 * (z23 * z112);
    const double z114 = z9 * z95 + 4.0 * (z5 * z99) - z2 * z100 + 2.0 * (R_2 * z101) - 2.0 * (z27 * z112);
    const double z115 = z59 * (z114 - z30 * z113);
    const double z116 = z29 * z113 - z30 * z115;
    const double z117 = z5 * z75 - z2 * z77 + 2.0 * (R_3 * z82);
    const double z118 = z5 * z86 + z2 * z88 - 2.0 * (R_3 * z93) - 4.0 * (z23 * z117);
    const double z119 = z5 * z96 + z2 * z98 - 2.0 * (R_3 * z101) + 2.0 * (z27 * z117) - z30 * z118;
    const double z120 = z59 * z119;
    const double z121 = z29 * z118 - z30 * z120;
    const double z122 = w3 * k3;
    const double z123 = z59 * (w2 * k4 - z30 * z122);
    const double z124 = z29 * z122 - z30 * z123;
    const double z125 = w3 * k2;
    const double z126 = z23 * z125;
    const double z127 = z59 * (z60 + 2.0 * (z27 * z125) + 4.0 * (z30 * z126));
    const double z128 = 4.0 * (z29 * z126) + z30 * z127;
    const double z129 = z63 - 4.0 * (z23 * z61);
    const double z130 = z59 * (2.0 * (z27 * z61) - z30 * z129);
    const double z131 = z29 * z129 - z30 * z130;
    /* (I.2.15) */
    J[2] = 2.0 * z35 + 4.0 * (R_0 * z42);
    J[3] = 4.0 * (R_1 * z42) - 2.0 * (z43 - z2 * z41);
    J[4] = 2.0 * (z3 * z32 + z2 * z39) + 4.0 * (R_2 * z42);
    J[5] = 4.0 * (R_3 * z42) - 2.0 * (z44 - (z9 * z32 + z5 * z33 - z44));
    J[6] = 2.0 * (a * (z45 + z46));
    J[7] = a * (1.0 - 2.0 * (z4 + z47));
    J[8] = 2.0 * (a * (z8 - z10));
    J[11] = 2.0 * (z2 * z48) - 4.0 * (R_0 * z50);
    J[12] = -(4.0 * (R_1 * z50) + 2.0 * (z2 * (z39 + z49)));
    J[13] = 2.0 * (z51 - (z43 - z51)) - 4.0 * (R_2 * z50);
    J[14] = 2.0 * (z35 + (z9 * z37 + z14 * z32)) - 4.0 * (R_3 * z50);
    J[15] = (2.0 * (z6 + z47) - 1.0) * a;
    J[16] = -2.0 * (a * (z45 - z46));
    J[17] = -2.0 * (a * (z15 + z16));
    J[21] = -z52;
    J[22] = -z53;
    J[23] = -z54;
    J[24] = -z55;
    J[25] = -z56;
    J[26] = -z57;
    J[29] = z52;
    J[31] = z54;
    J[32] = -z53;
    J[33] = z58;
    J[34] = -z57;
    J[35] = z56;
    J[38] = z53;
    J[39] = -z54;
    J[41] = z52;
    J[42] = z57;
    J[43] = z58;
    J[44] = -z55;
    J[47] = z54;
    J[48] = z53;
    J[49] = -z52;
    J[51] = -z56;
    J[52] = z55;
    J[53] = z58;
    J[56] = 2.0 * (z27 * z102) - (z22 * z83 + 4.0 * (z23 * z103));
    J[57] = 2.0 * (z27 * z110) - (z22 * z105 + 4.0 * (z23 * z111));
    J[58] = 2.0 * (z27 * z115) - (z22 * z112 + 4.0 * (z23 * z116));
    J[59] = -(z22 * z117 - 4.0 * (z23 * z121) + 2.0 * (z27 * z120));
    J[60] = 2.0 * (z27 * z123) - 4.0 * (z23 * z124);
    J[61] = z22 * z125 + 4.0 * (z23 * z128) + 2.0 * (z27 * z127);
    J[62] = z22 * z61 - 4.0 * (z23 * z131) + 2.0 * (z27 * z130);
    J[65] = -z103;
    J[66] = -z111;
    J[67] = -z116;
    J[68] = z121;
    J[69] = -z124;
    J[70] = z128;
    J[71] = -z131;
    J[74] = z102;
    J[75] = z110;
    J[76] = z115;
    J[77] = -z120;
    J[78] = z123;
    J[79] = z127;
    J[80] = z130;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[3] + J[4] + J[5] + J[6] + J[7] + J[8] + J[11] + J[12] + J[13] + J[14] + J[15] + J[16]
        + J[17] + J[32] + J[33] + J[34] + J[39] + J[44] + J[49] + J[51] + J[56] + J[57] + J[58] + J[59] +
        J[60] + J[61] + J[62] + J[65] + J[66] + J[67] + J[69] + J[71] + J[77]) <= DBL_MAX
        && fabs(z24) > 1e-13 * z19
        && fabs(z31) > 1e-13 * z25)) {
        /* the mass matrix is singular, if z13 is 0 */
        if (!(fabs(z13) > 0.0)) {
            return chaplygin_ball_quaternion_refuse(fabs(z13), 0.0, CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z24 is nearly 0 */
        if (!(fabs(z24) > 1e-13 * z19)) {
            return chaplygin_ball_quaternion_refuse(fabs(z24), 1e-13 * z19,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if z31 is nearly 0 */
        if (!(fabs(z31) > 1e-13 * z25)) {
            return chaplygin_ball_quaternion_refuse(fabs(z31), 1e-13 * z25,
                CHAPLYGIN_BALL_QUATERNION_SINGULAR_2);
        }
        return chaplygin_ball_quaternion_finish(81, J);
    }
    return CHAPLYGIN_BALL_QUATERNION_OK;
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
    const double w1 = y[6]; /* [rad/s] */
    const double z2 = I1 * w1;
    const double w3 = y[8]; /* [rad/s] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double z3 = I3 * w3;
    const double w2 = y[7]; /* [rad/s] */
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
    const chaplygin_ball_quaternion_lanes z1 = 2.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const chaplygin_ball_quaternion_lanes z2 = R_1 * z1;
    const chaplygin_ball_quaternion_lanes z3 = R_1 * z2;
    const chaplygin_ball_quaternion_lanes z4 = R_2 * z1;
    const chaplygin_ball_quaternion_lanes z5 = R_2 * z4;
    const chaplygin_ball_quaternion_lanes R_z3 = 1.0 - (z3 + z5);
    const chaplygin_ball_quaternion_lanes z6 = k1 * R_z3 * R_z3;
    const chaplygin_ball_quaternion_lanes z7 = R_3 * z4;
    const chaplygin_ball_quaternion_lanes z8 = R_0 * z1;
    const chaplygin_ball_quaternion_lanes z9 = R_1 * z8;
    const chaplygin_ball_quaternion_lanes R_z2 = z7 + z9;
    const chaplygin_ball_quaternion_lanes z10 = R_z2 * R_z2;
    const chaplygin_ball_quaternion_lanes z11 = I1 + z6 + k1 * z10;
    const chaplygin_ball_quaternion_lanes z12 = R_3 * z1;
    const chaplygin_ball_quaternion_lanes z13 = R_1 * z12;
    const chaplygin_ball_quaternion_lanes z14 = R_2 * z8;
    const chaplygin_ball_quaternion_lanes R_z1 = z13 - z14;
    const chaplygin_ball_quaternion_lanes z15 = R_z1 * R_z1;
    const chaplygin_ball_quaternion_lanes z16 = I2 + z6 + k1 * z15;
    const chaplygin_ball_quaternion_lanes z17 = R_z2 * k1;
    const chaplygin_ball_quaternion_lanes z18 = R_z1 * z17;
    const chaplygin_ball_quaternion_lanes z19 = 1.0 / z11;
    const chaplygin_ball_quaternion_lanes z20 = z19 * z18;
    const chaplygin_ball_quaternion_lanes z21 = z16 - z18 * z20;
    /* the mass matrix is singular, if z21 is nearly 0 */
    bad |=
        chaplygin_ball_quaternion_misses(chaplygin_ball_quaternion_size(CHAPLYGIN_BALL_QUATERNION_SPREAD(z21)),
        1e-13 * z16);
    const chaplygin_ball_quaternion_lanes z22 = I3 + k1 * (z10 + z15);
    const chaplygin_ball_quaternion_lanes z23 = k1 * (R_z1 * R_z3);
    const chaplygin_ball_quaternion_lanes z24 = z23 * z19;
    const chaplygin_ball_quaternion_lanes z25 = R_z3 * z17 + z24 * z18;
    const chaplygin_ball_quaternion_lanes z26 = 1.0 / z21;
    const chaplygin_ball_quaternion_lanes z27 = z25 * z26;
    const chaplygin_ball_quaternion_lanes z28 = z22 - z23 * z24 - z25 * z27;
    /* the mass matrix is singular, if z28 is nearly 0 */
    bad |=
        chaplygin_ball_quaternion_misses(chaplygin_ball_quaternion_size(CHAPLYGIN_BALL_QUATERNION_SPREAD(z28)),
        1e-13 * z22);
    const chaplygin_ball_quaternion_lanes z29 = R_3 * z12;
    const chaplygin_ball_quaternion_lanes z30 = R_2 * z2;
    const chaplygin_ball_quaternion_lanes z31 = R_3 * z8;
    const chaplygin_ball_quaternion_lanes z32 = w2 * w3 * k2;
    const chaplygin_ball_quaternion_lanes z33 = w1 * w3 * k3 - z32 * z20;
    const chaplygin_ball_quaternion_lanes z34 = (w1 * w2 * k4 + z32 * z24 - z27 * z33) / z28;
    const chaplygin_ball_quaternion_lanes z35 = z26 * z33 - z27 * z34;
    /* (I.2.4) */
    const chaplygin_ball_quaternion_lanes slope1 = a * ((z7 - z9) * w3 + ((1.0 - (z3 + z29)) * w2 + (z30 +
        z31) * w1));
    sum += slope1;
    chaplygin_ball_quaternion_put(dydt, slope1);
    const chaplygin_ball_quaternion_lanes slope2 = -a * ((z13 + z14) * w3 + ((z30 - z31) * w2 + (1.0 - (z5 +
        z29)) * w1));
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
    const chaplygin_ball_quaternion_lanes slope7 = z32 * z19 - z20 * z35 + z24 * z34;
    sum += slope7;
    chaplygin_ball_quaternion_put(dydt + 6 * stride, slope7);
    const chaplygin_ball_quaternion_lanes slope8 = -z35;
    sum += slope8;
    chaplygin_ball_quaternion_put(dydt + 7 * stride, slope8);
    const chaplygin_ball_quaternion_lanes slope9 = z34;
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
    const double k1 = a * (m * a);
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
