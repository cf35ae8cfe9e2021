/*
 * heavy_top_quaternion.c: heavy_top_quaternion, emitted by nhc 0.1.0 (nhc:eb46579a75db225a)
 * The symmetric top with a fixed point (Lagrange's top), its orientation a quaternion, so that it may stand
 *     upright.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: angular velocities and quasi-velocities of the spec
 * heavy_top_quaternion.h says what each function does.
 */
#include "heavy_top_quaternion.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const heavy_top_quaternion_coordinate_names[HEAVY_TOP_QUATERNION_NQ] = {
    "R_0",
    "R_1",
    "R_2",
    "R_3"
};
const char *const heavy_top_quaternion_state_names[HEAVY_TOP_QUATERNION_NY] = {
    "R_0",
    "R_1",
    "R_2",
    "R_3",
    "w1",
    "w2",
    "w3"
};
const char *const heavy_top_quaternion_parameter_names[HEAVY_TOP_QUATERNION_NP] = {
    "I1",
    "I3",
    "mgl"
};
const char *const heavy_top_quaternion_constraint_names[HEAVY_TOP_QUATERNION_NC] = {
    "R_norm"
};
const char *const heavy_top_quaternion_output_names[HEAVY_TOP_QUATERNION_NOUT] = {
    "height",
    "L_z"
};
const double heavy_top_quaternion_parameter_defaults[HEAVY_TOP_QUATERNION_NP] = {
    1.0,
    1.5,
    2.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define HEAVY_TOP_QUATERNION_SLOW __attribute__((cold, optimize("O1")))
#else
#define HEAVY_TOP_QUATERNION_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int heavy_top_quaternion_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return HEAVY_TOP_QUATERNION_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return HEAVY_TOP_QUATERNION_NOT_FINITE;
        }
    }
    return HEAVY_TOP_QUATERNION_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int heavy_top_quaternion_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : HEAVY_TOP_QUATERNION_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef HEAVY_TOP_QUATERNION_LANES
#if !defined(__GNUC__)
#define HEAVY_TOP_QUATERNION_LANES 1
#elif defined(__AVX512F__)
#define HEAVY_TOP_QUATERNION_LANES 8
#elif defined(__AVX__)
#define HEAVY_TOP_QUATERNION_LANES 4
#else
#define HEAVY_TOP_QUATERNION_LANES 2
#endif
#endif
#if HEAVY_TOP_QUATERNION_LANES > 1
typedef double heavy_top_quaternion_lanes __attribute__((vector_size(8 * HEAVY_TOP_QUATERNION_LANES)));
#else
typedef double heavy_top_quaternion_lanes;
#endif

