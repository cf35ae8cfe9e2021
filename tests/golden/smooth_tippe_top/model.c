/*
 * smooth_tippe_top.c: smooth_tippe_top, emitted by nhc 0.1.0 (nhc:e9d3fa527407a5d8)
 * The ball of routh_sphere on a plane without any friction.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * smooth_tippe_top.h says what each function does.
 */
#include "smooth_tippe_top.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const smooth_tippe_top_coordinate_names[SMOOTH_TIPPE_TOP_NQ] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const smooth_tippe_top_state_names[SMOOTH_TIPPE_TOP_NY] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "x'",
    "y'",
    "phi'",
    "theta'",
    "psi'"
};
const char *const smooth_tippe_top_parameter_names[SMOOTH_TIPPE_TOP_NP] = {
    "m",
    "R",
    "e",
    "I1",
    "I3",
    "g"
};
const char *const smooth_tippe_top_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const smooth_tippe_top_output_names[SMOOTH_TIPPE_TOP_NOUT] = {
    "jellett",
    "spin",
    "p_x",
    "p_y"
};
const double smooth_tippe_top_parameter_defaults[SMOOTH_TIPPE_TOP_NP] = {
    1.0,
    1.0,
    -0.2,
    0.38,
    0.42,
    9.81
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define SMOOTH_TIPPE_TOP_SLOW __attribute__((cold, optimize("O1")))
#else
#define SMOOTH_TIPPE_TOP_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int smooth_tippe_top_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return SMOOTH_TIPPE_TOP_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return SMOOTH_TIPPE_TOP_NOT_FINITE;
        }
    }
    return SMOOTH_TIPPE_TOP_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int smooth_tippe_top_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : SMOOTH_TIPPE_TOP_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef SMOOTH_TIPPE_TOP_LANES
#if !defined(__GNUC__)
#define SMOOTH_TIPPE_TOP_LANES 1
#elif defined(__AVX512F__)
#define SMOOTH_TIPPE_TOP_LANES 8
#elif defined(__AVX__)
#define SMOOTH_TIPPE_TOP_LANES 4
#else
#define SMOOTH_TIPPE_TOP_LANES 2
#endif
#endif
#if SMOOTH_TIPPE_TOP_LANES > 1
typedef double smooth_tippe_top_lanes __attribute__((vector_size(8 * SMOOTH_TIPPE_TOP_LANES)));
#else
typedef double smooth_tippe_top_lanes;
#endif

