/*
 * heavy_top.c: heavy_top, emitted by nhc 0.1.0 (nhc:303a123a99c7ff33)
 * The symmetric top with a fixed point (Lagrange's top).
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * heavy_top.h says what each function does.
 */
#include "heavy_top.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const heavy_top_coordinate_names[HEAVY_TOP_NQ] = {
    "phi",
    "theta",
    "psi"
};
const char *const heavy_top_state_names[HEAVY_TOP_NY] = {
    "phi",
    "theta",
    "psi",
    "phi'",
    "theta'",
    "psi'"
};
const char *const heavy_top_parameter_names[HEAVY_TOP_NP] = {
    "I1",
    "I3",
    "mgl"
};
const char *const heavy_top_constraint_names[1] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const char *const heavy_top_output_names[HEAVY_TOP_NOUT] = {
    "p_phi",
    "p_psi"
};
const double heavy_top_parameter_defaults[HEAVY_TOP_NP] = {
    1.0,
    1.5,
    2.0
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int heavy_top_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return HEAVY_TOP_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return HEAVY_TOP_NOT_FINITE;
        }
    }
    return HEAVY_TOP_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int heavy_top_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : HEAVY_TOP_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef HEAVY_TOP_LANES
#if !defined(__GNUC__)
#define HEAVY_TOP_LANES 1
#elif defined(__AVX512F__)
#define HEAVY_TOP_LANES 8
#elif defined(__AVX__)
#define HEAVY_TOP_LANES 4
#else
#define HEAVY_TOP_LANES 2
#endif
#endif
#if HEAVY_TOP_LANES > 1
typedef double heavy_top_lanes __attribute__((vector_size(8 * HEAVY_TOP_LANES)));
#else
typedef double heavy_top_lanes;
#endif