#if HEAVY_TOP_QUATERNION_LANES >= 2
static inline heavy_top_quaternion_lanes heavy_top_quaternion_get(const double *from)
{
    heavy_top_quaternion_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void heavy_top_quaternion_put(double *to, heavy_top_quaternion_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int heavy_top_quaternion_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = HEAVY_TOP_QUATERNION_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[HEAVY_TOP_QUATERNION_NY];
        double slope[HEAVY_TOP_QUATERNION_NY];
        for (size_t k = 0; k < HEAVY_TOP_QUATERNION_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = heavy_top_quaternion_rhs(t[i], state, p, slope);
        status = status == HEAVY_TOP_QUATERNION_OK ? one : status;
        for (size_t k = 0; k < HEAVY_TOP_QUATERNION_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if HEAVY_TOP_QUATERNION_LANES >= 2
#define HEAVY_TOP_QUATERNION_SPREAD(x) ((x) - (heavy_top_quaternion_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long heavy_top_quaternion_bits __attribute__((vector_size(8 * HEAVY_TOP_QUATERNION_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline heavy_top_quaternion_lanes heavy_top_quaternion_mark(heavy_top_quaternion_lanes value, heavy_top_quaternion_bits bad)
{
    return (heavy_top_quaternion_lanes)((heavy_top_quaternion_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int heavy_top_quaternion_is_good(int count, const double *check)
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
static inline void heavy_top_quaternion_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < HEAVY_TOP_QUATERNION_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < HEAVY_TOP_QUATERNION_NY; ++k) {
            state[k * HEAVY_TOP_QUATERNION_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void heavy_top_quaternion_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < HEAVY_TOP_QUATERNION_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * HEAVY_TOP_QUATERNION_LANES + l];
        }
    }
}
#endif

int heavy_top_quaternion_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the parameters alone */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double k1 = I1 - I3;
    const double k2 = 1.0 / I1;

    /* from the state */
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */
    const double z1 = mgl * (2.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1))));
    const double w3 = y[6]; /* [rad/s] */
    const double z2 = w3 * k1;
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    /* (I.2.4) */
    dydt[0] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    dydt[1] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    dydt[2] = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5; /* R_2' */
    dydt[3] = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)); /* R_3' */
    /* (I.2.15) 12:4 */
    dydt[4] = k2 * (z1 * (R_0 * R_1 + R_2 * R_3) + w2 * z2); /* w1' */
    dydt[5] = k2 * (z1 * (R_0 * R_2 - R_1 * R_3) - w1 * z2); /* w2' */
    dydt[6] = 0.0; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(I3) > 0.0 * (dydt[0] + dydt[1] + dydt[2] + dydt[3] + dydt[4] + dydt[5]))) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I1), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I3), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        return heavy_top_quaternion_finish(7, dydt);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

