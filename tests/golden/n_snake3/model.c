/*
 * n_snake3.c: n_snake3, emitted by nhc 0.1.0 (nhc:d4b20ec301285332)
 * Three links with a wheeled axle under the middle of each, hinged in a row with springs in the hinges.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * n_snake3.h says what each function does.
 */
#include "n_snake3.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const n_snake3_coordinate_names[N_SNAKE3_NQ] = {
    "x",
    "y",
    "theta1",
    "theta2",
    "theta3"
};
const char *const n_snake3_state_names[N_SNAKE3_NY] = {
    "x",
    "y",
    "theta1",
    "theta2",
    "theta3",
    "v",
    "w"
};
const char *const n_snake3_parameter_names[N_SNAKE3_NP] = {
    "m",
    "J",
    "a",
    "k"
};
const char *const n_snake3_constraint_names[N_SNAKE3_NC] = {
    "wheel1",
    "wheel2",
    "wheel3"
};
const char *const n_snake3_output_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double n_snake3_parameter_defaults[N_SNAKE3_NP] = {
    1.0,
    0.1,
    0.5,
    0.5
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define N_SNAKE3_SLOW __attribute__((cold, optimize("O1")))
#else
#define N_SNAKE3_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int n_snake3_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return N_SNAKE3_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return N_SNAKE3_NOT_FINITE;
        }
    }
    return N_SNAKE3_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int n_snake3_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : N_SNAKE3_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef N_SNAKE3_LANES
#if !defined(__GNUC__)
#define N_SNAKE3_LANES 1
#elif defined(__AVX512F__)
#define N_SNAKE3_LANES 8
#elif defined(__AVX__)
#define N_SNAKE3_LANES 4
#else
#define N_SNAKE3_LANES 2
#endif
#endif
#if N_SNAKE3_LANES > 1
typedef double n_snake3_lanes __attribute__((vector_size(8 * N_SNAKE3_LANES)));
#else
typedef double n_snake3_lanes;
#endif

