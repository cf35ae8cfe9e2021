/*
 * cvt_eps.c: cvt_eps, emitted by nhc 0.1.0 (nhc:c9cd9bd553e72351)
 * The transmission with a driver that breaks the symmetry; most integrators for nonholonomic systems drift on
 *     it.
 * Source: cvt_eps.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `y`
 * cvt_eps.h says what each function does.
 */
#include "cvt_eps.h"

#include <float.h>
#include <math.h>

const char *const cvt_eps_coordinate_names[] = {
    "x",
    "y",
    "xi"
};
const char *const cvt_eps_state_names[] = {
    "x",
    "y",
    "xi",
    "x'",
    "xi'"
};
const char *const cvt_eps_parameter_names[] = {
    "eps"
};
const double cvt_eps_parameter_defaults[] = {
    0.3
};

static int cvt_eps_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? CVT_EPS_OK : CVT_EPS_NOT_FINITE;
}

int cvt_eps_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double x = y[0];
    const double y_2 = y[1];
    const double xi = y[2];
    const double x_dot = y[3];
    const double xi_dot = y[4];
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* state */
    const double s_xi = sin(xi);
    const double z1 = 1.0 + s_xi * s_xi;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CVT_EPS_SINGULAR_2;
    }
    const double c_xi = cos(xi);
    const double c1 = cos(2.0 * xi);
    /* (III.3) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = -x_dot * s_xi; /* y' */
    dydt[2] = xi_dot; /* xi' */
    /* (III.3) 9:4 */
    dydt[3] = -(x - s_xi * (y_2 - c_xi * (x_dot * xi_dot))) / z1; /* x'' */
    dydt[4] = s_xi + eps * c1; /* xi'' */
    return cvt_eps_finish(5, dydt);
}

int cvt_eps_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double xi = y[2];
    const double x_dot = y[3];
    const double xi_dot = y[4];

    /* state */
    const double s_xi = sin(xi);
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = -x_dot * s_xi; /* y' */
    qdot[2] = xi_dot; /* xi' */
    return cvt_eps_finish(3, qdot);
}

int cvt_eps_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double x = y[0];
    const double y_2 = y[1];
    const double xi = y[2];
    const double x_dot = y[3];
    const double xi_dot = y[4];
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* state */
    const double s_xi = sin(xi);
    const double z1 = 1.0 + s_xi * s_xi;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CVT_EPS_SINGULAR_2;
    }
    const double c_xi = cos(xi);
    const double z2 = c_xi * (x_dot * xi_dot);
    const double z3 = x - s_xi * (y_2 - z2);
    const double z4 = 1.0 / z1;
    const double c1 = cos(2.0 * xi);
    /* (III.3) */
    qddot[0] = -z3 * z4; /* x'' */
    qddot[1] = z3 * (s_xi * z4) - z2; /* y'' */
    qddot[2] = s_xi + eps * c1; /* xi'' */
    return cvt_eps_finish(3, qddot);
}

int cvt_eps_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0];
    const double y_2 = q[1];
    const double xi = q[2];
    const double x_dot = qdot[0];
    const double xi_dot = qdot[2];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = xi;
    y[3] = x_dot;
    y[4] = xi_dot;
    return cvt_eps_finish(5, y);
}

int cvt_eps_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double xi = q[2];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];

    /* state */
    const double s_xi = sin(xi);
    /* (I.1.1) 12:5 */
    r[0] = y_dot + x_dot * s_xi; /* belt = 0 */
    return cvt_eps_finish(1, r);
}

int cvt_eps_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double xi = y[2];
    const double x_dot = y[3];
    const double xi_dot = y[4];

    /* state */
    const double s_xi = sin(xi);
    const double z1 = 1.0 + s_xi * s_xi;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CVT_EPS_SINGULAR_2;
    }
    const double c_xi = cos(xi);
    const double z2 = y_2 - c_xi * (x_dot * xi_dot);
    /* (I.4.1) 12:5 */
    lambda[0] = z2 + (x - s_xi * z2) * (s_xi / z1); /* reaction of belt: Q_i gains lambda_1 a_1i */
    return cvt_eps_finish(1, lambda);
}