#if HEAVY_TOP_LANES >= 2
static inline heavy_top_lanes heavy_top_get(const double *from)
{
    heavy_top_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void heavy_top_put(double *to, heavy_top_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int heavy_top_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = HEAVY_TOP_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[HEAVY_TOP_NY];
        double slope[HEAVY_TOP_NY];
        for (size_t k = 0; k < HEAVY_TOP_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = heavy_top_rhs(t[i], state, p, slope);
        status = status == HEAVY_TOP_OK ? one : status;
        for (size_t k = 0; k < HEAVY_TOP_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if HEAVY_TOP_LANES >= 2
#define HEAVY_TOP_SPREAD(x) ((x) - (heavy_top_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long heavy_top_bits __attribute__((vector_size(8 * HEAVY_TOP_LANES)));

/* all bits where value is not above bound, or is no number */
static inline heavy_top_bits heavy_top_misses(heavy_top_lanes value, heavy_top_lanes bound)
{
    return ~(heavy_top_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline heavy_top_lanes heavy_top_mark(heavy_top_lanes value, heavy_top_bits bad)
{
    return (heavy_top_lanes)((heavy_top_bits)value | bad);
}

static inline heavy_top_lanes heavy_top_size(heavy_top_lanes x)
{
    return (heavy_top_lanes)((heavy_top_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int heavy_top_is_good(int count, const double *check)
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
static inline void heavy_top_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < HEAVY_TOP_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < HEAVY_TOP_NY; ++k) {
            state[k * HEAVY_TOP_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void heavy_top_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < HEAVY_TOP_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * HEAVY_TOP_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void heavy_top_turn_lanes(heavy_top_lanes x, heavy_top_lanes *far,
    heavy_top_lanes *sine, heavy_top_lanes *cosine)
{
    double angle[HEAVY_TOP_LANES];
    double up[HEAVY_TOP_LANES];
    double along[HEAVY_TOP_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < HEAVY_TOP_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int heavy_top_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double theta_dot = y[4]; /* theta' [rad/s] */
    const double psi_dot = y[5]; /* psi' [rad/s] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / I1;
    const double k2 = I3 * k1;
    const double k3 = mgl * k1;

    /* from the state */
    const double z1 = phi_dot * c_theta;
    const double z2 = (psi_dot + z1) * k2;
    const double z3 = theta_dot / s_theta * (2.0 * z1 - z2);
    /* (II.3) */
    dydt[0] = phi_dot; /* phi' */
    dydt[1] = theta_dot; /* theta' */
    dydt[2] = psi_dot; /* psi' */
    /* (II.3) 16:4 */
    dydt[3] = -z3; /* phi'' */
    dydt[4] = s_theta * (k3 + phi_dot * (z1 - z2)); /* theta'' */
    dydt[5] = s_theta * (phi_dot * theta_dot) + c_theta * z3; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(I3) > 0.0 * (dydt[4] + dydt[5]))) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return heavy_top_refuse(fabs(I1), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return heavy_top_refuse(fabs(I3), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I1 * (s_theta * s_theta) is 0 */
        if (!(fabs(I1 * (s_theta * s_theta)) > 0.0)) {
            return heavy_top_refuse(fabs(I1 * (s_theta * s_theta)), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        return heavy_top_finish(6, dydt);
    }
    return HEAVY_TOP_OK;
}

int heavy_top_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;

    /* from the state */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    qdot[0] = phi_dot; /* phi' */
    const double theta_dot = y[4]; /* theta' [rad/s] */
    qdot[1] = theta_dot; /* theta' */
    const double psi_dot = y[5]; /* psi' [rad/s] */
    qdot[2] = psi_dot; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2]) <= DBL_MAX)) {
        return heavy_top_finish(3, qdot);
    }
    return HEAVY_TOP_OK;
}

int heavy_top_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double theta_dot = y[4]; /* theta' [rad/s] */
    const double psi_dot = y[5]; /* psi' [rad/s] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / I1;
    const double k2 = I3 * k1;
    const double k3 = mgl * k1;

    /* from the state */
    const double z1 = phi_dot * c_theta;
    const double z2 = (psi_dot + z1) * k2;
    const double z3 = theta_dot / s_theta * (2.0 * z1 - z2);
    /* (II.3) */
    qddot[0] = -z3; /* phi'' */
    qddot[1] = s_theta * (k3 + phi_dot * (z1 - z2)); /* theta'' */
    qddot[2] = s_theta * (phi_dot * theta_dot) + c_theta * z3; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(I3) > 0.0 * (qddot[1] + qddot[2]))) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return heavy_top_refuse(fabs(I1), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return heavy_top_refuse(fabs(I3), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I1 * (s_theta * s_theta) is 0 */
        if (!(fabs(I1 * (s_theta * s_theta)) > 0.0)) {
            return heavy_top_refuse(fabs(I1 * (s_theta * s_theta)), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        return heavy_top_finish(3, qddot);
    }
    return HEAVY_TOP_OK;
}

int heavy_top_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double phi = q[0]; /* precession [rad] */
    y[0] = phi;
    const double theta = q[1]; /* nutation [rad] */
    y[1] = theta;
    const double psi = q[2]; /* spin [rad] */
    y[2] = psi;
    const double phi_dot = qdot[0]; /* phi' [rad/s] */
    y[3] = phi_dot;
    const double theta_dot = qdot[1]; /* theta' [rad/s] */
    y[4] = theta_dot;
    const double psi_dot = qdot[2]; /* psi' [rad/s] */
    y[5] = psi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5]) <= DBL_MAX)) {
        return heavy_top_finish(6, y);
    }
    return HEAVY_TOP_OK;
}

int heavy_top_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return HEAVY_TOP_OK;
}

int heavy_top_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);

    /* what else is read */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */

    /* from the state */
    /* the mass matrix is singular, if I1 is 0 */
    if (!(fabs(I1) > 0.0)) {
        return heavy_top_refuse(fabs(I1), 0.0, HEAVY_TOP_SINGULAR_2);
    }
    /* the mass matrix is singular, if I3 is 0 */
    if (!(fabs(I3) > 0.0)) {
        return heavy_top_refuse(fabs(I3), 0.0, HEAVY_TOP_SINGULAR_2);
    }
    /* the mass matrix is singular, if I1 * (s_theta * s_theta) is 0 */
    if (!(fabs(I1 * (s_theta * s_theta)) > 0.0)) {
        return heavy_top_refuse(fabs(I1 * (s_theta * s_theta)), 0.0, HEAVY_TOP_SINGULAR_2);
    }
    (void)lambda;
    return HEAVY_TOP_OK;
}

