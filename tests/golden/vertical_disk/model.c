/*
 * vertical_disk.c: vertical_disk, emitted by nhc 0.1.0 (nhc:a647b4138d4b7c34)
 * A disk that stays upright and rolls without slipping.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * vertical_disk.h says what each function does.
 */
#include "vertical_disk.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const vertical_disk_coordinate_names[VERTICAL_DISK_NQ] = {
    "x",
    "y",
    "phi",
    "theta"
};
const char *const vertical_disk_state_names[VERTICAL_DISK_NY] = {
    "x",
    "y",
    "phi",
    "theta",
    "phi'",
    "theta'"
};
const char *const vertical_disk_parameter_names[VERTICAL_DISK_NP] = {
    "m",
    "R",
    "I",
    "J"
};
const char *const vertical_disk_constraint_names[VERTICAL_DISK_NC] = {
    "roll_x",
    "roll_y"
};
const char *const vertical_disk_output_names[VERTICAL_DISK_NOUT] = {
    "speed"
};
const double vertical_disk_parameter_defaults[VERTICAL_DISK_NP] = {
    1.0,
    0.5,
    0.125,
    0.0625
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int vertical_disk_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return VERTICAL_DISK_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return VERTICAL_DISK_NOT_FINITE;
        }
    }
    return VERTICAL_DISK_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int vertical_disk_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : VERTICAL_DISK_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef VERTICAL_DISK_LANES
#if !defined(__GNUC__)
#define VERTICAL_DISK_LANES 1
#elif defined(__AVX512F__)
#define VERTICAL_DISK_LANES 8
#elif defined(__AVX__)
#define VERTICAL_DISK_LANES 4
#else
#define VERTICAL_DISK_LANES 2
#endif
#endif
#if VERTICAL_DISK_LANES > 1
typedef double vertical_disk_lanes __attribute__((vector_size(8 * VERTICAL_DISK_LANES)));
#else
typedef double vertical_disk_lanes;
#endif

