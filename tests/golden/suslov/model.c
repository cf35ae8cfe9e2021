/*
 * suslov.c: suslov, emitted by nhc 0.1.0 (nhc:5f7189a758d73cc8)
 * A rigid body with a fixed point that must not turn about one of its own axes.
 * Source: suslov.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * suslov.h says what each function does.
 */
#include "suslov.h"

#include <float.h>
#include <math.h>

const char *const suslov_coordinate_names[] = {
    "phi",
    "theta",
    "psi"
};
const char *const suslov_state_names[] = {
    "phi",
    "theta",
    "psi",
    "w1",
    "w2"
};
const char *const suslov_parameter_names[] = {
    "I11",
    "I22",
    "I33",
    "I13",
    "I23"
};
const double suslov_parameter_defaults[] = {
    1.0,
    1.6,
    2.0,
    0.3,
    -0.2
};

static int suslov_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? SUSLOV_OK : SUSLOV_NOT_FINITE;
}

int suslov_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = 1.0 / I11;
    const double k2 = 1.0 / I22;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return SUSLOV_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I11) > 0.0)) {
        return SUSLOV_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I22) > 0.0)) {
        return SUSLOV_SINGULAR_2;
    }
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double z1 = 1.0 / s_theta;
    const double z2 = (c_psi * w2 + s_psi * w1) * z1;
    const double c_theta = cos(theta);
    const double z3 = I13 * w1 + I23 * w2;
    /* (I.2.15) */
    dydt[0] = z2; /* phi' */
    dydt[1] = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2); /* theta' */
    dydt[2] = -c_theta * z2; /* psi' */
    /* (I.2.15) 20:4 */
    dydt[3] = -w2 * z3 * k1; /* w1' */
    dydt[4] = w1 * z3 * k2; /* w2' */
    return suslov_finish(5, dydt);
}

int suslov_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return SUSLOV_SINGULAR_1;
    }
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double z1 = 1.0 / s_theta;
    const double z2 = (c_psi * w2 + s_psi * w1) * z1;
    const double c_theta = cos(theta);
    /* (I.2.4) */
    qdot[0] = z2; /* phi' */
    qdot[1] = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2); /* theta' */
    qdot[2] = -c_theta * z2; /* psi' */
    return suslov_finish(3, qdot);
}

int suslov_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = 1.0 / I11;
    const double k2 = 1.0 / I22;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return SUSLOV_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I11) > 0.0)) {
        return SUSLOV_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I22) > 0.0)) {
        return SUSLOV_SINGULAR_2;
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
    const double z9 = c_theta * z8;
    const double z10 = s_psi * z9;
    const double z11 = I13 * w1 + I23 * w2;
    const double z12 = w1 * z11 * k2;
    const double z13 = c_psi * z9;
    const double z14 = w2 * z11 * k1;
    const double z15 = z1 * z7 - z2 * (w2 * z10 + c_psi * z12 - (w1 * z13 + s_psi * z14));
    const double z16 = w1 * (c_psi * z6 + s_theta * z10) - z3 * z14 - (w2 * (s_psi * z6 - s_theta * z13) + z4
        * z12);
    /* (I.2.15) */
    qddot[0] = -z15; /* phi'' */
    qddot[1] = z2 * z16 - z5 * z7; /* theta'' */
    qddot[2] = z8 * z5 + c_theta * z15; /* psi'' */
    return suslov_finish(3, qddot);
}

int suslov_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double phi = q[0]; /* precession [rad] */
    const double theta = q[1]; /* nutation [rad] */
    const double psi = q[2]; /* spin [rad] */
    const double phi_dot = qdot[0];
    const double theta_dot = qdot[1];

    /* state */
    const double s_theta = sin(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    y[0] = phi;
    y[1] = theta;
    y[2] = psi;
    y[3] = phi_dot * (s_theta * s_psi) + theta_dot * c_psi;
    y[4] = phi_dot * (s_theta * c_psi) - theta_dot * s_psi;
    return suslov_finish(5, y);
}