double heavy_top_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double theta_dot = y[4]; /* theta' [rad/s] */
    const double psi_dot = y[5]; /* psi' [rad/s] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* from the state */
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z1 = 0.5 * (I1 * (theta_dot * theta_dot + s_theta * s_theta * (phi_dot * phi_dot)) + I3 *
        (omega3 * omega3)) + mgl * c_theta;
    return z1;
}

int heavy_top_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 36 * sizeof *J);
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double theta_dot = y[4]; /* theta' [rad/s] */
    const double psi_dot = y[5]; /* psi' [rad/s] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* from the parameters alone */
    const double k1 = 1.0 / I1;
    const double k2 = I3 * k1;
    const double k3 = mgl * k1;
    const double k4 = 2.0 - k2;

    /* from the state */
    const double z1 = phi_dot * c_theta;
    const double z2 = (psi_dot + z1) * k2;
    const double z3 = 2.0 * z1 - z2;
    const double z4 = 1.0 / s_theta;
    const double z5 = theta_dot * z4;
    const double z6 = phi_dot * s_theta;
    const double z7 = z3 * (theta_dot * c_theta * (z4 * z4)) + z5 * (z6 * k4);
    const double z8 = z5 * (c_theta * k4);
    const double z9 = z4 * z3;
    const double z10 = k2 * z5;
    const double z11 = z1 - z2;
    const double z12 = z6 * k2;
    /* (II.3) */
    J[3] = 1.0;
    J[10] = 1.0;
    J[17] = 1.0;
    J[19] = z7;
    J[21] = -z8;
    J[22] = -z9;
    J[23] = z10;
    J[25] = c_theta * (k3 + phi_dot * z11) - z6 * (z6 - z12);
    J[27] = s_theta * (z11 + phi_dot * (c_theta - c_theta * k2));
    J[29] = -z12;
    J[31] = theta_dot * z1 - (theta_dot * z3 + c_theta * z7);
    J[33] = theta_dot * s_theta + c_theta * z8;
    J[34] = z6 + c_theta * z9;
    J[35] = -c_theta * z10;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    /* (times 0 it is NaN then, and the comparison fails) */
    if (!(fabs(I3) > 0.0 * (J[25] + J[27] + J[29] + J[31] + J[33] + J[34] + J[35]))) {
        /* the mass matrix is singular, if I1 is 0 */
        if (!(fabs(I1) > 0.0)) {
            return heavy_top_refuse(fabs(I1), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I3 is 0 */
        if (!(fabs(I3) > 0.0)) {
            return heavy_top_refuse(fabs(I3), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        /* the mass matrix is singular, if I1 * (s_theta * s_theta) is 0 */
        if (!(fabs(I1 * (s_theta * s_theta)) > 0.0)) {
            return heavy_top_refuse(fabs(I1 * (s_theta * s_theta)), 0.0, HEAVY_TOP_SINGULAR_2);
        }
        return heavy_top_finish(36, J);
    }
    return HEAVY_TOP_OK;
}

int heavy_top_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);

    /* what else is read */
    const double phi_dot = y[3]; /* phi' [rad/s] */
    const double psi_dot = y[5]; /* psi' [rad/s] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */

    /* from the state */
    const double z1 = I3 * (psi_dot + phi_dot * c_theta);
    /* 19:10 */
    out[0] = phi_dot * (I1 * (s_theta * s_theta)) + c_theta * z1; /* p_phi */
    /* 20:10 */
    out[1] = z1; /* p_psi */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX)) {
        return heavy_top_finish(2, out);
    }
    return HEAVY_TOP_OK;
}

