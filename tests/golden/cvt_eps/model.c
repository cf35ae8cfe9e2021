/*
 * cvt_eps.c: cvt_eps, emitted by nhc 0.1.0 (nhc:5f8b1e635282ca3c)
 * The transmission with a driver that breaks the symmetry; most integrators for nonholonomic systems drift on
 *     it.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `y`
 * cvt_eps.h says what each function does.
 */
#include "cvt_eps.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const cvt_eps_coordinate_names[CVT_EPS_NQ] = {
    "x",
    "y",
    "xi"
};
const char *const cvt_eps_state_names[CVT_EPS_NY] = {
    "x",
    "y",
    "xi",
    "x'",
    "xi'"
};
const char *const cvt_eps_parameter_names[CVT_EPS_NP] = {
    "eps"
};
const char *const cvt_eps_constraint_names[CVT_EPS_NC] = {
    "belt"
};
const char *const cvt_eps_output_names[CVT_EPS_NOUT] = {
    "E_xi",
    "E_xy"
};
const double cvt_eps_parameter_defaults[CVT_EPS_NP] = {
    0.3
};

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int cvt_eps_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return CVT_EPS_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return CVT_EPS_NOT_FINITE;
        }
    }
    return CVT_EPS_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int cvt_eps_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : CVT_EPS_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef CVT_EPS_LANES
#if !defined(__GNUC__)
#define CVT_EPS_LANES 1
#elif defined(__AVX512F__)
#define CVT_EPS_LANES 8
#elif defined(__AVX__)
#define CVT_EPS_LANES 4
#else
#define CVT_EPS_LANES 2
#endif
#endif
#if CVT_EPS_LANES > 1
typedef double cvt_eps_lanes __attribute__((vector_size(8 * CVT_EPS_LANES)));
#else
typedef double cvt_eps_lanes;
#endif

