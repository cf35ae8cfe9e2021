/*
 * ball_on_table.c: ball_on_table, emitted by nhc 0.1.0 (nhc:cf86522a9b607524)
 * A homogeneous ball that rolls on a turning table; its centre runs on a circle, though nothing holds it
 *     there.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the affine part b_alpha of the
 *     constraints contains the dependent coordinates `x`, `y`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the constraints are not
 *     homogeneous (b_alpha is not zero)
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the time t occurs in T, U or the
 *     constraints
 * ball_on_table.h says what each function does.
 */
#include "ball_on_table.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const ball_on_table_coordinate_names[BALL_ON_TABLE_NQ] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const ball_on_table_state_names[BALL_ON_TABLE_NY] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "phi'",
    "theta'",
    "psi'"
};
const char *const ball_on_table_parameter_names[BALL_ON_TABLE_NP] = {
    "m",
    "a",
    "k",
    "Omega0",
    "Omega1",
    "nu"
};
const char *const ball_on_table_constraint_names[BALL_ON_TABLE_NC] = {
    "roll_x",
    "roll_y"
};
const char *const ball_on_table_output_names[BALL_ON_TABLE_NOUT] = {
    "spin",
    "moving_energy"
};
const double ball_on_table_parameter_defaults[BALL_ON_TABLE_NP] = {
    1.0,
    0.3,
    0.4,
    1.4,
    0.0,
    2.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define BALL_ON_TABLE_SLOW __attribute__((cold, optimize("O1")))
#else
#define BALL_ON_TABLE_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int ball_on_table_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return BALL_ON_TABLE_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return BALL_ON_TABLE_NOT_FINITE;
        }
    }
    return BALL_ON_TABLE_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int ball_on_table_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : BALL_ON_TABLE_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef BALL_ON_TABLE_LANES
#if !defined(__GNUC__)
#define BALL_ON_TABLE_LANES 1
#elif defined(__AVX512F__)
#define BALL_ON_TABLE_LANES 8
#elif defined(__AVX__)
#define BALL_ON_TABLE_LANES 4
#else
#define BALL_ON_TABLE_LANES 2
#endif
#endif
#if BALL_ON_TABLE_LANES > 1
typedef double ball_on_table_lanes __attribute__((vector_size(8 * BALL_ON_TABLE_LANES)));
#else
typedef double ball_on_table_lanes;
#endif

