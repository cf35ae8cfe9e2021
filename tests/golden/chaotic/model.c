/*
 * chaotic.c: chaotic, emitted by nhc 0.1.0 (nhc:50ed3ec99ef57fae)
 * Seven coupled oscillators with one contact constraint; reversible and chaotic.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x`
 * chaotic.h says what each function does.
 */
#include "chaotic.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const chaotic_coordinate_names[CHAOTIC_NQ] = {
    "x",
    "y1",
    "y2",
    "y3",
    "z1",
    "z2",
    "z3"
};
const char *const chaotic_state_names[CHAOTIC_NY] = {
    "x",
    "y1",
    "y2",
    "y3",
    "z1",
    "z2",
    "z3",
    "y1'",
    "y2'",
    "y3'",
    "z1'",
    "z2'",
    "z3'"
};
const char *const chaotic_parameter_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const chaotic_constraint_names[CHAOTIC_NC] = {
    "contact"
};
const char *const chaotic_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double chaotic_parameter_defaults[1] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define CHAOTIC_SLOW __attribute__((cold, optimize("O1")))
#else
#define CHAOTIC_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int chaotic_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CHAOTIC_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CHAOTIC_NOT_FINITE;
        }
    }
    return CHAOTIC_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int chaotic_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CHAOTIC_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CHAOTIC_LANES
#if !defined(__GNUC__)
#define CHAOTIC_LANES 1
#elif defined(__AVX512F__)
#define CHAOTIC_LANES 8
#elif defined(__AVX__)
#define CHAOTIC_LANES 4
#else
#define CHAOTIC_LANES 2
#endif
#endif
#if CHAOTIC_LANES > 1
typedef double chaotic_lanes __attribute__((vector_size(8 * CHAOTIC_LANES)));
#else
typedef double chaotic_lanes;
#endif

#if CHAOTIC_LANES >= 2
static inline chaotic_lanes chaotic_get(const double *from)
{
    chaotic_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void chaotic_put(double *to, chaotic_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int chaotic_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CHAOTIC_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CHAOTIC_NY];
        double slope[CHAOTIC_NY];
        for (size_t k = 0; k < CHAOTIC_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = chaotic_rhs(t[i], state, p, slope);
        status = status == CHAOTIC_OK ? one : status;
        for (size_t k = 0; k < CHAOTIC_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CHAOTIC_LANES >= 2
#define CHAOTIC_SPREAD(x) ((x) - (chaotic_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long chaotic_bits __attribute__((vector_size(8 * CHAOTIC_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline chaotic_lanes chaotic_mark(chaotic_lanes value, chaotic_bits bad)
{
    return (chaotic_lanes)((chaotic_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int chaotic_is_good(int count, const double *check)
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
static inline void chaotic_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CHAOTIC_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CHAOTIC_NY; ++k) {
            state[k * CHAOTIC_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void chaotic_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CHAOTIC_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CHAOTIC_LANES + l];
        }
    }
}
#endif

int chaotic_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y1_ = y[1]; /* y1 */
    const double z4 = 1.0 + y1_ * y1_;
    const double y2 = y[2];
    const double z5 = y2 * y2;
    const double y3 = y[3];
    const double z6 = y3 * y3;
    const double z7 = z4 + (z5 + z6);
    const double z1 = y[4];
    const double z8 = 1.0 + z1 * z1;
    const double z2 = y[5];
    const double z9 = z2 * z2;
    const double z10 = z1 * (z9 + z4);
    const double z3 = y[6];
    const double z11 = z3 * (1.0 + z6);
    const double z12 = z2 * (z5 + z8);
    const double x = y[0];
    const double y1_dot = y[7]; /* y1' */
    const double y2_dot = y[8]; /* y2' */
    const double y3_dot = y[9]; /* y3' */
    const double z1_dot = y[10]; /* z1' */
    const double z2_dot = y[11]; /* z2' */
    const double z3_dot = y[12]; /* z3' */
    const double z13 = y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot) - (y3 * z11 + (y2 * z12 + (x +
        y1_ * z10)));
    const double z14 = z13 / z7;
    /* (I.1.2) */
    dydt[0] = -(y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot)); /* x' */
    dydt[1] = y1_dot; /* y1' */
    dydt[2] = y2_dot; /* y2' */
    dydt[3] = y3_dot; /* y3' */
    dydt[4] = z1_dot; /* z1' */
    dydt[5] = z2_dot; /* z2' */
    dydt[6] = z3_dot; /* z3' */
    /* (III.3) 10:4 */
    dydt[7] = -y1_ * z8; /* y1'' */
    dydt[8] = -y2 * (1.0 + z9); /* y2'' */
    dydt[9] = -y3 * (1.0 + z3 * z3); /* y3'' */
    dydt[10] = -(z10 + y1_ * z14); /* z1'' */
    dydt[11] = -(z12 + y2 * z14); /* z2'' */
    dydt[12] = -(z11 + y3 * z14); /* z3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[7] + dydt[8] + dydt[9] + dydt[10] + dydt[11] + dydt[12]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z7 is 0 */
        if (!(fabs(z7) > 0.0)) {
            return chaotic_refuse(fabs(z7), 0.0, CHAOTIC_SINGULAR_2);
        }
        return chaotic_finish(13, dydt);
    }
    return CHAOTIC_OK;
}

