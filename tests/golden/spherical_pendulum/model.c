/*
 * spherical_pendulum.c: spherical_pendulum, emitted by nhc 0.1.0 (nhc:65530e2dc7193a1c)
 * A pendulum that swings in space.
 * Source: spherical_pendulum.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * spherical_pendulum.h says what each function does.
 */
#include "spherical_pendulum.h"

#include <float.h>
#include <math.h>

const char *const spherical_pendulum_coordinate_names[] = {
    "theta",
    "phi"
};
const char *const spherical_pendulum_state_names[] = {
    "theta",
    "phi",
    "theta'",
    "phi'"
};
const char *const spherical_pendulum_parameter_names[] = {
    "m",
    "l",
    "g"
};
const double spherical_pendulum_parameter_defaults[] = {
    1.0,
    1.0,
    9.81
};

static int spherical_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? SPHERICAL_PENDULUM_OK : SPHERICAL_PENDULUM_NOT_FINITE;
}

int spherical_pendulum_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[2];
    const double phi_dot = y[3];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * (l * l);
    const double k2 = g / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    /* the mass matrix is singular */
    if (!(fabs(k1 * (s_theta * s_theta)) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    /* (II.3) */
    dydt[0] = theta_dot; /* theta' */
    dydt[1] = phi_dot; /* phi' */
    /* (II.3) 13:4 */
    dydt[2] = s_theta * (phi_dot * phi_dot * c_theta - k2); /* theta'' */
    dydt[3] = -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta); /* phi'' */
    return spherical_pendulum_finish(4, dydt);
}

int spherical_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta_dot = y[2];
    const double phi_dot = y[3];

    /* state */
    /* (I.2.4) */
    qdot[0] = theta_dot; /* theta' */
    qdot[1] = phi_dot; /* phi' */
    return spherical_pendulum_finish(2, qdot);
}

int spherical_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[2];
    const double phi_dot = y[3];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * (l * l);
    const double k2 = g / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    /* the mass matrix is singular */
    if (!(fabs(k1 * (s_theta * s_theta)) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    /* (II.3) */
    qddot[0] = s_theta * (phi_dot * phi_dot * c_theta - k2); /* theta'' */
    qddot[1] = -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta); /* phi'' */
    return spherical_pendulum_finish(2, qddot);
}

int spherical_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta = q[0]; /* angle from the downward vertical [rad] */
    const double phi = q[1]; /* azimuth [rad] */
    const double theta_dot = qdot[0];
    const double phi_dot = qdot[1];

    /* state */
    y[0] = theta;
    y[1] = phi;
    y[2] = theta_dot;
    y[3] = phi_dot;
    return spherical_pendulum_finish(4, y);
}

int spherical_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return SPHERICAL_PENDULUM_OK;
}

int spherical_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */

    /* parameters only */
    const double k1 = m * (l * l);

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    /* the mass matrix is singular */
    if (!(fabs(k1 * (s_theta * s_theta)) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    (void)lambda;
    return SPHERICAL_PENDULUM_OK;
}

double spherical_pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[2];
    const double phi_dot = y[3];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * l;

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double z1 = k1 * (l * (0.5 * (theta_dot * theta_dot) + 0.5 * (s_theta * s_theta * (phi_dot *
        phi_dot))) - g * c_theta);
    return z1;
}

int spherical_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double theta_dot = y[2];
    const double phi_dot = y[3];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * (l * l);
    const double k2 = 1.0 / l;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    /* the mass matrix is singular */
    if (!(fabs(k1 * z1) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z2 = 1.0 / s_theta;
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 1.0;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 1.0;
    J[8] = phi_dot * phi_dot * (1.0 - 2.0 * z1) - k2 * (g * c_theta);
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 2.0 * (c_theta * (phi_dot * s_theta));
    J[12] = 2.0 * (theta_dot * phi_dot / (s_theta * s_theta));
    J[13] = 0.0;
    J[14] = -2.0 * (z2 * (phi_dot * c_theta));
    J[15] = -2.0 * (theta_dot * c_theta * z2);
    return spherical_pendulum_finish(16, J);
}

int spherical_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[0]; /* angle from the downward vertical [rad] */
    const double phi_dot = y[3];
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */

    /* parameters only */
    const double k1 = m * (l * l);

    /* state */
    const double s_theta = sin(theta);
    /* 16:8 */
    out[0] = phi_dot * (k1 * (s_theta * s_theta)); /* L_z */
    return spherical_pendulum_finish(1, out);
}

int spherical_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double m = p[0]; /* mass of the bob [kg] */
    const double l = p[1]; /* length of the rod [m] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * (l * l);
    const double k2 = g / l;
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta = y[i]; /* angle from the downward vertical [rad] */
        const double theta_dot = y[2 * count + i];
        const double phi_dot = y[3 * count + i];
        const double s_theta = sin(theta);
        /* the mass matrix is singular */
        singular1 |= !(fabs(k1 * (s_theta * s_theta)) > 0.0);
        const double c_theta = cos(theta);
        /* (II.3) */
        const double slope1 = theta_dot; /* theta' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = phi_dot; /* phi' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        /* (II.3) 13:4 */
        const double slope3 = s_theta * (phi_dot * phi_dot * c_theta - k2); /* theta'' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta); /* phi'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
    }
    if (singular1) {
        return SPHERICAL_PENDULUM_SINGULAR_2;
    }
    return bad ? SPHERICAL_PENDULUM_NOT_FINITE : SPHERICAL_PENDULUM_OK;
}
