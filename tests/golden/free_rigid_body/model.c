/*
 * free_rigid_body.c: free_rigid_body, emitted by nhc 0.1.0 (nhc:c9e99ceef6e8f5c5)
 * A free rigid body; the components of its angular velocity on body axes are the quasi-velocities.
 * Equations of motion: euler-lagrange (I.2.14)
 * Why: quasi-velocities of the spec
 * free_rigid_body.h says what each function does.
 */
#include "free_rigid_body.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const free_rigid_body_coordinate_names[FREE_RIGID_BODY_NQ] = {
    "phi",
    "theta",
    "psi"
};
const char *const free_rigid_body_state_names[FREE_RIGID_BODY_NY] = {
    "phi",
    "theta",
    "psi",
    "w1",
    "w2",
    "w3"
};
const char *const free_rigid_body_parameter_names[FREE_RIGID_BODY_NP] = {
    "I1",
    "I2",
    "I3"
};
const char *const free_rigid_body_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const free_rigid_body_output_names[FREE_RIGID_BODY_NOUT] = {
    "L_squared"
};
const double free_rigid_body_parameter_defaults[FREE_RIGID_BODY_NP] = {
    1.0,
    2.0,
    3.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int free_rigid_body_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return FREE_RIGID_BODY_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return FREE_RIGID_BODY_NOT_FINITE;
        }
    }
    return FREE_RIGID_BODY_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int free_rigid_body_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : FREE_RIGID_BODY_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef FREE_RIGID_BODY_LANES
#if !defined(__GNUC__)
#define FREE_RIGID_BODY_LANES 1
#elif defined(__AVX512F__)
#define FREE_RIGID_BODY_LANES 8
#elif defined(__AVX__)
#define FREE_RIGID_BODY_LANES 4
#else
#define FREE_RIGID_BODY_LANES 2
#endif
#endif
#if FREE_RIGID_BODY_LANES > 1
typedef double free_rigid_body_lanes __attribute__((vector_size(8 * FREE_RIGID_BODY_LANES)));
#else
typedef double free_rigid_body_lanes;
#endif

