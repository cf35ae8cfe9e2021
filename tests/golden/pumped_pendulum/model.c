/*
 * pumped_pendulum.c: pumped_pendulum, emitted by nhc 0.1.0 (nhc:2dbb653b8c13dfc6)
 * A pendulum whose pivot is moved to and fro; T depends on time and is not homogeneous in the velocities.
 * Source: pumped_pendulum.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * pumped_pendulum.h says what each function does.
 */
#include "pumped_pendulum.h"

#include <float.h>
#include <math.h>

const char *const pumped_pendulum_coordinate_names[] = {
    "theta"
};
const char *const pumped_pendulum_state_names[] = {
    "theta",
    "theta'"
};
const char *const pumped_pendulum_parameter_names[] = {
    "m",
    "l",
    "g",
    "a",
    "nu"
};
const double pumped_pendulum_parameter_defaults[] = {
    1.0,
    1.0,
    9.81,
    0.3,
    3.0
};

static int pumped_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? PUMPED_PENDULUM_OK : PUMPED_PENDULUM_NOT_FINITE;
}

int pumped_pendulum_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[1];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* parameters only */
    const double k1 = a * (nu * nu);
    const double k2 = 1.0 / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PUMPED_PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s1 = sin(t * nu);
    /* (II.3) */
    dydt[0] = theta_dot; /* theta' */
    /* (II.3) 17:4 */
    dydt[1] = -(g * s_theta - c_theta * (s1 * k1)) * k2; /* theta'' */
    return pumped_pendulum_finish(2, dydt);
}

int pumped_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta_dot = y[1];

    /* state */
    /* (I.2.4) */
    qdot[0] = theta_dot; /* theta' */
    return pumped_pendulum_finish(1, qdot);
}

int pumped_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* parameters only */
    const double k1 = a * (nu * nu);
    const double k2 = 1.0 / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PUMPED_PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s1 = sin(t * nu);
    /* (II.3) */
    qddot[0] = -(g * s_theta - c_theta * (s1 * k1)) * k2; /* theta'' */
    return pumped_pendulum_finish(1, qddot);
}

int pumped_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = qdot[0];

    /* state */
    y[0] = theta;
    y[1] = theta_dot;
    return pumped_pendulum_finish(2, y);
}

int pumped_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PUMPED_PENDULUM_SINGULAR_2;
    }
    (void)lambda;
    return PUMPED_PENDULUM_OK;
}

double pumped_pendulum_energy(double t, const double *y, const double *p)
{
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[1];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* parameters only */
    const double k1 = m * g;

    /* state */
    const double c1 = cos(t * nu);
    const double c_theta = cos(theta);
    const double x_dot = a * (nu * c1) + l * (theta_dot * c_theta);
    const double s_theta = sin(theta);
    const double y_dot = l * (theta_dot * s_theta);
    return 0.5 * (m * (x_dot * x_dot + y_dot * y_dot)) - l * c_theta * k1;
}

int pumped_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */

    /* parameters only */
    const double k1 = a * (nu * nu);
    const double k2 = 1.0 / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PUMPED_PENDULUM_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double s1 = sin(t * nu);
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 1.0;
    J[2] = -k2 * (g * c_theta + s_theta * (s1 * k1));
    J[3] = 0.0;
    return pumped_pendulum_finish(4, J);
}

int pumped_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return PUMPED_PENDULUM_OK;
}

int pumped_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double a = p[3]; /* amplitude of the pivot [m] */
    const double nu = p[4]; /* frequency of the pivot [rad/s] */
    const double k1 = a * (nu * nu);
    const double k2 = 1.0 / l;
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PUMPED_PENDULUM_SINGULAR_2;
    }
    int bad = 0;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double t_ = t[i]; /* time */
        const double theta = y[i]; /* angle from the downward vertical [rad] */
        const double theta_dot = y[count + i];
        const double s_theta = sin(theta);
        const double c_theta = cos(theta);
        const double s1 = sin(t_ * nu);
        /* (II.3) */
        const double slope1 = theta_dot; /* theta' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        /* (II.3) 17:4 */
        const double slope2 = -(g * s_theta - c_theta * (s1 * k1)) * k2; /* theta'' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
    }
    return bad ? PUMPED_PENDULUM_NOT_FINITE : PUMPED_PENDULUM_OK;
}
