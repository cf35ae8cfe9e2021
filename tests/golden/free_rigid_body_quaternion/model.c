/*
 * free_rigid_body_quaternion.c: free_rigid_body_quaternion, emitted by nhc 0.1.0 (nhc:27a5230300325600)
 * A free rigid body, its orientation a quaternion; Euler's equations, and no orientation that is special.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: angular velocities and quasi-velocities of the spec
 * free_rigid_body_quaternion.h says what each function does.
 */
#include "free_rigid_body_quaternion.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const free_rigid_body_quaternion_coordinate_names[FREE_RIGID_BODY_QUATERNION_NQ] = {
    "R_0",
    "R_1",
    "R_2",
    "R_3"
};
const char *const free_rigid_body_quaternion_state_names[FREE_RIGID_BODY_QUATERNION_NY] = {
    "R_0",
    "R_1",
    "R_2",
    "R_3",
    "w1",
    "w2",
    "w3"
};
const char *const free_rigid_body_quaternion_parameter_names[FREE_RIGID_BODY_QUATERNION_NP] = {
    "I1",
    "I2",
    "I3"
};
const char *const free_rigid_body_quaternion_constraint_names[FREE_RIGID_BODY_QUATERNION_NC] = {
    "R_norm"
};
const char *const free_rigid_body_quaternion_output_names[FREE_RIGID_BODY_QUATERNION_NOUT] = {
    "L_x",
    "L_y",
    "L_z"
};
const double free_rigid_body_quaternion_parameter_defaults[FREE_RIGID_BODY_QUATERNION_NP] = {
    1.0,
    2.0,
    3.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define FREE_RIGID_BODY_QUATERNION_SLOW __attribute__((cold, optimize("O1")))
#else
#define FREE_RIGID_BODY_QUATERNION_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int free_rigid_body_quaternion_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return FREE_RIGID_BODY_QUATERNION_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return FREE_RIGID_BODY_QUATERNION_NOT_FINITE;
        }
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int free_rigid_body_quaternion_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : FREE_RIGID_BODY_QUATERNION_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef FREE_RIGID_BODY_QUATERNION_LANES
#if !defined(__GNUC__)
#define FREE_RIGID_BODY_QUATERNION_LANES 1
#elif defined(__AVX512F__)
#define FREE_RIGID_BODY_QUATERNION_LANES 8
#elif defined(__AVX__)
#define FREE_RIGID_BODY_QUATERNION_LANES 4
#else
#define FREE_RIGID_BODY_QUATERNION_LANES 2
#endif
#endif
#if FREE_RIGID_BODY_QUATERNION_LANES > 1
typedef double free_rigid_body_quaternion_lanes __attribute__((vector_size(8 * FREE_RIGID_BODY_QUATERNION_LANES)));
#else
typedef double free_rigid_body_quaternion_lanes;
#endif