int chaotic_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y1_ = y[1]; /* y1 */
    const double y2 = y[2];
    const double y3 = y[3];
    const double z1_dot = y[10]; /* z1' */
    const double z2_dot = y[11]; /* z2' */
    const double z3_dot = y[12]; /* z3' */
    /* (I.1.2) */
    qdot[0] = -(y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot)); /* x' */
    const double y1_dot = y[7]; /* y1' */
    qdot[1] = y1_dot; /* y1' */
    const double y2_dot = y[8]; /* y2' */
    qdot[2] = y2_dot; /* y2' */
    const double y3_dot = y[9]; /* y3' */
    qdot[3] = y3_dot; /* y3' */
    qdot[4] = z1_dot; /* z1' */
    qdot[5] = z2_dot; /* z2' */
    qdot[6] = z3_dot; /* z3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3]) <= DBL_MAX)) {
        return chaotic_finish(7, qdot);
    }
    return CHAOTIC_OK;
}

int chaotic_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y1_ = y[1]; /* y1 */
    const double z4 = 1.0 + y1_ * y1_;
    const double y2 = y[2];
    const double z5 = y2 * y2;
    const double y3 = y[3];
    const double z6 = y3 * y3;
    const double z7 = z4 + (z5 + z6);
    const double y1_dot = y[7]; /* y1' */
    const double y2_dot = y[8]; /* y2' */
    const double y3_dot = y[9]; /* y3' */
    const double z1_dot = y[10]; /* z1' */
    const double z2_dot = y[11]; /* z2' */
    const double z3_dot = y[12]; /* z3' */
    const double z8 = y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot);
    const double z1 = y[4];
    const double z9 = 1.0 + z1 * z1;
    const double z2 = y[5];
    const double z10 = z2 * (z5 + z9);
    const double z11 = z2 * z2;
    const double z12 = z1 * (z11 + z4);
    const double z3 = y[6];
    const double z13 = z3 * (1.0 + z6);
    const double x = y[0];
    const double z14 = (z8 - (y1_ * z12 + (x + (y3 * z13 + y2 * z10)))) / z7;
    const double z15 = z10 + y2 * z14;
    const double z16 = z12 + y1_ * z14;
    const double z17 = z13 + y3 * z14;
    /* (III.3) */
    qddot[0] = y2 * z15 + (y1_ * z16 + y3 * z17) - z8; /* x'' */
    qddot[1] = -y1_ * z9; /* y1'' */
    qddot[2] = -y2 * (1.0 + z11); /* y2'' */
    qddot[3] = -y3 * (1.0 + z3 * z3); /* y3'' */
    qddot[4] = -z16; /* z1'' */
    qddot[5] = -z15; /* z2'' */
    qddot[6] = -z17; /* z3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5] + qddot[6]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z7 is 0 */
        if (!(fabs(z7) > 0.0)) {
            return chaotic_refuse(fabs(z7), 0.0, CHAOTIC_SINGULAR_2);
        }
        return chaotic_finish(7, qddot);
    }
    return CHAOTIC_OK;
}