#if N_SNAKE3_LANES >= 2
static inline n_snake3_lanes n_snake3_get(const double *from)
{
    n_snake3_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void n_snake3_put(double *to, n_snake3_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int n_snake3_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = N_SNAKE3_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[N_SNAKE3_NY];
        double slope[N_SNAKE3_NY];
        for (size_t k = 0; k < N_SNAKE3_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = n_snake3_rhs(t[i], state, p, slope);
        status = status == N_SNAKE3_OK ? one : status;
        for (size_t k = 0; k < N_SNAKE3_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if N_SNAKE3_LANES >= 2
#define N_SNAKE3_SPREAD(x) ((x) - (n_snake3_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long n_snake3_bits __attribute__((vector_size(8 * N_SNAKE3_LANES)));

/* all bits where value is not above bound, or is no number */
static inline n_snake3_bits n_snake3_misses(n_snake3_lanes value, n_snake3_lanes bound)
{
    return ~(n_snake3_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline n_snake3_lanes n_snake3_mark(n_snake3_lanes value, n_snake3_bits bad)
{
    return (n_snake3_lanes)((n_snake3_bits)value | bad);
}

static inline n_snake3_lanes n_snake3_size(n_snake3_lanes x)
{
    return (n_snake3_lanes)((n_snake3_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int n_snake3_is_good(int count, const double *check)
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
static inline void n_snake3_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < N_SNAKE3_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < N_SNAKE3_NY; ++k) {
            state[k * N_SNAKE3_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void n_snake3_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < N_SNAKE3_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * N_SNAKE3_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void n_snake3_turn_lanes(n_snake3_lanes x, n_snake3_lanes *far,
    n_snake3_lanes *sine, n_snake3_lanes *cosine)
{
    double angle[N_SNAKE3_LANES];
    double up[N_SNAKE3_LANES];
    double along[N_SNAKE3_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < N_SNAKE3_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int n_snake3_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double z2 = theta2 - theta3;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double c2 = cos(z2);
    const double s2 = sin(z2);
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / a;
    const double k2 = J * k1;
    const double k3 = k1 * k2;
    const double k4 = m * a;
    const double k5 = a * k4;
    const double k6 = k * k1;

    /* from the state */
    const double z3 = c1 * c2 + s1 * s2;
    const double z4 = z3 * z3 + (1.0 + c1 * c1);
    const double z5 = s1 * s1;
    const double z6 = c1 * s2 - s1 * c2;
    const double z7 = z6 * z6;
    const double z8 = m * z4 + k3 * (z5 + z7);
    const double z9 = z5 * k5 + J * z4 + z7 * k5;
    const double z10 = c1 * s1;
    const double z11 = a * z3;
    const double z12 = z6 * z11;
    const double z13 = z10 * k4 - (k2 * z10 - k3 * z12) - m * z12;
    const double z14 = 1.0 / z8;
    const double z15 = z14 * z13;
    const double z16 = z9 - z13 * z15;
    const double z17 = a * w;
    const double z18 = v * s1 - c1 * z17;
    const double z19 = k1 * z18;
    const double v1_x2 = v * c1 + s1 * z17;
    const double z20 = s2 * v1_x2 - c2 * z18;
    const double z21 = w - z19;
    const double z22 = c1 * z21;
    const double z23 = s1 * z21;
    const double z24 = v * z22 + z17 * z23;
    const double z25 = k1 * (z18 - z20);
    const double z26 = c2 * z25;
    const double z27 = v * z23 - z17 * z22;
    const double z28 = s2 * z25;
    const double z29 = v1_x2 * z26 - s2 * z27 + (z18 * z28 - c2 * z24);
    const double z30 = v1_x2 * z28 + c2 * z27 - (z18 * z26 + s2 * z24);
    const double z31 = k3 * (s1 * z24 + z6 * z29) - m * (c1 * z27 + z3 * z30) - k6 * (s1 * (z1 - z2) + z2 *
        z6);
    const double z32 = k4 * (s1 * z27) + (k2 * (c1 * z24) - k3 * (z29 * z11)) - k4 * (z6 * z30);
    const double z33 = (z31 * z15 - (k * (z1 * (1.0 + c1) - z2 * (c1 + z3)) - z32)) / z16;
    /* (I.2.4) */
    dydt[0] = c_theta1 * v; /* x' */
    dydt[1] = s_theta1 * v; /* y' */
    dydt[2] = w; /* theta1' */
    dydt[3] = z19; /* theta2' */
    dydt[4] = k1 * z20; /* theta3' */
    /* (I.2.15) 22:4 */
    dydt[5] = -(z14 * z31 + z15 * z33); /* v' */
    dydt[6] = z33; /* w' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[4] + dydt[5]) <= DBL_MAX && fabs(z16) > 1e-13 * z9)) {
        /* the coframe is singular, if a is 0 */
        if (!(fabs(a) > 0.0)) {
            return n_snake3_refuse(fabs(a), 0.0, N_SNAKE3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return n_snake3_refuse(fabs(z8), 0.0, N_SNAKE3_SINGULAR_2);
        }
        /* the mass matrix is singular, if z16 is nearly 0 */
        if (!(fabs(z16) > 1e-13 * z9)) {
            return n_snake3_refuse(fabs(z16), 1e-13 * z9, N_SNAKE3_SINGULAR_2);
        }
        return n_snake3_finish(7, dydt);
    }
    return N_SNAKE3_OK;
}

int n_snake3_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double z4 = theta2 - theta3;
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double s2 = sin(z4);
    const double c2 = cos(z4);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double a = p[2]; /* half the length of a link [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / a;

    /* from the state */
    const double z2 = a * w;
    const double z3 = v * s1 - c1 * z2;
    /* (I.2.4) */
    qdot[0] = c_theta1 * v; /* x' */
    qdot[1] = s_theta1 * v; /* y' */
    qdot[2] = w; /* theta1' */
    qdot[3] = k1 * z3; /* theta2' */
    qdot[4] = k1 * (s2 * (v * c1 + s1 * z2) - c2 * z3); /* theta3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[3] + qdot[4]) <= DBL_MAX)) {
        /* the coframe is singular, if a is 0 */
        if (!(fabs(a) > 0.0)) {
            return n_snake3_refuse(fabs(a), 0.0, N_SNAKE3_SINGULAR_1);
        }
        return n_snake3_finish(5, qdot);
    }
    return N_SNAKE3_OK;
}

N_SNAKE3_SLOW
int n_snake3_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double z2 = theta2 - theta3;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double c2 = cos(z2);
    const double s2 = sin(z2);
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / a;
    const double k2 = J * k1;
    const double k3 = k1 * k2;
    const double k4 = m * a;
    const double k5 = a * k4;

    /* from the state */
    const double z3 = c1 * c2 + s1 * s2;
    const double z4 = 1.0 + c1 * c1;
    const double z5 = s1 * s1;
    const double z6 = c1 * s2 - s1 * c2;
    const double z7 = m * (z3 * z3 + z4) + k3 * (z5 + z6 * z6);
    const double z8 = a * s1;
    const double z9 = a * c1;
    const double z10 = s2 * z8 + c2 * z9;
    const double z11 = c2 * z8 - s2 * z9;
    const double z12 = J * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11);
    const double z13 = c1 * s1;
    const double z14 = z6 * z10;
    const double z15 = k2 * z13 - k3 * z14 - z13 * k4 + m * z14;
    const double z16 = 1.0 / z7;
    const double z17 = z16 * z15;
    const double z18 = z12 - z15 * z17;
    const double z19 = v * w;
    const double z20 = a * w;
    const double z21 = v * s1 - c1 * z20;
    const double z22 = w - k1 * z21;
    const double z23 = s1 * z22;
    const double z24 = c1 * z22;
    const double z25 = v * z23 - z20 * z24;
    const double v1_x2 = v * c1 + s1 * z20;
    const double z26 = k1 * (z21 - (s2 * v1_x2 - c2 * z21));
    const double z27 = s2 * z26;
    const double z28 = c2 * z26;
    const double z29 = v * z24 + z20 * z23;
    const double z30 = v1_x2 * z27 + c2 * z25 - (z21 * z28 + s2 * z29);
    const double z31 = v1_x2 * z28 + z21 * z27;
    const double z32 = z31 - (s2 * z25 + c2 * z29);
    const double z33 = m * (c1 * z25 + z3 * z30) - k3 * (s1 * z29 + z6 * z32) + k * (k1 * (z1 * s1 - z2 * (s1
        - z6)));
    const double z34 = m * (z11 * z30) + (k4 * (s1 * z25) + (k2 * (c1 * z29) - k3 * (z10 * z32)));
    const double z35 = (k * (z1 * (1.0 + c1) - z2 * (c1 + z3)) - z34 - z17 * z33) / z18;
    const double z36 = z16 * z33 - z17 * z35;
    const double z37 = a * z35;
    const double z38 = z29 + (s1 * z36 + c1 * z37);
    /* (I.2.15) */
    qddot[0] = c_theta1 * z36 - s_theta1 * z19; /* x'' */
    qddot[1] = c_theta1 * z19 + s_theta1 * z36; /* y'' */
    qddot[2] = -z35; /* theta1'' */
    qddot[3] = k1 * z38; /* theta2'' */
    qddot[4] = k1 * (z31 - (s2 * (z25 - (c1 * z36 - s1 * z37)) + c2 * z38)); /* theta3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[3] + qddot[4]) <= DBL_MAX && fabs(z18) > 1e-13 * z12)) {
        /* the coframe is singular, if a is 0 */
        if (!(fabs(a) > 0.0)) {
            return n_snake3_refuse(fabs(a), 0.0, N_SNAKE3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z7 is 0 */
        if (!(fabs(z7) > 0.0)) {
            return n_snake3_refuse(fabs(z7), 0.0, N_SNAKE3_SINGULAR_2);
        }
        /* the mass matrix is singular, if z18 is nearly 0 */
        if (!(fabs(z18) > 1e-13 * z12)) {
            return n_snake3_refuse(fabs(z18), 1e-13 * z12, N_SNAKE3_SINGULAR_2);
        }
        return n_snake3_finish(5, qddot);
    }
    return N_SNAKE3_OK;
}

int n_snake3_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta1 = q[2]; /* first link [rad] */

    /* sines and cosines */
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);

    /* what else is read */
    const double x = q[0]; /* middle of the first link [m] */
    const double y_2 = q[1]; /* y: middle of the first link [m] */
    const double theta2 = q[3]; /* second link [rad] */
    const double theta3 = q[4]; /* third link [rad] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta1_dot = qdot[2]; /* theta1' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = theta1;
    y[3] = theta2;
    y[4] = theta3;
    y[5] = x_dot * c_theta1 + y_dot * s_theta1;
    y[6] = theta1_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[4] + y[5] + y[6]) <= DBL_MAX)) {
        return n_snake3_finish(7, y);
    }
    return N_SNAKE3_OK;
}

int n_snake3_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta1 = q[2]; /* first link [rad] */
    const double theta2 = q[3]; /* second link [rad] */
    const double theta3 = q[4]; /* third link [rad] */

    /* sines and cosines */
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta2 = cos(theta2);
    const double s_theta3 = sin(theta3);
    const double c_theta3 = cos(theta3);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta1_dot = qdot[2]; /* theta1' [rad/s] */
    const double theta2_dot = qdot[3]; /* theta2' [rad/s] */
    const double theta3_dot = qdot[4]; /* theta3' [rad/s] */
    const double a = p[2]; /* half the length of a link [m] */

    /* from the coordinates and velocities */
    const double z1 = theta1_dot * a;
    const double z2 = theta2_dot * a;
    const double z3 = s_theta2 * z2;
    const double x2_dot = x_dot + s_theta1 * z1 + z3;
    const double z4 = c_theta2 * z2;
    const double y2_dot = y_dot - c_theta1 * z1 - z4;
    const double z5 = theta3_dot * a;
    /* (I.1.1) 25:5 */
    r[0] = y_dot * c_theta1 - x_dot * s_theta1; /* wheel1 = 0 */
    /* (I.1.1) 26:5 */
    r[1] = c_theta2 * y2_dot - s_theta2 * x2_dot; /* wheel2 = 0 */
    /* (I.1.1) 27:5 */
    /* wheel3 = 0 */
    r[2] = -(s_theta3 * (z3 + x2_dot + s_theta3 * z5) + c_theta3 * (z4 - y2_dot + c_theta3 * z5));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2]) <= DBL_MAX)) {
        return n_snake3_finish(3, r);
    }
    return N_SNAKE3_OK;
}

N_SNAKE3_SLOW
int n_snake3_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double z2 = theta2 - theta3;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double c2 = cos(z2);
    const double s2 = sin(z2);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / a;
    const double k2 = J * k1;
    const double k3 = k1 * k2;
    const double k4 = m * a;
    const double k5 = a * k4;
    const double k6 = m * k1;

    /* from the state */
    const double z3 = c1 * c2 + s1 * s2;
    const double z4 = 1.0 + c1 * c1;
    const double z5 = s1 * s1;
    const double z6 = c1 * s2 - s1 * c2;
    const double z7 = m * (z3 * z3 + z4) + k3 * (z5 + z6 * z6);
    const double z8 = a * s1;
    const double z9 = a * c1;
    const double z10 = s2 * z8 + c2 * z9;
    const double z11 = c2 * z8 - s2 * z9;
    const double z12 = J * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11);
    const double z13 = c1 * s1;
    const double z14 = z6 * z10;
    const double z15 = k2 * z13 - k3 * z14 - z13 * k4 + m * z14;
    const double z16 = 1.0 / z7;
    const double z17 = z16 * z15;
    const double z18 = z12 - z15 * z17;
    const double z19 = a * w;
    const double v1_x2 = v * c1 + s1 * z19;
    const double z20 = v * s1 - c1 * z19;
    const double z21 = s2 * v1_x2 - c2 * z20;
    const double z22 = k1 * (z20 - z21);
    const double z23 = s2 * z22;
    const double z24 = k1 * z20;
    const double z25 = w - z24;
    const double z26 = s1 * z25;
    const double z27 = c1 * z25;
    const double z28 = v * z26 - z19 * z27;
    const double z29 = c2 * z22;
    const double z30 = v * z27 + z19 * z26;
    const double z31 = v1_x2 * z23 + c2 * z28 - (z20 * z29 + s2 * z30);
    const double z32 = v1_x2 * z29 - s2 * z28 + (z20 * z23 - c2 * z30);
    const double z33 = k3 * (s1 * z30 + z6 * z32) - m * (c1 * z28 + z3 * z31) - k * (k1 * (z1 * s1 - z2 * (s1
        - z6)));
    const double z34 = k2 * (c1 * z30) - k3 * (z10 * z32) + k4 * (s1 * z28) + m * (z11 * z31);
    const double z35 = (z34 - k * (z1 * (1.0 + c1) - z2 * (c1 + z3)) - z17 * z33) / z18;
    const double z36 = z16 * z33 - z17 * z35;
    const double z37 = a * z35;
    const double z38 = c1 * z36 - s1 * z37;
    const double z39 = s1 * z36 + c1 * z37;
    const double z40 = m * (z31 + (c2 * z38 + s2 * z39));
    const double z41 = k1 * (k * z2 - k2 * (z32 - (s2 * z38 - c2 * z39)));
    const double z42 = s2 * z40 - c2 * z41;
    const double z43 = z42 + k1 * (k * (z1 - z2) - k2 * (z30 - z39));
    const double z44 = m * (v * w) - (c1 * z43 - s1 * (m * (z28 + z38) + s2 * z41 + c2 * z40));
    /* (I.4.1) 25:5 */
    lambda[0] = z44; /* reaction of wheel1: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 26:5 */
    lambda[1] = m * (z24 * v1_x2) + z42 + z43; /* reaction of wheel2: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 27:5 */
    lambda[2] = k6 * (z21 * (c2 * v1_x2 + s2 * z20)) + z41; /* reaction of wheel3: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1] + lambda[2]) <= DBL_MAX && fabs(z18) > 1e-13 * z12)) {
        /* the coframe is singular, if a is 0 */
        if (!(fabs(a) > 0.0)) {
            return n_snake3_refuse(fabs(a), 0.0, N_SNAKE3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z7 is 0 */
        if (!(fabs(z7) > 0.0)) {
            return n_snake3_refuse(fabs(z7), 0.0, N_SNAKE3_SINGULAR_2);
        }
        /* the mass matrix is singular, if z18 is nearly 0 */
        if (!(fabs(z18) > 1e-13 * z12)) {
            return n_snake3_refuse(fabs(z18), 1e-13 * z12, N_SNAKE3_SINGULAR_2);
        }
        return n_snake3_finish(3, lambda);
    }
    return N_SNAKE3_OK;
}

double n_snake3_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double z2 = theta2 - theta3;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double s2 = sin(z2);
    const double c2 = cos(z2);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / a;

    /* from the state */
    const double z3 = a * w;
    const double z4 = v * s1 - c1 * z3;
    const double z5 = k1 * z4;
    const double v1_x2 = v * c1 + s1 * z3;
    const double z6 = k1 * (s2 * v1_x2 - c2 * z4);
    const double v1_x3 = c2 * v1_x2 + s2 * z4;
    const double z7 = J * (w * w + z5 * z5 + z6 * z6) + m * (v * v + v1_x2 * v1_x2 + v1_x3 * v1_x3);
    return 0.5 * (k * (z1 * z1 + z2 * z2) + z7);
}