#if FREE_RIGID_BODY_LANES >= 2
static inline free_rigid_body_lanes free_rigid_body_get(const double *from)
{
    free_rigid_body_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void free_rigid_body_put(double *to, free_rigid_body_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int free_rigid_body_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = FREE_RIGID_BODY_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[FREE_RIGID_BODY_NY];
        double slope[FREE_RIGID_BODY_NY];
        for (size_t k = 0; k < FREE_RIGID_BODY_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = free_rigid_body_rhs(t[i], state, p, slope);
        status = status == FREE_RIGID_BODY_OK ? one : status;
        for (size_t k = 0; k < FREE_RIGID_BODY_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if FREE_RIGID_BODY_LANES >= 2
#define FREE_RIGID_BODY_SPREAD(x) ((x) - (free_rigid_body_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long free_rigid_body_bits __attribute__((vector_size(8 * FREE_RIGID_BODY_LANES)));

/* all bits where value is not above bound, or is no number */
static inline free_rigid_body_bits free_rigid_body_misses(free_rigid_body_lanes value, free_rigid_body_lanes bound)
{
    return ~(free_rigid_body_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline free_rigid_body_lanes free_rigid_body_mark(free_rigid_body_lanes value, free_rigid_body_bits bad)
{
    return (free_rigid_body_lanes)((free_rigid_body_bits)value | bad);
}

static inline free_rigid_body_lanes free_rigid_body_size(free_rigid_body_lanes x)
{
    return (free_rigid_body_lanes)((free_rigid_body_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int free_rigid_body_is_good(int count, const double *check)
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
static inline void free_rigid_body_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < FREE_RIGID_BODY_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < FREE_RIGID_BODY_NY; ++k) {
            state[k * FREE_RIGID_BODY_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void free_rigid_body_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < FREE_RIGID_BODY_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * FREE_RIGID_BODY_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void free_rigid_body_turn_lanes(free_rigid_body_lanes x, free_rigid_body_lanes *far,
    free_rigid_body_lanes *sine, free_rigid_body_lanes *cosine)
{
    double angle[FREE_RIGID_BODY_LANES];
    double up[FREE_RIGID_BODY_LANES];
    double along[FREE_RIGID_BODY_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < FREE_RIGID_BODY_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int free_rigid_body_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);

    /* what else is read */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double w3 = y[5]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = (I2 - I3) / I1;
    const double k2 = -(I1 - I3) / I2;
    const double k3 = (I1 - I2) / I3;

    /* from the state */
    const double z1 = (c_psi * w2 + s_psi * w1) / s_theta;
    /* (I.2.4) */
    dydt[0] = z1; /* phi' */
    dydt[1] = c_psi * w1 - s_psi * w2; /* theta' */
    dydt[2] = w3 - c_theta * z1; /* psi' */
    /* (I.2.14) 18:4 */
    dydt[3] = w2 * w3 * k1; /* w1' */
    dydt[4] = w1 * w3 * k2; /* w2' */
    dydt[5] = w1 * w2 * k3; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[1] + dydt[2] + dydt[3] + dydt[4] + dydt[5]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return free_rigid_body_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I2 is 0 */
        if (!(fabs(I2) > 0.0)) {
            return free_rigid_body_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return free_rigid_body_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return free_rigid_body_refuse(fabs(s_theta), 1e-12 * 4.0, FREE_RIGID_BODY_SINGULAR_1);
        }
        return free_rigid_body_finish(6, dydt);
    }
    return FREE_RIGID_BODY_OK;
}

int free_rigid_body_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);

    /* what else is read */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double w3 = y[5]; /* [rad/s] */

    /* from the state */
    const double z1 = (c_psi * w2 + s_psi * w1) / s_theta;
    /* (I.2.4) */
    qdot[0] = z1; /* phi' */
    qdot[1] = c_psi * w1 - s_psi * w2; /* theta' */
    qdot[2] = w3 - c_theta * z1; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[1] + qdot[2]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return free_rigid_body_refuse(fabs(s_theta), 1e-12 * 4.0, FREE_RIGID_BODY_SINGULAR_1);
        }
        return free_rigid_body_finish(3, qdot);
    }
    return FREE_RIGID_BODY_OK;
}

int free_rigid_body_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);

    /* what else is read */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double w3 = y[5]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = (I2 - I3) / I1;
    const double k2 = (I1 - I3) / I2;
    const double k3 = (I1 - I2) / I3;

    /* from the state */
    const double z1 = 1.0 / s_theta;
    const double z2 = s_psi * w2 - c_psi * w1;
    const double z3 = c_psi * w2 + s_psi * w1;
    const double z4 = w3 - c_theta * (z3 * z1);
    const double z5 = s_psi * z4;
    const double z6 = w1 * w3 * k2;
    const double z7 = c_psi * z4;
    const double z8 = w2 * w3 * k1;
    const double z9 = z1 * z1 * (z2 * (c_theta * z3)) - z1 * (w2 * z5 + c_psi * z6 - (w1 * z7 + s_psi * z8));
    /* (I.2.14) */
    qddot[0] = z9; /* phi'' */
    qddot[1] = -(w2 * z7 - s_psi * z6 + (w1 * z5 - c_psi * z8)); /* theta'' */
    qddot[2] = w1 * w2 * k3 - (z3 * z2 + c_theta * z9); /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[1] + qddot[2]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return free_rigid_body_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I2 is 0 */
        if (!(fabs(I2) > 0.0)) {
            return free_rigid_body_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return free_rigid_body_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return free_rigid_body_refuse(fabs(s_theta), 1e-12 * 4.0, FREE_RIGID_BODY_SINGULAR_1);
        }
        return free_rigid_body_finish(3, qddot);
    }
    return FREE_RIGID_BODY_OK;
}

int free_rigid_body_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[1]; /* nutation [rad] */
    const double psi = q[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);

    /* what else is read */
    const double phi = q[0]; /* precession [rad] */
    const double phi_dot = qdot[0]; /* phi' [rad/s] */
    const double theta_dot = qdot[1]; /* theta' [rad/s] */
    const double psi_dot = qdot[2]; /* psi' [rad/s] */

    /* from the coordinates and velocities */
    const double z1 = phi_dot * s_theta;
    y[0] = phi;
    y[1] = theta;
    y[2] = psi;
    y[3] = z1 * s_psi + theta_dot * c_psi;
    y[4] = z1 * c_psi - theta_dot * s_psi;
    y[5] = psi_dot + phi_dot * c_theta;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[3] + y[4] + y[5]) <= DBL_MAX)) {
        return free_rigid_body_finish(6, y);
    }
    return FREE_RIGID_BODY_OK;
}