int chaotic_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0];
    y[0] = x;
    const double y1_ = q[1]; /* y1 */
    y[1] = y1_;
    const double y2 = q[2];
    y[2] = y2;
    const double y3 = q[3];
    y[3] = y3;
    const double z1 = q[4];
    y[4] = z1;
    const double z2 = q[5];
    y[5] = z2;
    const double z3 = q[6];
    y[6] = z3;
    const double y1_dot = qdot[1]; /* y1' */
    y[7] = y1_dot;
    const double y2_dot = qdot[2]; /* y2' */
    y[8] = y2_dot;
    const double y3_dot = qdot[3]; /* y3' */
    y[9] = y3_dot;
    const double z1_dot = qdot[4]; /* z1' */
    y[10] = z1_dot;
    const double z2_dot = qdot[5]; /* z2' */
    y[11] = z2_dot;
    const double z3_dot = qdot[6]; /* z3' */
    y[12] = z3_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5] + y[6] + y[7] + y[8] + y[9] + y[10] + y[11] + y[12])
        <= DBL_MAX)) {
        return chaotic_finish(13, y);
    }
    return CHAOTIC_OK;
}

int chaotic_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double y1_ = q[1]; /* y1 */
    const double y2 = q[2];
    const double y3 = q[3];
    const double x_dot = qdot[0]; /* x' */
    const double z1_dot = qdot[4]; /* z1' */
    const double z2_dot = qdot[5]; /* z2' */
    const double z3_dot = qdot[6]; /* z3' */
    /* (I.1.1) 13:5 */
    r[0] = x_dot + y1_ * z1_dot + y2 * z2_dot + y3 * z3_dot; /* contact = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return chaotic_finish(1, r);
    }
    return CHAOTIC_OK;
}

int chaotic_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y1_ = y[1]; /* y1 */
    const double z4 = 1.0 + y1_ * y1_;
    const double y2 = y[2];
    const double z5 = y2 * y2;
    const double y3 = y[3];
    const double z6 = y3 * y3;
    const double z7 = z4 + (z5 + z6);
    const double x = y[0];
    const double z1 = y[4];
    const double z2 = y[5];
    const double z8 = y2 * (z2 * (1.0 + (z5 + z1 * z1))) + (x + y1_ * (z1 * (z2 * z2 + z4)));
    const double z3 = y[6];
    const double y1_dot = y[7]; /* y1' */
    const double y2_dot = y[8]; /* y2' */
    const double y3_dot = y[9]; /* y3' */
    const double z1_dot = y[10]; /* z1' */
    const double z2_dot = y[11]; /* z2' */
    const double z3_dot = y[12]; /* z3' */
    const double z9 = (y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot) - (y3 * (z3 * (1.0 + z6)) + z8))
        / z7;
    /* (I.4.1) 13:5 */
    lambda[0] = -z9; /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z7 is 0 */
        if (!(fabs(z7) > 0.0)) {
            return chaotic_refuse(fabs(z7), 0.0, CHAOTIC_SINGULAR_2);
        }
        return chaotic_finish(1, lambda);
    }
    return CHAOTIC_OK;
}

