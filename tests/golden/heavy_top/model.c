/*
 * heavy_top.c: heavy_top, emitted by nhc 0.1.0 (nhc:54ba711c97c2c347)
 * The symmetric top with a fixed point (Lagrange's top).
 * Source: heavy_top.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * heavy_top.h says what each function does.
 */
#include "heavy_top.h"

#include <float.h>
#include <math.h>

const char *const heavy_top_coordinate_names[] = {
    "phi",
    "theta",
    "psi"
};
const char *const heavy_top_state_names[] = {
    "phi",
    "theta",
    "psi",
    "phi'",
    "theta'",
    "psi'"
};
const char *const heavy_top_parameter_names[] = {
    "I1",
    "I3",
    "mgl"
};
const double heavy_top_parameter_defaults[] = {
    1.0,
    1.5,
    2.0
};

static int heavy_top_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? HEAVY_TOP_OK : HEAVY_TOP_NOT_FINITE;
}

int heavy_top_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double phi_dot = y[3];
    const double theta_dot = y[4];
    const double psi_dot = y[5];
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* parameters only */
    const double k1 = 2.0 * I1 - 2.0 * I3;
    const double k2 = I1 - I3;
    const double k3 = 1.0 / I1;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I1 * z1 + I3 * (1.0 - z1);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z3 = I3 * c_theta;
    const double z4 = 1.0 / z2;
    const double z5 = z3 * z4;
    const double z6 = I3 - z3 * z5;
    /* the mass matrix is singular */
    if (!(fabs(z6) > 1e-14 * I3)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    const double z7 = phi_dot * c_theta;
    const double z8 = psi_dot * I3;
    const double z9 = theta_dot * s_theta * (z7 * k1 - z8);
    const double z10 = (s_theta * (I3 * (phi_dot * theta_dot)) + z9 * z5) / z6;
    /* (II.3) */
    dydt[0] = phi_dot; /* phi' */
    dydt[1] = theta_dot; /* theta' */
    dydt[2] = psi_dot; /* psi' */
    /* (II.3) 16:4 */
    dydt[3] = -(z9 * z4 + z5 * z10); /* phi'' */
    dydt[4] = s_theta * (mgl - phi_dot * (z8 - z7 * k2)) * k3; /* theta'' */
    dydt[5] = z10; /* psi'' */
    return heavy_top_finish(6, dydt);
}

int heavy_top_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double phi_dot = y[3];
    const double theta_dot = y[4];
    const double psi_dot = y[5];

    /* state */
    /* (I.2.4) */
    qdot[0] = phi_dot; /* phi' */
    qdot[1] = theta_dot; /* theta' */
    qdot[2] = psi_dot; /* psi' */
    return heavy_top_finish(3, qdot);
}

int heavy_top_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double phi_dot = y[3];
    const double theta_dot = y[4];
    const double psi_dot = y[5];
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* parameters only */
    const double k1 = 2.0 * I1 - 2.0 * I3;
    const double k2 = I1 - I3;
    const double k3 = 1.0 / I1;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I1 * z1 + I3 * (1.0 - z1);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z3 = I3 * c_theta;
    const double z4 = 1.0 / z2;
    const double z5 = z3 * z4;
    const double z6 = I3 - z3 * z5;
    /* the mass matrix is singular */
    if (!(fabs(z6) > 1e-14 * I3)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    const double z7 = phi_dot * c_theta;
    const double z8 = psi_dot * I3;
    const double z9 = theta_dot * s_theta * (z7 * k1 - z8);
    const double z10 = (s_theta * (I3 * (phi_dot * theta_dot)) + z9 * z5) / z6;
    /* (II.3) */
    qddot[0] = -(z9 * z4 + z5 * z10); /* phi'' */
    qddot[1] = s_theta * (mgl - phi_dot * (z8 - z7 * k2)) * k3; /* theta'' */
    qddot[2] = z10; /* psi'' */
    return heavy_top_finish(3, qddot);
}

int heavy_top_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
    y[0] = phi;
    y[1] = theta;
    y[2] = psi;
    y[3] = phi_dot;
    y[4] = theta_dot;
    y[5] = psi_dot;
    return heavy_top_finish(6, y);
}

int heavy_top_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return HEAVY_TOP_OK;
}

int heavy_top_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I1 * z1 + I3 * (1.0 - z1);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z3 = I3 * c_theta;
    /* the mass matrix is singular */
    if (!(fabs(I3 - z3 * (z3 / z2)) > 1e-14 * I3)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    (void)lambda;
    return HEAVY_TOP_OK;
}

double heavy_top_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double phi_dot = y[3];
    const double theta_dot = y[4];
    const double psi_dot = y[5];
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z1 = 0.5 * (I1 * (theta_dot * theta_dot + s_theta * s_theta * (phi_dot * phi_dot))) + 0.5 *
        (I3 * (omega3 * omega3));
    return z1 + mgl * c_theta;
}

