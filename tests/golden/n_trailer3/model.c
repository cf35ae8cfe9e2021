/*
 * n_trailer3.c: n_trailer3, emitted by nhc 0.1.0 (nhc:773ea33f80af98bc)
 * A tractor with three trailers, each hitched to the axle before it; none of the four axles slips sideways.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * n_trailer3.h says what each function does.
 */
#include "n_trailer3.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const n_trailer3_coordinate_names[N_TRAILER3_NQ] = {
    "x",
    "y",
    "theta0",
    "theta1",
    "theta2",
    "theta3"
};
const char *const n_trailer3_state_names[N_TRAILER3_NY] = {
    "x",
    "y",
    "theta0",
    "theta1",
    "theta2",
    "theta3",
    "v",
    "w"
};
const char *const n_trailer3_parameter_names[N_TRAILER3_NP] = {
    "m0",
    "J0",
    "m",
    "J",
    "L"
};
const char *const n_trailer3_constraint_names[N_TRAILER3_NC] = {
    "axle0",
    "axle1",
    "axle2",
    "axle3"
};
const char *const n_trailer3_output_names[N_TRAILER3_NOUT] = {
    "tail_x",
    "tail_y"
};
const double n_trailer3_parameter_defaults[N_TRAILER3_NP] = {
    1.0,
    0.1,
    0.5,
    0.05,
    0.8
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define N_TRAILER3_SLOW __attribute__((cold, optimize("O1")))
#else
#define N_TRAILER3_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int n_trailer3_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return N_TRAILER3_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return N_TRAILER3_NOT_FINITE;
        }
    }
    return N_TRAILER3_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int n_trailer3_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : N_TRAILER3_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef N_TRAILER3_LANES
#if !defined(__GNUC__)
#define N_TRAILER3_LANES 1
#elif defined(__AVX512F__)
#define N_TRAILER3_LANES 8
#elif defined(__AVX__)
#define N_TRAILER3_LANES 4
#else
#define N_TRAILER3_LANES 2
#endif
#endif
#if N_TRAILER3_LANES > 1
typedef double n_trailer3_lanes __attribute__((vector_size(8 * N_TRAILER3_LANES)));
#else
typedef double n_trailer3_lanes;
#endif

