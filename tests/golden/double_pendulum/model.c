/*
 * double_pendulum.c: double_pendulum, emitted by nhc 0.1.0 (nhc:25796aed39c0a0ee)
 * Two pendulums in a row, absolute angles; the model gives positions and nhc differentiates them.
 * Source: double_pendulum.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * double_pendulum.h says what each function does.
 */
#include "double_pendulum.h"

#include <float.h>
#include <math.h>

const char *const double_pendulum_coordinate_names[] = {
    "theta1",
    "theta2"
};
const char *const double_pendulum_state_names[] = {
    "theta1",
    "theta2",
    "theta1'",
    "theta2'"
};
const char *const double_pendulum_parameter_names[] = {
    "m1",
    "m2",
    "l1",
    "l2",
    "g"
};
const double double_pendulum_parameter_defaults[] = {
    1.0,
    1.0,
    1.0,
    1.0,
    9.81
};

static int double_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? DOUBLE_PENDULUM_OK : DOUBLE_PENDULUM_NOT_FINITE;
}

int double_pendulum_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */
    const double theta1_dot = y[2];
    const double theta2_dot = y[3];
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m1 * g;
    const double k2 = (m1 + m2) * (l1 * l1);
    const double k3 = l2 * (m2 * l1);
    const double k4 = m2 * (l2 * l2);
    const double k5 = m2 * l2;
    const double k6 = 1.0 / k2;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    const double s_theta1 = sin(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta1 = cos(theta1);
    const double c_theta2 = cos(theta2);
    const double z1 = k3 * (s_theta1 * s_theta2 + c_theta1 * c_theta2);
    const double z2 = z1 * k6;
    const double z3 = k4 - z1 * z2;
    /* the mass matrix is singular */
    if (!(fabs(z3) > 1e-14 * k4)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    const double z4 = s_theta1 * c_theta2 - c_theta1 * s_theta2;
    const double z5 = l1 * (m2 * (l2 * (theta2_dot * theta2_dot) * z4 + g * s_theta1) + s_theta1 * k1);
    const double z6 = (k5 * (z4 * (l1 * (theta1_dot * theta1_dot)) - g * s_theta2) + z5 * z2) / z3;
    /* (II.3) */
    dydt[0] = theta1_dot; /* theta1' */
    dydt[1] = theta2_dot; /* theta2' */
    /* (II.3) 20:4 */
    dydt[2] = -(z5 * k6 + z2 * z6); /* theta1'' */
    dydt[3] = z6; /* theta2'' */
    return double_pendulum_finish(4, dydt);
}

int double_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta1_dot = y[2];
    const double theta2_dot = y[3];

    /* state */
    /* (I.2.4) */
    qdot[0] = theta1_dot; /* theta1' */
    qdot[1] = theta2_dot; /* theta2' */
    return double_pendulum_finish(2, qdot);
}

int double_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */
    const double theta1_dot = y[2];
    const double theta2_dot = y[3];
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m1 * g;
    const double k2 = (m1 + m2) * (l1 * l1);
    const double k3 = l2 * (m2 * l1);
    const double k4 = m2 * (l2 * l2);
    const double k5 = m2 * l2;
    const double k6 = 1.0 / k2;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    const double s_theta1 = sin(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta1 = cos(theta1);
    const double c_theta2 = cos(theta2);
    const double z1 = k3 * (s_theta1 * s_theta2 + c_theta1 * c_theta2);
    const double z2 = z1 * k6;
    const double z3 = k4 - z1 * z2;
    /* the mass matrix is singular */
    if (!(fabs(z3) > 1e-14 * k4)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    const double z4 = s_theta1 * c_theta2 - c_theta1 * s_theta2;
    const double z5 = l1 * (m2 * (l2 * (theta2_dot * theta2_dot) * z4 + g * s_theta1) + s_theta1 * k1);
    const double z6 = (k5 * (z4 * (l1 * (theta1_dot * theta1_dot)) - g * s_theta2) + z5 * z2) / z3;
    /* (II.3) */
    qddot[0] = -(z5 * k6 + z2 * z6); /* theta1'' */
    qddot[1] = z6; /* theta2'' */
    return double_pendulum_finish(2, qddot);
}

int double_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double theta1 = q[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = q[1]; /* lower rod from the downward vertical [rad] */
    const double theta1_dot = qdot[0];
    const double theta2_dot = qdot[1];

    /* state */
    y[0] = theta1;
    y[1] = theta2;
    y[2] = theta1_dot;
    y[3] = theta2_dot;
    return double_pendulum_finish(4, y);
}

int double_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return DOUBLE_PENDULUM_OK;
}