int suslov_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double theta = q[1]; /* nutation [rad] */
    const double phi_dot = qdot[0];
    const double psi_dot = qdot[2];

    /* state */
    const double c_theta = cos(theta);
    /* (I.1.1) 22:5 */
    r[0] = psi_dot + phi_dot * c_theta; /* no_spin = 0 */
    return suslov_finish(1, r);
}

int suslov_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = I11 - I22;
    const double k2 = 1.0 / I11;
    const double k3 = 1.0 / I22;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return SUSLOV_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I11) > 0.0)) {
        return SUSLOV_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I22) > 0.0)) {
        return SUSLOV_SINGULAR_2;
    }
    const double z1 = I13 * w1 + I23 * w2;
    /* (I.4.1) 22:5 */
    /* reaction of no_spin: Q_i gains lambda_1 a_1i */
    lambda[0] = -(w1 * w2 * k1 + (I13 * (w2 * z1 * k2) - I23 * (w1 * z1 * k3)));
    return suslov_finish(1, lambda);
}

double suslov_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double w1 = y[3];
    const double w2 = y[4];
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */

    /* state */
    return 0.5 * (I11 * (w1 * w1)) + 0.5 * (I22 * (w2 * w2));
}

int suslov_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = 1.0 / I11;
    const double k2 = 1.0 / I22;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return SUSLOV_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(I11) > 0.0)) {
        return SUSLOV_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I22) > 0.0)) {
        return SUSLOV_SINGULAR_2;
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
    const double z7 = I23 * w2;
    const double z8 = I13 * w1;
    const double z9 = z8 + z7;
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = -c_theta * (z1 * z2);
    J[2] = z5 - z4;
    J[3] = s_psi * z3;
    J[4] = c_psi * z3;
    J[5] = 0.0;
    J[6] = -c_theta * (z4 - (z5 - (s_theta * c_psi * w1 - s_theta * s_psi * w2) * z2));
    J[7] = -z1;
    J[8] = c_psi;
    J[9] = -s_psi;
    J[10] = 0.0;
    J[11] = z1 + c_theta * (z2 * (c_theta * z1));
    J[12] = s_psi * (w2 * z6) - c_psi * (w1 * z6);
    J[13] = -s_psi * z6;
    J[14] = -c_psi * z6;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = -k1 * (I13 * w2);
    J[19] = -k1 * (z7 + z9);
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = k2 * (z8 + z9);
    J[24] = k2 * (I23 * w1);
    return suslov_finish(25, J);
}

int suslov_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double w1 = y[3];
    const double w2 = y[4];
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return SUSLOV_SINGULAR_1;
    }
    /* 28:7 */
    out[0] = I13 * w1 + I23 * w2; /* M3 */
    return suslov_finish(1, out);
}

int suslov_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
    const double I11 = p[0]; /* [kg*m^2] */
    const double I22 = p[1]; /* [kg*m^2] */
    const double I13 = p[3]; /* [kg*m^2] */
    const double I23 = p[4]; /* [kg*m^2] */
    const double k1 = 1.0 / I11;
    const double k2 = 1.0 / I22;
    /* the mass matrix is singular */
    if (!(fabs(I11) > 0.0)) {
        return SUSLOV_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I22) > 0.0)) {
        return SUSLOV_SINGULAR_2;
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
        const double s_theta = sin(theta);
        /* the coframe is singular */
        singular1 |= !(fabs(s_theta) > 1e-12 * 4.0);
        const double c_psi = cos(psi);
        const double s_psi = sin(psi);
        const double z1 = 1.0 / s_theta;
        const double z2 = (c_psi * w2 + s_psi * w1) * z1;
        const double c_theta = cos(theta);
        const double z3 = I13 * w1 + I23 * w2;
        /* (I.2.15) */
        const double slope1 = z2; /* phi' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2); /* theta' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = -c_theta * z2; /* psi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (I.2.15) 20:4 */
        const double slope4 = -w2 * z3 * k1; /* w1' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = w1 * z3 * k2; /* w2' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    if (singular1) {
        return SUSLOV_SINGULAR_1;
    }
    return bad ? SUSLOV_NOT_FINITE : SUSLOV_OK;
}
