/*
 * skate_incline.c: skate_incline, emitted by nhc 0.1.0 (nhc:b31f4f6c3a898a4a)
 * A skate on an inclined plane with its centre of mass above the edge; it never gets far downhill.
 * Source: skate_incline.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, phi': the dependent velocities that nhc would choose (y') are
 *     singular somewhere
 * skate_incline.h says what each function does.
 */
#include "skate_incline.h"

#include <float.h>
#include <math.h>

const char *const skate_incline_coordinate_names[] = {
    "x",
    "y",
    "phi"
};
const char *const skate_incline_state_names[] = {
    "x",
    "y",
    "phi",
    "v",
    "phi'"
};
const char *const skate_incline_parameter_names[] = {
    "m",
    "J",
    "g",
    "alpha"
};
const double skate_incline_parameter_defaults[] = {
    1.0,
    0.4,
    9.81,
    0.5235987755982988
};

static int skate_incline_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? SKATE_INCLINE_OK : SKATE_INCLINE_NOT_FINITE;
}

int skate_incline_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double v = y[3];
    const double phi_dot = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* parameters only */
    const double s_alpha = sin(alpha);
    const double k1 = g * s_alpha;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    /* (I.2.15) */
    dydt[0] = c_phi * v; /* x' */
    dydt[1] = s_phi * v; /* y' */
    dydt[2] = phi_dot; /* phi' */
    /* (I.2.15) 15:4 */
    dydt[3] = c_phi * k1; /* v' */
    dydt[4] = 0.0; /* phi'' */
    return skate_incline_finish(5, dydt);
}

int skate_incline_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double v = y[3];
    const double phi_dot = y[4];

    /* state */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    /* (I.2.4) */
    qdot[0] = c_phi * v; /* x' */
    qdot[1] = s_phi * v; /* y' */
    qdot[2] = phi_dot; /* phi' */
    return skate_incline_finish(3, qdot);
}

int skate_incline_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double v = y[3];
    const double phi_dot = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* parameters only */
    const double s_alpha = sin(alpha);
    const double k1 = g * s_alpha;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double z1 = c_phi * k1;
    /* (I.2.15) */
    qddot[0] = c_phi * z1 - v * (phi_dot * s_phi); /* x'' */
    qddot[1] = v * (phi_dot * c_phi) + s_phi * z1; /* y'' */
    qddot[2] = 0.0; /* phi'' */
    return skate_incline_finish(3, qddot);
}

int skate_incline_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* down the slope [m] */
    const double y_2 = q[1]; /* across the slope [m] */
    const double phi = q[2]; /* heading, from the fall line [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double phi_dot = qdot[2];

    /* state */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = x_dot * c_phi + y_dot * s_phi;
    y[4] = phi_dot;
    return skate_incline_finish(5, y);
}

int skate_incline_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double phi = q[2]; /* heading, from the fall line [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];

    /* state */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    /* (I.1.1) 18:5 */
    r[0] = x_dot * s_phi - y_dot * c_phi; /* slip = 0 */
    return skate_incline_finish(1, r);
}

int skate_incline_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double v = y[3];
    const double phi_dot = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* parameters only */
    const double s_alpha = sin(alpha);
    const double k1 = g * s_alpha;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    /* (I.4.1) 18:5 */
    lambda[0] = -m * (phi_dot * v + s_phi * k1); /* reaction of slip: Q_i gains lambda_1 a_1i */
    return skate_incline_finish(1, lambda);
}

double skate_incline_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double x = y[0]; /* down the slope [m] */
    const double v = y[3];
    const double phi_dot = y[4];
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* parameters only */
    const double s_alpha = sin(alpha);

    /* state */
    return 0.5 * (J * (phi_dot * phi_dot)) - m * (s_alpha * (x * g) - 0.5 * (v * v));
}

int skate_incline_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double phi = y[2]; /* heading, from the fall line [rad] */
    const double v = y[3];
    const double m = p[0]; /* mass [kg] */
    const double J_2 = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */

    /* parameters only */
    const double s_alpha = sin(alpha);
    const double k1 = g * s_alpha;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J_2) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = -s_phi * v;
    J[3] = c_phi;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = c_phi * v;
    J[8] = s_phi;
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 1.0;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = -s_phi * k1;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = 0.0;
    J[24] = 0.0;
    return skate_incline_finish(25, J);
}

int skate_incline_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double v = y[3];

    /* state */
    /* 20:10 */
    out[0] = v; /* speed */
    return skate_incline_finish(1, out);
}

int skate_incline_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double J = p[1]; /* moment of inertia about the normal [kg*m^2] */
    const double g = p[2]; /* acceleration of gravity [m/s^2] */
    const double alpha = p[3]; /* slope, 30 degrees [rad] */
    const double s_alpha = sin(alpha);
    const double k1 = g * s_alpha;
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return SKATE_INCLINE_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double phi = y[2 * count + i]; /* heading, from the fall line [rad] */
        const double v = y[3 * count + i];
        const double phi_dot = y[4 * count + i];
        const double c_phi = cos(phi);
        const double s_phi = sin(phi);
        /* (I.2.15) */
        const double slope1 = c_phi * v; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = s_phi * v; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = phi_dot; /* phi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (I.2.15) 15:4 */
        const double slope4 = c_phi * k1; /* v' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = 0.0; /* phi'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    return bad ? SKATE_INCLINE_NOT_FINITE : SKATE_INCLINE_OK;
}