int double_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */

    /* parameters only */
    const double k1 = (m1 + m2) * (l1 * l1);
    const double k2 = l2 * (m2 * l1);
    const double k3 = m2 * (l2 * l2);
    const double k4 = 1.0 / k1;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    const double s_theta1 = sin(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta1 = cos(theta1);
    const double c_theta2 = cos(theta2);
    const double z1 = k2 * (s_theta1 * s_theta2 + c_theta1 * c_theta2);
    /* the mass matrix is singular */
    if (!(fabs(k3 - z1 * (z1 * k4)) > 1e-14 * k3)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    (void)lambda;
    return DOUBLE_PENDULUM_OK;
}

double double_pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */
    const double theta1_dot = y[2];
    const double theta2_dot = y[3];
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m1 * l1;

    /* state */
    const double s_theta1 = sin(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta1 = cos(theta1);
    const double c_theta2 = cos(theta2);
    const double z1 = g * c_theta1;
    const double z2 = l1 * (theta1_dot * ((s_theta1 * s_theta2 + c_theta1 * c_theta2) * (theta2_dot * l2) +
        0.5 * (theta1_dot * l1)) - z1);
    const double z3 = m2 * (z2 + l2 * (0.5 * (l2 * (theta2_dot * theta2_dot)) - g * c_theta2)) + k1 * (0.5 *
        (l1 * (theta1_dot * theta1_dot)) - z1);
    return z3;
}

int double_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */
    const double theta1_dot = y[2];
    const double theta2_dot = y[3];
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m1 * g;
    const double k2 = (m1 + m2) * (l1 * l1);
    const double k3 = m2 * l1;
    const double k4 = l2 * k3;
    const double k5 = m2 * (l2 * l2);
    const double k6 = m2 * l2;
    const double k7 = 1.0 / k2;
    const double k8 = l1 * k1 + g * k3;
    const double k9 = g * k6;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    const double s_theta1 = sin(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta1 = cos(theta1);
    const double c_theta2 = cos(theta2);
    const double z1 = k4 * (s_theta1 * s_theta2 + c_theta1 * c_theta2);
    const double z2 = z1 * k7;
    const double z3 = k5 - z1 * z2;
    /* the mass matrix is singular */
    if (!(fabs(z3) > 1e-14 * k5)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    const double z4 = l2 * (theta2_dot * theta2_dot);
    const double z5 = k3 * z4;
    const double z6 = 1.0 / z3;
    const double z7 = s_theta1 * c_theta2 - c_theta1 * s_theta2;
    const double z8 = l1 * (theta1_dot * theta1_dot);
    const double z9 = l1 * (m2 * (z4 * z7 + g * s_theta1) + s_theta1 * k1);
    const double z10 = z6 * (k6 * (z7 * z8 - g * s_theta2) + z9 * z2);
    const double z11 = k4 * z10;
    const double z12 = s_theta1 * (s_theta2 * z5 - c_theta2 * z11) + c_theta1 * (k8 + c_theta2 * z5 +
        s_theta2 * z11);
    const double z13 = k6 * z8;
    const double z14 = k4 * (z9 * k7 + z2 * z10);
    const double z15 = s_theta1 * (s_theta2 * z13 - c_theta2 * z14) + c_theta1 * (c_theta2 * z13 + s_theta2 *
        z14) + z2 * z12;
    const double z16 = z6 * z15;
    const double z17 = s_theta2 * (s_theta1 * z5 + c_theta1 * z11) + c_theta2 * (c_theta1 * z5 - s_theta1 *
        z11);
    const double z18 = s_theta2 * (s_theta1 * z13 + c_theta1 * z14) + c_theta2 * (k9 + c_theta1 * z13 -
        s_theta1 * z14) + z2 * z17;
    const double z19 = z6 * z18;
    const double z20 = z6 * (theta1_dot * (l1 * (z7 * k6)));
    const double z21 = theta2_dot * (l2 * (k3 * z7));
    const double z22 = z6 * (z2 * z21);
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 1.0;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 1.0;
    J[8] = -(k7 * z12 + z2 * z16);
    J[9] = k7 * z17 + z2 * z19;
    J[10] = -2.0 * (z2 * z20);
    J[11] = -(2.0 * (k7 * z21) + 2.0 * (z2 * z22));
    J[12] = z16;
    J[13] = -z19;
    J[14] = 2.0 * z20;
    J[15] = 2.0 * z22;
    return double_pendulum_finish(16, J);
}

int double_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta1 = y[0]; /* upper rod from the downward vertical [rad] */
    const double theta2 = y[1]; /* lower rod from the downward vertical [rad] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */

    /* state */
    const double s_theta1 = sin(theta1);
    const double s_theta2 = sin(theta2);
    const double c_theta1 = cos(theta1);
    const double c_theta2 = cos(theta2);
    /* 23:10 */
    out[0] = l1 * s_theta1 + l2 * s_theta2; /* tip_x */
    /* 24:10 */
    out[1] = -(l1 * c_theta1 + l2 * c_theta2); /* tip_y */
    return double_pendulum_finish(2, out);
}

int double_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double m1 = p[0]; /* [kg] */
    const double m2 = p[1]; /* [kg] */
    const double l1 = p[2]; /* [m] */
    const double l2 = p[3]; /* [m] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */
    const double k1 = m1 * g;
    const double k2 = (m1 + m2) * (l1 * l1);
    const double k3 = l2 * (m2 * l1);
    const double k4 = m2 * (l2 * l2);
    const double k5 = m2 * l2;
    const double k6 = 1.0 / k2;
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta1 = y[i]; /* upper rod from the downward vertical [rad] */
        const double theta2 = y[count + i]; /* lower rod from the downward vertical [rad] */
        const double theta1_dot = y[2 * count + i];
        const double theta2_dot = y[3 * count + i];
        const double s_theta1 = sin(theta1);
        const double s_theta2 = sin(theta2);
        const double c_theta1 = cos(theta1);
        const double c_theta2 = cos(theta2);
        const double z1 = k3 * (s_theta1 * s_theta2 + c_theta1 * c_theta2);
        const double z2 = z1 * k6;
        const double z3 = k4 - z1 * z2;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z3) > 1e-14 * k4);
        const double z4 = s_theta1 * c_theta2 - c_theta1 * s_theta2;
        const double z5 = l1 * (m2 * (l2 * (theta2_dot * theta2_dot) * z4 + g * s_theta1) + s_theta1 * k1);
        const double z6 = (k5 * (z4 * (l1 * (theta1_dot * theta1_dot)) - g * s_theta2) + z5 * z2) / z3;
        /* (II.3) */
        const double slope1 = theta1_dot; /* theta1' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = theta2_dot; /* theta2' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        /* (II.3) 20:4 */
        const double slope3 = -(z5 * k6 + z2 * z6); /* theta1'' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = z6; /* theta2'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
    }
    if (singular1) {
        return DOUBLE_PENDULUM_SINGULAR_2;
    }
    return bad ? DOUBLE_PENDULUM_NOT_FINITE : DOUBLE_PENDULUM_OK;
}
