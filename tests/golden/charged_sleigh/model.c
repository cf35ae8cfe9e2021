/*
 * charged_sleigh.c: charged_sleigh, emitted by nhc 0.1.0 (nhc:f9eb9784cce4fe9d)
 * Chaplygin's sleigh with a charge at its centre of mass in a magnetic field; T depends on x and y.
 * Source: charged_sleigh.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * charged_sleigh.h says what each function does.
 */
#include "charged_sleigh.h"

#include <float.h>
#include <math.h>

const char *const charged_sleigh_coordinate_names[] = {
    "x",
    "y",
    "theta"
};
const char *const charged_sleigh_state_names[] = {
    "x",
    "y",
    "theta",
    "v",
    "w"
};
const char *const charged_sleigh_parameter_names[] = {
    "m",
    "J",
    "a",
    "B"
};
const double charged_sleigh_parameter_defaults[] = {
    1.0,
    0.5,
    0.7,
    0.9
};

static int charged_sleigh_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? CHARGED_SLEIGH_OK : CHARGED_SLEIGH_NOT_FINITE;
}

int charged_sleigh_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[3];
    const double w = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* parameters only */
    const double k1 = J + m * (a * a);
    const double k2 = 1.0 / m;
    const double k3 = 1.0 / k1;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double z1 = B + m * w;
    /* (I.2.15) */
    dydt[0] = c_theta * v; /* x' */
    dydt[1] = s_theta * v; /* y' */
    dydt[2] = w; /* theta' */
    /* (I.2.15) 18:4 */
    dydt[3] = a * w * z1 * k2; /* v' */
    dydt[4] = -z1 * (a * v) * k3; /* w' */
    return charged_sleigh_finish(5, dydt);
}

int charged_sleigh_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[3];
    const double w = y[4];

    /* state */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    /* (I.2.4) */
    qdot[0] = c_theta * v; /* x' */
    qdot[1] = s_theta * v; /* y' */
    qdot[2] = w; /* theta' */
    return charged_sleigh_finish(3, qdot);
}

int charged_sleigh_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[3];
    const double w = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* parameters only */
    const double k1 = J + m * (a * a);
    const double k2 = 1.0 / m;
    const double k3 = 1.0 / k1;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double z1 = B + m * w;
    const double z2 = a * w * z1 * k2;
    /* (I.2.15) */
    qddot[0] = c_theta * z2 - v * (s_theta * w); /* x'' */
    qddot[1] = v * (c_theta * w) + s_theta * z2; /* y'' */
    qddot[2] = -z1 * (a * v) * k3; /* theta'' */
    return charged_sleigh_finish(3, qddot);
}

int charged_sleigh_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* point of the edge [m] */
    const double y_2 = q[1]; /* point of the edge [m] */
    const double theta = q[2]; /* heading [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];

    /* state */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = x_dot * c_theta + y_dot * s_theta;
    y[4] = theta_dot;
    return charged_sleigh_finish(5, y);
}

int charged_sleigh_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double theta = q[2]; /* heading [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    /* (I.1.1) 20:5 */
    r[0] = y_dot * c_theta - x_dot * s_theta; /* slip = 0 */
    return charged_sleigh_finish(1, r);
}

int charged_sleigh_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double v = y[3];
    const double w = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = J + m * k1;
    const double k3 = k1 / k2;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    /* (I.4.1) 20:5 */
    lambda[0] = v * (B + m * (w - (B + m * w) * k3)); /* reaction of slip: Q_i gains lambda_1 a_1i */
    return charged_sleigh_finish(1, lambda);
}

double charged_sleigh_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double x = y[0]; /* point of the edge [m] */
    const double y_2 = y[1]; /* point of the edge [m] */
    const double theta = y[2]; /* heading [rad] */
    const double v = y[3];
    const double w = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* state */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double X_dot = c_theta * v - a * (s_theta * w);
    const double Y_dot = s_theta * v + a * (c_theta * w);
    const double z1 = 0.5 * (m * (X_dot * X_dot + Y_dot * Y_dot)) + 0.5 * (J * (w * w)) + 0.5 * (B * ((x + a
        * c_theta) * Y_dot - (y_2 + a * s_theta) * X_dot));
    return z1;
}

int charged_sleigh_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[3];
    const double w = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J_2 = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */

    /* parameters only */
    const double k1 = J_2 + m * (a * a);
    const double k2 = 1.0 / m;
    const double k3 = 1.0 / k1;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double z1 = a * (B + m * w);
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = -s_theta * v;
    J[3] = c_theta;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = c_theta * v;
    J[8] = s_theta;
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 1.0;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = k2 * (m * (a * w) + z1);
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = -k3 * z1;
    J[24] = -k3 * (m * (a * v));
    return charged_sleigh_finish(25, J);
}

int charged_sleigh_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double v = y[3];

    /* state */
    /* 25:10 */
    out[0] = v; /* speed */
    return charged_sleigh_finish(1, out);
}

int charged_sleigh_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the centre of mass [kg*m^2] */
    const double a = p[2]; /* from the edge to the centre of mass [m] */
    const double B = p[3]; /* charge times field [kg/s] */
    const double k1 = J + m * (a * a);
    const double k2 = 1.0 / m;
    const double k3 = 1.0 / k1;
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return CHARGED_SLEIGH_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta = y[2 * count + i]; /* heading [rad] */
        const double v = y[3 * count + i];
        const double w = y[4 * count + i];
        const double c_theta = cos(theta);
        const double s_theta = sin(theta);
        const double z1 = B + m * w;
        /* (I.2.15) */
        const double slope1 = c_theta * v; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = s_theta * v; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = w; /* theta' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (I.2.15) 18:4 */
        const double slope4 = a * w * z1 * k2; /* v' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -z1 * (a * v) * k3; /* w' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    return bad ? CHARGED_SLEIGH_NOT_FINITE : CHARGED_SLEIGH_OK;
}
