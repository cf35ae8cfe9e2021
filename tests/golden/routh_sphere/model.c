/*
 * routh_sphere.c: routh_sphere, emitted by nhc 0.1.0 (nhc:290306a0603017b3)
 * A ball with its centre of mass off its centre, dynamically symmetric, rolls on a horizontal plane.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * routh_sphere.h says what each function does.
 */
#include "routh_sphere.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const routh_sphere_coordinate_names[ROUTH_SPHERE_NQ] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const routh_sphere_state_names[ROUTH_SPHERE_NY] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "phi'",
    "theta'",
    "psi'"
};
const char *const routh_sphere_parameter_names[ROUTH_SPHERE_NP] = {
    "m",
    "R",
    "e",
    "I1",
    "I3",
    "g"
};
const char *const routh_sphere_constraint_names[ROUTH_SPHERE_NC] = {
    "roll_x",
    "roll_y"
};
const char *const routh_sphere_output_names[ROUTH_SPHERE_NOUT] = {
    "jellett",
    "routh"
};
const double routh_sphere_parameter_defaults[ROUTH_SPHERE_NP] = {
    1.0,
    1.0,
    -0.2,
    0.38,
    0.42,
    9.81
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define ROUTH_SPHERE_SLOW __attribute__((cold, optimize("O1")))
#else
#define ROUTH_SPHERE_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int routh_sphere_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return ROUTH_SPHERE_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return ROUTH_SPHERE_NOT_FINITE;
        }
    }
    return ROUTH_SPHERE_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int routh_sphere_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : ROUTH_SPHERE_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef ROUTH_SPHERE_LANES
#if !defined(__GNUC__)
#define ROUTH_SPHERE_LANES 1
#elif defined(__AVX512F__)
#define ROUTH_SPHERE_LANES 8
#elif defined(__AVX__)
#define ROUTH_SPHERE_LANES 4
#else
#define ROUTH_SPHERE_LANES 2
#endif
#endif
#if ROUTH_SPHERE_LANES > 1
typedef double routh_sphere_lanes __attribute__((vector_size(8 * ROUTH_SPHERE_LANES)));
#else
typedef double routh_sphere_lanes;
#endif