#if CVT_EPS_LANES >= 2
static inline cvt_eps_lanes cvt_eps_get(const double *from)
{
    cvt_eps_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void cvt_eps_put(double *to, cvt_eps_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int cvt_eps_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = CVT_EPS_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[CVT_EPS_NY];
        double slope[CVT_EPS_NY];
        for (size_t k = 0; k < CVT_EPS_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = cvt_eps_rhs(t[i], state, p, slope);
        status = status == CVT_EPS_OK ? one : status;
        for (size_t k = 0; k < CVT_EPS_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if CVT_EPS_LANES >= 2
#define CVT_EPS_SPREAD(x) ((x) - (cvt_eps_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long cvt_eps_bits __attribute__((vector_size(8 * CVT_EPS_LANES)));

/* makes a NaN of each lane whose bits are set */
static inline cvt_eps_lanes cvt_eps_mark(cvt_eps_lanes value, cvt_eps_bits bad)
{
    return (cvt_eps_lanes)((cvt_eps_bits)value | bad);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int cvt_eps_is_good(int count, const double *check)
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
static inline void cvt_eps_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < CVT_EPS_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < CVT_EPS_NY; ++k) {
            state[k * CVT_EPS_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void cvt_eps_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < CVT_EPS_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * CVT_EPS_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void cvt_eps_turn_lanes(cvt_eps_lanes x, cvt_eps_lanes *far,
    cvt_eps_lanes *sine, cvt_eps_lanes *cosine)
{
    double angle[CVT_EPS_LANES];
    double up[CVT_EPS_LANES];
    double along[CVT_EPS_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < CVT_EPS_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int cvt_eps_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double xi = y[2];

    /* sines and cosines */
    const double s_xi = sin(xi);
    const double c_xi = cos(xi);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double xi_dot = y[4]; /* xi' */
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* from the state */
    const double z1 = s_xi * s_xi;
    const double z2 = 1.0 + z1;
    /* (I.1.2) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = -x_dot * s_xi; /* y' */
    dydt[2] = xi_dot; /* xi' */
    /* (III.3) 9:4 */
    dydt[3] = (s_xi * (y_2 - c_xi * (x_dot * xi_dot)) - x) / z2; /* x'' */
    dydt[4] = s_xi - eps * (z1 - c_xi * c_xi); /* xi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[3] + dydt[4]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return cvt_eps_refuse(fabs(z2), 0.0, CVT_EPS_SINGULAR_2);
        }
        return cvt_eps_finish(5, dydt);
    }
    return CVT_EPS_OK;
}

int cvt_eps_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double xi = y[2];

    /* sines and cosines */
    const double s_xi = sin(xi);

    /* what else is read */
    const double x_dot = y[3]; /* x' */
    const double xi_dot = y[4]; /* xi' */

    /* from the state */
    /* (I.1.2) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = -x_dot * s_xi; /* y' */
    qdot[2] = xi_dot; /* xi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[1] + qdot[2]) <= DBL_MAX)) {
        return cvt_eps_finish(3, qdot);
    }
    return CVT_EPS_OK;
}

int cvt_eps_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double xi = y[2];

    /* sines and cosines */
    const double s_xi = sin(xi);
    const double c_xi = cos(xi);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double xi_dot = y[4]; /* xi' */
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* from the state */
    const double z1 = s_xi * s_xi;
    const double z2 = 1.0 + z1;
    const double z3 = c_xi * (x_dot * xi_dot);
    const double z4 = (x - s_xi * (y_2 - z3)) / z2;
    /* (III.3) */
    qddot[0] = -z4; /* x'' */
    qddot[1] = s_xi * z4 - z3; /* y'' */
    qddot[2] = s_xi - eps * (z1 - c_xi * c_xi); /* xi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[1] + qddot[2]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return cvt_eps_refuse(fabs(z2), 0.0, CVT_EPS_SINGULAR_2);
        }
        return cvt_eps_finish(3, qddot);
    }
    return CVT_EPS_OK;
}

int cvt_eps_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0];
    y[0] = x;
    const double y_2 = q[1]; /* y */
    y[1] = y_2;
    const double xi = q[2];
    y[2] = xi;
    const double x_dot = qdot[0]; /* x' */
    y[3] = x_dot;
    const double xi_dot = qdot[2]; /* xi' */
    y[4] = xi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4]) <= DBL_MAX)) {
        return cvt_eps_finish(5, y);
    }
    return CVT_EPS_OK;
}

int cvt_eps_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double xi = q[2];

    /* sines and cosines */
    const double s_xi = sin(xi);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' */
    const double y_dot = qdot[1]; /* y' */

    /* from the coordinates and velocities */
    /* (I.1.1) 12:5 */
    r[0] = y_dot + x_dot * s_xi; /* belt = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0]) <= DBL_MAX)) {
        return cvt_eps_finish(1, r);
    }
    return CVT_EPS_OK;
}

int cvt_eps_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;
    const double xi = y[2];

    /* sines and cosines */
    const double s_xi = sin(xi);
    const double c_xi = cos(xi);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double xi_dot = y[4]; /* xi' */

    /* from the state */
    const double z1 = 1.0 + s_xi * s_xi;
    /* (I.4.1) 12:5 */
    /* reaction of belt: Q_i gains lambda_1 a_1i */
    lambda[0] = (y_2 + x * s_xi - c_xi * (x_dot * xi_dot)) / z1;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z1 is 0 */
        if (!(fabs(z1) > 0.0)) {
            return cvt_eps_refuse(fabs(z1), 0.0, CVT_EPS_SINGULAR_2);
        }
        return cvt_eps_finish(1, lambda);
    }
    return CVT_EPS_OK;
}

double cvt_eps_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double xi = y[2];

    /* sines and cosines */
    const double s_xi = sin(xi);
    const double c_xi = cos(xi);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double xi_dot = y[4]; /* xi' */
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* from the state */
    const double z1 = c_xi + 0.5 * (xi_dot * xi_dot + (x * x + y_2 * y_2) - 2.0 * (eps * (c_xi * s_xi)));
    return 0.5 * (x_dot * x_dot * (1.0 + s_xi * s_xi)) + z1;
}

int cvt_eps_jacobian(double t, const double *y, const double *p, double *J)
{
    memset(J, 0, 25 * sizeof *J);
    (void)t;
    const double xi = y[2];

    /* sines and cosines */
    const double s_xi = sin(xi);
    const double c_xi = cos(xi);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double xi_dot = y[4]; /* xi' */
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* from the state */
    const double z1 = s_xi * s_xi;
    const double z2 = 1.0 + z1;
    const double z3 = 1.0 / z2;
    const double z4 = s_xi * z3;
    const double z5 = x_dot * xi_dot;
    const double z6 = y_2 - c_xi * z5;
    const double z7 = c_xi * s_xi;
    const double z8 = z7 * z3;
    /* (III.3) */
    J[3] = 1.0;
    J[7] = -x_dot * c_xi;
    J[8] = -s_xi;
    J[14] = 1.0;
    J[15] = -z3;
    J[16] = z4;
    J[17] = z3 * (z1 * z5 + c_xi * (z6 + 2.0 * ((x - s_xi * z6) * z4)));
    J[18] = -xi_dot * z8;
    J[19] = -x_dot * z8;
    J[22] = c_xi - 4.0 * (eps * z7);
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[17] + J[18] + J[19] + J[22]) <= DBL_MAX)) {
        /* the mass matrix is singular, if z2 is 0 */
        if (!(fabs(z2) > 0.0)) {
            return cvt_eps_refuse(fabs(z2), 0.0, CVT_EPS_SINGULAR_2);
        }
        return cvt_eps_finish(25, J);
    }
    return CVT_EPS_OK;
}

