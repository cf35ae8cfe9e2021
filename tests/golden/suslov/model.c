/*
 * suslov.c: suslov, emitted by nhc 0.1.0 (nhc:b6cbb95bad9355f3)
 * A rigid body with a fixed point that must not turn about one of its own axes.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * suslov.h says what each function does.
 */
#include "suslov.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const suslov_coordinate_names[SUSLOV_NQ] = {
    "phi",
    "theta",
    "psi"
};
const char *const suslov_state_names[SUSLOV_NY] = {
    "phi",
    "theta",
    "psi",
    "w1",
    "w2"
};
const char *const suslov_parameter_names[SUSLOV_NP] = {
    "I11",
    "I22",
    "I33",
    "I13",
    "I23"
};
const char *const suslov_constraint_names[SUSLOV_NC] = {
    "no_spin"
};
const char *const suslov_output_names[SUSLOV_NOUT] = {
    "M3"
};
const double suslov_parameter_defaults[SUSLOV_NP] = {
    1.0,
    1.6,
    2.0,
    0.3,
    -0.2
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int suslov_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return SUSLOV_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return SUSLOV_NOT_FINITE;
        }
    }
    return SUSLOV_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int suslov_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : SUSLOV_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef SUSLOV_LANES
#if !defined(__GNUC__)
#define SUSLOV_LANES 1
#elif defined(__AVX512F__)
#define SUSLOV_LANES 8
#elif defined(__AVX__)
#define SUSLOV_LANES 4
#else
#define SUSLOV_LANES 2
#endif
#endif
#if SUSLOV_LANES > 1
typedef double suslov_lanes __attribute__((vector_size(8 * SUSLOV_LANES)));
#else
typedef double suslov_lanes;
#endif