int heavy_top_quaternion_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    const double w3 = y[6]; /* [rad/s] */
    /* (I.2.4) */
    qdot[0] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    qdot[1] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    qdot[2] = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5; /* R_2' */
    qdot[3] = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)); /* R_3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3]) <= DBL_MAX)) {
        return heavy_top_quaternion_finish(4, qdot);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

int heavy_top_quaternion_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the parameters alone */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double k1 = 1.0 / I1;
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double k2 = 1.0 - I3 * k1;
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */
    const double k3 = mgl * k1;

    /* from the state */
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    const double w3 = y[6]; /* [rad/s] */
    const double z1 = 0.25 * (w3 * w3 + (w1 * w1 + w2 * w2));
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double z2 = R_1 * R_1 + R_2 * R_2;
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double z3 = R_0 * R_0 + R_3 * R_3;
    const double z4 = k3 / (z2 + z3);
    const double z5 = z1 + z2 * z4;
    const double z6 = w3 * k2;
    const double z7 = z1 - z3 * z4;
    /* (I.2.15) */
    qddot[0] = 0.5 * ((R_2 * w1 - R_1 * w2) * z6) - R_0 * z5; /* R_0'' */
    qddot[1] = 0.5 * ((R_3 * w1 + R_0 * w2) * z6) - R_1 * z7; /* R_1'' */
    qddot[2] = -(R_2 * z7 + 0.5 * ((R_0 * w1 - R_3 * w2) * z6)); /* R_2'' */
    qddot[3] = -(R_3 * z5 + 0.5 * ((R_1 * w1 + R_2 * w2) * z6)); /* R_3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(I3) > 0.0 * (qddot[0] + qddot[1] + qddot[2] + qddot[3]))) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I1), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I3), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        return heavy_top_quaternion_finish(4, qddot);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

int heavy_top_quaternion_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double R_0 = q[0]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[1]; /* quaternion of R, along x [1] */
    const double R_2 = q[2]; /* quaternion of R, along y [1] */
    const double R_3 = q[3]; /* quaternion of R, along z [1] */
    const double z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double z2 = R_0 * z1;
    const double z3 = R_1 * z1;
    const double z4 = R_3 * z1;
    const double z5 = R_2 * z1;
    y[0] = R_0;
    y[1] = R_1;
    y[2] = R_2;
    y[3] = R_3;
    const double R_0_dot = qdot[0]; /* R_0' [1/s] */
    const double R_1_dot = qdot[1]; /* R_1' [1/s] */
    const double R_2_dot = qdot[2]; /* R_2' [1/s] */
    const double R_3_dot = qdot[3]; /* R_3' [1/s] */
    y[4] = 2.0 * (R_1_dot * z2 - R_0_dot * z3 + (R_2_dot * z4 - R_3_dot * z5));
    y[5] = 2.0 * (R_2_dot * z2 - R_0_dot * z5 + (R_3_dot * z3 - R_1_dot * z4));
    y[6] = 2.0 * (R_3_dot * z2 - R_0_dot * z4 + (R_1_dot * z5 - R_2_dot * z3));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[4] + y[5] + y[6]) <= DBL_MAX)) {
        return heavy_top_quaternion_finish(7, y);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

int heavy_top_quaternion_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double R_0 = q[0]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[1]; /* quaternion of R, along x [1] */
    const double R_2 = q[2]; /* quaternion of R, along y [1] */
    const double R_3 = q[3]; /* quaternion of R, along z [1] */
    const double R_0_dot = qdot[0]; /* R_0' [1/s] */
    const double R_1_dot = qdot[1]; /* R_1' [1/s] */
    const double R_2_dot = qdot[2]; /* R_2' [1/s] */
    const double R_3_dot = qdot[3]; /* R_3' [1/s] */
    /* (I.1.1) 7:3 */
    r[0] = 2.0 * (R_3 * R_3_dot + (R_2 * R_2_dot + (R_0 * R_0_dot + R_1 * R_1_dot))); /* R_norm = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return heavy_top_quaternion_finish(1, r);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

int heavy_top_quaternion_positions(double t, const double *q, const double *p, double *f)
{
    (void)t;
    (void)p;

    /* from the coordinates */
    const double R_0 = q[0]; /* quaternion of R, scalar part [1] */
    const double R_1 = q[1]; /* quaternion of R, along x [1] */
    const double R_2 = q[2]; /* quaternion of R, along y [1] */
    const double R_3 = q[3]; /* quaternion of R, along z [1] */
    /* 7:3 */
    f[0] = R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)) - 1.0; /* R_norm = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(f[0]) <= DBL_MAX)) {
        return heavy_top_quaternion_finish(1, f);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

int heavy_top_quaternion_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;

    /* from the state */
    /* (I.4.1) 7:3 */
    lambda[0] = 0.0; /* reaction of R_norm: Q_i gains lambda_1 a_1i */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    if (!(fabs(I1 * I3) > 0.0)) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I1), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I3), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        return heavy_top_quaternion_finish(1, lambda);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

double heavy_top_quaternion_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double z1 = R_1 * R_1 + R_2 * R_2;
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    const double w3 = y[6]; /* [rad/s] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */
    const double z2 = 0.5 * (I1 * (w1 * w1 + w2 * w2) + I3 * (w3 * w3)) + mgl * (1.0 - 2.0 * (z1 / (z1 + (R_0
        * R_0 + R_3 * R_3))));
    return z2;
}