#if VERTICAL_DISK_LANES >= 2
static inline vertical_disk_lanes vertical_disk_get(const double *from)
{
    vertical_disk_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void vertical_disk_put(double *to, vertical_disk_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int vertical_disk_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = VERTICAL_DISK_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[VERTICAL_DISK_NY];
        double slope[VERTICAL_DISK_NY];
        for (size_t k = 0; k < VERTICAL_DISK_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = vertical_disk_rhs(t[i], state, p, slope);
        status = status == VERTICAL_DISK_OK ? one : status;
        for (size_t k = 0; k < VERTICAL_DISK_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if VERTICAL_DISK_LANES >= 2
#define VERTICAL_DISK_SPREAD(x) ((x) - (vertical_disk_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long vertical_disk_bits __attribute__((vector_size(8 * VERTICAL_DISK_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline vertical_disk_lanes vertical_disk_mark(vertical_disk_lanes value, vertical_disk_bits bad)
{
    return (vertical_disk_lanes)((vertical_disk_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int vertical_disk_is_good(int count, const double *check)
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
static inline void vertical_disk_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < VERTICAL_DISK_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < VERTICAL_DISK_NY; ++k) {
            state[k * VERTICAL_DISK_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void vertical_disk_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < VERTICAL_DISK_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * VERTICAL_DISK_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void vertical_disk_turn_lanes(vertical_disk_lanes x, vertical_disk_lanes *far,
    vertical_disk_lanes *sine, vertical_disk_lanes *cosine)
{
    double angle[VERTICAL_DISK_LANES];
    double up[VERTICAL_DISK_LANES];
    double along[VERTICAL_DISK_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < VERTICAL_DISK_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int vertical_disk_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* from the state */
    const double v1_x = theta_dot * R;
    /* (I.1.2) */
    dydt[0] = c_phi * v1_x; /* x' */
    dydt[1] = s_phi * v1_x; /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    /* (III.3) 16:4 */
    dydt[4] = 0.0; /* phi'' */
    dydt[5] = 0.0; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs((I + R * (m * R)) * J) > 0.0 * (dydt[0] + dydt[2]))) {
        /* the mass matrix is singular, if I + R * (m * R) is 0 */
        if (!(fabs(I + R * (m * R)) > 0.0)) {
            return vertical_disk_refuse(fabs(I + R * (m * R)), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return vertical_disk_refuse(fabs(J), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        return vertical_disk_finish(6, dydt);
    }
    return VERTICAL_DISK_OK;
}

int vertical_disk_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the state */
    const double v1_x = theta_dot * R;
    /* (I.1.2) */
    qdot[0] = c_phi * v1_x; /* x' */
    qdot[1] = s_phi * v1_x; /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[2]) <= DBL_MAX)) {
        return vertical_disk_finish(4, qdot);
    }
    return VERTICAL_DISK_OK;
}

int vertical_disk_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* from the state */
    const double z1 = R * (phi_dot * theta_dot);
    /* (III.3) */
    qddot[0] = -s_phi * z1; /* x'' */
    qddot[1] = c_phi * z1; /* y'' */
    qddot[2] = 0.0; /* phi'' */
    qddot[3] = 0.0; /* theta'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs((I + R * (m * R)) * J) > 0.0 * qddot[0])) {
        /* the mass matrix is singular, if I + R * (m * R) is 0 */
        if (!(fabs(I + R * (m * R)) > 0.0)) {
            return vertical_disk_refuse(fabs(I + R * (m * R)), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return vertical_disk_refuse(fabs(J), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        return vertical_disk_finish(4, qddot);
    }
    return VERTICAL_DISK_OK;
}

int vertical_disk_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* point of contact [m] */
    y[0] = x;
    const double y_2 = q[1]; /* y: point of contact [m] */
    y[1] = y_2;
    const double phi = q[2]; /* heading [rad] */
    y[2] = phi;
    const double theta = q[3]; /* angle rolled [rad] */
    y[3] = theta;
    const double phi_dot = qdot[2]; /* phi' [rad/s] */
    y[4] = phi_dot;
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    y[5] = theta_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5]) <= DBL_MAX)) {
        return vertical_disk_finish(6, y);
    }
    return VERTICAL_DISK_OK;
}

int vertical_disk_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* heading [rad] */

    /* sines and cosines */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double theta_dot = qdot[3]; /* theta' [rad/s] */
    const double R = p[1]; /* radius [m] */

    /* from the coordinates and velocities */
    const double v1_x = theta_dot * R;
    /* (I.1.1) 18:5 */
    r[0] = x_dot - c_phi * v1_x; /* roll_x = 0 */
    /* (I.1.1) 19:5 */
    r[1] = y_dot - s_phi * v1_x; /* roll_y = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1]) <= DBL_MAX)) {
        return vertical_disk_finish(2, r);
    }
    return VERTICAL_DISK_OK;
}

int vertical_disk_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* from the parameters alone */
    const double k1 = m * R;

    /* from the state */
    const double z1 = k1 * (phi_dot * theta_dot);
    /* (I.4.1) 18:5 */
    lambda[0] = -s_phi * z1; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 19:5 */
    lambda[1] = c_phi * z1; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(J * (I + R * k1)) > 0.0 * lambda[0])) {
        /* the mass matrix is singular, if J is 0 */
        if (!(fabs(J) > 0.0)) {
            return vertical_disk_refuse(fabs(J), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, if I + R * k1 is 0 */
        if (!(fabs(I + R * k1) > 0.0)) {
            return vertical_disk_refuse(fabs(I + R * k1), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        return vertical_disk_finish(2, lambda);
    }
    return VERTICAL_DISK_OK;
}

double vertical_disk_energy(double t, const double *y, const double *p)
{
    (void)t;

    /* from the parameters alone */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double k1 = I + m * (R * R);

    /* from the state */
    const double phi_dot = y[4]; /* phi' [rad/s] */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */
    return 0.5 * (J * (phi_dot * phi_dot) + theta_dot * theta_dot * k1);
}

int vertical_disk_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 36 * sizeof *J);
    (void)t;
    const double phi = y[2]; /* heading [rad] */

    /* sines and cosines */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);

    /* what else is read */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J_2 = p[3]; /* J: moment of inertia about the vertical [kg*m^2] */

    /* from the state */
    const double z1 = R * s_phi;
    const double z2 = R * c_phi;
    /* (III.3) */
    J[2] = -theta_dot * z1;
    J[5] = z2;
    J[8] = theta_dot * z2;
    J[11] = z1;
    J[16] = 1.0;
    J[23] = 1.0;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs((I + R * (m * R)) * J_2) > 0.0 * (J[2] + J[8]))) {
        /* the mass matrix is singular, if I + R * (m * R) is 0 */
        if (!(fabs(I + R * (m * R)) > 0.0)) {
            return vertical_disk_refuse(fabs(I + R * (m * R)), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        /* the mass matrix is singular, if J_2 is 0 */
        if (!(fabs(J_2) > 0.0)) {
            return vertical_disk_refuse(fabs(J_2), 0.0, VERTICAL_DISK_SINGULAR_2);
        }
        return vertical_disk_finish(36, J);
    }
    return VERTICAL_DISK_OK;
}

int vertical_disk_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;

    /* from the state */
    const double theta_dot = y[5]; /* theta' [rad/s] */
    const double R = p[1]; /* radius [m] */
    /* 22:10 */
    out[0] = theta_dot * R; /* speed */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return vertical_disk_finish(1, out);
    }
    return VERTICAL_DISK_OK;
}