#if ROUTH_SPHERE_LANES >= 2
static inline routh_sphere_lanes routh_sphere_get(const double *from)
{
    routh_sphere_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void routh_sphere_put(double *to, routh_sphere_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int routh_sphere_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = ROUTH_SPHERE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[ROUTH_SPHERE_NY];
        double slope[ROUTH_SPHERE_NY];
        for (size_t k = 0; k < ROUTH_SPHERE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = routh_sphere_rhs(t[i], state, p, slope);
        status = status == ROUTH_SPHERE_OK ? one : status;
        for (size_t k = 0; k < ROUTH_SPHERE_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if ROUTH_SPHERE_LANES >= 2
#define ROUTH_SPHERE_SPREAD(x) ((x) - (routh_sphere_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long routh_sphere_bits __attribute__((vector_size(8 * ROUTH_SPHERE_LANES)));

/* all bits where value is not above bound, or is no number */
static inline routh_sphere_bits routh_sphere_misses(routh_sphere_lanes value, routh_sphere_lanes bound)
{
    return ~(routh_sphere_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline routh_sphere_lanes routh_sphere_mark(routh_sphere_lanes value, routh_sphere_bits bad)
{
    return (routh_sphere_lanes)((routh_sphere_bits)value | bad);
}

static inline routh_sphere_lanes routh_sphere_size(routh_sphere_lanes x)
{
    return (routh_sphere_lanes)((routh_sphere_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int routh_sphere_is_good(int count, const double *check)
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
static inline void routh_sphere_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < ROUTH_SPHERE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < ROUTH_SPHERE_NY; ++k) {
            state[k * ROUTH_SPHERE_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void routh_sphere_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < ROUTH_SPHERE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * ROUTH_SPHERE_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void routh_sphere_turn_lanes(routh_sphere_lanes x, routh_sphere_lanes *far,
    routh_sphere_lanes *sine, routh_sphere_lanes *cosine)
{
    double angle[ROUTH_SPHERE_LANES];
    double up[ROUTH_SPHERE_LANES];
    double along[ROUTH_SPHERE_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < ROUTH_SPHERE_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int routh_sphere_rhs(double t, const double *y, const double *p, double *restrict dydt)
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
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R * R;
    const double k2 = m * e;
    const double k3 = m * R;
    const double k4 = e * e;
    const double k5 = I3 - (I1 + m * k4);
    const double k6 = e * k3;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k4 + R * z3);
    const double z5 = I3 + z1 * k1;
    const double z6 = I3 * c_theta - z1 * k6;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    const double z10 = s_theta * (psi_dot * R);
    const double z11 = theta_dot * R;
    const double z12 = theta_dot * s_theta;
    const double z13 = c_theta * k5;
    const double z14 = z12 * (phi_dot * (k6 - 2.0 * z13) - psi_dot * (I3 + c_theta * k6));
    const double z15 = (z14 * z8 + z12 * (phi_dot * (I3 + k3 * z3) - c_theta * (psi_dot * k1))) / z9;
    const double z16 = phi_dot * (phi_dot * (k6 - z13) - psi_dot * (I3 + (R + Z) * k3)) + k2 * (g + theta_dot
        * z11);
    /* (I.1.2) */
    dydt[0] = s_phi * z11 - c_phi * z10; /* x' */
    dydt[1] = -(c_phi * z11 + s_phi * z10); /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    dydt[4] = psi_dot; /* psi' */
    /* (III.3) 26:4 */
    dydt[5] = -(z14 * z7 + z8 * z15); /* phi'' */
    dydt[6] = s_theta * z16 / z4; /* theta'' */
    dydt[7] = z15; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[5] + dydt[6]) <= DBL_MAX && fabs(z9) > 1e-13 * z5)) {
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return routh_sphere_refuse(fabs(z2), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z4 is 0 */
        if (!(fabs(z4) > 0.0)) {
            return routh_sphere_refuse(fabs(z4), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z9 is nearly 0 */
        if (!(fabs(z9) > 1e-13 * z5)) {
            return routh_sphere_refuse(fabs(z9), 1e-13 * z5, ROUTH_SPHERE_SINGULAR_2);
        }
        return routh_sphere_finish(8, dydt);
    }
    return ROUTH_SPHERE_OK;
}

int routh_sphere_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double s_theta = sin(theta);

    /* what else is read */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the state */
    const double z1 = s_theta * (psi_dot * R);
    const double z2 = theta_dot * R;
    /* (I.1.2) */
    qdot[0] = s_phi * z2 - c_phi * z1; /* x' */
    qdot[1] = -(c_phi * z2 + s_phi * z1); /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    qdot[4] = psi_dot; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2]) <= DBL_MAX)) {
        return routh_sphere_finish(5, qdot);
    }
    return ROUTH_SPHERE_OK;
}

ROUTH_SPHERE_SLOW
int routh_sphere_accelerations(double t, const double *y, const double *p, double *qddot)
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
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R * R;
    const double k2 = m * e;
    const double k3 = m * R;
    const double k4 = e * e;
    const double k5 = I3 - (I1 + m * k4);
    const double k6 = e * k3;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k4 + R * z3);
    const double z5 = I3 + z1 * k1;
    const double z6 = I3 * c_theta - z1 * k6;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    const double z10 = phi_dot * c_phi;
    const double z11 = theta_dot * R;
    const double z12 = c_theta * k5;
    const double z13 = phi_dot * (phi_dot * (k6 - z12) - psi_dot * (I3 + (R + Z) * k3)) + k2 * (g + R *
        (theta_dot * theta_dot));
    const double z14 = s_theta * z13 / z4;
    const double z15 = R * z14;
    const double z16 = phi_dot * s_phi;
    const double z17 = psi_dot * R;
    const double z18 = s_theta * z17;
    const double z19 = theta_dot * s_theta;
    const double z20 = z19 * (phi_dot * (k6 - 2.0 * z12) - psi_dot * (I3 + c_theta * k6));
    const double z21 = (z20 * z8 + z19 * (phi_dot * (I3 + k3 * z3) - k1 * (psi_dot * c_theta))) / z9;
    const double z22 = theta_dot * c_theta * z17 + R * (s_theta * z21);
    /* (III.3) */
    qddot[0] = z10 * z11 + s_phi * z15 + (z16 * z18 - c_phi * z22); /* x'' */
    qddot[1] = z16 * z11 - c_phi * z15 - (z10 * z18 + s_phi * z22); /* y'' */
    qddot[2] = -(z20 * z7 + z8 * z21); /* phi'' */
    qddot[3] = z14; /* theta'' */
    qddot[4] = z21; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2]) <= DBL_MAX && fabs(z9) > 1e-13 * z5)) {
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return routh_sphere_refuse(fabs(z2), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z4 is 0 */
        if (!(fabs(z4) > 0.0)) {
            return routh_sphere_refuse(fabs(z4), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z9 is nearly 0 */
        if (!(fabs(z9) > 1e-13 * z5)) {
            return routh_sphere_refuse(fabs(z9), 1e-13 * z5, ROUTH_SPHERE_SINGULAR_2);
        }
        return routh_sphere_finish(5, qddot);
    }
    return ROUTH_SPHERE_OK;
}

int routh_sphere_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
    const double phi_dot = qdot[2]; /* phi' [rad/s] */
    y[5] = phi_dot;
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    y[6] = theta_dot;
    const double psi_dot = qdot[4]; /* psi' [rad/s] */
    y[7] = psi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5] + y[6] + y[7]) <= DBL_MAX)) {
        return routh_sphere_finish(8, y);
    }
    return ROUTH_SPHERE_OK;
}

