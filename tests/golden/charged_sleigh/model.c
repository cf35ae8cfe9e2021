/*
 * charged_sleigh.c: charged_sleigh, emitted by nhc 0.1.0 (nhc:1b829d75df74287d)
 * Caplygin's sleigh with a charge at its centre of mass in a magnetic field; T depends on x and y.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * charged_sleigh.h says what each function does.
 */
#include "charged_sleigh.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const charged_sleigh_coordinate_names[CHARGED_SLEIGH_NQ] = {
    "x",
    "y",
    "theta"
};
const char *const charged_sleigh_state_names[CHARGED_SLEIGH_NY] = {
    "x",
    "y",
    "theta",
    "v",
    "w"
};
const char *const charged_sleigh_parameter_names[CHARGED_SLEIGH_NP] = {
    "m",
    "J",
    "a",
    "B"
};
const char *const charged_sleigh_constraint_names[CHARGED_SLEIGH_NC] = {
    "slip"
};
const char *const charged_sleigh_output_names[CHARGED_SLEIGH_NOUT] = {
    "speed"
};
const double charged_sleigh_parameter_defaults[CHARGED_SLEIGH_NP] = {
    1.0,
    0.5,
    0.7,
    0.9
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int charged_sleigh_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CHARGED_SLEIGH_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CHARGED_SLEIGH_NOT_FINITE;
        }
    }
    return CHARGED_SLEIGH_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int charged_sleigh_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CHARGED_SLEIGH_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CHARGED_SLEIGH_LANES
#if !defined(__GNUC__)
#define CHARGED_SLEIGH_LANES 1
#elif defined(__AVX512F__)
#define CHARGED_SLEIGH_LANES 8
#elif defined(__AVX__)
#define CHARGED_SLEIGH_LANES 4
#else
#define CHARGED_SLEIGH_LANES 2
#endif
#endif
#if CHARGED_SLEIGH_LANES > 1
typedef double charged_sleigh_lanes __attribute__((vector_size(8 * CHARGED_SLEIGH_LANES)));
#else
typedef double charged_sleigh_lanes;
#endif