#if SUSLOV_LANES >= 2
static inline suslov_lanes suslov_get(const double *from)
{
    suslov_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void suslov_put(double *to, suslov_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int suslov_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = SUSLOV_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[SUSLOV_NY];
        double slope[SUSLOV_NY];
        for (size_t k = 0; k < SUSLOV_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = suslov_rhs(t[i], state, p, slope);
        status = status == SUSLOV_OK ? one : status;
        for (size_t k = 0; k < SUSLOV_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if SUSLOV_LANES >= 2
#define SUSLOV_SPREAD(x) ((x) - (suslov_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long suslov_bits __attribute__((vector_size(8 * SUSLOV_LANES)));

/* all bits where value is not above bound, or is no number */
static inline suslov_bits suslov_misses(suslov_lanes value, suslov_lanes bound)
{
    return ~(suslov_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline suslov_lanes suslov_mark(suslov_lanes value, suslov_bits bad)
{
    return (suslov_lanes)((suslov_bits)value | bad);
}

static inline suslov_lanes suslov_size(suslov_lanes x)
{
    return (suslov_lanes)((suslov_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int suslov_is_good(int count, const double *check)
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
static inline void suslov_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < SUSLOV_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < SUSLOV_NY; ++k) {
            state[k * SUSLOV_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void suslov_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < SUSLOV_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * SUSLOV_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void suslov_turn_lanes(suslov_lanes x, suslov_lanes *far,
    suslov_lanes *sine, suslov_lanes *cosine)
{
    double angle[SUSLOV_LANES];
    double up[SUSLOV_LANES];
    double along[SUSLOV_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < SUSLOV_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int suslov_rhs(double t, const double *y, const double *p, double *restrict dydt)
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
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = -1.0 / I11;
    const double k2 = 1.0 / I22;

    /* from the state */
    const double z1 = (c_psi * w2 + s_psi * w1) / s_theta;
    const double z2 = I13 * w1 + I23 * w2;
    /* (I.2.4) */
    dydt[0] = z1; /* phi' */
    dydt[1] = c_psi * w1 - s_psi * w2; /* theta' */
    dydt[2] = -c_theta * z1; /* psi' */
    /* (I.2.15) 20:4 */
    dydt[3] = w2 * z2 * k1; /* w1' */
    dydt[4] = w1 * z2 * k2; /* w2' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[1] + dydt[2] + dydt[3] + dydt[4]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I11 is 0 */
        if (!(fabs(I11) > 0.0)) {
            return suslov_refuse(fabs(I11), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I22 is 0 */
        if (!(fabs(I22) > 0.0)) {
            return suslov_refuse(fabs(I22), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return suslov_refuse(fabs(s_theta), 1e-12 * 4.0, SUSLOV_SINGULAR_1);
        }
        return suslov_finish(5, dydt);
    }
    return SUSLOV_OK;
}

int suslov_velocities(double t, const double *y, const double *p, double *qdot)
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

    /* from the state */
    const double z1 = (c_psi * w2 + s_psi * w1) / s_theta;
    /* (I.2.4) */
    qdot[0] = z1; /* phi' */
    qdot[1] = c_psi * w1 - s_psi * w2; /* theta' */
    qdot[2] = -c_theta * z1; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[1] + qdot[2]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return suslov_refuse(fabs(s_theta), 1e-12 * 4.0, SUSLOV_SINGULAR_1);
        }
        return suslov_finish(3, qdot);
    }
    return SUSLOV_OK;
}

int suslov_accelerations(double t, const double *y, const double *p, double *qddot)
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
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = 1.0 / I11;
    const double k2 = 1.0 / I22;

    /* from the state */
    const double z1 = c_psi * w2 + s_psi * w1;
    const double z2 = s_psi * w2 - c_psi * w1;
    const double z3 = 1.0 / s_theta;
    const double z4 = z1 * z3;
    const double z5 = c_theta * z4;
    const double z6 = s_psi * z5;
    const double z7 = I13 * w1 + I23 * w2;
    const double z8 = w1 * z7 * k2;
    const double z9 = c_psi * z5;
    const double z10 = w2 * z7 * k1;
    const double z11 = z1 * (c_theta * z2 * (z3 * z3)) + z3 * (w2 * z6 + c_psi * z8 - (w1 * z9 + s_psi *
        z10));
    /* (I.2.15) */
    qddot[0] = z11; /* phi'' */
    qddot[1] = w2 * z9 - s_psi * z8 + (w1 * z6 - c_psi * z10); /* theta'' */
    qddot[2] = -(z4 * (s_theta * z2) + c_theta * z11); /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[1] + qddot[2]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I11 is 0 */
        if (!(fabs(I11) > 0.0)) {
            return suslov_refuse(fabs(I11), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I22 is 0 */
        if (!(fabs(I22) > 0.0)) {
            return suslov_refuse(fabs(I22), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return suslov_refuse(fabs(s_theta), 1e-12 * 4.0, SUSLOV_SINGULAR_1);
        }
        return suslov_finish(3, qddot);
    }
    return SUSLOV_OK;
}

int suslov_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[1]; /* nutation [rad] */
    const double psi = q[2]; /* spin [rad] */

    /* sines and cosines */
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double s_theta = sin(theta);

    /* what else is read */
    const double phi = q[0]; /* precession [rad] */
    const double phi_dot = qdot[0]; /* phi' [rad/s] */
    const double theta_dot = qdot[1]; /* theta' [rad/s] */

    /* from the coordinates and velocities */
    const double z1 = phi_dot * s_theta;
    y[0] = phi;
    y[1] = theta;
    y[2] = psi;
    y[3] = theta_dot * c_psi + s_psi * z1;
    y[4] = c_psi * z1 - theta_dot * s_psi;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[3] + y[4]) <= DBL_MAX)) {
        return suslov_finish(5, y);
    }
    return SUSLOV_OK;
}

int suslov_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double theta = q[1]; /* nutation [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = qdot[0]; /* phi' [rad/s] */
    const double psi_dot = qdot[2]; /* psi' [rad/s] */

    /* from the coordinates and velocities */
    /* (I.1.1) 22:5 */
    r[0] = psi_dot + phi_dot * c_theta; /* no_spin = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return suslov_finish(1, r);
    }
    return SUSLOV_OK;
}

int suslov_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = I11 - I22;
    const double k2 = I13 / I11;
    const double k3 = I23 / I22;

    /* from the state */
    const double z1 = I13 * w1 + I23 * w2;
    /* (I.4.1) 22:5 */
    /* reaction of no_spin: Q_i gains lambda_1 a_1i */
    lambda[0] = -(w1 * w2 * k1 + (w2 * z1 * k2 - w1 * z1 * k3));
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I11 is 0 */
        if (!(fabs(I11) > 0.0)) {
            return suslov_refuse(fabs(I11), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I22 is 0 */
        if (!(fabs(I22) > 0.0)) {
            return suslov_refuse(fabs(I22), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return suslov_refuse(fabs(s_theta), 1e-12 * 4.0, SUSLOV_SINGULAR_1);
        }
        return suslov_finish(1, lambda);
    }
    return SUSLOV_OK;
}

double suslov_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the state */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    return 0.5 * (I11 * (w1 * w1) + I22 * (w2 * w2));
}

int suslov_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
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
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* from the parameters alone */
    const double k1 = 1.0 / I11;
    const double k2 = 1.0 / I22;
    const double k3 = -I13 * k1;
    const double k4 = I23 * k2;

    /* from the state */
    const double z1 = 1.0 / s_theta;
    const double z2 = c_psi * w2 + s_psi * w1;
    const double z3 = z1 * z1 * (c_theta * z2);
    const double z4 = z1 * (s_psi * w2 - c_psi * w1);
    const double z5 = s_psi * z1;
    const double z6 = c_psi * z1;
    const double z7 = I23 * w2;
    const double z8 = I13 * w1;
    const double z9 = z8 + z7;
    /* (I.2.15) */
    J[1] = -z3;
    J[2] = -z4;
    J[3] = z5;
    J[4] = z6;
    J[7] = -z2;
    J[8] = c_psi;
    J[9] = -s_psi;
    J[11] = z2 + c_theta * z3;
    J[12] = c_theta * z4;
    J[13] = -c_theta * z5;
    J[14] = -c_theta * z6;
    J[18] = w2 * k3;
    J[19] = -k1 * (z7 + z9);
    J[23] = k2 * (z8 + z9);
    J[24] = w1 * k4;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[11] + J[14] + J[18] + J[19] + J[23] + J[24]) <= DBL_MAX
        && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I11 is 0 */
        if (!(fabs(I11) > 0.0)) {
            return suslov_refuse(fabs(I11), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if I22 is 0 */
        if (!(fabs(I22) > 0.0)) {
            return suslov_refuse(fabs(I22), 0.0, SUSLOV_SINGULAR_2);
        }
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return suslov_refuse(fabs(s_theta), 1e-12 * 4.0, SUSLOV_SINGULAR_1);
        }
        return suslov_finish(25, J);
    }
    return SUSLOV_OK;
}

int suslov_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double w1 = y[3]; /* [rad/s] */
    const double w2 = y[4]; /* [rad/s] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* from the state */
    /* 28:7 */
    out[0] = I13 * w1 + I23 * w2; /* M3 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(s_theta) > 1e-12 * 4.0)) {
        /* the coframe is singular, if s_theta is nearly 0 */
        if (!(fabs(s_theta) > 1e-12 * 4.0)) {
            return suslov_refuse(fabs(s_theta), 1e-12 * 4.0, SUSLOV_SINGULAR_1);
        }
        return suslov_finish(1, out);
    }
    return SUSLOV_OK;
}

#if SUSLOV_LANES >= 2
static __attribute__((noinline)) void suslov_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    suslov_lanes far = {0}; /* the squares of the angles */
    suslov_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    suslov_bits bad = {0}; /* singular blocks */
    const double I13 = fixed[0];
    const double I23 = fixed[1];
    const double k1 = fixed[2];
    const double k2 = fixed[3];
    const suslov_lanes theta = suslov_get(y + 1 * stride);
    const suslov_lanes psi = suslov_get(y + 2 * stride);
    const suslov_lanes w1 = suslov_get(y + 3 * stride);
    const suslov_lanes w2 = suslov_get(y + 4 * stride);
    suslov_lanes sine1, cosine1;
    suslov_turn_lanes(SUSLOV_SPREAD(theta), &far, &sine1, &cosine1);
    const suslov_lanes s_theta = sine1;
    /* the coframe is singular, if s_theta is nearly 0 */
    bad |= suslov_misses(suslov_size(SUSLOV_SPREAD(s_theta)), SUSLOV_SPREAD(1e-12 * 4.0));
    suslov_lanes sine2, cosine2;
    suslov_turn_lanes(SUSLOV_SPREAD(psi), &far, &sine2, &cosine2);
    const suslov_lanes c_psi = cosine2;
    const suslov_lanes s_psi = sine2;
    const suslov_lanes z1 = (c_psi * w2 + s_psi * w1) / s_theta;
    const suslov_lanes c_theta = cosine1;
    const suslov_lanes z2 = I13 * w1 + I23 * w2;
    /* (I.2.4) */
    const suslov_lanes slope1 = z1;
    suslov_put(dydt, slope1);
    const suslov_lanes slope2 = c_psi * w1 - s_psi * w2;
    sum += slope2;
    suslov_put(dydt + 1 * stride, slope2);
    const suslov_lanes slope3 = -c_theta * z1;
    sum += slope3;
    suslov_put(dydt + 2 * stride, slope3);
    /* (I.2.15) 20:4 */
    const suslov_lanes slope4 = w2 * z2 * k1;
    sum += slope4;
    suslov_put(dydt + 3 * stride, slope4);
    const suslov_lanes slope5 = w1 * z2 * k2;
    sum += slope5;
    suslov_put(dydt + 4 * stride, slope5);
    suslov_put(check, suslov_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void suslov_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[SUSLOV_LANES];
    double state[5 * SUSLOV_LANES];
    double slope[5 * SUSLOV_LANES];
    suslov_fill(left, count, t, y, time, state);
    suslov_rhs_lanes(fixed, SUSLOV_LANES, time, state, slope, check);
    suslov_pour(left, count, slope, dydt);
}
#endif

int suslov_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
#if SUSLOV_LANES >= 2
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */
    const double k1 = -1.0 / I11;
    const double k2 = 1.0 / I22;
    const double fixed[] = {I13, I23, k1, k2};
    double check[1 * SUSLOV_LANES];
    int status = SUSLOV_OK;
    for (size_t i = 0; i < count; i += SUSLOV_LANES) {
        const size_t left = count - i < SUSLOV_LANES ? count - i : SUSLOV_LANES;
        if (left == SUSLOV_LANES) {
            suslov_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            suslov_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!suslov_is_good(1 * SUSLOV_LANES, check)) {
            const int one = suslov_one_by_one(count, i, left, t, y, p, dydt);
            status = status == SUSLOV_OK ? one : status;
        }
    }
    return status;
#else
    return suslov_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
