/*
 * disk_chain2.c: disk_chain2, emitted by nhc 0.1.0 (nhc:58afc0e113b377d5)
 * Two upright rolling disks joined by a spring; the first link of a chain that may be made as long as one
 *     likes.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinates `x1`, `y1`, `x2`, `y2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `x1` contains the
 *     dependent coordinate `x2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `y1` contains the
 *     dependent coordinate `y2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `x2` contains the
 *     dependent coordinate `x1`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `y2` contains the
 *     dependent coordinate `y1`
 * disk_chain2.h says what each function does.
 */
#include "disk_chain2.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const disk_chain2_coordinate_names[DISK_CHAIN2_NQ] = {
    "x1",
    "y1",
    "phi1",
    "theta1",
    "x2",
    "y2",
    "phi2",
    "theta2"
};
const char *const disk_chain2_state_names[DISK_CHAIN2_NY] = {
    "x1",
    "y1",
    "phi1",
    "theta1",
    "x2",
    "y2",
    "phi2",
    "theta2",
    "phi1'",
    "theta1'",
    "phi2'",
    "theta2'"
};
const char *const disk_chain2_parameter_names[DISK_CHAIN2_NP] = {
    "m",
    "R",
    "I",
    "J",
    "k"
};
const char *const disk_chain2_constraint_names[DISK_CHAIN2_NC] = {
    "roll_x1",
    "roll_y1",
    "roll_x2",
    "roll_y2"
};
const char *const disk_chain2_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double disk_chain2_parameter_defaults[DISK_CHAIN2_NP] = {
    1.0,
    0.5,
    0.125,
    0.0625,
    1.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define DISK_CHAIN2_SLOW __attribute__((cold, optimize("O1")))
#else
#define DISK_CHAIN2_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int disk_chain2_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return DISK_CHAIN2_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return DISK_CHAIN2_NOT_FINITE;
        }
    }
    return DISK_CHAIN2_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int disk_chain2_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : DISK_CHAIN2_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef DISK_CHAIN2_LANES
#if !defined(__GNUC__)
#define DISK_CHAIN2_LANES 1
#elif defined(__AVX512F__)
#define DISK_CHAIN2_LANES 8
#elif defined(__AVX__)
#define DISK_CHAIN2_LANES 4
#else
#define DISK_CHAIN2_LANES 2
#endif
#endif
#if DISK_CHAIN2_LANES > 1
typedef double disk_chain2_lanes __attribute__((vector_size(8 * DISK_CHAIN2_LANES)));
#else
typedef double disk_chain2_lanes;
#endif