int routh_sphere_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    const double psi_dot = qdot[4]; /* psi' [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the coordinates and velocities */
    const double z1 = psi_dot * s_theta;
    /* (I.1.1) 29:5 */
    r[0] = x_dot - R * (theta_dot * s_phi - c_phi * z1); /* roll_x = 0 */
    /* (I.1.1) 30:5 */
    r[1] = y_dot + R * (theta_dot * c_phi + s_phi * z1); /* roll_y = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1]) <= DBL_MAX)) {
        return routh_sphere_finish(2, r);
    }
    return ROUTH_SPHERE_OK;
}

ROUTH_SPHERE_SLOW
int routh_sphere_reactions(double t, const double *y, const double *p, double *lambda)
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
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R * R;
    const double k2 = m * e;
    const double k3 = m * R;
    const double k4 = e * e;
    const double k5 = I3 - (I1 + m * k4);
    const double k6 = e * k3;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k4 + R * z3);
    const double z5 = I3 + z1 * k1;
    const double z6 = I3 * c_theta - z1 * k6;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    const double z10 = s_theta * c_phi;
    const double z11 = theta_dot * s_theta;
    const double z12 = c_theta * k5;
    const double z13 = z11 * (phi_dot * (k6 - 2.0 * z12) - psi_dot * (I3 + c_theta * k6));
    const double z14 = (z13 * z8 + z11 * (phi_dot * (I3 + k3 * z3) - k1 * (psi_dot * c_theta))) / z9;
    const double z15 = k3 * z14;
    const double z16 = k2 * (z13 * z7 + z8 * z14);
    const double z17 = R + Z;
    const double z18 = phi_dot * (phi_dot * (k6 - z12) - psi_dot * (I3 + z17 * k3)) + k2 * (g + R *
        (theta_dot * theta_dot));
    const double z19 = m * z17 * (s_theta * z18 / z4);
    const double z20 = phi_dot * R;
    const double z21 = phi_dot * e;
    const double z22 = s_theta * (psi_dot * z20) - (e * (theta_dot * z11) + s_theta * (phi_dot * z21));
    const double z23 = theta_dot * c_theta;
    const double z24 = R * (psi_dot * z23) - theta_dot * z20 - 2.0 * (z23 * z21);
    const double z25 = s_theta * s_phi;
    /* (I.4.1) 29:5 */
    /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    lambda[0] = m * (s_phi * z22 - c_phi * z24) - (z10 * z15 + (z10 * z16 - s_phi * z19));
    /* (I.4.1) 30:5 */
    /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    lambda[1] = -(z25 * z15 + (z25 * z16 + c_phi * z19) + m * (c_phi * z22 + s_phi * z24));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1]) <= DBL_MAX && fabs(z9) > 1e-13 * z5)) {
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return routh_sphere_refuse(fabs(z2), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z4 is 0 */
        if (!(fabs(z4) > 0.0)) {
            return routh_sphere_refuse(fabs(z4), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z9 is nearly 0 */
        if (!(fabs(z9) > 1e-13 * z5)) {
            return routh_sphere_refuse(fabs(z9), 1e-13 * z5, ROUTH_SPHERE_SINGULAR_2);
        }
        return routh_sphere_finish(2, lambda);
    }
    return ROUTH_SPHERE_OK;
}

double routh_sphere_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * g;

    /* from the state */
    const double Z = e * c_theta;
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z1 = e * s_theta;
    const double z2 = theta_dot * z1;
    const double z3 = theta_dot * (R + Z);
    const double z4 = phi_dot * z1 - R * (psi_dot * s_theta);
    const double z5 = I1 * (theta_dot * theta_dot + s_theta * s_theta * (phi_dot * phi_dot)) + m * (z2 * z2 +
        (z3 * z3 + z4 * z4));
    return Z * k1 + 0.5 * (I3 * (omega3 * omega3) + z5);
}

ROUTH_SPHERE_SLOW
int routh_sphere_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 64 * sizeof *J);
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double theta_dot = y[6]; /* theta' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* from the parameters alone */
    const double k1 = m * R * R;
    const double k2 = m * e;
    const double k3 = m * R;
    const double k4 = e * e;
    const double k5 = I3 - (I1 + m * k4);
    const double k6 = e * k3;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k4 + R * z3);
    const double z5 = I3 + z1 * k1;
    const double z6 = I3 * c_theta - z1 * k6;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    const double z10 = theta_dot * R;
    const double z11 = psi_dot * R;
    const double z12 = s_theta * z11;
    const double z13 = c_theta * z11;
    const double z14 = R * s_theta;
    const double z15 = theta_dot * s_theta;
    const double z16 = phi_dot * z15;
    const double z17 = 1.0 / z9;
    const double z18 = c_theta * k5;
    const double z19 = k6 - 2.0 * z18;
    const double z20 = I3 + c_theta * k6;
    const double z21 = phi_dot * z19 - psi_dot * z20;
    const double z22 = z15 * z21;
    const double z23 = I3 + k3 * z3;
    const double z24 = psi_dot * k1;
    const double z25 = phi_dot * z23 - c_theta * z24;
    const double z26 = z17 * (z22 * z8 + z15 * z25);
    const double z27 = z22 * z7 + z8 * z26;
    const double z28 = s_theta * (k6 * (psi_dot * z15) + 2.0 * (z16 * k5) - I3 * z26) + c_theta * (theta_dot
        * z21 - 2.0 * (s_theta * (k6 * z26 - k5 * z27)));
    const double z29 = s_theta * (2.0 * (z16 * k6) - (z15 * z24 - I3 * z27)) - c_theta * (theta_dot * z25 -
        2.0 * (s_theta * (k1 * z26 + k6 * z27)));
    const double z30 = z17 * (z29 - z8 * z28);
    const double z31 = z15 * z19;
    const double z32 = z17 * (z15 * z23 + z8 * z31);
    const double z33 = s_theta * z21;
    const double z34 = z17 * (z8 * z33 + s_theta * z25);
    const double z35 = z15 * z20;
    const double z36 = z17 * (z8 * z35 + k1 * (c_theta * z15));
    const double z37 = 1.0 / z4;
    const double z38 = k6 - z18;
    const double z39 = I3 + (R + Z) * k3;
    const double z40 = phi_dot * z38 - psi_dot * z39;
    const double z41 = phi_dot * z40 + k2 * (g + R * (theta_dot * theta_dot));
    const double z42 = phi_dot * s_theta;
    const double z43 = z14 * z37;
    const double z44 = s_theta * (k5 * (phi_dot * z42) + e * (k3 * (psi_dot * z42) + 2.0 * (m * (z41 *
        z43))));
    /* (III.3) */
    J[2] = c_phi * z10 + s_phi * z12;
    J[3] = -c_phi * z13;
    J[6] = R * s_phi;
    J[7] = -c_phi * z14;
    J[10] = s_phi * z10 - c_phi * z12;
    J[11] = -s_phi * z13;
    J[14] = -R * c_phi;
    J[15] = -s_phi * z14;
    J[21] = 1.0;
    J[30] = 1.0;
    J[39] = 1.0;
    J[43] = z8 * z30 - z7 * z28;
    J[45] = -(z7 * z31 + z8 * z32);
    J[46] = -(z7 * z33 + z8 * z34);
    J[47] = z7 * z35 + z8 * z36;
    J[51] = z37 * (c_theta * z41 + z44);
    J[53] = z37 * (s_theta * z40 + z42 * z38);
    J[54] = 2.0 * (k2 * (theta_dot * z43));
    J[55] = -z37 * (z42 * z39);
    J[59] = -z30;
    J[61] = z32;
    J[62] = z34;
    J[63] = -z36;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[10] + J[11] + J[15] + J[43] + J[45] + J[46] + J[47] + J[51] + J[53] + J[54] + J[55] +
        J[59] + J[63]) <= DBL_MAX
        && fabs(z9) > 1e-13 * z5)) {
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return routh_sphere_refuse(fabs(z2), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z4 is 0 */
        if (!(fabs(z4) > 0.0)) {
            return routh_sphere_refuse(fabs(z4), 0.0, ROUTH_SPHERE_SINGULAR_2);
        }
        /* the mass matrix is singular, if z9 is nearly 0 */
        if (!(fabs(z9) > 1e-13 * z5)) {
            return routh_sphere_refuse(fabs(z9), 1e-13 * z5, ROUTH_SPHERE_SINGULAR_2);
        }
        return routh_sphere_finish(64, J);
    }
    return ROUTH_SPHERE_OK;
}