#if N_TRAILER3_LANES >= 2
static inline n_trailer3_lanes n_trailer3_get(const double *from)
{
    n_trailer3_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void n_trailer3_put(double *to, n_trailer3_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int n_trailer3_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = N_TRAILER3_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[N_TRAILER3_NY];
        double slope[N_TRAILER3_NY];
        for (size_t k = 0; k < N_TRAILER3_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = n_trailer3_rhs(t[i], state, p, slope);
        status = status == N_TRAILER3_OK ? one : status;
        for (size_t k = 0; k < N_TRAILER3_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if N_TRAILER3_LANES >= 2
#define N_TRAILER3_SPREAD(x) ((x) - (n_trailer3_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long n_trailer3_bits __attribute__((vector_size(8 * N_TRAILER3_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline n_trailer3_lanes n_trailer3_mark(n_trailer3_lanes value, n_trailer3_bits bad)
{
    return (n_trailer3_lanes)((n_trailer3_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int n_trailer3_is_good(int count, const double *check)
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
static inline void n_trailer3_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < N_TRAILER3_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < N_TRAILER3_NY; ++k) {
            state[k * N_TRAILER3_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void n_trailer3_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < N_TRAILER3_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * N_TRAILER3_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void n_trailer3_turn_lanes(n_trailer3_lanes x, n_trailer3_lanes *far,
    n_trailer3_lanes *sine, n_trailer3_lanes *cosine)
{
    double angle[N_TRAILER3_LANES];
    double up[N_TRAILER3_LANES];
    double along[N_TRAILER3_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < N_TRAILER3_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int n_trailer3_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double z1 = theta2 - theta3;
    const double z2 = theta0 - theta1;
    const double z3 = theta1 - theta2;
    const double s1 = sin(z1);
    const double c3 = cos(z1);
    const double c1 = cos(z2);
    const double s2 = sin(z2);
    const double c2 = cos(z3);
    const double s3 = sin(z3);
    const double c_theta0 = cos(theta0);
    const double s_theta0 = sin(theta0);

    /* what else is read */
    const double v = y[6]; /* [m/s] */
    const double w = y[7]; /* [rad/s] */
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / L;
    const double k2 = k1 * (J * k1);

    /* from the state */
    const double z4 = c1 * c2;
    const double z5 = s1 * z4;
    const double z6 = c1 * s3;
    const double z7 = c3 * z4;
    const double z8 = m0 + k2 * (z5 * z5 + (s2 * s2 + z6 * z6)) + m * (z7 * z7 + (c1 * c1 + z4 * z4));
    const double z9 = v * k1;
    const double z10 = s2 * z9;
    const double z11 = z6 * z9;
    const double z12 = z5 * z9;
    const double z13 = s2 * (w - z10);
    const double z14 = c2 * z13 + (s2 - z6) * z11;
    const double z15 = z7 * ((z6 - z5) * z12 + c3 * z14);
    /* (I.2.4) */
    dydt[0] = c_theta0 * v; /* x' */
    dydt[1] = s_theta0 * v; /* y' */
    dydt[2] = w; /* theta0' */
    dydt[3] = z10; /* theta1' */
    dydt[4] = z11; /* theta2' */
    dydt[5] = z12; /* theta3' */
    /* (I.2.15) 30:4 */
    dydt[6] = (m * (z15 + (c1 * z13 + z4 * z14)) - k2 * z15) * (v / z8); /* v' */
    dydt[7] = 0.0; /* w' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J0) > 0.0 * dydt[6])) {
        /* the mass matrix is singular, if J0 is 0 */
        if (!(fabs(J0) > 0.0)) {
            return n_trailer3_refuse(fabs(J0), 0.0, N_TRAILER3_SINGULAR_2);
        }
        /* the coframe is singular, if L is 0 */
        if (!(fabs(L) > 0.0)) {
            return n_trailer3_refuse(fabs(L), 0.0, N_TRAILER3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return n_trailer3_refuse(fabs(z8), 0.0, N_TRAILER3_SINGULAR_2);
        }
        return n_trailer3_finish(8, dydt);
    }
    return N_TRAILER3_OK;
}

int n_trailer3_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double z1 = theta0 - theta1;
    const double z3 = theta1 - theta2;
    const double c_theta0 = cos(theta0);
    const double s_theta0 = sin(theta0);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double s2 = sin(z3);
    const double c2 = cos(z3);
    const double s3 = sin(theta2 - theta3);

    /* what else is read */
    const double v = y[6]; /* [m/s] */
    const double w = y[7]; /* [rad/s] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / L;

    /* from the state */
    const double z2 = v * k1;
    const double z4 = c1 * z2;
    /* (I.2.4) */
    qdot[0] = c_theta0 * v; /* x' */
    qdot[1] = s_theta0 * v; /* y' */
    qdot[2] = w; /* theta0' */
    qdot[3] = s1 * z2; /* theta1' */
    qdot[4] = s2 * z4; /* theta2' */
    qdot[5] = s3 * (c2 * z4); /* theta3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[2] + qdot[5]) <= DBL_MAX)) {
        /* the coframe is singular, if L is 0 */
        if (!(fabs(L) > 0.0)) {
            return n_trailer3_refuse(fabs(L), 0.0, N_TRAILER3_SINGULAR_1);
        }
        return n_trailer3_finish(6, qdot);
    }
    return N_TRAILER3_OK;
}

N_TRAILER3_SLOW
int n_trailer3_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double z1 = theta2 - theta3;
    const double z2 = theta0 - theta1;
    const double z3 = theta1 - theta2;
    const double s1 = sin(z1);
    const double c3 = cos(z1);
    const double c1 = cos(z2);
    const double s2 = sin(z2);
    const double c2 = cos(z3);
    const double s3 = sin(z3);
    const double s_theta0 = sin(theta0);
    const double c_theta0 = cos(theta0);

    /* what else is read */
    const double v = y[6]; /* [m/s] */
    const double w = y[7]; /* [rad/s] */
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / L;
    const double k2 = k1 * (J * k1);

    /* from the state */
    const double z4 = c1 * c2;
    const double z5 = s1 * z4;
    const double z6 = c1 * s3;
    const double z7 = c3 * z4;
    const double z8 = m0 + k2 * (z5 * z5 + (s2 * s2 + z6 * z6)) + m * (z7 * z7 + (c1 * c1 + z4 * z4));
    const double z9 = v * w;
    const double z10 = v * k1;
    const double z11 = (z6 - z5) * z10;
    const double z12 = s2 * k1;
    const double z13 = w - v * z12;
    const double z14 = s2 * z13;
    const double z15 = (s2 - z6) * z10;
    const double z16 = c2 * z14 + z6 * z15;
    const double z17 = z7 * (z5 * z11 + c3 * z16);
    const double z18 = c1 * z13;
    const double z19 = v / z8 * (k2 * z17 - m * (z17 + (s2 * z18 + z4 * z16)));
    const double z20 = k1 * z19;
    /* (I.2.15) */
    qddot[0] = -(s_theta0 * z9 + c_theta0 * z19); /* x'' */
    qddot[1] = c_theta0 * z9 - s_theta0 * z19; /* y'' */
    qddot[2] = 0.0; /* theta0'' */
    qddot[3] = z18 * z10 - z12 * z19; /* theta1'' */
    qddot[4] = -(z10 * (s3 * z14 - z4 * z15) + z6 * z20); /* theta2'' */
    qddot[5] = z10 * (z7 * z11 - s1 * z16) - z5 * z20; /* theta3'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J0) > 0.0 * (qddot[0] + qddot[1] + qddot[3] + qddot[4] + qddot[5]))) {
        /* the mass matrix is singular, if J0 is 0 */
        if (!(fabs(J0) > 0.0)) {
            return n_trailer3_refuse(fabs(J0), 0.0, N_TRAILER3_SINGULAR_2);
        }
        /* the coframe is singular, if L is 0 */
        if (!(fabs(L) > 0.0)) {
            return n_trailer3_refuse(fabs(L), 0.0, N_TRAILER3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return n_trailer3_refuse(fabs(z8), 0.0, N_TRAILER3_SINGULAR_2);
        }
        return n_trailer3_finish(6, qddot);
    }
    return N_TRAILER3_OK;
}

int n_trailer3_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta0 = q[2]; /* heading of the tractor [rad] */

    /* sines and cosines */
    const double c_theta0 = cos(theta0);
    const double s_theta0 = sin(theta0);

    /* what else is read */
    const double x = q[0]; /* axle of the tractor [m] */
    const double y_2 = q[1]; /* y: axle of the tractor [m] */
    const double theta1 = q[3]; /* first trailer [rad] */
    const double theta2 = q[4]; /* second trailer [rad] */
    const double theta3 = q[5]; /* third trailer [rad] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta0_dot = qdot[2]; /* theta0' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = theta0;
    y[3] = theta1;
    y[4] = theta2;
    y[5] = theta3;
    y[6] = x_dot * c_theta0 + y_dot * s_theta0;
    y[7] = theta0_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[4] + y[5] + y[6] + y[7]) <= DBL_MAX)) {
        return n_trailer3_finish(8, y);
    }
    return N_TRAILER3_OK;
}

int n_trailer3_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta0 = q[2]; /* heading of the tractor [rad] */
    const double theta1 = q[3]; /* first trailer [rad] */
    const double theta2 = q[4]; /* second trailer [rad] */
    const double theta3 = q[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double s_theta0 = sin(theta0);
    const double c_theta0 = cos(theta0);
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta2 = cos(theta2);
    const double s_theta3 = sin(theta3);
    const double c_theta3 = cos(theta3);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta1_dot = qdot[3]; /* theta1' [rad/s] */
    const double theta2_dot = qdot[4]; /* theta2' [rad/s] */
    const double theta3_dot = qdot[5]; /* theta3' [rad/s] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the coordinates and velocities */
    const double z1 = theta1_dot * L;
    const double x1_dot = x_dot + s_theta1 * z1;
    const double y1_dot = y_dot - c_theta1 * z1;
    const double z2 = theta2_dot * L;
    const double x2_dot = x1_dot + s_theta2 * z2;
    const double y2_dot = y1_dot - c_theta2 * z2;
    const double z3 = theta3_dot * L;
    /* (I.1.1) 32:5 */
    r[0] = y_dot * c_theta0 - x_dot * s_theta0; /* axle0 = 0 */
    /* (I.1.1) 33:5 */
    r[1] = c_theta1 * y1_dot - s_theta1 * x1_dot; /* axle1 = 0 */
    /* (I.1.1) 34:5 */
    r[2] = c_theta2 * y2_dot - s_theta2 * x2_dot; /* axle2 = 0 */
    /* (I.1.1) 35:5 */
    r[3] = c_theta3 * (y2_dot - c_theta3 * z3) - s_theta3 * (x2_dot + s_theta3 * z3); /* axle3 = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2] + r[3]) <= DBL_MAX)) {
        return n_trailer3_finish(4, r);
    }
    return N_TRAILER3_OK;
}

N_TRAILER3_SLOW
int n_trailer3_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double z1 = theta2 - theta3;
    const double z2 = theta0 - theta1;
    const double z3 = theta1 - theta2;
    const double s1 = sin(z1);
    const double c3 = cos(z1);
    const double c1 = cos(z2);
    const double s2 = sin(z2);
    const double c2 = cos(z3);
    const double s3 = sin(z3);

    /* what else is read */
    const double v = y[6]; /* [m/s] */
    const double w = y[7]; /* [rad/s] */
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / L;
    const double k2 = J * k1;
    const double k3 = k1 * k2;

    /* from the state */
    const double z4 = c1 * c2;
    const double z5 = s1 * z4;
    const double z6 = c1 * s3;
    const double z7 = c3 * z4;
    const double z8 = m0 + k3 * (z5 * z5 + (s2 * s2 + z6 * z6)) + m * (z7 * z7 + (c1 * c1 + z4 * z4));
    const double z9 = s2 * k1;
    const double z10 = v * z9;
    const double z11 = w - z10;
    const double z12 = c1 * z11;
    const double z13 = v * k1;
    const double z14 = (z6 - z5) * z13;
    const double z15 = s2 * z11;
    const double z16 = (s2 - z6) * z13;
    const double z17 = c2 * z15 + z6 * z16;
    const double z18 = z5 * z14 + c3 * z17;
    const double z19 = z7 * z18;
    const double z20 = v / z8 * (k3 * z19 - m * (z19 + (s2 * z12 + z4 * z17)));
    const double z21 = k2 * (z12 * z13 - z9 * z20);
    const double z22 = k1 * z6;
    const double z23 = k2 * (z13 * (s3 * z15 - z4 * z16) + z22 * z20);
    const double z24 = k1 * z5;
    const double z25 = k2 * (z13 * (z7 * z14 - s1 * z17) - z24 * z20);
    const double z26 = m * (v * z18 + z7 * z20);
    const double z27 = m * (v * z17 + z4 * z20) - s1 * z25 + c3 * z26;
    const double z28 = m0 * (v * w) + c1 * z21 + s2 * (m * (v * z15 + c1 * z20) + s3 * z23 + c2 * z27);
    const double z29 = m * v;
    const double z30 = v * z29;
    /* (I.4.1) 32:5 */
    lambda[0] = z28; /* reaction of axle0: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 33:5 */
    lambda[1] = z10 * (c1 * z29) - z21 - c2 * z23 + s3 * z27; /* reaction of axle1: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 34:5 */
    lambda[2] = z4 * (z22 * z30) + z23 + c3 * z25 + s1 * z26; /* reaction of axle2: Q_i gains lambda_3 a_3i */
    /* (I.4.1) 35:5 */
    lambda[3] = z7 * (z24 * z30) - z25; /* reaction of axle3: Q_i gains lambda_4 a_4i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J0) > 0.0 * (lambda[0] + lambda[1] + lambda[2] + lambda[3]))) {
        /* the mass matrix is singular, if J0 is 0 */
        if (!(fabs(J0) > 0.0)) {
            return n_trailer3_refuse(fabs(J0), 0.0, N_TRAILER3_SINGULAR_2);
        }
        /* the coframe is singular, if L is 0 */
        if (!(fabs(L) > 0.0)) {
            return n_trailer3_refuse(fabs(L), 0.0, N_TRAILER3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return n_trailer3_refuse(fabs(z8), 0.0, N_TRAILER3_SINGULAR_2);
        }
        return n_trailer3_finish(4, lambda);
    }
    return N_TRAILER3_OK;
}

double n_trailer3_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double c1 = cos(theta0 - theta1);
    const double c2 = cos(theta1 - theta2);
    const double c3 = cos(theta2 - theta3);

    /* what else is read */
    const double v = y[6]; /* [m/s] */
    const double w = y[7]; /* [rad/s] */
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the parameters alone */
    const double k1 = J / (L * L);
    const double k2 = m0 + k1;

    /* from the state */
    const double z1 = c2 * c2;
    const double z2 = c3 * c3;
    const double z3 = (k2 + c1 * c1 * (m * (1.0 + z1 * (1.0 + z2)) - k1 * (z1 * z2))) * v * v;
    return 0.5 * (J0 * (w * w) + z3);
}

N_TRAILER3_SLOW
int n_trailer3_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 64 * sizeof *J);
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double z1 = theta2 - theta3;
    const double z2 = theta0 - theta1;
    const double z3 = theta1 - theta2;
    const double s1 = sin(z1);
    const double c3 = cos(z1);
    const double c1 = cos(z2);
    const double s2 = sin(z2);
    const double c2 = cos(z3);
    const double s3 = sin(z3);
    const double s_theta0 = sin(theta0);
    const double c_theta0 = cos(theta0);

    /* what else is read */
    const double v = y[6]; /* [m/s] */
    const double w = y[7]; /* [rad/s] */
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J_2 = p[3]; /* J: each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the parameters alone */
    const double k1 = 1.0 / L;
    const double k2 = k1 * (J_2 * k1);

    /* from the state */
    const double z4 = c1 * c2;
    const double z5 = s1 * z4;
    const double z6 = c1 * s3;
    const double z7 = c3 * z4;
    const double z8 = m0 + k2 * (z5 * z5 + (s2 * s2 + z6 * z6)) + m * (z7 * z7 + (c1 * c1 + z4 * z4));
    const double z9 = v * k1;
    const double z10 = c1 * z9;
    const double z11 = s2 * k1;
    const double z12 = z9 * (s2 * s3);
    const double z13 = c2 * z10;
    const double z14 = s2 * c2;
    const double z15 = s1 * z9;
    const double z16 = c3 * z13;
    const double z17 = 1.0 / z8;
    const double z18 = v * k2;
    const double z19 = s2 * z18;
    const double z20 = m * v;
    const double z21 = z7 * z20;
    const double z22 = z5 * z18;
    const double z23 = z4 * z20 + c3 * z21 + s1 * z22;
    const double z24 = z6 * z18;
    const double z25 = c1 * z20 + c2 * z23 + s3 * z24;
    const double z26 = c1 * z19 - s2 * z25;
    const double z27 = w - v * z11;
    const double z28 = c1 * z24;
    const double z29 = c1 * z23;
    const double z30 = c2 * z28 - s3 * z29;
    const double z31 = z9 * z30;
    const double z32 = c1 * z27;
    const double z33 = k1 * (z6 - z5);
    const double z34 = v * z33;
    const double z35 = s1 * z34;
    const double z36 = s2 * z27;
    const double z37 = k1 * (s2 - z6);
    const double z38 = v * z37;
    const double z39 = s3 * z38;
    const double z40 = c2 * z36 + c1 * z39;
    const double z41 = z4 * z35 + c3 * z40;
    const double z42 = z7 * z41;
    const double z43 = k2 * z42 - m * (z42 + (s2 * z32 + z4 * z40));
    const double z44 = z43 * (v * z17);
    const double z45 = k2 * z44;
    const double z46 = c2 * z38;
    const double z47 = m * z44;
    const double z48 = c3 * z34;
    const double z49 = z41 * z20 + 2.0 * (z7 * z47);
    const double z50 = z4 * z22;
    const double z51 = z4 * z21;
    const double z52 = c3 * z50 - s1 * z51;
    const double z53 = z9 * z52;
    const double z54 = z53 - ((z4 * z48 - s1 * z40) * z18 - 2.0 * (z5 * z45));
    const double z55 = z48 * z22 - (z35 * z21 + (z40 * z20 + 2.0 * (z4 * z47))) - c3 * z49 - s1 * z54;
    const double z56 = z27 * z19 + (z46 * z24 - (z39 * z23 + (z36 * z20 + 2.0 * (c1 * z47)))) + c2 * z55;
    const double z57 = z31 - (z53 - ((s3 * z36 - c1 * z46) * z18 + 2.0 * (z6 * z45)));
    const double z58 = c1 * (z9 * z26 + (z27 * z25 - (z31 + (z32 * z18 - 2.0 * (s2 * z45))))) + s2 * (z56 -
        s3 * z57);
    const double z59 = c2 * (z36 * z24 + z38 * z29 + c1 * z57) - s3 * (z36 * z23 - z38 * z28 - c1 * z55);
    const double z60 = c3 * (z40 * z22 + z34 * z51 + z4 * z54) - s1 * (z40 * z21 - z34 * z50 + z4 * z49);
    /* (I.2.15) */
    J[2] = -s_theta0 * v;
    J[6] = c_theta0;
    J[10] = c_theta0 * v;
    J[14] = s_theta0;
    J[23] = 1.0;
    J[26] = z10;
    J[27] = -z10;
    J[30] = z11;
    J[34] = -z12;
    J[35] = z13 + z12;
    J[36] = -z13;
    J[38] = k1 * z6;
    J[42] = -z14 * z15;
    J[43] = (z14 - z6) * z15;
    J[44] = z16 + z6 * z15;
    J[45] = -z16;
    J[46] = k1 * z5;
    J[50] = z17 * z58;
    J[51] = (z59 - z58) * z17;
    J[52] = (z60 - z59) * z17;
    J[53] = -z17 * z60;
    J[54] = z17 * (z11 * z26 - (z37 * z30 + (z43 + z33 * z52)));
    J[55] = -z17 * z26;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J0) > 0.0 * (J[34] + J[35] + J[38] + J[42] + J[43] + J[44] + J[46] + J[50] + J[51] + J[52] +
        J[53] + J[54] + J[55]))) {
        /* the mass matrix is singular, if J0 is 0 */
        if (!(fabs(J0) > 0.0)) {
            return n_trailer3_refuse(fabs(J0), 0.0, N_TRAILER3_SINGULAR_2);
        }
        /* the coframe is singular, if L is 0 */
        if (!(fabs(L) > 0.0)) {
            return n_trailer3_refuse(fabs(L), 0.0, N_TRAILER3_SINGULAR_1);
        }
        /* the mass matrix is singular, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return n_trailer3_refuse(fabs(z8), 0.0, N_TRAILER3_SINGULAR_2);
        }
        return n_trailer3_finish(64, J);
    }
    return N_TRAILER3_OK;
}

int n_trailer3_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */

    /* sines and cosines */
    const double c_theta3 = cos(theta3);
    const double s_theta3 = sin(theta3);
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double c_theta2 = cos(theta2);
    const double s_theta2 = sin(theta2);

    /* what else is read */
    const double x = y[0]; /* axle of the tractor [m] */
    const double y_2 = y[1]; /* y: axle of the tractor [m] */
    const double L = p[4]; /* from axle to axle [m] */

    /* from the state */
    /* 40:11 */
    out[0] = x - L * (c_theta3 + (c_theta1 + c_theta2)); /* tail_x */
    /* 41:11 */
    out[1] = y_2 - L * (s_theta3 + (s_theta1 + s_theta2)); /* tail_y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(L) > 0.0 * (out[0] + out[1]))) {
        /* the coframe is singular, if L is 0 */
        if (!(fabs(L) > 0.0)) {
            return n_trailer3_refuse(fabs(L), 0.0, N_TRAILER3_SINGULAR_1);
        }
        return n_trailer3_finish(2, out);
    }
    return N_TRAILER3_OK;
}