#if CHARGED_SLEIGH_LANES >= 2
static inline charged_sleigh_lanes charged_sleigh_get(const double *from)
{
    charged_sleigh_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void charged_sleigh_put(double *to, charged_sleigh_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int charged_sleigh_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CHARGED_SLEIGH_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CHARGED_SLEIGH_NY];
        double slope[CHARGED_SLEIGH_NY];
        for (size_t k = 0; k < CHARGED_SLEIGH_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = charged_sleigh_rhs(t[i], state, p, slope);
        status = status == CHARGED_SLEIGH_OK ? one : status;
        for (size_t k = 0; k < CHARGED_SLEIGH_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CHARGED_SLEIGH_LANES >= 2
#define CHARGED_SLEIGH_SPREAD(x) ((x) - (charged_sleigh_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long charged_sleigh_bits __attribute__((vector_size(8 * CHARGED_SLEIGH_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline charged_sleigh_lanes charged_sleigh_mark(charged_sleigh_lanes value, charged_sleigh_bits bad)
{
    return (charged_sleigh_lanes)((charged_sleigh_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int charged_sleigh_is_good(int count, const double *check)
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
static inline void charged_sleigh_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CHARGED_SLEIGH_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CHARGED_SLEIGH_NY; ++k) {
            state[k * CHARGED_SLEIGH_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void charged_sleigh_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CHARGED_SLEIGH_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CHARGED_SLEIGH_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void charged_sleigh_turn_lanes(charged_sleigh_lanes x, charged_sleigh_lanes *far,
    charged_sleigh_lanes *sine, charged_sleigh_lanes *cosine)
{
    double angle[CHARGED_SLEIGH_LANES];
    double up[CHARGED_SLEIGH_LANES];
    double along[CHARGED_SLEIGH_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < CHARGED_SLEIGH_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int charged_sleigh_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* from the parameters alone */
    const double k1 = J + m * (a * a);
    const double k2 = 1.0 / m;
    const double k3 = -1.0 / k1;

    /* from the state */
    const double z1 = a * (B + m * w);
    /* (I.2.4) */
    dydt[0] = c_theta * v; /* x' */
    dydt[1] = s_theta * v; /* y' */
    dydt[2] = w; /* theta' */
    /* (I.2.15) 18:4 */
    dydt[3] = k2 * (w * z1); /* v' */
    dydt[4] = k3 * (v * z1); /* w' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[3] + dydt[4]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return charged_sleigh_refuse(fabs(m), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return charged_sleigh_refuse(fabs(k1), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        return charged_sleigh_finish(5, dydt);
    }
    return CHARGED_SLEIGH_OK;
}

int charged_sleigh_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */

    /* from the state */
    /* (I.2.4) */
    qdot[0] = c_theta * v; /* x' */
    qdot[1] = s_theta * v; /* y' */
    qdot[2] = w; /* theta' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[2]) <= DBL_MAX)) {
        return charged_sleigh_finish(3, qdot);
    }
    return CHARGED_SLEIGH_OK;
}

int charged_sleigh_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* from the parameters alone */
    const double k1 = J + m * (a * a);
    const double k2 = 1.0 / m;
    const double k3 = -1.0 / k1;

    /* from the state */
    const double z1 = v * w;
    const double z2 = a * (B + m * w);
    const double z3 = k2 * (w * z2);
    /* (I.2.15) */
    qddot[0] = c_theta * z3 - s_theta * z1; /* x'' */
    qddot[1] = c_theta * z1 + s_theta * z3; /* y'' */
    qddot[2] = k3 * (v * z2); /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return charged_sleigh_refuse(fabs(m), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return charged_sleigh_refuse(fabs(k1), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        return charged_sleigh_finish(3, qddot);
    }
    return CHARGED_SLEIGH_OK;
}

int charged_sleigh_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);

    /* what else is read */
    const double x = q[0]; /* point of the edge [m] */
    const double y_2 = q[1]; /* y: point of the edge [m] */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[2]; /* theta' [rad/s] */

    /* from the coordinates and velocities */
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = x_dot * c_theta + y_dot * s_theta;
    y[4] = theta_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[3] + y[4]) <= DBL_MAX)) {
        return charged_sleigh_finish(5, y);
    }
    return CHARGED_SLEIGH_OK;
}

int charged_sleigh_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double theta = q[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */

    /* from the coordinates and velocities */
    /* (I.1.1) 20:5 */
    r[0] = y_dot * c_theta - x_dot * s_theta; /* slip = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return charged_sleigh_finish(1, r);
    }
    return CHARGED_SLEIGH_OK;
}

int charged_sleigh_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double k1 = J + m * (a * a);
    const double k2 = J / k1;

    /* from the state */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double B = p[3]; /* charge times field [kg/s] */
    /* (I.4.1) 20:5 */
    lambda[0] = v * (B + m * w) * k2; /* reaction of slip: Q_i gains lambda_1 a_1i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(m) > 0.0 * lambda[0])) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return charged_sleigh_refuse(fabs(m), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k1 is 0 */
        if (!(fabs(k1) > 0.0)) {
            return charged_sleigh_refuse(fabs(k1), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        return charged_sleigh_finish(1, lambda);
    }
    return CHARGED_SLEIGH_OK;
}

double charged_sleigh_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double x = y[0]; /* point of the edge [m] */
    const double y_2 = y[1]; /* y: point of the edge [m] */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* from the parameters alone */
    const double k1 = a * a;

    /* from the state */
    const double z1 = v * (x * s_theta - y_2 * c_theta) + a * w * (a + (x * c_theta + y_2 * s_theta));
    const double z2 = w * w;
    return 0.5 * (B * z1 + (J * z2 + m * (z2 * k1 + v * v)));
}

int charged_sleigh_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;
    const double theta = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double v = y[3]; /* [m/s] */
    const double w = y[4]; /* [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double J_2 = p[1]; /* J: moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* from the parameters alone */
    const double k1 = m * a;
    const double k2 = J_2 + m * (a * a);
    const double k3 = 1.0 / m;
    const double k4 = 1.0 / k2;
    const double k5 = -k1 * k4;

    /* from the state */
    const double z1 = a * (B + m * w);
    /* (I.2.15) */
    J[2] = -s_theta * v;
    J[3] = c_theta;
    J[7] = c_theta * v;
    J[8] = s_theta;
    J[14] = 1.0;
    J[19] = k3 * (z1 + w * k1);
    J[23] = -k4 * z1;
    J[24] = v * k5;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[2] + J[19] + J[23] + J[24]) <= DBL_MAX)) {
        /* the mass matrix is singular, if m is 0 */
        if (!(fabs(m) > 0.0)) {
            return charged_sleigh_refuse(fabs(m), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        /* the mass matrix is singular, if k2 is 0 */
        if (!(fabs(k2) > 0.0)) {
            return charged_sleigh_refuse(fabs(k2), 0.0, CHARGED_SLEIGH_SINGULAR_2);
        }
        return charged_sleigh_finish(25, J);
    }
    return CHARGED_SLEIGH_OK;
}

int charged_sleigh_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;

    /* from the state */
    const double v = y[3]; /* [m/s] */
    /* 25:10 */
    out[0] = v; /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return charged_sleigh_finish(1, out);
    }
    return CHARGED_SLEIGH_OK;
}