N_SNAKE3_SLOW
int n_snake3_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 49 * sizeof *J);
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */

    /* sines and cosines */
    const double z1 = theta1 - theta2;
    const double z2 = theta2 - theta3;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double c2 = cos(z2);
    const double s2 = sin(z2);
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);

    /* what else is read */
    const double v = y[5]; /* [m/s] */
    const double w = y[6]; /* [rad/s] */
    const double m = p[0]; /* each link [kg] */
    const double J_2 = p[1]; /* J: each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / a;
    const double k2 = J_2 * k1;
    const double k3 = k1 * k2;
    const double k4 = m * a;
    const double k5 = a * k4;
    const double k6 = k2 - k4;
    const double k7 = k * k1;

    /* from the state */
    const double z3 = c1 * c2 + s1 * s2;
    const double z4 = 1.0 + c1 * c1;
    const double z5 = s1 * s1;
    const double z6 = c1 * s2 - s1 * c2;
    const double z7 = m * (z3 * z3 + z4) + k3 * (z5 + z6 * z6);
    const double z8 = a * s1;
    const double z9 = a * c1;
    const double z10 = s2 * z8 + c2 * z9;
    const double z11 = c2 * z8 - s2 * z9;
    const double z12 = J_2 * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11);
    const double z13 = c1 * s1;
    const double z14 = z6 * z10;
    const double z15 = k2 * z13 - k3 * z14 - z13 * k4 + m * z14;
    const double z16 = 1.0 / z7;
    const double z17 = z16 * z15;
    const double z18 = z12 - z15 * z17;
    const double z19 = a * w;
    const double v1_x2 = v * c1 + s1 * z19;
    const double z20 = k1 * v1_x2;
    const double z21 = s1 * k1;
    const double z22 = v * s1 - c1 * z19;
    const double z23 = k1 * (c2 * v1_x2 + s2 * z22);
    const double z24 = k1 * (z22 - (s2 * v1_x2 - c2 * z22));
    const double z25 = c2 * z24;
    const double z26 = m * z3;
    const double z27 = s2 * z24;
    const double z28 = z6 * k3;
    const double z29 = z22 * z26 + v1_x2 * z28;
    const double z30 = v1_x2 * z26 - z22 * z28;
    const double z31 = k1 * (c2 * z29 - s2 * z30);
    const double z32 = m * c1 + c2 * z26 + s2 * z28;
    const double z33 = c2 * z28 - (s1 * k3 + s2 * z26);
    const double z34 = z19 * z32 - v * z33;
    const double z35 = z19 * z33 + v * z32;
    const double z36 = c1 * z34 - s1 * z35;
    const double z37 = z25 * z26 + z27 * z28 + z31 + c2 * z31 - k1 * z36;
    const double z38 = z27 * z26 - z25 * z28 + s2 * z31;
    const double z39 = w - k1 * z22;
    const double z40 = c1 * z39;
    const double z41 = s1 * z39;
    const double z42 = v * z40 + z19 * z41;
    const double z43 = z2 * k7;
    const double z44 = 1.0 / z18;
    const double z45 = v * z41 - z19 * z40;
    const double z46 = v1_x2 * z25 - s2 * z45 + (z22 * z27 - c2 * z42);
    const double z47 = v1_x2 * z27 + c2 * z45 - (z22 * z25 + s2 * z42);
    const double z48 = k1 * (s1 - z6);
    const double z49 = k3 * (s1 * z42 + z6 * z46) - m * (c1 * z45 + z3 * z47) - k * (z1 * z21 - z2 * z48);
    const double z50 = 1.0 + c1;
    const double z51 = c1 + z3;
    const double z52 = c1 * k2;
    const double z53 = z10 * k3;
    const double z54 = s1 * k4;
    const double z55 = m * z11;
    const double z56 = k * (z1 * z50 - z2 * z51) - (z42 * z52 - z46 * z53 + z45 * z54 + z47 * z55);
    const double z57 = z44 * (z49 * z17 + z56);
    const double z58 = k6 * z57;
    const double z59 = z49 * z16 + z17 * z57;
    const double z60 = k3 * z59;
    const double z61 = z19 * z38 + (z39 * z35 - (z42 * k3 + z43 + c1 * z58 - 2.0 * (s1 * z60)));
    const double z62 = m * z57;
    const double z63 = z3 * z62;
    const double z64 = k3 * z57;
    const double z65 = z6 * z64;
    const double z66 = m * z47;
    const double z67 = z11 * z62;
    const double z68 = m * z59;
    const double z69 = z3 * z68;
    const double z70 = z66 + z67 + 2.0 * z69;
    const double z71 = z1 * k7 - (v * z37 - z61 - a * (c2 * z63 + s2 * z65)) + s2 * z70;
    const double z72 = z46 * k3 - z43;
    const double z73 = z10 * z64;
    const double z74 = z6 * z60;
    const double z75 = z72 - (z73 + 2.0 * z74);
    const double z76 = v * z38 + (z19 * z37 - (z39 * z34 - (m * z45 - s1 * z58 + 2.0 * (c1 * z68))));
    const double z77 = k * z21 + c1 * (z71 + c2 * z75) - s1 * (z76 - a * (s2 * z63 - c2 * z65) + c2 * z70 -
        s2 * z75);
    const double z78 = z22 * z55 + v1_x2 * z53;
    const double z79 = v1_x2 * z55 - z22 * z53;
    const double z80 = k1 * (c2 * z78 - s2 * z79);
    const double z81 = z54 + c2 * z55 + s2 * z53;
    const double z82 = z52 - s2 * z55 + c2 * z53;
    const double z83 = z19 * z81 - v * z82;
    const double z84 = z19 * z82 + v * z81;
    const double z85 = c1 * z83 - s1 * z84;
    const double z86 = z25 * z55 + z27 * z53 + z80 + c2 * z80 - k1 * z85;
    const double z87 = z27 * z55 - z25 * z53 + s2 * z80;
    const double z88 = k6 * z59;
    const double z89 = z19 * z87 + (z39 * z84 + (z45 * k4 - c1 * z88 + 2.0 * (k5 * (s1 * z57))));
    const double z90 = z69 + (z66 + 2.0 * z67);
    const double z91 = z72 - (2.0 * z73 + z74);
    const double z92 = z11 * z68;
    const double z93 = z10 * z60;
    const double z94 = v * z86 - z89 - a * (c2 * z90 - s2 * z91) - s2 * z92 + c2 * z93;
    const double z95 = z39 * z83 + (k * (z1 - z2) - z42 * k2 + s1 * z88 - 2.0 * (J_2 * (c1 * z57)));
    const double z96 = v * z87 + (z19 * z86 - z95) - a * (s2 * z90 + c2 * z91) + c2 * z92;
    const double z97 = k * z50 + c1 * z94 + s1 * (z96 + s2 * z93);
    const double z98 = z44 * (z97 - z17 * z77);
    const double z99 = v1_x2 * z31 - (z42 * z26 - z45 * z28 - z24 * z30 + z9 * z63) + z8 * z65;
    const double z100 = z22 * z31 - (z45 * z26 + z42 * z28 - z24 * z29 + z8 * z63) - z9 * z65;
    const double z101 = k * z48 - c2 * (z99 + s1 * z70 - c1 * z75) - s2 * (z100 - c1 * z70 - s1 * z75);
    const double z102 = z77 + z101;
    const double z103 = v1_x2 * z80 - (z42 * z55 - z45 * z53 - z24 * z79 + z9 * z90) - z8 * z91;
    const double z104 = z22 * z80 - (z45 * z55 + z42 * z53 - z24 * z78 + z8 * z90) + z9 * z91;
    const double z105 = k * z51 + c2 * (z103 + s1 * z92 + c1 * z93) + s2 * (z104 - c1 * z92 + s1 * z93);
    const double z106 = z44 * (z97 + z105 - z17 * z102);
    const double z107 = z44 * (z105 - z17 * z101);
    const double z108 = z40 * z33 + z41 * z32 - s1 * z37 + c1 * z38;
    const double z109 = z44 * (z40 * z82 + z41 * z81 - s1 * z86 + c1 * z87 + z17 * z108);
    const double z110 = z36 + a * (z40 * z32 - z41 * z33 - s1 * z38 - c1 * z37);
    const double z111 = z85 + a * (z40 * z81 - z41 * z82 - s1 * z87 - c1 * z86) + z17 * z110;
    const double z112 = z44 * z111;
    /* (I.2.15) */
    J[2] = -s_theta1 * v;
    J[5] = c_theta1;
    J[9] = c_theta1 * v;
    J[12] = s_theta1;
    J[20] = 1.0;
    J[23] = z20;
    J[24] = -z20;
    J[26] = z21;
    J[27] = -c1;
    J[30] = -z23;
    J[31] = 2.0 * z23;
    J[32] = -z23;
    J[33] = k1 * z6;
    J[34] = z3;
    J[37] = z16 * z77 - z17 * z98;
    J[38] = z17 * z106 - z16 * z102;
    J[39] = z16 * z101 - z17 * z107;
    J[40] = z16 * z108 + z17 * z109;
    J[41] = -(z16 * z110 + z17 * z112);
    J[44] = -z98;
    J[45] = z106;
    J[46] = -z107;
    J[47] = z109;
    J[48] = -z112;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[24] + J[31] + J[32] + J[33] + J[37] + J[38] + J[39] + J[40] + J[41] + J[44] + J[46] + J[48])
        <= DBL_MAX
        && fabs(z18) > 1e-13 * z12)) {
        /* the coframe is singular, if a is 0 */
        if (!(fabs(a) > 0.0)) {
            return n_snake3_refuse(fabs(a), 0.0, N_SNAKE3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z7 is 0 */
        if (!(fabs(z7) > 0.0)) {
            return n_snake3_refuse(fabs(z7), 0.0, N_SNAKE3_SINGULAR_2);
        }
        /* the mass matrix is singular, if z18 is nearly 0 */
        if (!(fabs(z18) > 1e-13 * z12)) {
            return n_snake3_refuse(fabs(z18), 1e-13 * z12, N_SNAKE3_SINGULAR_2);
        }
        return n_snake3_finish(49, J);
    }
    return N_SNAKE3_OK;
}

int n_snake3_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;

    /* from the state */
    const double a = p[2]; /* half the length of a link [m] */
    /* the coframe is singular, if a is 0 */
    if (!(fabs(a) > 0.0)) {
        return n_snake3_refuse(fabs(a), 0.0, N_SNAKE3_SINGULAR_1);
    }
    (void)out;
    return N_SNAKE3_OK;
}