int cvt_eps_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double xi = y[2];

    /* sines and cosines */
    const double c_xi = cos(xi);
    const double s_xi = sin(xi);

    /* what else is read */
    const double x = y[0];
    const double y_2 = y[1]; /* y */
    const double x_dot = y[3]; /* x' */
    const double xi_dot = y[4]; /* xi' */
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* from the state */
    /* 15:9 */
    out[0] = c_xi + 0.5 * (xi_dot * xi_dot - 2.0 * (eps * (c_xi * s_xi))); /* E_xi */
    /* 16:9 */
    out[1] = 0.5 * (x * x + y_2 * y_2 + x_dot * x_dot * (1.0 + s_xi * s_xi)); /* E_xy */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1]) <= DBL_MAX)) {
        return cvt_eps_finish(2, out);
    }
    return CVT_EPS_OK;
}

#if CVT_EPS_LANES >= 2
static __attribute__((noinline)) void cvt_eps_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    cvt_eps_lanes far = {0}; /* the squares of the angles */
    cvt_eps_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    cvt_eps_bits bad = {0}; /* singular blocks */
    const double eps = fixed[0];
    const cvt_eps_lanes x = cvt_eps_get(y);
    const cvt_eps_lanes y_2 = cvt_eps_get(y + 1 * stride);
    const cvt_eps_lanes xi = cvt_eps_get(y + 2 * stride);
    const cvt_eps_lanes x_dot = cvt_eps_get(y + 3 * stride);
    const cvt_eps_lanes xi_dot = cvt_eps_get(y + 4 * stride);
    cvt_eps_lanes sine1, cosine1;
    cvt_eps_turn_lanes(CVT_EPS_SPREAD(xi), &far, &sine1, &cosine1);
    const cvt_eps_lanes s_xi = sine1;
    const cvt_eps_lanes z1 = s_xi * s_xi;
    const cvt_eps_lanes z2 = 1.0 + z1;
    const cvt_eps_lanes c_xi = cosine1;
    /* (I.1.2) */
    const cvt_eps_lanes slope1 = x_dot;
    cvt_eps_put(dydt, slope1);
    const cvt_eps_lanes slope2 = -x_dot * s_xi;
    cvt_eps_put(dydt + 1 * stride, slope2);
    const cvt_eps_lanes slope3 = xi_dot;
    cvt_eps_put(dydt + 2 * stride, slope3);
    /* (III.3) 9:4 */
    const cvt_eps_lanes slope4 = (s_xi * (y_2 - c_xi * (x_dot * xi_dot)) - x) / z2;
    sum += slope4;
    cvt_eps_put(dydt + 3 * stride, slope4);
    const cvt_eps_lanes slope5 = s_xi - eps * (z1 - c_xi * c_xi);
    sum += slope5;
    cvt_eps_put(dydt + 4 * stride, slope5);
    cvt_eps_put(check, cvt_eps_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void cvt_eps_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[CVT_EPS_LANES];
    double state[5 * CVT_EPS_LANES];
    double slope[5 * CVT_EPS_LANES];
    cvt_eps_fill(left, count, t, y, time, state);
    cvt_eps_rhs_lanes(fixed, CVT_EPS_LANES, time, state, slope, check);
    cvt_eps_pour(left, count, slope, dydt);
}
#endif

int cvt_eps_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
#if CVT_EPS_LANES >= 2
    const double eps = p[0]; /* what breaks the symmetry of the driver */
    const double fixed[] = {eps};
    double check[1 * CVT_EPS_LANES];
    int status = CVT_EPS_OK;
    for (size_t i = 0; i < count; i += CVT_EPS_LANES) {
        const size_t left = count - i < CVT_EPS_LANES ? count - i : CVT_EPS_LANES;
        if (left == CVT_EPS_LANES) {
            cvt_eps_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            cvt_eps_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!cvt_eps_is_good(1 * CVT_EPS_LANES, check)) {
            const int one = cvt_eps_one_by_one(count, i, left, t, y, p, dydt);
            status = status == CVT_EPS_OK ? one : status;
        }
    }
    return status;
#else
    return cvt_eps_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
