/*
 * free_rigid_body.c: free_rigid_body, emitted by nhc 0.1.0 (nhc:3a1994f873fbc789)
 * A free rigid body; the components of its angular velocity on body axes are the quasi-velocities.
 * Source: free_rigid_body.yaml
 * Equations of motion: euler-lagrange (I.2.14)
 * Why: quasi-velocities of the spec
 * free_rigid_body.h says what each function does.
 */
#include "free_rigid_body.h"

#include <float.h>
#include <math.h>

const char *const free_rigid_body_coordinate_names[] = {
    "phi",
    "theta",
    "psi"
};
const char *const free_rigid_body_state_names[] = {
    "phi",
    "theta",
    "psi",
    "w1",
    "w2",
    "w3"
};
const char *const free_rigid_body_parameter_names[] = {
    "I1",
    "I2",
    "I3"
};
const double free_rigid_body_parameter_defaults[] = {
    1.0,
    2.0,
    3.0
};

static int free_rigid_body_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? FREE_RIGID_BODY_OK : FREE_RIGID_BODY_NOT_FINITE;
}

int free_rigid_body_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double w3 = y[5];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I2 - I3;
    const double k2 = I1 - I3;
    const double k3 = I1 - I2;
    const double k4 = 1.0 / I1;
    const double k5 = 1.0 / I2;
    const double k6 = 1.0 / I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return FREE_RIGID_BODY_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I2) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I3) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double z1 = 1.0 / s_theta;
    const double z2 = (c_psi * w2 + s_psi * w1) * z1;
    const double c_theta = cos(theta);
    /* (I.2.14) */
    dydt[0] = z2; /* phi' */
    dydt[1] = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2); /* theta' */
    dydt[2] = w3 - c_theta * z2; /* psi' */
    /* (I.2.14) 18:4 */
    dydt[3] = w2 * w3 * k1 * k4; /* w1' */
    dydt[4] = -w1 * w3 * k2 * k5; /* w2' */
    dydt[5] = w1 * w2 * k3 * k6; /* w3' */
    return free_rigid_body_finish(6, dydt);
}

int free_rigid_body_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double w3 = y[5];

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return FREE_RIGID_BODY_SINGULAR_1;
    }
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double z1 = 1.0 / s_theta;
    const double z2 = (c_psi * w2 + s_psi * w1) * z1;
    const double c_theta = cos(theta);
    /* (I.2.4) */
    qdot[0] = z2; /* phi' */
    qdot[1] = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2); /* theta' */
    qdot[2] = w3 - c_theta * z2; /* psi' */
    return free_rigid_body_finish(3, qdot);
}

int free_rigid_body_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double w3 = y[5];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I2 - I3;
    const double k2 = I1 - I3;
    const double k3 = I1 - I2;
    const double k4 = 1.0 / I1;
    const double k5 = 1.0 / I2;
    const double k6 = 1.0 / I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return FREE_RIGID_BODY_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I2) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I3) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double z1 = c_psi * w2 + s_psi * w1;
    const double c_theta = cos(theta);
    const double z2 = 1.0 / s_theta;
    const double z3 = s_theta * c_psi;
    const double z4 = s_theta * s_psi;
    const double z5 = z3 * w1 - z4 * w2;
    const double z6 = c_theta * (z2 * z5);
    const double z7 = z6 / (s_theta * s_theta);
    const double z8 = z1 * z2;
    const double z9 = w3 - c_theta * z8;
    const double z10 = s_psi * z9;
    const double z11 = w1 * w3 * k2 * k5;
    const double z12 = c_psi * z9;
    const double z13 = w2 * w3 * k1 * k4;
    const double z14 = z1 * z7 + z2 * (w2 * z10 + c_psi * z11 - (w1 * z12 + s_psi * z13));
    const double z15 = w1 * (c_psi * z6 - s_theta * z10) + z3 * z13 - (w2 * (s_psi * z6 + s_theta * z12) - z4
        * z11);
    /* (I.2.14) */
    qddot[0] = -z14; /* phi'' */
    qddot[1] = z2 * z15 - z5 * z7; /* theta'' */
    qddot[2] = w1 * w2 * k3 * k6 + (z8 * z5 + c_theta * z14); /* psi'' */
    return free_rigid_body_finish(3, qddot);
}