HEAVY_TOP_QUATERNION_SLOW
int heavy_top_quaternion_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 49 * sizeof *J);
    (void)t;

    /* from the parameters alone */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double k1 = 1.0 / I1;
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double k2 = (I1 - I3) * k1;

    /* from the state */
    const double w1 = y[4]; /* [rad/s] */
    const double z1 = 0.5 * w1;
    const double w2 = y[5]; /* [rad/s] */
    const double z2 = 0.5 * w2;
    const double w3 = y[6]; /* [rad/s] */
    const double z3 = 0.5 * w3;
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double z4 = 0.5 * R_1;
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double z5 = 0.5 * R_2;
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double z6 = 0.5 * R_3;
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    const double z7 = 0.5 * R_0;
    const double z8 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */
    const double z9 = mgl * z8;
    const double z10 = 2.0 * (R_1 * z9);
    const double z11 = mgl * (z8 * z8);
    const double z12 = (R_0 * R_1 + R_2 * R_3) * z11;
    const double z13 = 2.0 * (R_0 * z9);
    const double z14 = 2.0 * (R_3 * z9);
    const double z15 = 2.0 * (R_2 * z9);
    const double z16 = w3 * k2;
    const double z17 = (R_0 * R_2 - R_1 * R_3) * z11;
    /* (I.2.15) */
    J[1] = -z1;
    J[2] = -z2;
    J[3] = -z3;
    J[4] = -z4;
    J[5] = -z5;
    J[6] = -z6;
    J[7] = z1;
    J[9] = z3;
    J[10] = -z2;
    J[11] = z7;
    J[12] = -z6;
    J[13] = z5;
    J[14] = z2;
    J[15] = -z3;
    J[17] = z1;
    J[18] = z6;
    J[19] = z7;
    J[20] = -z4;
    J[21] = z3;
    J[22] = z2;
    J[23] = -z1;
    J[25] = -z5;
    J[26] = z4;
    J[27] = z7;
    J[28] = k1 * (z10 - 4.0 * (R_0 * z12));
    J[29] = k1 * (z13 - 4.0 * (R_1 * z12));
    J[30] = k1 * (z14 - 4.0 * (R_2 * z12));
    J[31] = k1 * (z15 - 4.0 * (R_3 * z12));
    J[33] = z16;
    J[34] = w2 * k2;
    J[35] = k1 * (z15 - 4.0 * (R_0 * z17));
    J[36] = -k1 * (z14 + 4.0 * (R_1 * z17));
    J[37] = k1 * (z13 - 4.0 * (R_2 * z17));
    J[38] = -k1 * (z10 + 4.0 * (R_3 * z17));
    J[39] = -z16;
    J[41] = -w1 * k2;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(I3) > 0.0 * (J[10] + J[11] + J[12] + J[15] + J[20] + J[23] + J[25] + J[28] + J[29] + J[30] +
        J[31] + J[34] + J[35] + J[36] + J[37] + J[38] + J[39] + J[41]))) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I1), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return heavy_top_quaternion_refuse(fabs(I3), 0.0, HEAVY_TOP_QUATERNION_SINGULAR_2);
        }
        return heavy_top_quaternion_finish(49, J);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

int heavy_top_quaternion_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;

    /* from the state */
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double z1 = R_1 * R_1 + R_2 * R_2;
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double z2 = 1.0 / (z1 + (R_0 * R_0 + R_3 * R_3));
    const double w3 = y[6]; /* [rad/s] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double z3 = I3 * w3;
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double z4 = I1 * (R_0 * (R_2 * w1 - R_1 * w2) - R_3 * (R_1 * w1 + R_2 * w2)) + z3 * z1;
    /* 15:11 */
    out[0] = 1.0 - 2.0 * (z1 * z2); /* height */
    /* 16:8 */
    out[1] = z3 - 2.0 * (z2 * z4); /* L_z */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return heavy_top_quaternion_finish(2, out);
    }
    return HEAVY_TOP_QUATERNION_OK;
}