#if N_TRAILER3_LANES >= 2
static __attribute__((noinline)) void n_trailer3_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    n_trailer3_lanes far = {0}; /* the squares of the angles */
    n_trailer3_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    n_trailer3_bits bad = {0}; /* singular blocks */
    const double m0 = fixed[0];
    const double m = fixed[1];
    const double k1 = fixed[2];
    const double k2 = fixed[3];
    const n_trailer3_lanes theta0 = n_trailer3_get(y + 2 * stride);
    const n_trailer3_lanes theta1 = n_trailer3_get(y + 3 * stride);
    const n_trailer3_lanes theta2 = n_trailer3_get(y + 4 * stride);
    const n_trailer3_lanes theta3 = n_trailer3_get(y + 5 * stride);
    const n_trailer3_lanes v = n_trailer3_get(y + 6 * stride);
    const n_trailer3_lanes w = n_trailer3_get(y + 7 * stride);
    const n_trailer3_lanes z1 = theta2 - theta3;
    n_trailer3_lanes sine1, cosine1;
    n_trailer3_turn_lanes(N_TRAILER3_SPREAD(z1), &far, &sine1, &cosine1);
    const n_trailer3_lanes s1 = sine1;
    const n_trailer3_lanes z2 = theta0 - theta1;
    n_trailer3_lanes sine2, cosine2;
    n_trailer3_turn_lanes(N_TRAILER3_SPREAD(z2), &far, &sine2, &cosine2);
    const n_trailer3_lanes c1 = cosine2;
    const n_trailer3_lanes z3 = theta1 - theta2;
    n_trailer3_lanes sine3, cosine3;
    n_trailer3_turn_lanes(N_TRAILER3_SPREAD(z3), &far, &sine3, &cosine3);
    const n_trailer3_lanes c2 = cosine3;
    const n_trailer3_lanes z4 = c1 * c2;
    const n_trailer3_lanes z5 = s1 * z4;
    const n_trailer3_lanes s2 = sine2;
    const n_trailer3_lanes s3 = sine3;
    const n_trailer3_lanes z6 = c1 * s3;
    const n_trailer3_lanes c3 = cosine1;
    const n_trailer3_lanes z7 = c3 * z4;
    const n_trailer3_lanes z8 = m0 + k2 * (z5 * z5 + (s2 * s2 + z6 * z6)) + m * (z7 * z7 + (c1 * c1 + z4 *
        z4));
    n_trailer3_lanes sine4, cosine4;
    n_trailer3_turn_lanes(N_TRAILER3_SPREAD(theta0), &far, &sine4, &cosine4);
    const n_trailer3_lanes c_theta0 = cosine4;
    const n_trailer3_lanes s_theta0 = sine4;
    const n_trailer3_lanes z9 = v * k1;
    const n_trailer3_lanes z10 = s2 * z9;
    const n_trailer3_lanes z11 = z6 * z9;
    const n_trailer3_lanes z12 = z5 * z9;
    const n_trailer3_lanes z13 = s2 * (w - z10);
    const n_trailer3_lanes z14 = c2 * z13 + (s2 - z6) * z11;
    const n_trailer3_lanes z15 = z7 * ((z6 - z5) * z12 + c3 * z14);
    /* (I.2.4) */
    const n_trailer3_lanes slope1 = c_theta0 * v;
    n_trailer3_put(dydt, slope1);
    const n_trailer3_lanes slope2 = s_theta0 * v;
    n_trailer3_put(dydt + 1 * stride, slope2);
    const n_trailer3_lanes slope3 = w;
    n_trailer3_put(dydt + 2 * stride, slope3);
    const n_trailer3_lanes slope4 = z10;
    n_trailer3_put(dydt + 3 * stride, slope4);
    const n_trailer3_lanes slope5 = z11;
    n_trailer3_put(dydt + 4 * stride, slope5);
    const n_trailer3_lanes slope6 = z12;
    n_trailer3_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 30:4 */
    const n_trailer3_lanes slope7 = (m * (z15 + (c1 * z13 + z4 * z14)) - k2 * z15) * (v / z8);
    sum += slope7;
    n_trailer3_put(dydt + 6 * stride, slope7);
    const n_trailer3_lanes slope8 = N_TRAILER3_SPREAD(0.0);
    n_trailer3_put(dydt + 7 * stride, slope8);
    n_trailer3_put(check, n_trailer3_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void n_trailer3_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[N_TRAILER3_LANES];
    double state[8 * N_TRAILER3_LANES];
    double slope[8 * N_TRAILER3_LANES];
    n_trailer3_fill(left, count, t, y, time, state);
    n_trailer3_rhs_lanes(fixed, N_TRAILER3_LANES, time, state, slope, check);
    n_trailer3_pour(left, count, slope, dydt);
}
#endif

int n_trailer3_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if N_TRAILER3_LANES >= 2
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */
    const double k1 = 1.0 / L;
    const double k2 = k1 * (J * k1);
    /* the mass matrix is singular, if J0 is 0 */
    if (!(fabs(J0) > 0.0)) {
        return n_trailer3_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {m0, m, k1, k2};
    double check[1 * N_TRAILER3_LANES];
    int status = N_TRAILER3_OK;
    for (size_t i = 0; i < count; i += N_TRAILER3_LANES) {
        const size_t left = count - i < N_TRAILER3_LANES ? count - i : N_TRAILER3_LANES;
        if (left == N_TRAILER3_LANES) {
            n_trailer3_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            n_trailer3_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!n_trailer3_is_good(1 * N_TRAILER3_LANES, check)) {
            const int one = n_trailer3_one_by_one(count, i, left, t, y, p, dydt);
            status = status == N_TRAILER3_OK ? one : status;
        }
    }
    return status;
#else
    return n_trailer3_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