int free_rigid_body_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return FREE_RIGID_BODY_OK;
}

int free_rigid_body_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the state */
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if I1 is 0 */
    if (!(fabs(I1) > 0.0)) {
        return free_rigid_body_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_SINGULAR_2);
    }
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if I2 is 0 */
    if (!(fabs(I2) > 0.0)) {
        return free_rigid_body_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_SINGULAR_2);
    }
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if I3 is 0 */
    if (!(fabs(I3) > 0.0)) {
        return free_rigid_body_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_SINGULAR_2);
    }
    /* the coframe is singular, if s_theta is nearly 0 */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return free_rigid_body_refuse(fabs(s_theta), 1e-12 * 4.0, FREE_RIGID_BODY_SINGULAR_1);
    }
    (void)lambda;
    return FREE_RIGID_BODY_OK;
}

double free_rigid_body_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double w3 = y[5]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    return 0.5 * (I3 * (w3 * w3) + (I1 * (w1 * w1) + I2 * (w2 * w2)));
}

int free_rigid_body_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 36 * sizeof *J);
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);

    /* what else is read */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double w3 = y[5]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = (I2 - I3) / I1;
    const double k2 = -(I1 - I3) / I2;
    const double k3 = (I1 - I2) / I3;

    /* from the state */
    const double z1 = 1.0 / s_theta;
    const double z2 = c_psi * w2 + s_psi * w1;
    const double z3 = z1 * z1 * (c_theta * z2);
    const double z4 = z1 * (s_psi * w2 - c_psi * w1);
    const double z5 = s_psi * z1;
    const double z6 = c_psi * z1;
    /* (I.2.14) */
    J[1] = -z3;
    J[2] = -z4;
    J[3] = z5;
    J[4] = z6;
    J[8] = -z2;
    J[9] = c_psi;
    J[10] = -s_psi;
    J[13] = z2 + c_theta * z3;
    J[14] = c_theta * z4;
    J[15] = -c_theta * z5;
    J[16] = -c_theta * z6;
    J[17] = 1.0;
    J[22] = w3 * k1;
    J[23] = w2 * k1;
    J[27] = w3 * k2;
    J[29] = w1 * k2;
    J[33] = w2 * k3;
    J[34] = w1 * k3;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[13] + J[16] + J[22] + J[23] + J[27] + J[29] + J[33] + J[34]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return free_rigid_body_refuse(fabs(I1), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I2 is 0 */
        if (!(fabs(I2) > 0.0)) {
            return free_rigid_body_refuse(fabs(I2), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return free_rigid_body_refuse(fabs(I3), 0.0, FREE_RIGID_BODY_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return free_rigid_body_refuse(fabs(s_theta), 1e-12 * 4.0, FREE_RIGID_BODY_SINGULAR_1);
        }
        return free_rigid_body_finish(36, J);
    }
    return FREE_RIGID_BODY_OK;
}

int free_rigid_body_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double w3 = y[5]; /* [rad/s] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = I1 * I1;
    const double k2 = I2 * I2;
    const double k3 = I3 * I3;

    /* from the state */
    /* 24:14 */
    out[0] = w3 * w3 * k3 + (w1 * w1 * k1 + w2 * w2 * k2); /* L_squared */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return free_rigid_body_refuse(fabs(s_theta), 1e-12 * 4.0, FREE_RIGID_BODY_SINGULAR_1);
        }
        return free_rigid_body_finish(1, out);
    }
    return FREE_RIGID_BODY_OK;
}