#if HEAVY_TOP_LANES >= 2
static __attribute__((noinline)) void heavy_top_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    heavy_top_lanes far = {0}; /* the squares of the angles */
    heavy_top_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    heavy_top_bits bad = {0}; /* singular blocks */
    const double I1 = fixed[0];
    const double k2 = fixed[1];
    const double k3 = fixed[2];
    const heavy_top_lanes theta = heavy_top_get(y + 1 * stride);
    const heavy_top_lanes phi_dot = heavy_top_get(y + 3 * stride);
    const heavy_top_lanes theta_dot = heavy_top_get(y + 4 * stride);
    const heavy_top_lanes psi_dot = heavy_top_get(y + 5 * stride);
    heavy_top_lanes sine1, cosine1;
    heavy_top_turn_lanes(HEAVY_TOP_SPREAD(theta), &far, &sine1, &cosine1);
    const heavy_top_lanes s_theta = sine1;
    /* the mass matrix is singular, if I1 * (s_theta * s_theta) is 0 */
    bad |= heavy_top_misses(heavy_top_size(HEAVY_TOP_SPREAD(I1 * (s_theta * s_theta))),
        HEAVY_TOP_SPREAD(0.0));
    const heavy_top_lanes c_theta = cosine1;
    const heavy_top_lanes z1 = phi_dot * c_theta;
    const heavy_top_lanes z2 = (psi_dot + z1) * k2;
    const heavy_top_lanes z3 = theta_dot / s_theta * (2.0 * z1 - z2);
    /* (II.3) */
    const heavy_top_lanes slope1 = phi_dot;
    heavy_top_put(dydt, slope1);
    const heavy_top_lanes slope2 = theta_dot;
    heavy_top_put(dydt + 1 * stride, slope2);
    const heavy_top_lanes slope3 = psi_dot;
    heavy_top_put(dydt + 2 * stride, slope3);
    /* (II.3) 16:4 */
    const heavy_top_lanes slope4 = -z3;
    heavy_top_put(dydt + 3 * stride, slope4);
    const heavy_top_lanes slope5 = s_theta * (k3 + phi_dot * (z1 - z2));
    sum += slope5;
    heavy_top_put(dydt + 4 * stride, slope5);
    const heavy_top_lanes slope6 = s_theta * (phi_dot * theta_dot) + c_theta * z3;
    sum += slope6;
    heavy_top_put(dydt + 5 * stride, slope6);
    heavy_top_put(check, heavy_top_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void heavy_top_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[HEAVY_TOP_LANES];
    double state[6 * HEAVY_TOP_LANES];
    double slope[6 * HEAVY_TOP_LANES];
    heavy_top_fill(left, count, t, y, time, state);
    heavy_top_rhs_lanes(fixed, HEAVY_TOP_LANES, time, state, slope, check);
    heavy_top_pour(left, count, slope, dydt);
}
#endif

int heavy_top_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if HEAVY_TOP_LANES >= 2
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */
    const double k1 = 1.0 / I1;
    const double k2 = I3 * k1;
    const double k3 = mgl * k1;
    /* the mass matrix is singular, if I3 is 0 */
    if (!(fabs(I3) > 0.0)) {
        return heavy_top_one_by_one(count, 0, count, t, y, p, dydt);
    }
    const double fixed[] = {I1, k2, k3};
    double check[1 * HEAVY_TOP_LANES];
    int status = HEAVY_TOP_OK;
    for (size_t i = 0; i < count; i += HEAVY_TOP_LANES) {
        const size_t left = count - i < HEAVY_TOP_LANES ? count - i : HEAVY_TOP_LANES;
        if (left == HEAVY_TOP_LANES) {
            heavy_top_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            heavy_top_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!heavy_top_is_good(1 * HEAVY_TOP_LANES, check)) {
            const int one = heavy_top_one_by_one(count, i, left, t, y, p, dydt);
            status = status == HEAVY_TOP_OK ? one : status;
        }
    }
    return status;
#else
    return heavy_top_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