#if SMOOTH_TIPPE_TOP_LANES >= 2
static inline smooth_tippe_top_lanes smooth_tippe_top_get(const double *from)
{
    smooth_tippe_top_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void smooth_tippe_top_put(double *to, smooth_tippe_top_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int smooth_tippe_top_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = SMOOTH_TIPPE_TOP_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[SMOOTH_TIPPE_TOP_NY];
        double slope[SMOOTH_TIPPE_TOP_NY];
        for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = smooth_tippe_top_rhs(t[i], state, p, slope);
        status = status == SMOOTH_TIPPE_TOP_OK ? one : status;
        for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if SMOOTH_TIPPE_TOP_LANES >= 2
#define SMOOTH_TIPPE_TOP_SPREAD(x) ((x) - (smooth_tippe_top_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long smooth_tippe_top_bits __attribute__((vector_size(8 * SMOOTH_TIPPE_TOP_LANES)));

/* all bits where value is not above bound, or is no number */
static inline smooth_tippe_top_bits smooth_tippe_top_misses(smooth_tippe_top_lanes value, smooth_tippe_top_lanes bound)
{
    return ~(smooth_tippe_top_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline smooth_tippe_top_lanes smooth_tippe_top_mark(smooth_tippe_top_lanes value, smooth_tippe_top_bits bad)
{
    return (smooth_tippe_top_lanes)((smooth_tippe_top_bits)value | bad);
}

static inline smooth_tippe_top_lanes smooth_tippe_top_size(smooth_tippe_top_lanes x)
{
    return (smooth_tippe_top_lanes)((smooth_tippe_top_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int smooth_tippe_top_is_good(int count, const double *check)
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
static inline void smooth_tippe_top_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < SMOOTH_TIPPE_TOP_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
            state[k * SMOOTH_TIPPE_TOP_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void smooth_tippe_top_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * SMOOTH_TIPPE_TOP_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void smooth_tippe_top_turn_lanes(smooth_tippe_top_lanes x, smooth_tippe_top_lanes *far,
    smooth_tippe_top_lanes *sine, smooth_tippe_top_lanes *cosine)
{
    double angle[SMOOTH_TIPPE_TOP_LANES];
    double up[SMOOTH_TIPPE_TOP_LANES];
    double along[SMOOTH_TIPPE_TOP_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < SMOOTH_TIPPE_TOP_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int smooth_tippe_top_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x_dot = y[5]; /* x' [m/s] */
    const double y_dot = y[6]; /* y' [m/s] */
    const double phi_dot = y[7]; /* phi' [rad/s] */
    const double theta_dot = y[8]; /* theta' [rad/s] */
    const double psi_dot = y[9]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * e;
    const double k2 = e * k1;
    const double k3 = 1.0 / I1;
    const double k4 = I1 + k2;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = I1 + z1 * k2;
    const double z3 = phi_dot * c_theta;
    const double omega3 = psi_dot + z3;
    const double z4 = k3 * (omega3 * (theta_dot * I3));
    const double z5 = theta_dot * theta_dot;
    const double z6 = I3 * omega3;
    const double z7 = I1 * z3;
    const double z8 = (phi_dot * (z6 - z7) - k1 * (g - e * (c_theta * z5))) / z2;
    const double z9 = s_theta * (z5 + phi_dot * phi_dot + c_theta * z8);
    const double z10 = theta_dot / (I1 * s_theta) * (z6 - 2.0 * z7);
    /* (II.3) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    dydt[4] = psi_dot; /* psi' */
    /* (II.3) 24:4 */
    dydt[5] = (s_phi * z9 - c_phi * z4) * e; /* x'' */
    dydt[6] = -e * (s_phi * z4 + c_phi * z9); /* y'' */
    dydt[7] = z10; /* phi'' */
    dydt[8] = -s_theta * z8; /* theta'' */
    dydt[9] = s_theta * (phi_dot * theta_dot) - c_theta * z10; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m * I3) > 0.0 * (dydt[0] + dydt[1] + dydt[5] + dydt[6] + dydt[8] + dydt[9])
        && fabs(I1 * z1) > 1e-13 * (z1 * k4)
        && fabs(z2) > 1e-13 * k4)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return smooth_tippe_top_refuse(fabs(m), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return smooth_tippe_top_refuse(fabs(I3), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I1 * z1 is nearly 0 */
        if (!(fabs(I1 * z1) > 1e-13 * (z1 * k4))) {
            return smooth_tippe_top_refuse(fabs(I1 * z1), 1e-13 * (z1 * k4), SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if z2 is nearly 0 */
        if (!(fabs(z2) > 1e-13 * k4)) {
            return smooth_tippe_top_refuse(fabs(z2), 1e-13 * k4, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        return smooth_tippe_top_finish(10, dydt);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double x_dot = y[5]; /* x' [m/s] */
    qdot[0] = x_dot; /* x' */
    const double y_dot = y[6]; /* y' [m/s] */
    qdot[1] = y_dot; /* y' */
    const double phi_dot = y[7]; /* phi' [rad/s] */
    qdot[2] = phi_dot; /* phi' */
    const double theta_dot = y[8]; /* theta' [rad/s] */
    qdot[3] = theta_dot; /* theta' */
    const double psi_dot = y[9]; /* psi' [rad/s] */
    qdot[4] = psi_dot; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4]) <= DBL_MAX)) {
        return smooth_tippe_top_finish(5, qdot);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double phi_dot = y[7]; /* phi' [rad/s] */
    const double theta_dot = y[8]; /* theta' [rad/s] */
    const double psi_dot = y[9]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * e;
    const double k2 = m * e * e;
    const double k3 = I1 + k2;
    const double k4 = 1.0 / I1;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = I1 + z1 * k2;
    const double z3 = phi_dot * c_theta;
    const double omega3 = psi_dot + z3;
    const double z4 = k4 * (omega3 * (theta_dot * I3));
    const double z5 = theta_dot * theta_dot;
    const double z6 = I3 * omega3;
    const double z7 = I1 * z3;
    const double z8 = (phi_dot * (z6 - z7) - k1 * (g - e * (c_theta * z5))) / z2;
    const double z9 = s_theta * (z5 + phi_dot * phi_dot + c_theta * z8);
    const double z10 = theta_dot / (I1 * s_theta) * (z6 - 2.0 * z7);
    /* (II.3) */
    qddot[0] = (s_phi * z9 - c_phi * z4) * e; /* x'' */
    qddot[1] = -e * (s_phi * z4 + c_phi * z9); /* y'' */
    qddot[2] = z10; /* phi'' */
    qddot[3] = -s_theta * z8; /* theta'' */
    qddot[4] = s_theta * (phi_dot * theta_dot) - c_theta * z10; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m * I3) > 0.0 * (qddot[0] + qddot[1] + qddot[3] + qddot[4])
        && fabs(I1 * z1) > 1e-13 * (z1 * k3)
        && fabs(z2) > 1e-13 * k3)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return smooth_tippe_top_refuse(fabs(m), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return smooth_tippe_top_refuse(fabs(I3), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I1 * z1 is nearly 0 */
        if (!(fabs(I1 * z1) > 1e-13 * (z1 * k3))) {
            return smooth_tippe_top_refuse(fabs(I1 * z1), 1e-13 * (z1 * k3), SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if z2 is nearly 0 */
        if (!(fabs(z2) > 1e-13 * k3)) {
            return smooth_tippe_top_refuse(fabs(z2), 1e-13 * k3, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        return smooth_tippe_top_finish(5, qddot);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* geometric centre [m] */
    y[0] = x;
    const double y_2 = q[1]; /* y: geometric centre [m] */
    y[1] = y_2;
    const double phi = q[2]; /* precession [rad] */
    y[2] = phi;
    const double theta = q[3]; /* nutation [rad] */
    y[3] = theta;
    const double psi = q[4]; /* spin [rad] */
    y[4] = psi;
    const double x_dot = qdot[0]; /* x' [m/s] */
    y[5] = x_dot;
    const double y_dot = qdot[1]; /* y' [m/s] */
    y[6] = y_dot;
    const double phi_dot = qdot[2]; /* phi' [rad/s] */
    y[7] = phi_dot;
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    y[8] = theta_dot;
    const double psi_dot = qdot[4]; /* psi' [rad/s] */
    y[9] = psi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5] + y[6] + y[7] + y[8] + y[9]) <= DBL_MAX)) {
        return smooth_tippe_top_finish(10, y);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * e * e;
    const double k2 = I1 + k1;

    /* from the state */
    const double z1 = s_theta * s_theta;
    /* the mass matrix is singular, if m is 0 */
    if (!(fabs(m) > 0.0)) {
        return smooth_tippe_top_refuse(fabs(m), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
    }
    /* the mass matrix is singular, if I3 is 0 */
    if (!(fabs(I3) > 0.0)) {
        return smooth_tippe_top_refuse(fabs(I3), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
    }
    /* the mass matrix is singular, if I1 * z1 is nearly 0 */
    if (!(fabs(I1 * z1) > 1e-13 * (z1 * k2))) {
        return smooth_tippe_top_refuse(fabs(I1 * z1), 1e-13 * (z1 * k2), SMOOTH_TIPPE_TOP_SINGULAR_2);
    }
    /* the mass matrix is singular, if I1 + z1 * k1 is nearly 0 */
    if (!(fabs(I1 + z1 * k1) > 1e-13 * k2)) {
        return smooth_tippe_top_refuse(fabs(I1 + z1 * k1), 1e-13 * k2, SMOOTH_TIPPE_TOP_SINGULAR_2);
    }
    (void)lambda;
    return SMOOTH_TIPPE_TOP_OK;
}

double smooth_tippe_top_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double x_dot = y[5]; /* x' [m/s] */
    const double y_dot = y[6]; /* y' [m/s] */
    const double phi_dot = y[7]; /* phi' [rad/s] */
    const double theta_dot = y[8]; /* theta' [rad/s] */
    const double psi_dot = y[9]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = e * (m * g);

    /* from the state */
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z1 = theta_dot * e;
    const double z2 = c_theta * z1;
    const double z3 = phi_dot * (e * s_theta);
    const double X_dot = x_dot + (s_phi * z2 + c_phi * z3);
    const double Y_dot = y_dot - (c_phi * z2 - s_phi * z3);
    const double z4 = s_theta * z1;
    const double z5 = I1 * (theta_dot * theta_dot + s_theta * s_theta * (phi_dot * phi_dot)) + m * (X_dot *
        X_dot + Y_dot * Y_dot + z4 * z4);
    return 0.5 * (I3 * (omega3 * omega3) + z5) + c_theta * k1;
}

SMOOTH_TIPPE_TOP_SLOW
int smooth_tippe_top_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 100 * sizeof *J);
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double phi_dot = y[7]; /* phi' [rad/s] */
    const double theta_dot = y[8]; /* theta' [rad/s] */
    const double psi_dot = y[9]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * e;
    const double k2 = e * k1;
    const double k3 = m * e * e;
    const double k4 = I1 + k3;
    const double k5 = I1 - I3;
    const double k6 = 1.0 / I1;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = I1 + z1 * k3;
    const double z3 = s_theta * c_phi;
    const double z4 = theta_dot * theta_dot;
    const double z5 = 1.0 / z2;
    const double z6 = c_theta * z5;
    const double z7 = e * z4;
    const double z8 = phi_dot * c_theta;
    const double omega3 = psi_dot + z8;
    const double z9 = I3 * omega3;
    const double z10 = phi_dot * I1;
    const double z11 = c_theta * z10;
    const double z12 = z9 - z11;
    const double z13 = k1 * (g - c_theta * z7) - phi_dot * z12;
    const double z14 = z4 + phi_dot * phi_dot - z6 * z13;
    const double z15 = theta_dot * I3;
    const double z16 = s_phi * z15;
    const double z17 = omega3 * k6;
    const double z18 = c_theta * z14;
    const double z19 = s_theta * s_phi;
    const double z20 = phi_dot * s_theta;
    const double z21 = I3 * z20;
    const double z22 = s_theta * z10;
    const double z23 = k1 * (s_theta * z7) + phi_dot * (z21 - z22);
    const double z24 = s_theta * z5;
    const double z25 = k3 * (s_theta * c_theta * (z5 * z5));
    const double z26 = z6 * z23 - z13 * (z24 + 2.0 * (c_theta * z25));
    const double z27 = c_phi * z15;
    const double z28 = z27 * k6;
    const double z29 = z8 * k5 - z12;
    const double z30 = 2.0 * phi_dot - z6 * z29;
    const double z31 = theta_dot * c_theta * k2;
    const double z32 = theta_dot + z6 * z31;
    const double z33 = I3 * z17;
    const double z34 = phi_dot * I3;
    const double z35 = z6 * z34;
    const double z36 = k6 * z16;
    const double z37 = 1.0 / (I1 * s_theta);
    const double z38 = theta_dot * z37;
    const double z39 = I1 * c_theta;
    const double z40 = z9 - 2.0 * z11;
    const double z41 = z38 * (z21 - 2.0 * z22) + z39 * (z37 * z37 * (theta_dot * z40));
    const double z42 = z38 * (I3 * c_theta - 2.0 * z39);
    const double z43 = z37 * z40;
    const double z44 = I3 * z38;
    /* (II.3) */
    J[5] = 1.0;
    J[16] = 1.0;
    J[27] = 1.0;
    J[38] = 1.0;
    J[49] = 1.0;
    J[52] = e * (z3 * z14 + z16 * z17);
    J[53] = e * (s_phi * z18 - z19 * z26 + z20 * z28);
    J[57] = e * (z19 * z30 - c_theta * z28);
    J[58] = e * (2.0 * (z19 * z32) - c_phi * z33);
    J[59] = (z19 * z35 - z28) * e;
    J[62] = e * (z19 * z14 - z27 * z17);
    J[63] = (z20 * z36 - (c_phi * z18 - z3 * z26)) * e;
    J[67] = -e * (z3 * z30 + c_theta * z36);
    J[68] = -e * (2.0 * (z3 * z32) + s_phi * z33);
    J[69] = -e * (z36 + z3 * z35);
    J[73] = -z41;
    J[77] = z42;
    J[78] = z43;
    J[79] = z44;
    J[83] = z24 * z23 + z13 * (z6 - 2.0 * (s_theta * z25));
    J[87] = z24 * z29;
    J[88] = -2.0 * (z24 * z31);
    J[89] = -z24 * z34;
    J[93] = theta_dot * z8 + (z40 * (s_theta * z38) + c_theta * z41);
    J[97] = theta_dot * s_theta - c_theta * z42;
    J[98] = z20 - c_theta * z43;
    J[99] = -c_theta * z44;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m * I3) > 0.0 * (J[52] + J[53] + J[57] + J[58] + J[59] + J[62] + J[63] + J[67] + J[68] + J[69]
        + J[83] + J[87] + J[88] + J[89] + J[93] + J[97] + J[98] + J[99])
        && fabs(I1 * z1) > 1e-13 * (z1 * k4)
        && fabs(z2) > 1e-13 * k4)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return smooth_tippe_top_refuse(fabs(m), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return smooth_tippe_top_refuse(fabs(I3), 0.0, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I1 * z1 is nearly 0 */
        if (!(fabs(I1 * z1) > 1e-13 * (z1 * k4))) {
            return smooth_tippe_top_refuse(fabs(I1 * z1), 1e-13 * (z1 * k4), SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if z2 is nearly 0 */
        if (!(fabs(z2) > 1e-13 * k4)) {
            return smooth_tippe_top_refuse(fabs(z2), 1e-13 * k4, SMOOTH_TIPPE_TOP_SINGULAR_2);
        }
        return smooth_tippe_top_finish(100, J);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double x_dot = y[5]; /* x' [m/s] */
    const double y_dot = y[6]; /* y' [m/s] */
    const double phi_dot = y[7]; /* phi' [rad/s] */
    const double theta_dot = y[8]; /* theta' [rad/s] */
    const double psi_dot = y[9]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* from the parameters alone */
    const double k1 = R * I1;

    /* from the state */
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z1 = e * (theta_dot * c_theta);
    const double z2 = phi_dot * (e * s_theta);
    /* 27:12 */
    out[0] = k1 * (phi_dot * (s_theta * s_theta)) + I3 * (omega3 * (e + R * c_theta)); /* jellett */
    /* 28:9 */
    out[1] = omega3; /* spin */
    /* 29:8 */
    out[2] = m * (x_dot + (s_phi * z1 + c_phi * z2)); /* p_x */
    /* 30:8 */
    out[3] = m * (y_dot - (c_phi * z1 - s_phi * z2)); /* p_y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[2] + out[3]) <= DBL_MAX)) {
        return smooth_tippe_top_finish(4, out);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

#if SMOOTH_TIPPE_TOP_LANES >= 2
static __attribute__((noinline)) void smooth_tippe_top_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    smooth_tippe_top_lanes far = {0}; /* the squares of the angles */
    smooth_tippe_top_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    smooth_tippe_top_bits bad = {0}; /* singular blocks */
    const double e = fixed[0];
    const double I1 = fixed[1];
    const double I3 = fixed[2];
    const double g = fixed[3];
    const double k1 = fixed[4];
    const double k2 = fixed[5];
    const double k3 = fixed[6];
    const double k4 = fixed[7];
    const smooth_tippe_top_lanes phi = smooth_tippe_top_get(y + 2 * stride);
    const smooth_tippe_top_lanes theta = smooth_tippe_top_get(y + 3 * stride);
    const smooth_tippe_top_lanes x_dot = smooth_tippe_top_get(y + 5 * stride);
    const smooth_tippe_top_lanes y_dot = smooth_tippe_top_get(y + 6 * stride);
    const smooth_tippe_top_lanes phi_dot = smooth_tippe_top_get(y + 7 * stride);
    const smooth_tippe_top_lanes theta_dot = smooth_tippe_top_get(y + 8 * stride);
    const smooth_tippe_top_lanes psi_dot = smooth_tippe_top_get(y + 9 * stride);
    smooth_tippe_top_lanes sine1, cosine1;
    smooth_tippe_top_turn_lanes(SMOOTH_TIPPE_TOP_SPREAD(theta), &far, &sine1, &cosine1);
    const smooth_tippe_top_lanes s_theta = sine1;
    const smooth_tippe_top_lanes z1 = s_theta * s_theta;
    /* the mass matrix is singular, if I1 * z1 is nearly 0 */
    bad |= smooth_tippe_top_misses(smooth_tippe_top_size(SMOOTH_TIPPE_TOP_SPREAD(I1 * z1)), 1e-13 * (z1 *
        k4));
    const smooth_tippe_top_lanes z2 = I1 + z1 * k2;
    /* the mass matrix is singular, if z2 is nearly 0 */
    bad |= smooth_tippe_top_misses(smooth_tippe_top_size(SMOOTH_TIPPE_TOP_SPREAD(z2)),
        SMOOTH_TIPPE_TOP_SPREAD(1e-13 * k4));
    smooth_tippe_top_lanes sine2, cosine2;
    smooth_tippe_top_turn_lanes(SMOOTH_TIPPE_TOP_SPREAD(phi), &far, &sine2, &cosine2);
    const smooth_tippe_top_lanes c_phi = cosine2;
    const smooth_tippe_top_lanes c_theta = cosine1;
    const smooth_tippe_top_lanes z3 = phi_dot * c_theta;
    const smooth_tippe_top_lanes omega3 = psi_dot + z3;
    const smooth_tippe_top_lanes z4 = k3 * (omega3 * (theta_dot * I3));
    const smooth_tippe_top_lanes s_phi = sine2;
    const smooth_tippe_top_lanes z5 = theta_dot * theta_dot;
    const smooth_tippe_top_lanes z6 = I3 * omega3;
    const smooth_tippe_top_lanes z7 = I1 * z3;
    const smooth_tippe_top_lanes z8 = (phi_dot * (z6 - z7) - k1 * (g - e * (c_theta * z5))) / z2;
    const smooth_tippe_top_lanes z9 = s_theta * (z5 + phi_dot * phi_dot + c_theta * z8);
    const smooth_tippe_top_lanes z10 = theta_dot / (I1 * s_theta) * (z6 - 2.0 * z7);
    /* (II.3) */
    const smooth_tippe_top_lanes slope1 = x_dot;
    sum += slope1;
    smooth_tippe_top_put(dydt, slope1);
    const smooth_tippe_top_lanes slope2 = y_dot;
    sum += slope2;
    smooth_tippe_top_put(dydt + 1 * stride, slope2);
    const smooth_tippe_top_lanes slope3 = phi_dot;
    smooth_tippe_top_put(dydt + 2 * stride, slope3);
    const smooth_tippe_top_lanes slope4 = theta_dot;
    smooth_tippe_top_put(dydt + 3 * stride, slope4);
    const smooth_tippe_top_lanes slope5 = psi_dot;
    smooth_tippe_top_put(dydt + 4 * stride, slope5);
    /* (II.3) 24:4 */
    const smooth_tippe_top_lanes slope6 = (s_phi * z9 - c_phi * z4) * e;
    sum += slope6;
    smooth_tippe_top_put(dydt + 5 * stride, slope6);
    const smooth_tippe_top_lanes slope7 = -e * (s_phi * z4 + c_phi * z9);
    sum += slope7;
    smooth_tippe_top_put(dydt + 6 * stride, slope7);
    const smooth_tippe_top_lanes slope8 = z10;
    smooth_tippe_top_put(dydt + 7 * stride, slope8);
    const smooth_tippe_top_lanes slope9 = -s_theta * z8;
    sum += slope9;
    smooth_tippe_top_put(dydt + 8 * stride, slope9);
    const smooth_tippe_top_lanes slope10 = s_theta * (phi_dot * theta_dot) - c_theta * z10;
    sum += slope10;
    smooth_tippe_top_put(dydt + 9 * stride, slope10);
    smooth_tippe_top_put(check, smooth_tippe_top_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void smooth_tippe_top_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[SMOOTH_TIPPE_TOP_LANES];
    double state[10 * SMOOTH_TIPPE_TOP_LANES];
    double slope[10 * SMOOTH_TIPPE_TOP_LANES];
    smooth_tippe_top_fill(left, count, t, y, time, state);
    smooth_tippe_top_rhs_lanes(fixed, SMOOTH_TIPPE_TOP_LANES, time, state, slope, check);
    smooth_tippe_top_pour(left, count, slope, dydt);
}
#endif

int smooth_tippe_top_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if SMOOTH_TIPPE_TOP_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * e;
    const double k2 = e * k1;
    const double k3 = 1.0 / I1;
    const double k4 = I1 + k2;
    /* the mass matrix is singular, if I3 is 0 */
    if (!(fabs(I3) > 0.0)) {
        return smooth_tippe_top_one_by_one(count, 0, count, t, y, p, dydt);
    }
    /* the mass matrix is singular, if m is 0 */
    if (!(fabs(m) > 0.0)) {
        return smooth_tippe_top_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {e, I1, I3, g, k1, k2, k3, k4};
    double check[1 * SMOOTH_TIPPE_TOP_LANES];
    int status = SMOOTH_TIPPE_TOP_OK;
    for (size_t i = 0; i < count; i += SMOOTH_TIPPE_TOP_LANES) {
        const size_t left = count - i < SMOOTH_TIPPE_TOP_LANES ? count - i : SMOOTH_TIPPE_TOP_LANES;
        if (left == SMOOTH_TIPPE_TOP_LANES) {
            smooth_tippe_top_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            smooth_tippe_top_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!smooth_tippe_top_is_good(1 * SMOOTH_TIPPE_TOP_LANES, check)) {
            const int one = smooth_tippe_top_one_by_one(count, i, left, t, y, p, dydt);
            status = status == SMOOTH_TIPPE_TOP_OK ? one : status;
        }
    }
    return status;
#else
    return smooth_tippe_top_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