#if VERTICAL_DISK_LANES >= 2
static __attribute__((noinline)) void vertical_disk_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    vertical_disk_lanes far = {0}; /* the squares of the angles */
    vertical_disk_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    vertical_disk_bits bad = {0}; /* singular blocks */
    const double R = fixed[0];
    const vertical_disk_lanes phi = vertical_disk_get(y + 2 * stride);
    const vertical_disk_lanes phi_dot = vertical_disk_get(y + 4 * stride);
    const vertical_disk_lanes theta_dot = vertical_disk_get(y + 5 * stride);
    vertical_disk_lanes sine1, cosine1;
    vertical_disk_turn_lanes(VERTICAL_DISK_SPREAD(phi), &far, &sine1, &cosine1);
    const vertical_disk_lanes c_phi = cosine1;
    const vertical_disk_lanes v1_x = theta_dot * R;
    const vertical_disk_lanes s_phi = sine1;
    /* (I.1.2) */
    const vertical_disk_lanes slope1 = c_phi * v1_x;
    sum += slope1;
    vertical_disk_put(dydt, slope1);
    const vertical_disk_lanes slope2 = s_phi * v1_x;
    vertical_disk_put(dydt + 1 * stride, slope2);
    const vertical_disk_lanes slope3 = phi_dot;
    sum += slope3;
    vertical_disk_put(dydt + 2 * stride, slope3);
    const vertical_disk_lanes slope4 = theta_dot;
    vertical_disk_put(dydt + 3 * stride, slope4);
    /* (III.3) 16:4 */
    const vertical_disk_lanes slope5 = VERTICAL_DISK_SPREAD(0.0);
    vertical_disk_put(dydt + 4 * stride, slope5);
    const vertical_disk_lanes slope6 = VERTICAL_DISK_SPREAD(0.0);
    vertical_disk_put(dydt + 5 * stride, slope6);
    vertical_disk_put(check, vertical_disk_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void vertical_disk_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[VERTICAL_DISK_LANES];
    double state[6 * VERTICAL_DISK_LANES];
    double slope[6 * VERTICAL_DISK_LANES];
    vertical_disk_fill(left, count, t, y, time, state);
    vertical_disk_rhs_lanes(fixed, VERTICAL_DISK_LANES, time, state, slope, check);
    vertical_disk_pour(left, count, slope, dydt);
}
#endif

int vertical_disk_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if VERTICAL_DISK_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */
    /* the mass matrix is singular, if J is 0 */
    if (!(fabs(J) > 0.0)) {
        return vertical_disk_one_by_one(count, 0, count, t, y, p, dydt);
    }
    /* the mass matrix is singular, if I + R * (m * R) is 0 */
    if (!(fabs(I + R * (m * R)) > 0.0)) {
        return vertical_disk_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {R};
    double check[1 * VERTICAL_DISK_LANES];
    int status = VERTICAL_DISK_OK;
    for (size_t i = 0; i < count; i += VERTICAL_DISK_LANES) {
        const size_t left = count - i < VERTICAL_DISK_LANES ? count - i : VERTICAL_DISK_LANES;
        if (left == VERTICAL_DISK_LANES) {
            vertical_disk_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            vertical_disk_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!vertical_disk_is_good(1 * VERTICAL_DISK_LANES, check)) {
            const int one = vertical_disk_one_by_one(count, i, left, t, y, p, dydt);
            status = status == VERTICAL_DISK_OK ? one : status;
        }
    }
    return status;
#else
    return vertical_disk_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
