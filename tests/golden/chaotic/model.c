/*
 * chaotic.c: chaotic, emitted by nhc 0.1.0 (nhc:c407040e33d1a74a)
 * Seven coupled oscillators with one contact constraint; reversible and chaotic.
 * Source: chaotic.yaml
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

const char *const chaotic_coordinate_names[] = {
    "x",
    "y1",
    "y2",
    "y3",
    "z1",
    "z2",
    "z3"
};
const char *const chaotic_state_names[] = {
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
const char *const chaotic_parameter_names[] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double chaotic_parameter_defaults[] = {
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
    const double y1_ = y[1];
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
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];
    const double z13 = y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot) - (y3 * z11 + (y2 * z12 + (x +
        y1_ * z10)));
    const double z14 = z13 / z7;
    /* (III.3) */
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
        /* the mass matrix is singular */
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
    const double y1_ = y[1];
    const double y2 = y[2];
    const double y3 = y[3];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];
    /* (I.2.4) */
    qdot[0] = -(y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot)); /* x' */
    const double y1_dot = y[7];
    qdot[1] = y1_dot; /* y1' */
    const double y2_dot = y[8];
    qdot[2] = y2_dot; /* y2' */
    const double y3_dot = y[9];
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
    const double y1_ = y[1];
    const double z4 = 1.0 + y1_ * y1_;
    const double y2 = y[2];
    const double z5 = y2 * y2;
    const double y3 = y[3];
    const double z6 = y3 * y3;
    const double z7 = z4 + (z5 + z6);
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];
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
        /* the mass matrix is singular */
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

    /* from the state */
    const double x = q[0];
    y[0] = x;
    const double y1_ = q[1];
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
    const double y1_dot = qdot[1];
    y[7] = y1_dot;
    const double y2_dot = qdot[2];
    y[8] = y2_dot;
    const double y3_dot = qdot[3];
    y[9] = y3_dot;
    const double z1_dot = qdot[4];
    y[10] = z1_dot;
    const double z2_dot = qdot[5];
    y[11] = z2_dot;
    const double z3_dot = qdot[6];
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

    /* from the state */
    const double y1_ = q[1];
    const double y2 = q[2];
    const double y3 = q[3];
    const double x_dot = qdot[0];
    const double z1_dot = qdot[4];
    const double z2_dot = qdot[5];
    const double z3_dot = qdot[6];
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
    const double y1_ = y[1];
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
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];
    const double z9 = (y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot) - (y3 * (z3 * (1.0 + z6)) + z8))
        / z7;
    /* (I.4.1) 13:5 */
    lambda[0] = -z9; /* reaction of contact: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX)) {
        /* the mass matrix is singular */
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
    const double y1_ = y[1];
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
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];
    const double z11 = y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot);
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
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
    const double y3 = y[3];
    const double z4 = y3 * y3;
    const double y2 = y[2];
    const double z5 = y2 * y2;
    const double y1_ = y[1];
    const double z6 = 1.0 + y1_ * y1_;
    const double z7 = z4 + (z5 + z6);
    const double z1 = y[4];
    const double z8 = z1 * z1;
    const double z2 = y[5];
    const double z9 = z2 * z2;
    const double z10 = 1.0 / z6;
    const double z11 = y1_ * y2;
    const double z12 = z11 * z10;
    const double z13 = 1.0 + z5;
    const double z14 = 1.0 / (z13 - z11 * z12);
    const double z15 = y2 - y1_ * z12;
    const double z16 = y1_ * y3;
    const double z17 = z16 * z10;
    const double z18 = y2 * y3 - z11 * z17;
    const double z19 = z18 * z14;
    const double z20 = 1.0 + z4;
    const double z21 = 1.0 / (z20 - z16 * z17 - z18 * z19);
    const double z22 = z21 * (y3 - y1_ * z17 - z19 * z15);
    const double z23 = z14 * z15 - z19 * z22;
    const double z24 = z8 + z13;
    const double z25 = z2 * z24;
    const double x = y[0];
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];
    const double z26 = x - (y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot));
    const double z27 = z9 + z6;
    const double z28 = z1 * z27;
    const double z3 = y[6];
    const double z29 = z3 * z20;
    const double z30 = (z26 + (y1_ * z28 + (y3 * z29 + y2 * z25))) / z7;
    const double z31 = z25 - y2 * z30;
    const double z32 = y2 * z31;
    const double z33 = z29 - y3 * z30;
    const double z34 = z26 + y3 * z33;
    const double z35 = z28 - y1_ * z30;
    const double z36 = z32 + z34 - 2.0 * (y1_ * (z1 - z35));
    const double z37 = y2 * z35 - z12 * z36;
    const double z38 = z21 * (y3 * z35 - z17 * z36 - z19 * z37);
    const double z39 = z14 * z37 - z19 * z38;
    const double z40 = y1_ * z31;
    const double z41 = y1_ * z35;
    const double z42 = z41 + z34 - 2.0 * (y2 * (z2 - z31)) - z12 * z40;
    const double z43 = z21 * (y3 * z31 - z17 * z40 - z19 * z42);
    const double z44 = z14 * z42 - z19 * z43;
    const double z45 = y1_ * z33;
    const double z46 = y2 * z33 - z12 * z45;
    const double z47 = z21 * (z41 + (z26 + z32) - 2.0 * (y3 * (z3 - z33)) - z17 * z45 - z19 * z46);
    const double z48 = z14 * z46 - z19 * z47;
    const double z49 = z1 * z2;
    const double z50 = 2.0 * z49 - z12 * z27;
    const double z51 = z21 * (z17 * z27 + z19 * z50);
    const double z52 = z14 * z50 + z19 * z51;
    const double z53 = 2.0 * (z12 * z49) - z24;
    const double z54 = z21 * (2.0 * (z17 * z49) - z19 * z53);
    const double z55 = z14 * z53 - z19 * z54;
    const double z56 = z20 * z21;
    const double z57 = z19 * z56;
    const double z58 = y1_ * z1_dot;
    const double z59 = y2 * z1_dot - z58 * z12;
    const double z60 = z21 * (y3 * z1_dot - z58 * z17 - z19 * z59);
    const double z61 = z14 * z59 - z19 * z60;
    const double z62 = y1_ * z2_dot;
    const double z63 = y2 * z2_dot - z12 * z62;
    const double z64 = z21 * (y3 * z2_dot - z17 * z62 - z19 * z63);
    const double z65 = z14 * z63 - z19 * z64;
    const double z66 = y1_ * z3_dot;
    const double z67 = y2 * z3_dot - z12 * z66;
    const double z68 = z21 * (y3 * z3_dot - z17 * z66 - z19 * z67);
    const double z69 = z14 * z67 - z19 * z68;
    const double z70 = y1_ * y1_dot;
    const double z71 = y2 * y1_dot - z12 * z70;
    const double z72 = z21 * (y3 * y1_dot - z17 * z70 - z19 * z71);
    const double z73 = z14 * z71 - z19 * z72;
    const double z74 = y1_ * y2_dot;
    const double z75 = y2 * y2_dot - z12 * z74;
    const double z76 = z21 * (y3 * y2_dot - z17 * z74 - z19 * z75);
    const double z77 = z14 * z75 - z19 * z76;
    const double z78 = y1_ * y3_dot;
    const double z79 = y2 * y3_dot - z12 * z78;
    const double z80 = z21 * (y3 * y3_dot - z17 * z78 - z19 * z79);
    const double z81 = z14 * z79 - z19 * z80;
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
    J[92] = -(1.0 + z8);
    J[95] = -2.0 * (y1_ * z1);
    J[106] = -(1.0 + z9);
    J[109] = -2.0 * (y2 * z2);
    J[120] = -(1.0 + z3 * z3);
    J[123] = -2.0 * (y3 * z3);
    J[130] = y1_ * z10 - z12 * z23 - z17 * z22;
    J[131] = z10 * z36 - z12 * z39 - z17 * z38;
    J[132] = z10 * z40 - z12 * z44 - z17 * z43;
    J[133] = z10 * z45 - z12 * z48 - z17 * z47;
    J[134] = -(z10 * z27 - z12 * z52 + z17 * z51);
    J[135] = -(2.0 * (z10 * z49) + z12 * z55 + z17 * z54);
    J[136] = z17 * z56 - z12 * z57;
    J[137] = z17 * z60 - (z58 * z10 - z12 * z61);
    J[138] = z17 * z64 - (z10 * z62 - z12 * z65);
    J[139] = z17 * z68 - (z10 * z66 - z12 * z69);
    J[140] = z17 * z72 - (z10 * z70 - z12 * z73);
    J[141] = z17 * z76 - (z10 * z74 - z12 * z77);
    J[142] = z17 * z80 - (z10 * z78 - z12 * z81);
    J[143] = z23;
    J[144] = z39;
    J[145] = z44;
    J[146] = z48;
    J[147] = -z52;
    J[148] = z55;
    J[149] = z57;
    J[150] = -z61;
    J[151] = -z65;
    J[152] = -z69;
    J[153] = -z73;
    J[154] = -z77;
    J[155] = -z81;
    J[156] = z22;
    J[157] = z38;
    J[158] = z43;
    J[159] = z47;
    J[160] = z51;
    J[161] = z54;
    J[162] = -z56;
    J[163] = -z60;
    J[164] = -z64;
    J[165] = -z68;
    J[166] = -z72;
    J[167] = -z76;
    J[168] = -z80;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[92] + J[95] + J[106] + J[109] + J[120] + J[123] + J[130] + J[131] + J[132] + J[133] + J[134]
        + J[135] + J[136] + J[137] + J[138] + J[139] + J[140] + J[141] + J[142] + J[147] + J[150] + J[151] +
        J[152] + J[153] + J[154] + J[155] + J[162] + J[163] + J[164] + J[165] + J[166] + J[167] + J[168]) <=
        DBL_MAX)) {
        /* the mass matrix is singular */
        if (!(fabs(z7) > 0.0)) {
            return chaotic_refuse(fabs(z7), 0.0, CHAOTIC_SINGULAR_2);
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
    /* (III.3) */
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