#if BALL_ON_TABLE_LANES >= 2
static inline ball_on_table_lanes ball_on_table_get(const double *from)
{
    ball_on_table_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void ball_on_table_put(double *to, ball_on_table_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int ball_on_table_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = BALL_ON_TABLE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[BALL_ON_TABLE_NY];
        double slope[BALL_ON_TABLE_NY];
        for (size_t k = 0; k < BALL_ON_TABLE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = ball_on_table_rhs(t[i], state, p, slope);
        status = status == BALL_ON_TABLE_OK ? one : status;
        for (size_t k = 0; k < BALL_ON_TABLE_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if BALL_ON_TABLE_LANES >= 2
#define BALL_ON_TABLE_SPREAD(x) ((x) - (ball_on_table_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long ball_on_table_bits __attribute__((vector_size(8 * BALL_ON_TABLE_LANES)));

/* all bits where value is not above bound, or is no number */
static inline ball_on_table_bits ball_on_table_misses(ball_on_table_lanes value, ball_on_table_lanes bound)
{
    return ~(ball_on_table_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline ball_on_table_lanes ball_on_table_mark(ball_on_table_lanes value, ball_on_table_bits bad)
{
    return (ball_on_table_lanes)((ball_on_table_bits)value | bad);
}

static inline ball_on_table_lanes ball_on_table_size(ball_on_table_lanes x)
{
    return (ball_on_table_lanes)((ball_on_table_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int ball_on_table_is_good(int count, const double *check)
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
static inline void ball_on_table_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < BALL_ON_TABLE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < BALL_ON_TABLE_NY; ++k) {
            state[k * BALL_ON_TABLE_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void ball_on_table_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < BALL_ON_TABLE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * BALL_ON_TABLE_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void ball_on_table_turn_lanes(ball_on_table_lanes x, ball_on_table_lanes *far,
    ball_on_table_lanes *sine, ball_on_table_lanes *cosine)
{
    double angle[BALL_ON_TABLE_LANES];
    double up[BALL_ON_TABLE_LANES];
    double along[BALL_ON_TABLE_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < BALL_ON_TABLE_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int ball_on_table_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double z1 = t * nu;
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = 1.0 + k;
    const double k3 = k1 * k2;
    const double k4 = Omega1 * nu;
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / a;

    /* from the state */
    const double Omega = Omega0 + Omega1 * s1;
    const double z2 = psi_dot * s_theta;
    const double z3 = 1.0 / s_theta;
    const double z4 = Omega * Omega;
    const double z5 = c1 * k4;
    const double z6 = c_phi * z4 - s_phi * z5;
    const double z7 = s_phi * z4 + c_phi * z5;
    const double z8 = k5 * (theta_dot * Omega - k6 * (x * z6 + y_2 * z7));
    /* (I.1.2) */
    dydt[0] = a * (theta_dot * s_phi - c_phi * z2) - y_2 * Omega; /* x' */
    dydt[1] = x * Omega - a * (theta_dot * c_phi + s_phi * z2); /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    dydt[4] = psi_dot; /* psi' */
    /* (III.3) 25:4 */
    dydt[5] = z3 * (theta_dot * psi_dot - c_theta * (phi_dot * theta_dot + z8)); /* phi'' */
    dydt[6] = -(k5 * (Omega * z2 - k6 * (x * z7 - y_2 * z6)) + phi_dot * z2); /* theta'' */
    dydt[7] = z3 * (theta_dot * (phi_dot - psi_dot * c_theta) + z8); /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(k * m) > 0.0 * (dydt[0] + dydt[1] + dydt[5] + dydt[6] + dydt[7])
        && fabs(s_theta) > 1e-07 * 4.0)) {
        /* the mass matrix is singular, if k * k1 is 0 */
        if (!(fabs(k * k1) > 0.0)) {
            return ball_on_table_refuse(fabs(k * k1), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return ball_on_table_refuse(fabs(k3), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-07 * 4.0)) {
            return ball_on_table_refuse(fabs(s_theta), 1e-07 * 4.0, BALL_ON_TABLE_SINGULAR_2);
        }
        return ball_on_table_finish(8, dydt);
    }
    return BALL_ON_TABLE_OK;
}

int ball_on_table_velocities(double t, const double *y, const double *p, double *qdot)
{
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double s1 = sin(t * nu);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double a = p[1]; /* radius [m] */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the state */
    const double Omega = Omega0 + Omega1 * s1;
    const double z1 = psi_dot * s_theta;
    /* (I.1.2) */
    qdot[0] = a * (theta_dot * s_phi - c_phi * z1) - y_2 * Omega; /* x' */
    qdot[1] = x * Omega - a * (theta_dot * c_phi + s_phi * z1); /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    qdot[4] = psi_dot; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2]) <= DBL_MAX)) {
        return ball_on_table_finish(5, qdot);
    }
    return BALL_ON_TABLE_OK;
}

int ball_on_table_accelerations(double t, const double *y, const double *p, double *qddot)
{
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double z1 = t * nu;
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = 1.0 + k;
    const double k3 = k1 * k2;
    const double k4 = Omega1 * nu;
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / a;
    const double k7 = 1.0 - k5;
    const double k8 = a * k7;

    /* from the state */
    const double Omega = Omega0 + Omega1 * s1;
    const double z2 = psi_dot * s_theta;
    const double z3 = x * k7;
    const double z4 = c1 * k4;
    const double z5 = y_2 * k7;
    const double z6 = 1.0 / s_theta;
    const double z7 = Omega * Omega;
    const double z8 = c_phi * z7 - s_phi * z4;
    const double z9 = s_phi * z7 + c_phi * z4;
    const double z10 = k5 * (theta_dot * Omega - k6 * (x * z8 + y_2 * z9));
    /* (III.3) */
    qddot[0] = Omega * ((theta_dot * c_phi + s_phi * z2) * k8 - Omega * z3) - z4 * z5; /* x'' */
    qddot[1] = Omega * ((theta_dot * s_phi - c_phi * z2) * k8 - Omega * z5) + z4 * z3; /* y'' */
    qddot[2] = z6 * (theta_dot * psi_dot - c_theta * (phi_dot * theta_dot + z10)); /* phi'' */
    qddot[3] = -(k5 * (Omega * z2 - k6 * (x * z9 - y_2 * z8)) + phi_dot * z2); /* theta'' */
    qddot[4] = z6 * (theta_dot * (phi_dot - psi_dot * c_theta) + z10); /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(k * m) > 0.0 * (qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4])
        && fabs(s_theta) > 1e-07 * 4.0)) {
        /* the mass matrix is singular, if k * k1 is 0 */
        if (!(fabs(k * k1) > 0.0)) {
            return ball_on_table_refuse(fabs(k * k1), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return ball_on_table_refuse(fabs(k3), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-07 * 4.0)) {
            return ball_on_table_refuse(fabs(s_theta), 1e-07 * 4.0, BALL_ON_TABLE_SINGULAR_2);
        }
        return ball_on_table_finish(5, qddot);
    }
    return BALL_ON_TABLE_OK;
}

int ball_on_table_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* centre [m] */
    y[0] = x;
    const double y_2 = q[1]; /* y: centre [m] */
    y[1] = y_2;
    const double phi = q[2]; /* precession [rad] */
    y[2] = phi;
    const double theta = q[3]; /* nutation [rad] */
    y[3] = theta;
    const double psi = q[4]; /* spin [rad] */
    y[4] = psi;
    const double phi_dot = qdot[2]; /* phi' [rad/s] */
    y[5] = phi_dot;
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    y[6] = theta_dot;
    const double psi_dot = qdot[4]; /* psi' [rad/s] */
    y[7] = psi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5] + y[6] + y[7]) <= DBL_MAX)) {
        return ball_on_table_finish(8, y);
    }
    return BALL_ON_TABLE_OK;
}