double chaotic_energy(double t, const double *y, const double *p)
{
    (void)t;
    (void)p;

    /* from the state */
    const double y1_ = y[1]; /* y1 */
    const double z4 = y1_ * y1_;
    const double y2 = y[2];
    const double z5 = y2 * y2;
    const double y3 = y[3];
    const double z6 = y3 * y3;
    const double z1 = y[4];
    const double z7 = z1 * z1;
    const double z2 = y[5];
    const double z8 = z2 * z2;
    const double z3 = y[6];
    const double z9 = z3 * z3;
    const double x = y[0];
    const double z10 = x * x + z4 + z5 + z6 + z7 + z8 + z9 + (z4 * z7 + z5 * z8 + z6 * z9 + z7 * z8);
    const double z1_dot = y[10]; /* z1' */
    const double z2_dot = y[11]; /* z2' */
    const double z3_dot = y[12]; /* z3' */
    const double z11 = y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot);
    const double y1_dot = y[7]; /* y1' */
    const double y2_dot = y[8]; /* y2' */
    const double y3_dot = y[9]; /* y3' */
    const double z12 = z2_dot * z2_dot + (z1_dot * z1_dot + (y3_dot * y3_dot + (y2_dot * y2_dot + (y1_dot *
        y1_dot + z11 * z11))));
    return 0.5 * (z10 + (z3_dot * z3_dot + z12));
}

CHAOTIC_SLOW
int chaotic_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 169 * sizeof *J);
    (void)t;
    (void)p;

    /* from the state */
    const double y1_ = y[1]; /* y1 */
    const double z4 = y1_ * y1_;
    const double z5 = 1.0 + z4;
    const double y2 = y[2];
    const double z6 = y2 * y2;
    const double y3 = y[3];
    const double z7 = y3 * y3;
    const double z8 = z5 + (z6 + z7);
    const double z1 = y[4];
    const double z9 = 1.0 + z1 * z1;
    const double z10 = y1_ * z1;
    const double z2 = y[5];
    const double z11 = z2 * z2;
    const double z12 = 1.0 + z11;
    const double z13 = y2 * z2;
    const double z14 = 1.0 / z8;
    const double z15 = y1_ * z14;
    const double z16 = z6 + z9;
    const double z17 = z2 * z16;
    const double x = y[0];
    const double y1_dot = y[7]; /* y1' */
    const double y2_dot = y[8]; /* y2' */
    const double y3_dot = y[9]; /* y3' */
    const double z1_dot = y[10]; /* z1' */
    const double z2_dot = y[11]; /* z2' */
    const double z3_dot = y[12]; /* z3' */
    const double z18 = x - (y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot));
    const double z19 = z11 + z5;
    const double z20 = z1 * z19;
    const double z21 = 1.0 + z7;
    const double z3 = y[6];
    const double z22 = z3 * z21;
    const double z23 = z14 * (z18 + (y1_ * z20 + (y3 * z22 + y2 * z17)));
    const double z24 = z17 - y2 * z23;
    const double z25 = y2 * z24;
    const double z26 = z22 - y3 * z23;
    const double z27 = z18 + y3 * z26;
    const double z28 = z20 - y1_ * z23;
    const double z29 = z25 + z27 - 2.0 * (y1_ * (z1 - z28));
    const double z30 = z14 * (z7 * z28 + (y1_ * z29 + z6 * z28));
    const double z31 = y1_ * z28;
    const double z32 = z31 + z27 - 2.0 * (y2 * (z2 - z24));
    const double z33 = z14 * (z7 * z24 + (z4 * z24 + y2 * z32));
    const double z34 = z24 - z33;
    const double z35 = z31 + (z18 + z25) - 2.0 * (y3 * (z3 - z26));
    const double z36 = z14 * (y3 * z35 + (z4 + z6) * z26);
    const double z37 = z26 - z36;
    const double z38 = z1 * z13;
    const double z39 = 2.0 * (z1 * z2);
    const double z40 = z2 * z10;
    const double z41 = 2.0 * z40 + y2 * z16;
    const double z42 = y3 * z14;
    const double z43 = z21 * z42;
    const double z44 = y2 * z14;
    const double z45 = z28 - z30;
    const double z46 = y1_ * z19 + 2.0 * z38;
    /* (III.3) */
    J[1] = -z1_dot;
    J[2] = -z2_dot;
    J[3] = -z3_dot;
    J[10] = -y1_;
    J[11] = -y2;
    J[12] = -y3;
    J[20] = 1.0;
    J[34] = 1.0;
    J[48] = 1.0;
    J[62] = 1.0;
    J[76] = 1.0;
    J[90] = 1.0;
    J[92] = -z9;
    J[95] = -2.0 * z10;
    J[106] = -z12;
    J[109] = -2.0 * z13;
    J[120] = -(1.0 + z3 * z3);
    J[123] = -2.0 * (y3 * z3);
    J[130] = z15;
    J[131] = z29 - y1_ * z30;
    J[132] = y1_ * z34;
    J[133] = y1_ * z37;
    J[134] = y1_ * (2.0 * (z14 * z38) - y1_ * (1.0 - z19 * z14)) - z12;
    J[135] = z15 * z41 - z39;
    J[136] = y1_ * z43;
    J[137] = -z1_dot * z15;
    J[138] = -z2_dot * z15;
    J[139] = -z3_dot * z15;
    J[140] = -y1_dot * z15;
    J[141] = -y2_dot * z15;
    J[142] = -y3_dot * z15;
    J[143] = z44;
    J[144] = y2 * z45;
    J[145] = z32 - y2 * z33;
    J[146] = y2 * z37;
    J[147] = z44 * z46 - z39;
    J[148] = y2 * (2.0 * (z14 * z40) - y2 * (1.0 - z16 * z14)) - z9;
    J[149] = y2 * z43;
    J[150] = -z1_dot * z44;
    J[151] = -z2_dot * z44;
    J[152] = -z3_dot * z44;
    J[153] = -y1_dot * z44;
    J[154] = -y2_dot * z44;
    J[155] = -y3_dot * z44;
    J[156] = z42;
    J[157] = y3 * z45;
    J[158] = y3 * z34;
    J[159] = z35 - y3 * z36;
    J[160] = z42 * z46;
    J[161] = z42 * z41;
    J[162] = -(1.0 + z7 * (1.0 - z21 * z14));
    J[163] = -z1_dot * z42;
    J[164] = -z2_dot * z42;
    J[165] = -z3_dot * z42;
    J[166] = -y1_dot * z42;
    J[167] = -y2_dot * z42;
    J[168] = -y3_dot * z42;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[95] + J[109] + J[120] + J[123] + J[131] + J[132] + J[133] + J[134] + J[135] + J[136] +
        J[137] + J[138] + J[139] + J[140] + J[141] + J[142] + J[144] + J[145] + J[146] + J[147] + J[148] +
        J[149] + J[150] + J[151] + J[152] + J[153] + J[154] + J[155] + J[157] + J[158] + J[159] + J[160] +
        J[161] + J[162] + J[163] + J[164] + J[165] + J[166] + J[167] + J[168]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return chaotic_refuse(fabs(z8), 0.0, CHAOTIC_SINGULAR_2);
        }
        return chaotic_finish(169, J);
    }
    return CHAOTIC_OK;
}

