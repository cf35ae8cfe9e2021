/*
 * pendulum.c: pendulum, emitted by nhc 0.1.0 (nhc:bdac2a7edaca3800)
 * The plane pendulum, large swings.
 * Source: pendulum.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * pendulum.h says what each function does.
 */
#include "pendulum.h"

#include <float.h>
#include <math.h>

const char *const pendulum_coordinate_names[] = {
    "theta"
};
const char *const pendulum_state_names[] = {
    "theta",
    "theta'"
};
const char *const pendulum_parameter_names[] = {
    "m",
    "l",
    "g"
};
const double pendulum_parameter_defaults[] = {
    1.0,
    1.0,
    9.81
};

static int pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? PENDULUM_OK : PENDULUM_NOT_FINITE;
}

int pendulum_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[1];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = 1.0 / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    /* (II.3) */
    dydt[0] = theta_dot; /* theta' */
    /* (II.3) 12:4 */
    dydt[1] = -g * s_theta * k1; /* theta'' */
    return pendulum_finish(2, dydt);
}

int pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta_dot = y[1];

    /* state */
    /* (I.2.4) */
    qdot[0] = theta_dot; /* theta' */
    return pendulum_finish(1, qdot);
}

int pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = 1.0 / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    /* (II.3) */
    qddot[0] = -g * s_theta * k1; /* theta'' */
    return pendulum_finish(1, qddot);
}

int pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = qdot[0];

    /* state */
    y[0] = theta;
    y[1] = theta_dot;
    return pendulum_finish(2, y);
}

int pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return PENDULUM_OK;
}

int pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PENDULUM_SINGULAR_2;
    }
    (void)lambda;
    return PENDULUM_OK;
}

double pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[1];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * l;

    /* state */
    const double c_theta = cos(theta);
    return k1 * (0.5 * (l * (theta_dot * theta_dot)) - g * c_theta);
}

int pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = 1.0 / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PENDULUM_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 1.0;
    J[2] = -k1 * (g * c_theta);
    J[3] = 0.0;
    return pendulum_finish(4, J);
}

int pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double theta_dot = y[1];

    /* state */
    /* 15:9 */
    out[0] = theta_dot; /* rate */
    return pendulum_finish(1, out);
}

int pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double k1 = 1.0 / l;
    /* the mass matrix is singular */
    if (!(fabs(m * (l * l)) > 0.0)) {
        return PENDULUM_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta = y[i]; /* angle from the downward vertical [rad] */
        const double theta_dot = y[count + i];
        const double s_theta = sin(theta);
        /* (II.3) */
        const double slope1 = theta_dot; /* theta' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        /* (II.3) 12:4 */
        const double slope2 = -g * s_theta * k1; /* theta'' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
    }
    return bad ? PENDULUM_NOT_FINITE : PENDULUM_OK;
}