int ball_on_table_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double s1 = sin(t * nu);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x = q[0]; /* centre [m] */
    const double y = q[1]; /* centre [m] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    const double psi_dot = qdot[4]; /* psi' [rad/s] */
    const double a = p[1]; /* radius [m] */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the coordinates and velocities */
    const double Omega = Omega0 + Omega1 * s1;
    const double z1 = psi_dot * s_theta;
    /* (I.1.1) 27:5 */
    r[0] = y * Omega + (x_dot - a * (theta_dot * s_phi - c_phi * z1)); /* roll_x = 0 */
    /* (I.1.1) 28:5 */
    r[1] = y_dot + a * (theta_dot * c_phi + s_phi * z1) - x * Omega; /* roll_y = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1]) <= DBL_MAX)) {
        return ball_on_table_finish(2, r);
    }
    return BALL_ON_TABLE_OK;
}

int ball_on_table_reactions(double t, const double *y, const double *p, double *lambda)
{
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double z1 = t * nu;
    const double s_theta = sin(theta);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = 1.0 + k;
    const double k3 = k1 * k2;
    const double k4 = Omega1 * nu;
    const double k5 = 1.0 - 1.0 / k2;
    const double k6 = a * k5;

    /* from the state */
    const double Omega = Omega0 + Omega1 * s1;
    const double z2 = psi_dot * s_theta;
    const double z3 = x * k5;
    const double z4 = c1 * k4;
    const double z5 = y_2 * k5;
    /* (I.4.1) 27:5 */
    /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    lambda[0] = m * (Omega * ((theta_dot * c_phi + s_phi * z2) * k6 - Omega * z3) - z4 * z5);
    /* (I.4.1) 28:5 */
    /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    lambda[1] = m * (Omega * ((theta_dot * s_phi - c_phi * z2) * k6 - Omega * z5) + z4 * z3);
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(k * m * a) > 0.0 * (lambda[0] + lambda[1]) && fabs(s_theta) > 1e-07 * 4.0)) {
        /* the mass matrix is singular, if k * k1 is 0 */
        if (!(fabs(k * k1) > 0.0)) {
            return ball_on_table_refuse(fabs(k * k1), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return ball_on_table_refuse(fabs(k3), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-07 * 4.0)) {
            return ball_on_table_refuse(fabs(s_theta), 1e-07 * 4.0, BALL_ON_TABLE_SINGULAR_2);
        }
        return ball_on_table_finish(2, lambda);
    }
    return BALL_ON_TABLE_OK;
}