#if HEAVY_TOP_QUATERNION_LANES >= 2
static __attribute__((noinline)) void heavy_top_quaternion_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    heavy_top_quaternion_lanes far = {0}; /* the squares of the angles */
    heavy_top_quaternion_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    heavy_top_quaternion_bits bad = {0}; /* singular blocks */
    const double mgl = fixed[0];
    const double k1 = fixed[1];
    const double k2 = fixed[2];
    const heavy_top_quaternion_lanes R_0 = heavy_top_quaternion_get(y);
    const heavy_top_quaternion_lanes R_1 = heavy_top_quaternion_get(y + 1 * stride);
    const heavy_top_quaternion_lanes R_2 = heavy_top_quaternion_get(y + 2 * stride);
    const heavy_top_quaternion_lanes R_3 = heavy_top_quaternion_get(y + 3 * stride);
    const heavy_top_quaternion_lanes w1 = heavy_top_quaternion_get(y + 4 * stride);
    const heavy_top_quaternion_lanes w2 = heavy_top_quaternion_get(y + 5 * stride);
    const heavy_top_quaternion_lanes w3 = heavy_top_quaternion_get(y + 6 * stride);
    const heavy_top_quaternion_lanes z1 = mgl * (2.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1))));
    const heavy_top_quaternion_lanes z2 = w3 * k1;
    /* (I.2.4) */
    const heavy_top_quaternion_lanes slope1 = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2));
    sum += slope1;
    heavy_top_quaternion_put(dydt, slope1);
    const heavy_top_quaternion_lanes slope2 = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2));
    sum += slope2;
    heavy_top_quaternion_put(dydt + 1 * stride, slope2);
    const heavy_top_quaternion_lanes slope3 = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5;
    sum += slope3;
    heavy_top_quaternion_put(dydt + 2 * stride, slope3);
    const heavy_top_quaternion_lanes slope4 = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2));
    sum += slope4;
    heavy_top_quaternion_put(dydt + 3 * stride, slope4);
    /* (I.2.15) 12:4 */
    const heavy_top_quaternion_lanes slope5 = k2 * (z1 * (R_0 * R_1 + R_2 * R_3) + w2 * z2);
    sum += slope5;
    heavy_top_quaternion_put(dydt + 4 * stride, slope5);
    const heavy_top_quaternion_lanes slope6 = k2 * (z1 * (R_0 * R_2 - R_1 * R_3) - w1 * z2);
    sum += slope6;
    heavy_top_quaternion_put(dydt + 5 * stride, slope6);
    const heavy_top_quaternion_lanes slope7 = HEAVY_TOP_QUATERNION_SPREAD(0.0);
    heavy_top_quaternion_put(dydt + 6 * stride, slope7);
    heavy_top_quaternion_put(check, heavy_top_quaternion_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void heavy_top_quaternion_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[HEAVY_TOP_QUATERNION_LANES];
    double state[7 * HEAVY_TOP_QUATERNION_LANES];
    double slope[7 * HEAVY_TOP_QUATERNION_LANES];
    heavy_top_quaternion_fill(left, count, t, y, time, state);
    heavy_top_quaternion_rhs_lanes(fixed, HEAVY_TOP_QUATERNION_LANES, time, state, slope, check);
    heavy_top_quaternion_pour(left, count, slope, dydt);
}
#endif

int heavy_top_quaternion_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if HEAVY_TOP_QUATERNION_LANES >= 2
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */
    const double k1 = I1 - I3;
    const double k2 = 1.0 / I1;
    /* the mass matrix is singular, if I3 is 0 */
    if (!(fabs(I3) > 0.0)) {
        return heavy_top_quaternion_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {mgl, k1, k2};
    double check[1 * HEAVY_TOP_QUATERNION_LANES];
    int status = HEAVY_TOP_QUATERNION_OK;
    for (size_t i = 0; i < count; i += HEAVY_TOP_QUATERNION_LANES) {
        const size_t left = count - i < HEAVY_TOP_QUATERNION_LANES ? count - i : HEAVY_TOP_QUATERNION_LANES;
        if (left == HEAVY_TOP_QUATERNION_LANES) {
            heavy_top_quaternion_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            heavy_top_quaternion_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!heavy_top_quaternion_is_good(1 * HEAVY_TOP_QUATERNION_LANES, check)) {
            const int one = heavy_top_quaternion_one_by_one(count, i, left, t, y, p, dydt);
            status = status == HEAVY_TOP_QUATERNION_OK ? one : status;
        }
    }
    return status;
#else
    return heavy_top_quaternion_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