int free_rigid_body_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double phi = q[0]; /* precession [rad] */
    const double theta = q[1]; /* nutation [rad] */
    const double psi = q[2]; /* spin [rad] */
    const double phi_dot = qdot[0];
    const double theta_dot = qdot[1];
    const double psi_dot = qdot[2];

    /* state */
    const double s_theta = sin(theta);
    const double z1 = phi_dot * s_theta;
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double c_theta = cos(theta);
    y[0] = phi;
    y[1] = theta;
    y[2] = psi;
    y[3] = z1 * s_psi + theta_dot * c_psi;
    y[4] = z1 * c_psi - theta_dot * s_psi;
    y[5] = psi_dot + phi_dot * c_theta;
    return free_rigid_body_finish(6, y);
}

int free_rigid_body_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return FREE_RIGID_BODY_OK;
}

int free_rigid_body_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return FREE_RIGID_BODY_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I2) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I3) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    (void)lambda;
    return FREE_RIGID_BODY_OK;
}

double free_rigid_body_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double w1 = y[3];
    const double w2 = y[4];
    const double w3 = y[5];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* state */
    const double z1 = 0.5 * (I3 * (w3 * w3)) + (0.5 * (I1 * (w1 * w1)) + 0.5 * (I2 * (w2 * w2)));
    return z1;
}

int free_rigid_body_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double w3 = y[5];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I2 - I3;
    const double k2 = I1 - I3;
    const double k3 = I1 - I2;
    const double k4 = 1.0 / I1;
    const double k5 = 1.0 / I2;
    const double k6 = 1.0 / I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return FREE_RIGID_BODY_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I2) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I3) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double z1 = c_psi * w2 + s_psi * w1;
    const double z2 = 1.0 / (s_theta * s_theta);
    const double z3 = 1.0 / s_theta;
    const double z4 = s_psi * (w2 * z3);
    const double z5 = c_psi * (w1 * z3);
    const double z6 = c_theta * z3;
    /* (I.2.14) */
    J[0] = 0.0;
    J[1] = -c_theta * (z1 * z2);
    J[2] = z5 - z4;
    J[3] = s_psi * z3;
    J[4] = c_psi * z3;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = -c_theta * (z4 - (z5 - (s_theta * c_psi * w1 - s_theta * s_psi * w2) * z2));
    J[8] = -z1;
    J[9] = c_psi;
    J[10] = -s_psi;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = z1 + c_theta * (z2 * (c_theta * z1));
    J[14] = s_psi * (w2 * z6) - c_psi * (w1 * z6);
    J[15] = -s_psi * z6;
    J[16] = -c_psi * z6;
    J[17] = 1.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = k4 * (w3 * k1);
    J[23] = k4 * (w2 * k1);
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = -k5 * (w3 * k2);
    J[28] = 0.0;
    J[29] = -k5 * (w1 * k2);
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = k6 * (w2 * k3);
    J[34] = k6 * (w1 * k3);
    J[35] = 0.0;
    return free_rigid_body_finish(36, J);
}

int free_rigid_body_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double w3 = y[5];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I1 * I1;
    const double k2 = I2 * I2;
    const double k3 = I3 * I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return FREE_RIGID_BODY_SINGULAR_1;
    }
    /* 24:14 */
    out[0] = w3 * w3 * k3 + (w1 * w1 * k1 + w2 * w2 * k2); /* L_squared */
    return free_rigid_body_finish(1, out);
}

int free_rigid_body_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = I2 - I3;
    const double k2 = I1 - I3;
    const double k3 = I1 - I2;
    const double k4 = 1.0 / I1;
    const double k5 = 1.0 / I2;
    const double k6 = 1.0 / I3;
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I2) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I3) > 0.0)) {
        return FREE_RIGID_BODY_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta = y[count + i]; /* nutation [rad] */
        const double psi = y[2 * count + i]; /* spin [rad] */
        const double w1 = y[3 * count + i];
        const double w2 = y[4 * count + i];
        const double w3 = y[5 * count + i];
        const double s_theta = sin(theta);
        /* the coframe is singular */
        singular1 |= !(fabs(s_theta) > 1e-12 * 4.0);
        const double c_psi = cos(psi);
        const double s_psi = sin(psi);
        const double z1 = 1.0 / s_theta;
        const double z2 = (c_psi * w2 + s_psi * w1) * z1;
        const double c_theta = cos(theta);
        /* (I.2.14) */
        const double slope1 = z2; /* phi' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2); /* theta' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = w3 - c_theta * z2; /* psi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (I.2.14) 18:4 */
        const double slope4 = w2 * w3 * k1 * k4; /* w1' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -w1 * w3 * k2 * k5; /* w2' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = w1 * w2 * k3 * k6; /* w3' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
    }
    if (singular1) {
        return FREE_RIGID_BODY_SINGULAR_1;
    }
    return bad ? FREE_RIGID_BODY_NOT_FINITE : FREE_RIGID_BODY_OK;
}