#if CHARGED_SLEIGH_LANES >= 2
static __attribute__((noinline)) void charged_sleigh_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    charged_sleigh_lanes far = {0}; /* the squares of the angles */
    charged_sleigh_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    charged_sleigh_bits bad = {0}; /* singular blocks */
    const double m = fixed[0];
    const double a = fixed[1];
    const double B = fixed[2];
    const double k2 = fixed[3];
    const double k3 = fixed[4];
    const charged_sleigh_lanes theta = charged_sleigh_get(y + 2 * stride);
    const charged_sleigh_lanes v = charged_sleigh_get(y + 3 * stride);
    const charged_sleigh_lanes w = charged_sleigh_get(y + 4 * stride);
    charged_sleigh_lanes sine1, cosine1;
    charged_sleigh_turn_lanes(CHARGED_SLEIGH_SPREAD(theta), &far, &sine1, &cosine1);
    const charged_sleigh_lanes c_theta = cosine1;
    const charged_sleigh_lanes s_theta = sine1;
    const charged_sleigh_lanes z1 = a * (B + m * w);
    /* (I.2.4) */
    const charged_sleigh_lanes slope1 = c_theta * v;
    sum += slope1;
    charged_sleigh_put(dydt, slope1);
    const charged_sleigh_lanes slope2 = s_theta * v;
    charged_sleigh_put(dydt + 1 * stride, slope2);
    const charged_sleigh_lanes slope3 = w;
    charged_sleigh_put(dydt + 2 * stride, slope3);
    /* (I.2.15) 18:4 */
    const charged_sleigh_lanes slope4 = k2 * (w * z1);
    sum += slope4;
    charged_sleigh_put(dydt + 3 * stride, slope4);
    const charged_sleigh_lanes slope5 = k3 * (v * z1);
    sum += slope5;
    charged_sleigh_put(dydt + 4 * stride, slope5);
    charged_sleigh_put(check, charged_sleigh_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void charged_sleigh_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CHARGED_SLEIGH_LANES];
    double state[5 * CHARGED_SLEIGH_LANES];
    double slope[5 * CHARGED_SLEIGH_LANES];
    charged_sleigh_fill(left, count, t, y, time, state);
    charged_sleigh_rhs_lanes(fixed, CHARGED_SLEIGH_LANES, time, state, slope, check);
    charged_sleigh_pour(left, count, slope, dydt);
}
#endif

int charged_sleigh_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if CHARGED_SLEIGH_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */
    const double k1 = J + m * (a * a);
    const double k2 = 1.0 / m;
    const double k3 = -1.0 / k1;
    const double fixed[] = {m, a, B, k2, k3};
    double check[1 * CHARGED_SLEIGH_LANES];
    int status = CHARGED_SLEIGH_OK;
    for (size_t i = 0; i < count; i += CHARGED_SLEIGH_LANES) {
        const size_t left = count - i < CHARGED_SLEIGH_LANES ? count - i : CHARGED_SLEIGH_LANES;
        if (left == CHARGED_SLEIGH_LANES) {
            charged_sleigh_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            charged_sleigh_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!charged_sleigh_is_good(1 * CHARGED_SLEIGH_LANES, check)) {
            const int one = charged_sleigh_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CHARGED_SLEIGH_OK ? one : status;
        }
    }
    return status;
#else
    return charged_sleigh_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