#if DISK_CHAIN2_LANES >= 2
static inline disk_chain2_lanes disk_chain2_get(const double *from)
{
    disk_chain2_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void disk_chain2_put(double *to, disk_chain2_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int disk_chain2_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = DISK_CHAIN2_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[DISK_CHAIN2_NY];
        double slope[DISK_CHAIN2_NY];
        for (size_t k = 0; k < DISK_CHAIN2_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = disk_chain2_rhs(t[i], state, p, slope);
        status = status == DISK_CHAIN2_OK ? one : status;
        for (size_t k = 0; k < DISK_CHAIN2_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if DISK_CHAIN2_LANES >= 2
#define DISK_CHAIN2_SPREAD(x) ((x) - (disk_chain2_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long disk_chain2_bits __attribute__((vector_size(8 * DISK_CHAIN2_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline disk_chain2_lanes disk_chain2_mark(disk_chain2_lanes value, disk_chain2_bits bad)
{
    return (disk_chain2_lanes)((disk_chain2_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int disk_chain2_is_good(int count, const double *check)
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
static inline void disk_chain2_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < DISK_CHAIN2_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < DISK_CHAIN2_NY; ++k) {
            state[k * DISK_CHAIN2_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void disk_chain2_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < DISK_CHAIN2_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * DISK_CHAIN2_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void disk_chain2_turn_lanes(disk_chain2_lanes x, disk_chain2_lanes *far,
    disk_chain2_lanes *sine, disk_chain2_lanes *cosine)
{
    double angle[DISK_CHAIN2_LANES];
    double up[DISK_CHAIN2_LANES];
    double along[DISK_CHAIN2_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < DISK_CHAIN2_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int disk_chain2_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double phi1 = y[2]; /* heading [rad] */
    const double phi2 = y[6]; /* heading [rad] */

    /* sines and cosines */
    const double c_phi1 = cos(phi1);
    const double s_phi1 = sin(phi1);
    const double c_phi2 = cos(phi2);
    const double s_phi2 = sin(phi2);

    /* what else is read */
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* y1: first disk [m] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi1_dot = y[8]; /* phi1' [rad/s] */
    const double theta1_dot = y[9]; /* theta1' [rad/s] */
    const double phi2_dot = y[10]; /* phi2' [rad/s] */
    const double theta2_dot = y[11]; /* theta2' [rad/s] */
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* from the parameters alone */
    const double k1 = I + m * (R * R);
    const double k2 = R * k / k1;

    /* from the state */
    const double v1_x1 = theta1_dot * R;
    const double v1_x2 = theta2_dot * R;
    const double z1 = x1 - x2;
    const double z2 = y1_ - y2;
    /* (I.1.2) */
    dydt[0] = c_phi1 * v1_x1; /* x1' */
    dydt[1] = s_phi1 * v1_x1; /* y1' */
    dydt[2] = phi1_dot; /* phi1' */
    dydt[3] = theta1_dot; /* theta1' */
    dydt[4] = c_phi2 * v1_x2; /* x2' */
    dydt[5] = s_phi2 * v1_x2; /* y2' */
    dydt[6] = phi2_dot; /* phi2' */
    dydt[7] = theta2_dot; /* theta2' */
    /* (III.3) 24:4 */
    dydt[8] = 0.0; /* phi1'' */
    dydt[9] = -(z1 * c_phi1 + z2 * s_phi1) * k2; /* theta1'' */
    dydt[10] = 0.0; /* phi2'' */
    dydt[11] = (z1 * c_phi2 + z2 * s_phi2) * k2; /* theta2'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J) > 0.0 * (dydt[0] + dydt[2] + dydt[4] + dydt[6] + dydt[9] + dydt[11]))) {
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return disk_chain2_refuse(fabs(J), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return disk_chain2_refuse(fabs(k1), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        return disk_chain2_finish(12, dydt);
    }
    return DISK_CHAIN2_OK;
}

int disk_chain2_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi1 = y[2]; /* heading [rad] */
    const double phi2 = y[6]; /* heading [rad] */

    /* sines and cosines */
    const double c_phi1 = cos(phi1);
    const double s_phi1 = sin(phi1);
    const double c_phi2 = cos(phi2);
    const double s_phi2 = sin(phi2);

    /* what else is read */
    const double phi1_dot = y[8]; /* phi1' [rad/s] */
    const double theta1_dot = y[9]; /* theta1' [rad/s] */
    const double phi2_dot = y[10]; /* phi2' [rad/s] */
    const double theta2_dot = y[11]; /* theta2' [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the state */
    const double v1_x1 = theta1_dot * R;
    const double v1_x2 = theta2_dot * R;
    /* (I.1.2) */
    qdot[0] = c_phi1 * v1_x1; /* x1' */
    qdot[1] = s_phi1 * v1_x1; /* y1' */
    qdot[2] = phi1_dot; /* phi1' */
    qdot[3] = theta1_dot; /* theta1' */
    qdot[4] = c_phi2 * v1_x2; /* x2' */
    qdot[5] = s_phi2 * v1_x2; /* y2' */
    qdot[6] = phi2_dot; /* phi2' */
    qdot[7] = theta2_dot; /* theta2' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[2] + qdot[4] + qdot[6]) <= DBL_MAX)) {
        return disk_chain2_finish(8, qdot);
    }
    return DISK_CHAIN2_OK;
}

int disk_chain2_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi1 = y[2]; /* heading [rad] */
    const double phi2 = y[6]; /* heading [rad] */

    /* sines and cosines */
    const double s_phi1 = sin(phi1);
    const double c_phi1 = cos(phi1);
    const double s_phi2 = sin(phi2);
    const double c_phi2 = cos(phi2);

    /* what else is read */
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* y1: first disk [m] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi1_dot = y[8]; /* phi1' [rad/s] */
    const double theta1_dot = y[9]; /* theta1' [rad/s] */
    const double phi2_dot = y[10]; /* phi2' [rad/s] */
    const double theta2_dot = y[11]; /* theta2' [rad/s] */
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* from the parameters alone */
    const double k1 = I + m * (R * R);
    const double k2 = R * k / k1;

    /* from the state */
    const double z1 = R * (phi1_dot * theta1_dot);
    const double z2 = x1 - x2;
    const double z3 = y1_ - y2;
    const double z4 = (z2 * c_phi1 + z3 * s_phi1) * k2;
    const double z5 = R * z4;
    const double z6 = R * (phi2_dot * theta2_dot);
    const double z7 = (z2 * c_phi2 + z3 * s_phi2) * k2;
    const double z8 = R * z7;
    /* (III.3) */
    qddot[0] = -(s_phi1 * z1 + c_phi1 * z5); /* x1'' */
    qddot[1] = c_phi1 * z1 - s_phi1 * z5; /* y1'' */
    qddot[2] = 0.0; /* phi1'' */
    qddot[3] = -z4; /* theta1'' */
    qddot[4] = c_phi2 * z8 - s_phi2 * z6; /* x2'' */
    qddot[5] = c_phi2 * z6 + s_phi2 * z8; /* y2'' */
    qddot[6] = 0.0; /* phi2'' */
    qddot[7] = z7; /* theta2'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J) > 0.0 * (qddot[0] + qddot[1] + qddot[3] + qddot[4] + qddot[5]))) {
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return disk_chain2_refuse(fabs(J), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return disk_chain2_refuse(fabs(k1), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        return disk_chain2_finish(8, qddot);
    }
    return DISK_CHAIN2_OK;
}

int disk_chain2_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x1 = q[0]; /* first disk [m] */
    y[0] = x1;
    const double y1_ = q[1]; /* y1: first disk [m] */
    y[1] = y1_;
    const double phi1 = q[2]; /* heading [rad] */
    y[2] = phi1;
    const double theta1 = q[3]; /* angle rolled [rad] */
    y[3] = theta1;
    const double x2 = q[4]; /* second disk [m] */
    y[4] = x2;
    const double y2 = q[5]; /* second disk [m] */
    y[5] = y2;
    const double phi2 = q[6]; /* heading [rad] */
    y[6] = phi2;
    const double theta2 = q[7]; /* angle rolled [rad] */
    y[7] = theta2;
    const double phi1_dot = qdot[2]; /* phi1' [rad/s] */
    y[8] = phi1_dot;
    const double theta1_dot = qdot[3]; /* theta1' [rad/s] */
    y[9] = theta1_dot;
    const double phi2_dot = qdot[6]; /* phi2' [rad/s] */
    y[10] = phi2_dot;
    const double theta2_dot = qdot[7]; /* theta2' [rad/s] */
    y[11] = theta2_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5] + y[6] + y[7] + y[8] + y[9] + y[10] + y[11]) <= DBL_MAX)) {
        return disk_chain2_finish(12, y);
    }
    return DISK_CHAIN2_OK;
}

int disk_chain2_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi1 = q[2]; /* heading [rad] */
    const double phi2 = q[6]; /* heading [rad] */

    /* sines and cosines */
    const double c_phi1 = cos(phi1);
    const double s_phi1 = sin(phi1);
    const double c_phi2 = cos(phi2);
    const double s_phi2 = sin(phi2);

    /* what else is read */
    const double x1_dot = qdot[0]; /* x1' [m/s] */
    const double y1_dot = qdot[1]; /* y1' [m/s] */
    const double theta1_dot = qdot[3]; /* theta1' [rad/s] */
    const double x2_dot = qdot[4]; /* x2' [m/s] */
    const double y2_dot = qdot[5]; /* y2' [m/s] */
    const double theta2_dot = qdot[7]; /* theta2' [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the coordinates and velocities */
    const double v1_x1 = theta1_dot * R;
    const double v1_x2 = theta2_dot * R;
    /* (I.1.1) 27:5 */
    r[0] = x1_dot - c_phi1 * v1_x1; /* roll_x1 = 0 */
    /* (I.1.1) 28:5 */
    r[1] = y1_dot - s_phi1 * v1_x1; /* roll_y1 = 0 */
    /* (I.1.1) 29:5 */
    r[2] = x2_dot - c_phi2 * v1_x2; /* roll_x2 = 0 */
    /* (I.1.1) 30:5 */
    r[3] = y2_dot - s_phi2 * v1_x2; /* roll_y2 = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2] + r[3]) <= DBL_MAX)) {
        return disk_chain2_finish(4, r);
    }
    return DISK_CHAIN2_OK;
}

int disk_chain2_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi1 = y[2]; /* heading [rad] */
    const double phi2 = y[6]; /* heading [rad] */

    /* sines and cosines */
    const double s_phi1 = sin(phi1);
    const double c_phi1 = cos(phi1);
    const double s_phi2 = sin(phi2);
    const double c_phi2 = cos(phi2);

    /* what else is read */
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* y1: first disk [m] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi1_dot = y[8]; /* phi1' [rad/s] */
    const double theta1_dot = y[9]; /* theta1' [rad/s] */
    const double phi2_dot = y[10]; /* phi2' [rad/s] */
    const double theta2_dot = y[11]; /* theta2' [rad/s] */
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* from the parameters alone */
    const double k1 = m * R;
    const double k2 = m * R * R;
    const double k3 = I + k2;
    const double k4 = k2 / k3;

    /* from the state */
    const double z1 = k1 * (phi1_dot * theta1_dot);
    const double z2 = x1 - x2;
    const double z3 = y1_ - y2;
    const double z4 = (z2 * c_phi1 + z3 * s_phi1) * k4;
    const double z5 = k1 * (phi2_dot * theta2_dot);
    const double z6 = (z2 * c_phi2 + z3 * s_phi2) * k4;
    /* (I.4.1) 27:5 */
    lambda[0] = k * (z2 - c_phi1 * z4) - s_phi1 * z1; /* reaction of roll_x1: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 28:5 */
    lambda[1] = c_phi1 * z1 + k * (z3 - s_phi1 * z4); /* reaction of roll_y1: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 29:5 */
    lambda[2] = -(s_phi2 * z5 + k * (z2 - c_phi2 * z6)); /* reaction of roll_x2: Q_i gains lambda_3 a_3i */
    /* (I.4.1) 30:5 */
    lambda[3] = c_phi2 * z5 - k * (z3 - s_phi2 * z6); /* reaction of roll_y2: Q_i gains lambda_4 a_4i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J) > 0.0 * (lambda[0] + lambda[1] + lambda[2] + lambda[3]))) {
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return disk_chain2_refuse(fabs(J), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return disk_chain2_refuse(fabs(k3), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        return disk_chain2_finish(4, lambda);
    }
    return DISK_CHAIN2_OK;
}

double disk_chain2_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double x1 = y[0]; /* first disk [m] */
    const double x2 = y[4]; /* second disk [m] */
    const double z1 = x1 - x2;
    const double y1_ = y[1]; /* y1: first disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double z2 = y1_ - y2;
    const double theta1_dot = y[9]; /* theta1' [rad/s] */
    const double R = p[1]; /* radius [m] */
    const double v1_x1 = theta1_dot * R;
    const double theta2_dot = y[11]; /* theta2' [rad/s] */
    const double v1_x2 = theta2_dot * R;
    const double phi1_dot = y[8]; /* phi1' [rad/s] */
    const double phi2_dot = y[10]; /* phi2' [rad/s] */
    const double m = p[0]; /* mass of each [kg] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double z3 = J * (phi1_dot * phi1_dot) + (I * (theta1_dot * theta1_dot) + m * (v1_x1 * v1_x1)) + (J
        * (phi2_dot * phi2_dot) + (I * (theta2_dot * theta2_dot) + m * (v1_x2 * v1_x2)));
    const double k = p[4]; /* stiffness of the spring [N/m] */
    return 0.5 * (k * (z1 * z1 + z2 * z2) + z3);
}

DISK_CHAIN2_SLOW
int disk_chain2_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 144 * sizeof *J);
    (void)t;
    const double phi1 = y[2]; /* heading [rad] */
    const double phi2 = y[6]; /* heading [rad] */

    /* sines and cosines */
    const double s_phi1 = sin(phi1);
    const double c_phi1 = cos(phi1);
    const double s_phi2 = sin(phi2);
    const double c_phi2 = cos(phi2);

    /* what else is read */
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* y1: first disk [m] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double theta1_dot = y[9]; /* theta1' [rad/s] */
    const double theta2_dot = y[11]; /* theta2' [rad/s] */
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J_2 = p[3]; /* J: about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* from the parameters alone */
    const double k1 = I + m * (R * R);
    const double k2 = R * k / k1;

    /* from the state */
    const double z1 = R * s_phi1;
    const double z2 = R * c_phi1;
    const double z3 = R * s_phi2;
    const double z4 = R * c_phi2;
    const double z5 = c_phi1 * k2;
    const double z6 = s_phi1 * k2;
    const double z7 = y1_ - y2;
    const double z8 = x1 - x2;
    const double z9 = c_phi2 * k2;
    const double z10 = s_phi2 * k2;
    /* (III.3) */
    J[2] = -theta1_dot * z1;
    J[9] = z2;
    J[14] = theta1_dot * z2;
    J[21] = z1;
    J[32] = 1.0;
    J[45] = 1.0;
    J[54] = -theta2_dot * z3;
    J[59] = z4;
    J[66] = theta2_dot * z4;
    J[71] = z3;
    J[82] = 1.0;
    J[95] = 1.0;
    J[108] = -z5;
    J[109] = -z6;
    J[110] = (z8 * s_phi1 - z7 * c_phi1) * k2;
    J[112] = z5;
    J[113] = z6;
    J[132] = z9;
    J[133] = z10;
    J[136] = -z9;
    J[137] = -z10;
    J[138] = k2 * (z7 * c_phi2 - z8 * s_phi2);
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J_2) > 0.0 * (J[2] + J[14] + J[54] + J[66] + J[110] + J[138]))) {
        /* the mass matrix is singular, if J_2 is 0 */
        if (!(fabs(J_2) > 0.0)) {
            return disk_chain2_refuse(fabs(J_2), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return disk_chain2_refuse(fabs(k1), 0.0, DISK_CHAIN2_SINGULAR_2);
        }
        return disk_chain2_finish(144, J);
    }
    return DISK_CHAIN2_OK;
}