double cvt_eps_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double x = y[0];
    const double y_2 = y[1];
    const double xi = y[2];
    const double x_dot = y[3];
    const double xi_dot = y[4];
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* state */
    const double c_xi = cos(xi);
    const double s1 = sin(2.0 * xi);
    const double s_xi = sin(xi);
    const double z1 = x_dot * s_xi;
    const double z2 = 0.5 * (x * x + y_2 * y_2) + c_xi - 0.5 * (eps * s1) + 0.5 * (xi_dot * xi_dot + (x_dot *
        x_dot + z1 * z1));
    return z2;
}

int cvt_eps_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double x = y[0];
    const double y_2 = y[1];
    const double xi = y[2];
    const double x_dot = y[3];
    const double xi_dot = y[4];
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* state */
    const double s_xi = sin(xi);
    const double z1 = 1.0 + s_xi * s_xi;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CVT_EPS_SINGULAR_2;
    }
    const double c_xi = cos(xi);
    const double z2 = 1.0 / z1;
    const double z3 = x_dot * xi_dot;
    const double z4 = y_2 - c_xi * z3;
    const double z5 = z2 * (s_xi * (s_xi * z3) + c_xi * (z4 + 2.0 * (s_xi * ((x - s_xi * z4) * z2))));
    const double z6 = c_xi * s_xi;
    const double s1 = sin(2.0 * xi);
    /* (III.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    J[3] = 1.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = -x_dot * c_xi;
    J[8] = -s_xi;
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 1.0;
    J[15] = -z2;
    J[16] = s_xi * z2;
    J[17] = z5;
    J[18] = -z2 * (xi_dot * z6);
    J[19] = -z2 * (x_dot * z6);
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = c_xi - 2.0 * (eps * s1);
    J[23] = 0.0;
    J[24] = 0.0;
    return cvt_eps_finish(25, J);
}

int cvt_eps_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double x = y[0];
    const double y_2 = y[1];
    const double xi = y[2];
    const double x_dot = y[3];
    const double xi_dot = y[4];
    const double eps = p[0]; /* what breaks the symmetry of the driver */

    /* state */
    const double s1 = sin(2.0 * xi);
    const double c_xi = cos(xi);
    const double s_xi = sin(xi);
    const double z1 = x_dot * s_xi;
    /* 15:9 */
    out[0] = 0.5 * (xi_dot * xi_dot) + c_xi - 0.5 * (eps * s1); /* E_xi */
    /* 16:9 */
    out[1] = 0.5 * (y_2 * y_2 + (x * x + (x_dot * x_dot + z1 * z1))); /* E_xy */
    return cvt_eps_finish(2, out);
}

int cvt_eps_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
    const double eps = p[0]; /* what breaks the symmetry of the driver */
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x = y[i];
        const double y_2 = y[count + i];
        const double xi = y[2 * count + i];
        const double x_dot = y[3 * count + i];
        const double xi_dot = y[4 * count + i];
        const double s_xi = sin(xi);
        const double z1 = 1.0 + s_xi * s_xi;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z1) > 0.0);
        const double c_xi = cos(xi);
        const double c1 = cos(2.0 * xi);
        /* (III.3) */
        const double slope1 = x_dot; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = -x_dot * s_xi; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = xi_dot; /* xi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (III.3) 9:4 */
        const double slope4 = -(x - s_xi * (y_2 - c_xi * (x_dot * xi_dot))) / z1; /* x'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = s_xi + eps * c1; /* xi'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    if (singular1) {
        return CVT_EPS_SINGULAR_2;
    }
    return bad ? CVT_EPS_NOT_FINITE : CVT_EPS_OK;
}