double ball_on_table_energy(double t, const double *y, const double *p)
{
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double s1 = sin(t * nu);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the parameters alone */
    const double I = m * k * a * a;

    /* from the state */
    const double omega_z = phi_dot + psi_dot * c_theta;
    const double z1 = psi_dot * s_theta;
    const double omega_x = theta_dot * c_phi + s_phi * z1;
    const double omega_y = theta_dot * s_phi - c_phi * z1;
    const double Omega = Omega0 + Omega1 * s1;
    const double z2 = y_2 * Omega - a * omega_y;
    const double z3 = x * Omega - a * omega_x;
    const double z4 = I * (omega_z * omega_z + (omega_x * omega_x + omega_y * omega_y)) + m * (z2 * z2 + z3 *
        z3);
    return 0.5 * z4;
}

BALL_ON_TABLE_SLOW
int ball_on_table_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 64 * sizeof *J);
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double z1 = t * nu;
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the parameters alone */
    const double k1 = m * a * a;
    const double k2 = 1.0 + k;
    const double k3 = k1 * k2;
    const double k4 = Omega1 * nu;
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / a;
    const double k7 = k5 * k6;

    /* from the state */
    const double Omega = Omega0 + Omega1 * s1;
    const double z2 = s_theta * s_phi;
    const double z3 = psi_dot * c_theta;
    const double z4 = a * c_phi;
    const double z5 = a * s_phi;
    const double z6 = c_phi * s_theta;
    const double z7 = 1.0 / s_theta;
    const double z8 = c_theta * z7;
    const double z9 = Omega * Omega;
    const double z10 = c1 * k4;
    const double z11 = c_phi * z9 - s_phi * z10;
    const double z12 = z11 * k7;
    const double z13 = s_phi * z9 + c_phi * z10;
    const double z14 = z13 * k7;
    const double z15 = (x * z13 - y_2 * z11) * k7;
    const double z16 = k6 * (x * z11 + y_2 * z13);
    const double z17 = k5 * (theta_dot * Omega - z16);
    const double z18 = phi_dot * theta_dot + z17;
    const double z19 = theta_dot * psi_dot;
    const double z20 = c_theta * (z7 * z7);
    const double z21 = theta_dot * z8;
    const double z22 = Omega * k5;
    const double z23 = phi_dot + z22;
    const double z24 = theta_dot * z7;
    const double z25 = phi_dot - z3;
    /* (III.3) */
    J[1] = -Omega;
    J[2] = a * (theta_dot * c_phi + psi_dot * z2);
    J[3] = -z3 * z4;
    J[6] = z5;
    J[7] = -a * z6;
    J[8] = Omega;
    J[10] = a * (theta_dot * s_phi - psi_dot * z6);
    J[11] = -z3 * z5;
    J[14] = -z4;
    J[15] = -a * z2;
    J[21] = 1.0;
    J[30] = 1.0;
    J[39] = 1.0;
    J[40] = z8 * z12;
    J[41] = z8 * z14;
    J[42] = -z8 * z15;
    J[43] = z18 - (z19 - c_theta * z18) * z20;
    J[45] = -z21;
    J[46] = z7 * (psi_dot - c_theta * z23);
    J[47] = z24;
    J[48] = z14;
    J[49] = -z12;
    J[50] = k5 * z16;
    J[51] = -z3 * z23;
    J[53] = -psi_dot * s_theta;
    J[55] = -s_theta * z23;
    J[56] = -z7 * z12;
    J[57] = -z7 * z14;
    J[58] = z7 * z15;
    J[59] = z19 - (theta_dot * z25 + z17) * z20;
    J[61] = z24;
    J[62] = z7 * (z25 + z22);
    J[63] = -z21;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(k * m) > 0.0 * (J[2] + J[3] + J[7] + J[10] + J[11] + J[15] + J[40] + J[41] + J[42] + J[43] +
        J[46] + J[47] + J[50] + J[51] + J[55] + J[56] + J[57] + J[58] + J[59] + J[62] + J[63])
        && fabs(s_theta) > 1e-07 * 4.0)) {
        /* the mass matrix is singular, if k * k1 is 0 */
        if (!(fabs(k * k1) > 0.0)) {
            return ball_on_table_refuse(fabs(k * k1), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if k3 is 0 */
        if (!(fabs(k3) > 0.0)) {
            return ball_on_table_refuse(fabs(k3), 0.0, BALL_ON_TABLE_SINGULAR_2);
        }
        /* the mass matrix is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-07 * 4.0)) {
            return ball_on_table_refuse(fabs(s_theta), 1e-07 * 4.0, BALL_ON_TABLE_SINGULAR_2);
        }
        return ball_on_table_finish(64, J);
    }
    return BALL_ON_TABLE_OK;
}

int ball_on_table_outputs(double t, const double *y, const double *p, double *out)
{
    const double theta = y[3]; /* nutation [rad] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double s1 = sin(t * nu);

    /* what else is read */
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* y: centre [m] */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */

    /* from the parameters alone */
    const double k1 = a * a;

    /* from the state */
    const double z1 = psi_dot * c_theta;
    const double Omega = Omega0 + Omega1 * s1;
    const double z2 = theta_dot * theta_dot;
    const double z3 = 0.5 * z2 + psi_dot * (0.5 * psi_dot - Omega * c_theta) - phi_dot * (Omega - (0.5 *
        phi_dot + z1));
    const double z4 = 0.5 * (Omega * Omega * (x * x + y_2 * y_2)) - k1 * (0.5 * (z2 + s_theta * s_theta *
        (psi_dot * psi_dot)) + k * z3);
    /* 31:9 */
    out[0] = phi_dot + z1; /* spin */
    /* 32:18 */
    out[1] = -m * z4; /* moving_energy */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return ball_on_table_finish(2, out);
    }
    return BALL_ON_TABLE_OK;
}

#if BALL_ON_TABLE_LANES >= 2
static __attribute__((noinline)) void ball_on_table_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    ball_on_table_lanes far = {0}; /* the squares of the angles */
    ball_on_table_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    ball_on_table_bits bad = {0}; /* singular blocks */
    const double a = fixed[0];
    const double Omega0 = fixed[1];
    const double Omega1 = fixed[2];
    const double nu = fixed[3];
    const double k4 = fixed[4];
    const double k5 = fixed[5];
    const double k6 = fixed[6];
    const ball_on_table_lanes t_ = ball_on_table_get(t);
    const ball_on_table_lanes x = ball_on_table_get(y);
    const ball_on_table_lanes y_2 = ball_on_table_get(y + 1 * stride);
    const ball_on_table_lanes phi = ball_on_table_get(y + 2 * stride);
    const ball_on_table_lanes theta = ball_on_table_get(y + 3 * stride);
    const ball_on_table_lanes phi_dot = ball_on_table_get(y + 5 * stride);
    const ball_on_table_lanes theta_dot = ball_on_table_get(y + 6 * stride);
    const ball_on_table_lanes psi_dot = ball_on_table_get(y + 7 * stride);
    ball_on_table_lanes sine1, cosine1;
    ball_on_table_turn_lanes(BALL_ON_TABLE_SPREAD(theta), &far, &sine1, &cosine1);
    const ball_on_table_lanes s_theta = sine1;
    /* the mass matrix is singular, if s_theta is nearly 0 */
    bad |= ball_on_table_misses(ball_on_table_size(BALL_ON_TABLE_SPREAD(s_theta)), BALL_ON_TABLE_SPREAD(1e-07
        * 4.0));
    const ball_on_table_lanes z1 = t_ * nu;
    ball_on_table_lanes sine2, cosine2;
    ball_on_table_turn_lanes(BALL_ON_TABLE_SPREAD(z1), &far, &sine2, &cosine2);
    const ball_on_table_lanes s1 = sine2;
    const ball_on_table_lanes Omega = Omega0 + Omega1 * s1;
    ball_on_table_lanes sine3, cosine3;
    ball_on_table_turn_lanes(BALL_ON_TABLE_SPREAD(phi), &far, &sine3, &cosine3);
    const ball_on_table_lanes s_phi = sine3;
    const ball_on_table_lanes c_phi = cosine3;
    const ball_on_table_lanes z2 = psi_dot * s_theta;
    const ball_on_table_lanes z3 = 1.0 / s_theta;
    const ball_on_table_lanes c_theta = cosine1;
    const ball_on_table_lanes z4 = Omega * Omega;
    const ball_on_table_lanes c1 = cosine2;
    const ball_on_table_lanes z5 = c1 * k4;
    const ball_on_table_lanes z6 = c_phi * z4 - s_phi * z5;
    const ball_on_table_lanes z7 = s_phi * z4 + c_phi * z5;
    const ball_on_table_lanes z8 = k5 * (theta_dot * Omega - k6 * (x * z6 + y_2 * z7));
    /* (I.1.2) */
    const ball_on_table_lanes slope1 = a * (theta_dot * s_phi - c_phi * z2) - y_2 * Omega;
    sum += slope1;
    ball_on_table_put(dydt, slope1);
    const ball_on_table_lanes slope2 = x * Omega - a * (theta_dot * c_phi + s_phi * z2);
    sum += slope2;
    ball_on_table_put(dydt + 1 * stride, slope2);
    const ball_on_table_lanes slope3 = phi_dot;
    ball_on_table_put(dydt + 2 * stride, slope3);
    const ball_on_table_lanes slope4 = theta_dot;
    ball_on_table_put(dydt + 3 * stride, slope4);
    const ball_on_table_lanes slope5 = psi_dot;
    ball_on_table_put(dydt + 4 * stride, slope5);
    /* (III.3) 25:4 */
    const ball_on_table_lanes slope6 = z3 * (theta_dot * psi_dot - c_theta * (phi_dot * theta_dot + z8));
    sum += slope6;
    ball_on_table_put(dydt + 5 * stride, slope6);
    const ball_on_table_lanes slope7 = -(k5 * (Omega * z2 - k6 * (x * z7 - y_2 * z6)) + phi_dot * z2);
    sum += slope7;
    ball_on_table_put(dydt + 6 * stride, slope7);
    const ball_on_table_lanes slope8 = z3 * (theta_dot * (phi_dot - psi_dot * c_theta) + z8);
    sum += slope8;
    ball_on_table_put(dydt + 7 * stride, slope8);
    ball_on_table_put(check, ball_on_table_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void ball_on_table_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[BALL_ON_TABLE_LANES];
    double state[8 * BALL_ON_TABLE_LANES];
    double slope[8 * BALL_ON_TABLE_LANES];
    ball_on_table_fill(left, count, t, y, time, state);
    ball_on_table_rhs_lanes(fixed, BALL_ON_TABLE_LANES, time, state, slope, check);
    ball_on_table_pour(left, count, slope, dydt);
}
#endif

int ball_on_table_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if BALL_ON_TABLE_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */
    const double k1 = m * a * a;
    const double k2 = 1.0 + k;
    const double k3 = k1 * k2;
    const double k4 = Omega1 * nu;
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / a;
    /* the mass matrix is singular, if k * k1 is 0 */
    if (!(fabs(k * k1) > 0.0)) {
        return ball_on_table_one_by_one(count, 0, count, t, y, p, dydt);
    }
    /* the mass matrix is singular, if k3 is 0 */
    if (!(fabs(k3) > 0.0)) {
        return ball_on_table_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {a, Omega0, Omega1, nu, k4, k5, k6};
    double check[1 * BALL_ON_TABLE_LANES];
    int status = BALL_ON_TABLE_OK;
    for (size_t i = 0; i < count; i += BALL_ON_TABLE_LANES) {
        const size_t left = count - i < BALL_ON_TABLE_LANES ? count - i : BALL_ON_TABLE_LANES;
        if (left == BALL_ON_TABLE_LANES) {
            ball_on_table_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            ball_on_table_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!ball_on_table_is_good(1 * BALL_ON_TABLE_LANES, check)) {
            const int one = ball_on_table_one_by_one(count, i, left, t, y, p, dydt);
            status = status == BALL_ON_TABLE_OK ? one : status;
        }
    }
    return status;
#else
    return ball_on_table_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