int chaotic_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return CHAOTIC_OK;
}

#if CHAOTIC_LANES >= 2
static __attribute__((noinline)) void chaotic_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    (void)fixed;
    chaotic_lanes far = {0}; /* the squares of the angles */
    chaotic_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    chaotic_bits bad = {0}; /* singular blocks */
    const chaotic_lanes x = chaotic_get(y);
    const chaotic_lanes y1_ = chaotic_get(y + 1 * stride);
    const chaotic_lanes y2 = chaotic_get(y + 2 * stride);
    const chaotic_lanes y3 = chaotic_get(y + 3 * stride);
    const chaotic_lanes z1 = chaotic_get(y + 4 * stride);
    const chaotic_lanes z2 = chaotic_get(y + 5 * stride);
    const chaotic_lanes z3 = chaotic_get(y + 6 * stride);
    const chaotic_lanes y1_dot = chaotic_get(y + 7 * stride);
    const chaotic_lanes y2_dot = chaotic_get(y + 8 * stride);
    const chaotic_lanes y3_dot = chaotic_get(y + 9 * stride);
    const chaotic_lanes z1_dot = chaotic_get(y + 10 * stride);
    const chaotic_lanes z2_dot = chaotic_get(y + 11 * stride);
    const chaotic_lanes z3_dot = chaotic_get(y + 12 * stride);
    const chaotic_lanes z4 = 1.0 + y1_ * y1_;
    const chaotic_lanes z5 = y2 * y2;
    const chaotic_lanes z6 = y3 * y3;
    const chaotic_lanes z7 = z4 + (z5 + z6);
    const chaotic_lanes z8 = 1.0 + z1 * z1;
    const chaotic_lanes z9 = z2 * z2;
    const chaotic_lanes z10 = z1 * (z9 + z4);
    const chaotic_lanes z11 = z3 * (1.0 + z6);
    const chaotic_lanes z12 = z2 * (z5 + z8);
    const chaotic_lanes z13 = y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot) - (y3 * z11 + (y2 * z12 +
        (x + y1_ * z10)));
    const chaotic_lanes z14 = z13 / z7;
    /* (I.1.2) */
    const chaotic_lanes slope1 = -(y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot));
    sum += slope1;
    chaotic_put(dydt, slope1);
    const chaotic_lanes slope2 = y1_dot;
    chaotic_put(dydt + 1 * stride, slope2);
    const chaotic_lanes slope3 = y2_dot;
    chaotic_put(dydt + 2 * stride, slope3);
    const chaotic_lanes slope4 = y3_dot;
    chaotic_put(dydt + 3 * stride, slope4);
    const chaotic_lanes slope5 = z1_dot;
    chaotic_put(dydt + 4 * stride, slope5);
    const chaotic_lanes slope6 = z2_dot;
    chaotic_put(dydt + 5 * stride, slope6);
    const chaotic_lanes slope7 = z3_dot;
    chaotic_put(dydt + 6 * stride, slope7);
    /* (III.3) 10:4 */
    const chaotic_lanes slope8 = -y1_ * z8;
    sum += slope8;
    chaotic_put(dydt + 7 * stride, slope8);
    const chaotic_lanes slope9 = -y2 * (1.0 + z9);
    sum += slope9;
    chaotic_put(dydt + 8 * stride, slope9);
    const chaotic_lanes slope10 = -y3 * (1.0 + z3 * z3);
    sum += slope10;
    chaotic_put(dydt + 9 * stride, slope10);
    const chaotic_lanes slope11 = -(z10 + y1_ * z14);
    sum += slope11;
    chaotic_put(dydt + 10 * stride, slope11);
    const chaotic_lanes slope12 = -(z12 + y2 * z14);
    sum += slope12;
    chaotic_put(dydt + 11 * stride, slope12);
    const chaotic_lanes slope13 = -(z11 + y3 * z14);
    sum += slope13;
    chaotic_put(dydt + 12 * stride, slope13);
    chaotic_put(check, chaotic_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void chaotic_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CHAOTIC_LANES];
    double state[13 * CHAOTIC_LANES];
    double slope[13 * CHAOTIC_LANES];
    chaotic_fill(left, count, t, y, time, state);
    chaotic_rhs_lanes(fixed, CHAOTIC_LANES, time, state, slope, check);
    chaotic_pour(left, count, slope, dydt);
}
#endif

int chaotic_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
#if CHAOTIC_LANES >= 2
    const double *fixed = p;
    double check[1 * CHAOTIC_LANES];
    int status = CHAOTIC_OK;
    for (size_t i = 0; i < count; i += CHAOTIC_LANES) {
        const size_t left = count - i < CHAOTIC_LANES ? count - i : CHAOTIC_LANES;
        if (left == CHAOTIC_LANES) {
            chaotic_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            chaotic_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!chaotic_is_good(1 * CHAOTIC_LANES, check)) {
            const int one = chaotic_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CHAOTIC_OK ? one : status;
        }
    }
    return status;
#else
    return chaotic_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