int disk_chain2_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return DISK_CHAIN2_OK;
}

#if DISK_CHAIN2_LANES >= 2
static __attribute__((noinline)) void disk_chain2_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    disk_chain2_lanes far = {0}; /* the squares of the angles */
    disk_chain2_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    disk_chain2_bits bad = {0}; /* singular blocks */
    const double R = fixed[0];
    const double k2 = fixed[1];
    const disk_chain2_lanes x1 = disk_chain2_get(y);
    const disk_chain2_lanes y1_ = disk_chain2_get(y + 1 * stride);
    const disk_chain2_lanes phi1 = disk_chain2_get(y + 2 * stride);
    const disk_chain2_lanes x2 = disk_chain2_get(y + 4 * stride);
    const disk_chain2_lanes y2 = disk_chain2_get(y + 5 * stride);
    const disk_chain2_lanes phi2 = disk_chain2_get(y + 6 * stride);
    const disk_chain2_lanes phi1_dot = disk_chain2_get(y + 8 * stride);
    const disk_chain2_lanes theta1_dot = disk_chain2_get(y + 9 * stride);
    const disk_chain2_lanes phi2_dot = disk_chain2_get(y + 10 * stride);
    const disk_chain2_lanes theta2_dot = disk_chain2_get(y + 11 * stride);
    disk_chain2_lanes sine1, cosine1;
    disk_chain2_turn_lanes(DISK_CHAIN2_SPREAD(phi1), &far, &sine1, &cosine1);
    const disk_chain2_lanes c_phi1 = cosine1;
    const disk_chain2_lanes v1_x1 = theta1_dot * R;
    const disk_chain2_lanes s_phi1 = sine1;
    disk_chain2_lanes sine2, cosine2;
    disk_chain2_turn_lanes(DISK_CHAIN2_SPREAD(phi2), &far, &sine2, &cosine2);
    const disk_chain2_lanes c_phi2 = cosine2;
    const disk_chain2_lanes v1_x2 = theta2_dot * R;
    const disk_chain2_lanes s_phi2 = sine2;
    const disk_chain2_lanes z1 = x1 - x2;
    const disk_chain2_lanes z2 = y1_ - y2;
    /* (I.1.2) */
    const disk_chain2_lanes slope1 = c_phi1 * v1_x1;
    sum += slope1;
    disk_chain2_put(dydt, slope1);
    const disk_chain2_lanes slope2 = s_phi1 * v1_x1;
    disk_chain2_put(dydt + 1 * stride, slope2);
    const disk_chain2_lanes slope3 = phi1_dot;
    sum += slope3;
    disk_chain2_put(dydt + 2 * stride, slope3);
    const disk_chain2_lanes slope4 = theta1_dot;
    disk_chain2_put(dydt + 3 * stride, slope4);
    const disk_chain2_lanes slope5 = c_phi2 * v1_x2;
    sum += slope5;
    disk_chain2_put(dydt + 4 * stride, slope5);
    const disk_chain2_lanes slope6 = s_phi2 * v1_x2;
    disk_chain2_put(dydt + 5 * stride, slope6);
    const disk_chain2_lanes slope7 = phi2_dot;
    sum += slope7;
    disk_chain2_put(dydt + 6 * stride, slope7);
    const disk_chain2_lanes slope8 = theta2_dot;
    disk_chain2_put(dydt + 7 * stride, slope8);
    /* (III.3) 24:4 */
    const disk_chain2_lanes slope9 = DISK_CHAIN2_SPREAD(0.0);
    disk_chain2_put(dydt + 8 * stride, slope9);
    const disk_chain2_lanes slope10 = -(z1 * c_phi1 + z2 * s_phi1) * k2;
    sum += slope10;
    disk_chain2_put(dydt + 9 * stride, slope10);
    const disk_chain2_lanes slope11 = DISK_CHAIN2_SPREAD(0.0);
    disk_chain2_put(dydt + 10 * stride, slope11);
    const disk_chain2_lanes slope12 = (z1 * c_phi2 + z2 * s_phi2) * k2;
    sum += slope12;
    disk_chain2_put(dydt + 11 * stride, slope12);
    disk_chain2_put(check, disk_chain2_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void disk_chain2_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[DISK_CHAIN2_LANES];
    double state[12 * DISK_CHAIN2_LANES];
    double slope[12 * DISK_CHAIN2_LANES];
    disk_chain2_fill(left, count, t, y, time, state);
    disk_chain2_rhs_lanes(fixed, DISK_CHAIN2_LANES, time, state, slope, check);
    disk_chain2_pour(left, count, slope, dydt);
}
#endif

int disk_chain2_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if DISK_CHAIN2_LANES >= 2
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */
    const double k1 = I + m * (R * R);
    const double k2 = R * k / k1;
    /* the mass matrix is singular, if J is 0 */
    if (!(fabs(J) > 0.0)) {
        return disk_chain2_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {R, k2};
    double check[1 * DISK_CHAIN2_LANES];
    int status = DISK_CHAIN2_OK;
    for (size_t i = 0; i < count; i += DISK_CHAIN2_LANES) {
        const size_t left = count - i < DISK_CHAIN2_LANES ? count - i : DISK_CHAIN2_LANES;
        if (left == DISK_CHAIN2_LANES) {
            disk_chain2_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            disk_chain2_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!disk_chain2_is_good(1 * DISK_CHAIN2_LANES, check)) {
            const int one = disk_chain2_one_by_one(count, i, left, t, y, p, dydt);
            status = status == DISK_CHAIN2_OK ? one : status;
        }
    }
    return status;
#else
    return disk_chain2_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