#if FREE_RIGID_BODY_QUATERNION_LANES >= 2
static inline free_rigid_body_quaternion_lanes free_rigid_body_quaternion_get(const double *from)
{
    free_rigid_body_quaternion_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void free_rigid_body_quaternion_put(double *to, free_rigid_body_quaternion_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int free_rigid_body_quaternion_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = FREE_RIGID_BODY_QUATERNION_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[FREE_RIGID_BODY_QUATERNION_NY];
        double slope[FREE_RIGID_BODY_QUATERNION_NY];
        for (size_t k = 0; k < FREE_RIGID_BODY_QUATERNION_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = free_rigid_body_quaternion_rhs(t[i], state, p, slope);
        status = status == FREE_RIGID_BODY_QUATERNION_OK ? one : status;
        for (size_t k = 0; k < FREE_RIGID_BODY_QUATERNION_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if FREE_RIGID_BODY_QUATERNION_LANES >= 2
#define FREE_RIGID_BODY_QUATERNION_SPREAD(x) ((x) - (free_rigid_body_quaternion_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long free_rigid_body_quaternion_bits __attribute__((vector_size(8 * FREE_RIGID_BODY_QUATERNION_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline free_rigid_body_quaternion_lanes free_rigid_body_quaternion_mark(free_rigid_body_quaternion_lanes value, free_rigid_body_quaternion_bits bad)
{
    return (free_rigid_body_quaternion_lanes)((free_rigid_body_quaternion_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int free_rigid_body_quaternion_is_good(int count, const double *check)
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
static inline void free_rigid_body_quaternion_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < FREE_RIGID_BODY_QUATERNION_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < FREE_RIGID_BODY_QUATERNION_NY; ++k) {
            state[k * FREE_RIGID_BODY_QUATERNION_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void free_rigid_body_quaternion_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < FREE_RIGID_BODY_QUATERNION_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * FREE_RIGID_BODY_QUATERNION_LANES + l];
        }
    }
}
#endif

int free_rigid_body_quaternion_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;

    /* from the parameters alone */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = (I2 - I3) / I1;
    const double k2 = -(I1 - I3) / I2;
    const double k3 = (I1 - I2) / I3;

    /* from the state */
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    const double w3 = y[6]; /* [rad/s] */
    /* (I.2.4) */
    dydt[0] = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)); /* R_0' */
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    dydt[1] = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)); /* R_1' */
    dydt[2] = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5; /* R_2' */
    dydt[3] = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)); /* R_3' */
    /* (I.2.15) 12:4 */
    dydt[4] = w2 * w3 * k1; /* w1' */
    dydt[5] = w1 * w3 * k2; /* w2' */
    dydt[6] = w1 * w2 * k3; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[3] + dydt[4] + dydt[5] + dydt[6]) <= DBL_MAX)) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I2 is 0 */
        if (!(fabs(I2) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        return free_rigid_body_quaternion_finish(7, dydt);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

int free_rigid_body_quaternion_velocities(double t, const double *y, const double *p, double *qdot)
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
        return free_rigid_body_quaternion_finish(4, qdot);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

int free_rigid_body_quaternion_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;

    /* from the parameters alone */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = I2 - I3;
    const double I1 = p[0]; /* [kg*m^2] */
    const double k2 = I1 - I3;
    const double k3 = 1.0 / I1;
    const double k4 = 1.0 / I2;
    const double k5 = (I1 - I2) / I3;

    /* from the state */
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    const double w3 = y[6]; /* [rad/s] */
    const double z1 = w3 * w3 + (w1 * w1 + w2 * w2);
    const double z2 = k4 * (w3 * k2);
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double z3 = R_3 * w2;
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double z4 = R_1 * w2;
    const double z5 = k3 * (w3 * k1);
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double z6 = R_2 * w2;
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    const double z7 = R_0 * w2;
    /* (I.2.15) */
    qddot[0] = (2.0 * (w1 * (R_2 * z2 - z3 * k5) - z4 * z5) - R_0 * z1) * 0.25; /* R_0'' */
    qddot[1] = (2.0 * (w1 * (z6 * k5 + R_3 * z2) + z7 * z5) - R_1 * z1) * 0.25; /* R_1'' */
    qddot[2] = -0.25 * (R_2 * z1 + 2.0 * (w1 * (R_0 * z2 + z4 * k5) - z3 * z5)); /* R_2'' */
    qddot[3] = (2.0 * (w1 * (z7 * k5 - R_1 * z2) - z6 * z5) - R_3 * z1) * 0.25; /* R_3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3]) <= DBL_MAX)) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I2 is 0 */
        if (!(fabs(I2) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        return free_rigid_body_quaternion_finish(4, qddot);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

int free_rigid_body_quaternion_state(double t, const double *q, const double *qdot, const double *p,
    double *y)
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
        return free_rigid_body_quaternion_finish(7, y);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

int free_rigid_body_quaternion_residuals(double t, const double *q, const double *qdot, const double *p,
    double *r)
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
        return free_rigid_body_quaternion_finish(1, r);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

int free_rigid_body_quaternion_positions(double t, const double *q, const double *p, double *f)
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
        return free_rigid_body_quaternion_finish(1, f);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

int free_rigid_body_quaternion_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;

    /* from the state */
    /* (I.4.1) 7:3 */
    lambda[0] = 0.0; /* reaction of R_norm: Q_i gains lambda_1 a_1i */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    if (!(fabs(I1 * I2 * I3) > 0.0)) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I2 is 0 */
        if (!(fabs(I2) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        return free_rigid_body_quaternion_finish(1, lambda);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

double free_rigid_body_quaternion_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double w1 = y[4]; /* [rad/s] */
    const double w2 = y[5]; /* [rad/s] */
    const double w3 = y[6]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    return 0.5 * (I1 * (w1 * w1) + I2 * (w2 * w2) + I3 * (w3 * w3));
}

FREE_RIGID_BODY_QUATERNION_SLOW
int free_rigid_body_quaternion_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 49 * sizeof *J);
    (void)t;

    /* from the parameters alone */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = (I2 - I3) / I1;
    const double k2 = -(I1 - I3) / I2;
    const double k3 = (I1 - I2) / I3;

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
    J[33] = w3 * k1;
    J[34] = w2 * k1;
    J[39] = w3 * k2;
    J[41] = w1 * k2;
    J[46] = w2 * k3;
    J[47] = w1 * k3;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[10] + J[11] + J[12] + J[15] + J[20] + J[23] + J[25] + J[33] + J[34] + J[39] + J[41] + J[46]
        + J[47]) <= DBL_MAX)) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I2 is 0 */
        if (!(fabs(I2) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return free_rigid_body_quaternion_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_QUATERNION_SINGULAR_2);
        }
        return free_rigid_body_quaternion_finish(49, J);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

int free_rigid_body_quaternion_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;

    /* from the state */
    const double w1 = y[4]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double z1 = I1 * w1;
    const double R_0 = y[0]; /* quaternion of R, scalar part [1] */
    const double R_1 = y[1]; /* quaternion of R, along x [1] */
    const double R_2 = y[2]; /* quaternion of R, along y [1] */
    const double R_3 = y[3]; /* quaternion of R, along z [1] */
    const double z2 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)));
    const double w3 = y[6]; /* [rad/s] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double z3 = I3 * w3;
    const double w2 = y[5]; /* [rad/s] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double z4 = I2 * w2;
    const double z5 = R_2 * z1 - (R_0 * z3 + R_1 * z4);
    const double z6 = R_3 * z1 + (R_0 * z4 - R_1 * z3);
    const double z7 = R_3 * z4 - (R_0 * z1 + R_2 * z3);
    /* 14:8 */
    out[0] = z1 - 2.0 * (z2 * (R_2 * z5 + R_3 * z6)); /* L_x */
    /* 15:8 */
    out[1] = z4 + 2.0 * (z2 * (R_1 * z5 - R_3 * z7)); /* L_y */
    /* 16:8 */
    out[2] = z3 + 2.0 * (z2 * (R_1 * z6 + R_2 * z7)); /* L_z */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1] + out[2]) <= DBL_MAX)) {
        return free_rigid_body_quaternion_finish(3, out);
    }
    return FREE_RIGID_BODY_QUATERNION_OK;
}