int heavy_top_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double phi_dot = y[3];
    const double theta_dot = y[4];
    const double psi_dot = y[5];
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */

    /* parameters only */
    const double k1 = 2.0 * I1 - 2.0 * I3;
    const double k2 = I1 - I3;
    const double k3 = 1.0 / I1;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I1 * z1 + I3 * (1.0 - z1);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z3 = I3 * c_theta;
    const double z4 = 1.0 / z2;
    const double z5 = z3 * z4;
    const double z6 = I3 - z3 * z5;
    /* the mass matrix is singular */
    if (!(fabs(z6) > 1e-14 * I3)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    const double z7 = phi_dot * c_theta;
    const double z8 = psi_dot * I3;
    const double z9 = z7 * k1 - z8;
    const double z10 = theta_dot * s_theta;
    const double z11 = z10 * z9;
    const double z12 = 1.0 / z6;
    const double z13 = I3 * (phi_dot * theta_dot);
    const double z14 = z12 * (s_theta * z13 + z11 * z5);
    const double z15 = z11 * z4 + z5 * z14;
    const double z16 = z10 * k1;
    const double z17 = c_theta * (theta_dot * z9 - 2.0 * (s_theta * (k2 * z15))) - s_theta * (phi_dot * z16 +
        I3 * z14);
    const double z18 = z12 * (c_theta * z13 - s_theta * (I3 * z15) + z5 * z17);
    const double z19 = c_theta * z16;
    const double z20 = I3 * s_theta;
    const double z21 = z12 * (theta_dot * z20 + z5 * z19);
    const double z22 = s_theta * z9;
    const double z23 = z12 * (phi_dot * z20 + z5 * z22);
    const double z24 = I3 * z10;
    const double z25 = z12 * (z5 * z24);
    const double z26 = z8 - z7 * k2;
    const double z27 = phi_dot * s_theta;
    const double z28 = z27 * k2;
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    J[3] = 1.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = 1.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 0.0;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 1.0;
    J[18] = 0.0;
    J[19] = -(z4 * z17 + z5 * z18);
    J[20] = 0.0;
    J[21] = -(z4 * z19 + z5 * z21);
    J[22] = -(z4 * z22 + z5 * z23);
    J[23] = z4 * z24 + z5 * z25;
    J[24] = 0.0;
    J[25] = k3 * (c_theta * (mgl - phi_dot * z26) - s_theta * (phi_dot * z28));
    J[26] = 0.0;
    J[27] = -k3 * (s_theta * z26 - c_theta * z28);
    J[28] = 0.0;
    J[29] = -k3 * (I3 * z27);
    J[30] = 0.0;
    J[31] = z18;
    J[32] = 0.0;
    J[33] = z21;
    J[34] = z23;
    J[35] = -z25;
    return heavy_top_finish(36, J);
}

int heavy_top_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[1]; /* nutation [rad] */
    const double phi_dot = y[3];
    const double psi_dot = y[5];
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double z1 = I3 * (psi_dot + phi_dot * c_theta);
    /* 19:10 */
    out[0] = phi_dot * (I1 * (s_theta * s_theta)) + c_theta * z1; /* p_phi */
    /* 20:10 */
    out[1] = z1; /* p_psi */
    return heavy_top_finish(2, out);
}

int heavy_top_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double I1 = p[0]; /* across the axis, at the fixed point [kg*m^2] */
    const double I3 = p[1]; /* about the axis [kg*m^2] */
    const double mgl = p[2]; /* weight times the distance of the centre of mass [N*m] */
    const double k1 = 2.0 * I1 - 2.0 * I3;
    const double k2 = I1 - I3;
    const double k3 = 1.0 / I1;
    /* the mass matrix is singular */
    if (!(fabs(I1) > 0.0)) {
        return HEAVY_TOP_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta = y[count + i]; /* nutation [rad] */
        const double phi_dot = y[3 * count + i];
        const double theta_dot = y[4 * count + i];
        const double psi_dot = y[5 * count + i];
        const double s_theta = sin(theta);
        const double z1 = s_theta * s_theta;
        const double z2 = I1 * z1 + I3 * (1.0 - z1);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z2) > 0.0);
        const double c_theta = cos(theta);
        const double z3 = I3 * c_theta;
        const double z4 = 1.0 / z2;
        const double z5 = z3 * z4;
        const double z6 = I3 - z3 * z5;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z6) > 1e-14 * I3);
        const double z7 = phi_dot * c_theta;
        const double z8 = psi_dot * I3;
        const double z9 = theta_dot * s_theta * (z7 * k1 - z8);
        const double z10 = (s_theta * (I3 * (phi_dot * theta_dot)) + z9 * z5) / z6;
        /* (II.3) */
        const double slope1 = phi_dot; /* phi' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = theta_dot; /* theta' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = psi_dot; /* psi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (II.3) 16:4 */
        const double slope4 = -(z9 * z4 + z5 * z10); /* phi'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = s_theta * (mgl - phi_dot * (z8 - z7 * k2)) * k3; /* theta'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = z10; /* psi'' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
    }
    if (singular1) {
        return HEAVY_TOP_SINGULAR_2;
    }
    return bad ? HEAVY_TOP_NOT_FINITE : HEAVY_TOP_OK;
}