int routh_sphere_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = y[5]; /* phi' [rad/s] */
    const double psi_dot = y[7]; /* psi' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* from the parameters alone */
    const double k1 = I1 * I3;
    const double k2 = I1 * (m * (R * R));
    const double k3 = m * I3;
    const double k4 = R * I1;

    /* from the state */
    const double z1 = s_theta * s_theta;
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z2 = e + R * c_theta;
    /* 33:12 */
    out[0] = phi_dot * z1 * k4 + I3 * (omega3 * z2); /* jellett */
    /* 34:10 */
    out[1] = omega3 * sqrt(k1 + z1 * k2 + k3 * (z2 * z2)); /* routh */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return routh_sphere_finish(2, out);
    }
    return ROUTH_SPHERE_OK;
}

#if ROUTH_SPHERE_LANES >= 2
static __attribute__((noinline)) void routh_sphere_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    routh_sphere_lanes far = {0}; /* the squares of the angles */
    routh_sphere_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    routh_sphere_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double R = fixed[1];
    const double e = fixed[2];
    const double I1 = fixed[3];
    const double I3 = fixed[4];
    const double g = fixed[5];
    const double k1 = fixed[6];
    const double k2 = fixed[7];
    const double k3 = fixed[8];
    const double k4 = fixed[9];
    const double k5 = fixed[10];
    const double k6 = fixed[11];
    const routh_sphere_lanes phi = routh_sphere_get(y + 2 * stride);
    const routh_sphere_lanes theta = routh_sphere_get(y + 3 * stride);
    const routh_sphere_lanes phi_dot = routh_sphere_get(y + 5 * stride);
    const routh_sphere_lanes theta_dot = routh_sphere_get(y + 6 * stride);
    const routh_sphere_lanes psi_dot = routh_sphere_get(y + 7 * stride);
    routh_sphere_lanes sine1, cosine1;
    routh_sphere_turn_lanes(ROUTH_SPHERE_SPREAD(theta), &far, &sine1, &cosine1);
    const routh_sphere_lanes s_theta = sine1;
    const routh_sphere_lanes z1 = s_theta * s_theta;
    const routh_sphere_lanes z2 = I3 - z1 * k5;
    const routh_sphere_lanes c_theta = cosine1;
    const routh_sphere_lanes Z = e * c_theta;
    const routh_sphere_lanes z3 = R + 2.0 * Z;
    const routh_sphere_lanes z4 = I1 + m * (k4 + R * z3);
    const routh_sphere_lanes z5 = I3 + z1 * k1;
    const routh_sphere_lanes z6 = I3 * c_theta - z1 * k6;
    const routh_sphere_lanes z7 = 1.0 / z2;
    const routh_sphere_lanes z8 = z6 * z7;
    const routh_sphere_lanes z9 = z5 - z6 * z8;
    /* the mass matrix is singular, if z9 is nearly 0 */
    bad |= routh_sphere_misses(routh_sphere_size(ROUTH_SPHERE_SPREAD(z9)), 1e-13 * z5);
    routh_sphere_lanes sine2, cosine2;
    routh_sphere_turn_lanes(ROUTH_SPHERE_SPREAD(phi), &far, &sine2, &cosine2);
    const routh_sphere_lanes c_phi = cosine2;
    const routh_sphere_lanes z10 = s_theta * (psi_dot * R);
    const routh_sphere_lanes s_phi = sine2;
    const routh_sphere_lanes z11 = theta_dot * R;
    const routh_sphere_lanes z12 = theta_dot * s_theta;
    const routh_sphere_lanes z13 = c_theta * k5;
    const routh_sphere_lanes z14 = z12 * (phi_dot * (k6 - 2.0 * z13) - psi_dot * (I3 + c_theta * k6));
    const routh_sphere_lanes z15 = (z14 * z8 + z12 * (phi_dot * (I3 + k3 * z3) - c_theta * (psi_dot * k1))) /
        z9;
    const routh_sphere_lanes z16 = phi_dot * (phi_dot * (k6 - z13) - psi_dot * (I3 + (R + Z) * k3)) + k2 * (g
        + theta_dot * z11);
    /* (I.1.2) */
    const routh_sphere_lanes slope1 = s_phi * z11 - c_phi * z10;
    sum += slope1;
    routh_sphere_put(dydt, slope1);
    const routh_sphere_lanes slope2 = -(c_phi * z11 + s_phi * z10);
    sum += slope2;
    routh_sphere_put(dydt + 1 * stride, slope2);
    const routh_sphere_lanes slope3 = phi_dot;
    routh_sphere_put(dydt + 2 * stride, slope3);
    const routh_sphere_lanes slope4 = theta_dot;
    routh_sphere_put(dydt + 3 * stride, slope4);
    const routh_sphere_lanes slope5 = psi_dot;
    routh_sphere_put(dydt + 4 * stride, slope5);
    /* (III.3) 26:4 */
    const routh_sphere_lanes slope6 = -(z14 * z7 + z8 * z15);
    sum += slope6;
    routh_sphere_put(dydt + 5 * stride, slope6);
    const routh_sphere_lanes slope7 = s_theta * z16 / z4;
    sum += slope7;
    routh_sphere_put(dydt + 6 * stride, slope7);
    const routh_sphere_lanes slope8 = z15;
    routh_sphere_put(dydt + 7 * stride, slope8);
    routh_sphere_put(check, routh_sphere_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void routh_sphere_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[ROUTH_SPHERE_LANES];
    double state[8 * ROUTH_SPHERE_LANES];
    double slope[8 * ROUTH_SPHERE_LANES];
    routh_sphere_fill(left, count, t, y, time, state);
    routh_sphere_rhs_lanes(fixed, ROUTH_SPHERE_LANES, time, state, slope, check);
    routh_sphere_pour(left, count, slope, dydt);
}
#endif

int routh_sphere_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if ROUTH_SPHERE_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * R * R;
    const double k2 = m * e;
    const double k3 = m * R;
    const double k4 = e * e;
    const double k5 = I3 - (I1 + m * k4);
    const double k6 = e * k3;
    const double fixed[] = {m, R, e, I1, I3, g, k1, k2, k3, k4, k5, k6};
    double check[1 * ROUTH_SPHERE_LANES];
    int status = ROUTH_SPHERE_OK;
    for (size_t i = 0; i < count; i += ROUTH_SPHERE_LANES) {
        const size_t left = count - i < ROUTH_SPHERE_LANES ? count - i : ROUTH_SPHERE_LANES;
        if (left == ROUTH_SPHERE_LANES) {
            routh_sphere_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            routh_sphere_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!routh_sphere_is_good(1 * ROUTH_SPHERE_LANES, check)) {
            const int one = routh_sphere_one_by_one(count, i, left, t, y, p, dydt);
            status = status == ROUTH_SPHERE_OK ? one : status;
        }
    }
    return status;
#else
    return routh_sphere_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