#if FREE_RIGID_BODY_QUATERNION_LANES >= 2
static __attribute__((noinline)) void free_rigid_body_quaternion_rhs_lanes(const double *fixed,
    size_t stride, const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    free_rigid_body_quaternion_lanes far = {0}; /* the squares of the angles */
    free_rigid_body_quaternion_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    free_rigid_body_quaternion_bits bad = {0}; /* singular blocks */
    const double k1 = fixed[0];
    const double k2 = fixed[1];
    const double k3 = fixed[2];
    const free_rigid_body_quaternion_lanes R_0 = free_rigid_body_quaternion_get(y);
    const free_rigid_body_quaternion_lanes R_1 = free_rigid_body_quaternion_get(y + 1 * stride);
    const free_rigid_body_quaternion_lanes R_2 = free_rigid_body_quaternion_get(y + 2 * stride);
    const free_rigid_body_quaternion_lanes R_3 = free_rigid_body_quaternion_get(y + 3 * stride);
    const free_rigid_body_quaternion_lanes w1 = free_rigid_body_quaternion_get(y + 4 * stride);
    const free_rigid_body_quaternion_lanes w2 = free_rigid_body_quaternion_get(y + 5 * stride);
    const free_rigid_body_quaternion_lanes w3 = free_rigid_body_quaternion_get(y + 6 * stride);
    /* (I.2.4) */
    const free_rigid_body_quaternion_lanes slope1 = -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2));
    sum += slope1;
    free_rigid_body_quaternion_put(dydt, slope1);
    const free_rigid_body_quaternion_lanes slope2 = 0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2));
    sum += slope2;
    free_rigid_body_quaternion_put(dydt + 1 * stride, slope2);
    const free_rigid_body_quaternion_lanes slope3 = (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5;
    sum += slope3;
    free_rigid_body_quaternion_put(dydt + 2 * stride, slope3);
    const free_rigid_body_quaternion_lanes slope4 = 0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2));
    sum += slope4;
    free_rigid_body_quaternion_put(dydt + 3 * stride, slope4);
    /* (I.2.15) 12:4 */
    const free_rigid_body_quaternion_lanes slope5 = w2 * w3 * k1;
    sum += slope5;
    free_rigid_body_quaternion_put(dydt + 4 * stride, slope5);
    const free_rigid_body_quaternion_lanes slope6 = w1 * w3 * k2;
    sum += slope6;
    free_rigid_body_quaternion_put(dydt + 5 * stride, slope6);
    const free_rigid_body_quaternion_lanes slope7 = w1 * w2 * k3;
    sum += slope7;
    free_rigid_body_quaternion_put(dydt + 6 * stride, slope7);
    free_rigid_body_quaternion_put(check, free_rigid_body_quaternion_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void free_rigid_body_quaternion_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[FREE_RIGID_BODY_QUATERNION_LANES];
    double state[7 * FREE_RIGID_BODY_QUATERNION_LANES];
    double slope[7 * FREE_RIGID_BODY_QUATERNION_LANES];
    free_rigid_body_quaternion_fill(left, count, t, y, time, state);
    free_rigid_body_quaternion_rhs_lanes(fixed, FREE_RIGID_BODY_QUATERNION_LANES, time, state, slope, check);
    free_rigid_body_quaternion_pour(left, count, slope, dydt);
}
#endif

int free_rigid_body_quaternion_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if FREE_RIGID_BODY_QUATERNION_LANES >= 2
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = (I2 - I3) / I1;
    const double k2 = -(I1 - I3) / I2;
    const double k3 = (I1 - I2) / I3;
    const double fixed[] = {k1, k2, k3};
    double check[1 * FREE_RIGID_BODY_QUATERNION_LANES];
    int status = FREE_RIGID_BODY_QUATERNION_OK;
    for (size_t i = 0; i < count; i += FREE_RIGID_BODY_QUATERNION_LANES) {
        const size_t left = count - i < FREE_RIGID_BODY_QUATERNION_LANES ? count - i : FREE_RIGID_BODY_QUATERNION_LANES;
        if (left == FREE_RIGID_BODY_QUATERNION_LANES) {
            free_rigid_body_quaternion_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            free_rigid_body_quaternion_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!free_rigid_body_quaternion_is_good(1 * FREE_RIGID_BODY_QUATERNION_LANES, check)) {
            const int one = free_rigid_body_quaternion_one_by_one(count, i, left, t, y, p, dydt);
            status = status == FREE_RIGID_BODY_QUATERNION_OK ? one : status;
        }
    }
    return status;
#else
    return free_rigid_body_quaternion_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