#if N_SNAKE3_LANES >= 2
static __attribute__((noinline)) void n_snake3_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    n_snake3_lanes far = {0}; /* the squares of the angles */
    n_snake3_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    n_snake3_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double J = fixed[1];
    const double a = fixed[2];
    const double k = fixed[3];
    const double k1 = fixed[4];
    const double k2 = fixed[5];
    const double k3 = fixed[6];
    const double k4 = fixed[7];
    const double k5 = fixed[8];
    const double k6 = fixed[9];
    const n_snake3_lanes theta1 = n_snake3_get(y + 2 * stride);
    const n_snake3_lanes theta2 = n_snake3_get(y + 3 * stride);
    const n_snake3_lanes theta3 = n_snake3_get(y + 4 * stride);
    const n_snake3_lanes v = n_snake3_get(y + 5 * stride);
    const n_snake3_lanes w = n_snake3_get(y + 6 * stride);
    const n_snake3_lanes z1 = theta1 - theta2;
    n_snake3_lanes sine1, cosine1;
    n_snake3_turn_lanes(N_SNAKE3_SPREAD(z1), &far, &sine1, &cosine1);
    const n_snake3_lanes c1 = cosine1;
    const n_snake3_lanes z2 = theta2 - theta3;
    n_snake3_lanes sine2, cosine2;
    n_snake3_turn_lanes(N_SNAKE3_SPREAD(z2), &far, &sine2, &cosine2);
    const n_snake3_lanes c2 = cosine2;
    const n_snake3_lanes s1 = sine1;
    const n_snake3_lanes s2 = sine2;
    const n_snake3_lanes z3 = c1 * c2 + s1 * s2;
    const n_snake3_lanes z4 = z3 * z3 + (1.0 + c1 * c1);
    const n_snake3_lanes z5 = s1 * s1;
    const n_snake3_lanes z6 = c1 * s2 - s1 * c2;
    const n_snake3_lanes z7 = z6 * z6;
    const n_snake3_lanes z8 = m * z4 + k3 * (z5 + z7);
    const n_snake3_lanes z9 = z5 * k5 + J * z4 + z7 * k5;
    const n_snake3_lanes z10 = c1 * s1;
    const n_snake3_lanes z11 = a * z3;
    const n_snake3_lanes z12 = z6 * z11;
    const n_snake3_lanes z13 = z10 * k4 - (k2 * z10 - k3 * z12) - m * z12;
    const n_snake3_lanes z14 = 1.0 / z8;
    const n_snake3_lanes z15 = z14 * z13;
    const n_snake3_lanes z16 = z9 - z13 * z15;
    /* the mass matrix is singular, if z16 is nearly 0 */
    bad |= n_snake3_misses(n_snake3_size(N_SNAKE3_SPREAD(z16)), 1e-13 * z9);
    n_snake3_lanes sine3, cosine3;
    n_snake3_turn_lanes(N_SNAKE3_SPREAD(theta1), &far, &sine3, &cosine3);
    const n_snake3_lanes c_theta1 = cosine3;
    const n_snake3_lanes s_theta1 = sine3;
    const n_snake3_lanes z17 = a * w;
    const n_snake3_lanes z18 = v * s1 - c1 * z17;
    const n_snake3_lanes z19 = k1 * z18;
    const n_snake3_lanes v1_x2 = v * c1 + s1 * z17;
    const n_snake3_lanes z20 = s2 * v1_x2 - c2 * z18;
    const n_snake3_lanes z21 = w - z19;
    const n_snake3_lanes z22 = c1 * z21;
    const n_snake3_lanes z23 = s1 * z21;
    const n_snake3_lanes z24 = v * z22 + z17 * z23;
    const n_snake3_lanes z25 = k1 * (z18 - z20);
    const n_snake3_lanes z26 = c2 * z25;
    const n_snake3_lanes z27 = v * z23 - z17 * z22;
    const n_snake3_lanes z28 = s2 * z25;
    const n_snake3_lanes z29 = v1_x2 * z26 - s2 * z27 + (z18 * z28 - c2 * z24);
    const n_snake3_lanes z30 = v1_x2 * z28 + c2 * z27 - (z18 * z26 + s2 * z24);
    const n_snake3_lanes z31 = k3 * (s1 * z24 + z6 * z29) - m * (c1 * z27 + z3 * z30) - k6 * (s1 * (z1 - z2)
        + z2 * z6);
    const n_snake3_lanes z32 = k4 * (s1 * z27) + (k2 * (c1 * z24) - k3 * (z29 * z11)) - k4 * (z6 * z30);
    const n_snake3_lanes z33 = (z31 * z15 - (k * (z1 * (1.0 + c1) - z2 * (c1 + z3)) - z32)) / z16;
    /* (I.2.4) */
    const n_snake3_lanes slope1 = c_theta1 * v;
    n_snake3_put(dydt, slope1);
    const n_snake3_lanes slope2 = s_theta1 * v;
    n_snake3_put(dydt + 1 * stride, slope2);
    const n_snake3_lanes slope3 = w;
    n_snake3_put(dydt + 2 * stride, slope3);
    const n_snake3_lanes slope4 = z19;
    n_snake3_put(dydt + 3 * stride, slope4);
    const n_snake3_lanes slope5 = k1 * z20;
    sum += slope5;
    n_snake3_put(dydt + 4 * stride, slope5);
    /* (I.2.15) 22:4 */
    const n_snake3_lanes slope6 = -(z14 * z31 + z15 * z33);
    sum += slope6;
    n_snake3_put(dydt + 5 * stride, slope6);
    const n_snake3_lanes slope7 = z33;
    n_snake3_put(dydt + 6 * stride, slope7);
    n_snake3_put(check, n_snake3_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void n_snake3_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[N_SNAKE3_LANES];
    double state[7 * N_SNAKE3_LANES];
    double slope[7 * N_SNAKE3_LANES];
    n_snake3_fill(left, count, t, y, time, state);
    n_snake3_rhs_lanes(fixed, N_SNAKE3_LANES, time, state, slope, check);
    n_snake3_pour(left, count, slope, dydt);
}
#endif

int n_snake3_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
#if N_SNAKE3_LANES >= 2
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */
    const double k1 = 1.0 / a;
    const double k2 = J * k1;
    const double k3 = k1 * k2;
    const double k4 = m * a;
    const double k5 = a * k4;
    const double k6 = k * k1;
    const double fixed[] = {m, J, a, k, k1, k2, k3, k4, k5, k6};
    double check[1 * N_SNAKE3_LANES];
    int status = N_SNAKE3_OK;
    for (size_t i = 0; i < count; i += N_SNAKE3_LANES) {
        const size_t left = count - i < N_SNAKE3_LANES ? count - i : N_SNAKE3_LANES;
        if (left == N_SNAKE3_LANES) {
            n_snake3_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            n_snake3_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!n_snake3_is_good(1 * N_SNAKE3_LANES, check)) {
            const int one = n_snake3_one_by_one(count, i, left, t, y, p, dydt);
            status = status == N_SNAKE3_OK ? one : status;
        }
    }
    return status;
#else
    return n_snake3_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