#if FREE_RIGID_BODY_LANES >= 2
static __attribute__((noinline)) void free_rigid_body_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    free_rigid_body_lanes far = {0}; /* the squares of the angles */
    free_rigid_body_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    free_rigid_body_bits bad = {0}; /* singular blocks */
    const double k1 = fixed[0];
    const double k2 = fixed[1];
    const double k3 = fixed[2];
    const free_rigid_body_lanes theta = free_rigid_body_get(y + 1 * stride);
    const free_rigid_body_lanes psi = free_rigid_body_get(y + 2 * stride);
    const free_rigid_body_lanes w1 = free_rigid_body_get(y + 3 * stride);
    const free_rigid_body_lanes w2 = free_rigid_body_get(y + 4 * stride);
    const free_rigid_body_lanes w3 = free_rigid_body_get(y + 5 * stride);
    free_rigid_body_lanes sine1, cosine1;
    free_rigid_body_turn_lanes(FREE_RIGID_BODY_SPREAD(theta), &far, &sine1, &cosine1);
    const free_rigid_body_lanes s_theta = sine1;
    /* the coframe is singular, if s_theta is nearly 0 */
    bad |= free_rigid_body_misses(free_rigid_body_size(FREE_RIGID_BODY_SPREAD(s_theta)),
        FREE_RIGID_BODY_SPREAD(1e-12 * 4.0));
    free_rigid_body_lanes sine2, cosine2;
    free_rigid_body_turn_lanes(FREE_RIGID_BODY_SPREAD(psi), &far, &sine2, &cosine2);
    const free_rigid_body_lanes c_psi = cosine2;
    const free_rigid_body_lanes s_psi = sine2;
    const free_rigid_body_lanes z1 = (c_psi * w2 + s_psi * w1) / s_theta;
    const free_rigid_body_lanes c_theta = cosine1;
    /* (I.2.4) */
    const free_rigid_body_lanes slope1 = z1;
    free_rigid_body_put(dydt, slope1);
    const free_rigid_body_lanes slope2 = c_psi * w1 - s_psi * w2;
    sum += slope2;
    free_rigid_body_put(dydt + 1 * stride, slope2);
    const free_rigid_body_lanes slope3 = w3 - c_theta * z1;
    sum += slope3;
    free_rigid_body_put(dydt + 2 * stride, slope3);
    /* (I.2.14) 18:4 */
    const free_rigid_body_lanes slope4 = w2 * w3 * k1;
    sum += slope4;
    free_rigid_body_put(dydt + 3 * stride, slope4);
    const free_rigid_body_lanes slope5 = w1 * w3 * k2;
    sum += slope5;
    free_rigid_body_put(dydt + 4 * stride, slope5);
    const free_rigid_body_lanes slope6 = w1 * w2 * k3;
    sum += slope6;
    free_rigid_body_put(dydt + 5 * stride, slope6);
    free_rigid_body_put(check, free_rigid_body_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void free_rigid_body_rhs_tail(const double *fixed, size_t left,
    size_t count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[FREE_RIGID_BODY_LANES];
    double state[6 * FREE_RIGID_BODY_LANES];
    double slope[6 * FREE_RIGID_BODY_LANES];
    free_rigid_body_fill(left, count, t, y, time, state);
    free_rigid_body_rhs_lanes(fixed, FREE_RIGID_BODY_LANES, time, state, slope, check);
    free_rigid_body_pour(left, count, slope, dydt);
}
#endif

int free_rigid_body_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if FREE_RIGID_BODY_LANES >= 2
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = (I2 - I3) / I1;
    const double k2 = -(I1 - I3) / I2;
    const double k3 = (I1 - I2) / I3;
    const double fixed[] = {k1, k2, k3};
    double check[1 * FREE_RIGID_BODY_LANES];
    int status = FREE_RIGID_BODY_OK;
    for (size_t i = 0; i < count; i += FREE_RIGID_BODY_LANES) {
        const size_t left = count - i < FREE_RIGID_BODY_LANES ? count - i : FREE_RIGID_BODY_LANES;
        if (left == FREE_RIGID_BODY_LANES) {
            free_rigid_body_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            free_rigid_body_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!free_rigid_body_is_good(1 * FREE_RIGID_BODY_LANES, check)) {
            const int one = free_rigid_body_one_by_one(count, i, left, t, y, p, dydt);
            status = status == FREE_RIGID_BODY_OK ? one : status;
        }
    }
    return status;
#else
    return free_rigid_body_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
