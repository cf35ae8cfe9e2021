/*
 * routh_sphere.c: routh_sphere, emitted by nhc 0.1.0 (nhc:ad17aa3b4868fad1)
 * A ball with its centre of mass off its centre, dynamically symmetric, rolls on a horizontal plane.
 * Source: routh_sphere.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * routh_sphere.h says what each function does.
 */
#include "routh_sphere.h"

#include <float.h>
#include <math.h>

const char *const routh_sphere_coordinate_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const routh_sphere_state_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "phi'",
    "theta'",
    "psi'"
};
const char *const routh_sphere_parameter_names[] = {
    "m",
    "R",
    "e",
    "I1",
    "I3",
    "g"
};
const double routh_sphere_parameter_defaults[] = {
    1.0,
    1.0,
    -0.2,
    0.38,
    0.42,
    9.81
};

static int routh_sphere_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? ROUTH_SPHERE_OK : ROUTH_SPHERE_NOT_FINITE;
}

int routh_sphere_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = R * R;
    const double k2 = m * k1;
    const double k3 = e * e;
    const double k4 = m * k3;
    const double k5 = I3 - (I1 + k4);
    const double k6 = m * R;
    const double k7 = e * k6;
    const double k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4);
    const double k9 = m * e;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k3 + R * z3);
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double z5 = I3 + z1 * k2;
    const double z6 = I3 * c_theta - z1 * k7;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    /* the mass matrix is singular */
    if (!(fabs(z9) > 1e-14 * z5)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double z10 = theta_dot * s_theta;
    const double z11 = z10 * (phi_dot * (k7 - c_theta * k8) - psi_dot * (I3 + c_theta * k7));
    const double z12 = (z10 * (phi_dot * (I3 + k6 * z3) - c_theta * (k1 * (psi_dot * m))) + z11 * z8) / z9;
    const double z13 = phi_dot * (phi_dot * (k7 - c_theta * k5) - psi_dot * (I3 + (R + Z) * k6)) + k9 * (g +
        R * (theta_dot * theta_dot));
    /* (III.3) */
    dydt[0] = R * (theta_dot * s_phi - psi_dot * (s_theta * c_phi)); /* x' */
    dydt[1] = -R * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    dydt[4] = psi_dot; /* psi' */
    /* (III.3) 26:4 */
    dydt[5] = -(z11 * z7 + z8 * z12); /* phi'' */
    dydt[6] = s_theta * z13 / z4; /* theta'' */
    dydt[7] = z12; /* psi'' */
    return routh_sphere_finish(8, dydt);
}

int routh_sphere_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double s_phi = sin(phi);
    const double s_theta = sin(theta);
    const double c_phi = cos(phi);
    /* (I.2.4) */
    qdot[0] = R * (theta_dot * s_phi - psi_dot * (s_theta * c_phi)); /* x' */
    qdot[1] = -R * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    qdot[4] = psi_dot; /* psi' */
    return routh_sphere_finish(5, qdot);
}

int routh_sphere_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = R * R;
    const double k2 = m * k1;
    const double k3 = e * e;
    const double k4 = m * k3;
    const double k5 = I3 - (I1 + k4);
    const double k6 = m * R;
    const double k7 = e * k6;
    const double k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4);
    const double k9 = m * e;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k3 + R * z3);
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double z5 = I3 + z1 * k2;
    const double z6 = I3 * c_theta - z1 * k7;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    /* the mass matrix is singular */
    if (!(fabs(z9) > 1e-14 * z5)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z10 = phi_dot * c_phi;
    const double s_phi = sin(phi);
    const double z11 = phi_dot * (phi_dot * (k7 - c_theta * k5) - psi_dot * (I3 + (R + Z) * k6)) + k9 * (g +
        R * (theta_dot * theta_dot));
    const double z12 = s_theta * z11 / z4;
    const double z13 = theta_dot * c_theta;
    const double z14 = phi_dot * s_phi;
    const double z15 = theta_dot * s_theta;
    const double z16 = z15 * (phi_dot * (k7 - c_theta * k8) - psi_dot * (I3 + c_theta * k7));
    const double z17 = (z15 * (phi_dot * (I3 + k6 * z3) - c_theta * (k1 * (psi_dot * m))) + z16 * z8) / z9;
    const double z18 = theta_dot * z10 + s_phi * z12 - (psi_dot * (c_phi * z13 - s_theta * z14) + s_theta *
        c_phi * z17);
    const double z19 = theta_dot * z14 - c_phi * z12 - (psi_dot * (s_phi * z13 + s_theta * z10) + s_theta *
        s_phi * z17);
    /* (III.3) */
    qddot[0] = R * z18; /* x'' */
    qddot[1] = R * z19; /* y'' */
    qddot[2] = -(z16 * z7 + z8 * z17); /* phi'' */
    qddot[3] = z12; /* theta'' */
    qddot[4] = z17; /* psi'' */
    return routh_sphere_finish(5, qddot);
}

int routh_sphere_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* geometric centre [m] */
    const double y_2 = q[1]; /* geometric centre [m] */
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double psi = q[4]; /* spin [rad] */
    const double phi_dot = qdot[2];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = phi_dot;
    y[6] = theta_dot;
    y[7] = psi_dot;
    return routh_sphere_finish(8, y);
}

int routh_sphere_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double s_phi = sin(phi);
    const double s_theta = sin(theta);
    const double c_phi = cos(phi);
    /* (I.1.1) 29:5 */
    r[0] = x_dot - R * (theta_dot * s_phi - psi_dot * (s_theta * c_phi)); /* roll_x = 0 */
    /* (I.1.1) 30:5 */
    r[1] = y_dot + R * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* roll_y = 0 */
    return routh_sphere_finish(2, r);
}

int routh_sphere_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = R * R;
    const double k2 = m * k1;
    const double k3 = e * e;
    const double k4 = m * k3;
    const double k5 = I3 - (I1 + k4);
    const double k6 = m * R;
    const double k7 = e * k6;
    const double k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4);
    const double k9 = m * e;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k3 + R * z3);
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double z5 = I3 + z1 * k2;
    const double z6 = I3 * c_theta - z1 * k7;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    /* the mass matrix is singular */
    if (!(fabs(z9) > 1e-14 * z5)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double z10 = psi_dot * R;
    const double z11 = phi_dot * e - z10;
    const double z12 = s_theta * (theta_dot * e);
    const double z13 = phi_dot * (theta_dot * c_phi * z3 - s_theta * s_phi * z11) - theta_dot * (s_phi * z12
        + c_theta * (c_phi * z10));
    const double z14 = s_theta * k6;
    const double z15 = theta_dot * s_theta;
    const double z16 = z15 * (phi_dot * (k7 - c_theta * k8) - psi_dot * (I3 + c_theta * k7));
    const double z17 = (z15 * (phi_dot * (I3 + k6 * z3) - c_theta * (k1 * (psi_dot * m))) + z16 * z8) / z9;
    const double z18 = s_theta * k9;
    const double z19 = z16 * z7 + z8 * z17;
    const double z20 = R + Z;
    const double z21 = phi_dot * (phi_dot * (k7 - c_theta * k5) - psi_dot * (I3 + z20 * k6)) + k9 * (g + R *
        (theta_dot * theta_dot));
    const double z22 = s_theta * z21 / z4;
    const double z23 = m * z13 - (c_phi * z14 * z17 + (c_phi * z18 * z19 - z20 * (m * s_phi) * z22));
    const double z24 = phi_dot * (theta_dot * s_phi * z3 + s_theta * c_phi * z11) + theta_dot * (c_phi * z12
        - c_theta * (s_phi * z10));
    const double z25 = m * z24 - (s_phi * z14 * z17 + (s_phi * z18 * z19 + z20 * (m * c_phi) * z22));
    /* (I.4.1) 29:5 */
    lambda[0] = z23; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 30:5 */
    lambda[1] = z25; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    return routh_sphere_finish(2, lambda);
}

double routh_sphere_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = R * R;
    const double k2 = 0.5 * e;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = theta_dot * theta_dot;
    const double c_theta = cos(theta);
    const double z3 = phi_dot * z1 * (0.5 * (phi_dot * e) - psi_dot * R) + (z2 * (k2 + R * c_theta) + g *
        c_theta);
    const double z4 = psi_dot * psi_dot;
    const double z5 = phi_dot * (c_theta * (psi_dot * I3) + phi_dot * (0.5 * (I1 * z1) + I3 * (0.5 - 0.5 *
        z1)));
    const double z6 = m * (e * z3 + k1 * (0.5 * z2 + 0.5 * (z1 * z4))) + (z5 + (0.5 * (I1 * z2) + 0.5 * (I3 *
        z4)));
    return z6;
}

int routh_sphere_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = R * R;
    const double k2 = m * k1;
    const double k3 = e * e;
    const double k4 = m * k3;
    const double k5 = I3 - (I1 + k4);
    const double k6 = m * R;
    const double k7 = e * k6;
    const double k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4);
    const double k9 = m * e;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double z2 = I3 - z1 * k5;
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double Z = e * c_theta;
    const double z3 = R + 2.0 * Z;
    const double z4 = I1 + m * (k3 + R * z3);
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double z5 = I3 + z1 * k2;
    const double z6 = I3 * c_theta - z1 * k7;
    const double z7 = 1.0 / z2;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    /* the mass matrix is singular */
    if (!(fabs(z9) > 1e-14 * z5)) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double z10 = psi_dot * R;
    const double z11 = s_theta * z10;
    const double c_phi = cos(phi);
    const double z12 = theta_dot * R;
    const double z13 = theta_dot * s_theta;
    const double z14 = phi_dot * z13;
    const double z15 = 1.0 / z9;
    const double z16 = I3 + k6 * z3;
    const double z17 = k1 * (psi_dot * m);
    const double z18 = phi_dot * z16 - c_theta * z17;
    const double z19 = k7 - c_theta * k8;
    const double z20 = I3 + c_theta * k7;
    const double z21 = phi_dot * z19 - psi_dot * z20;
    const double z22 = z13 * z21;
    const double z23 = z15 * (z13 * z18 + z22 * z8);
    const double z24 = z22 * z7 + z8 * z23;
    const double z25 = s_theta * (k7 * (psi_dot * z13) + z14 * k8 - I3 * z23) + c_theta * (theta_dot * z21 -
        2.0 * (s_theta * (k7 * z23 - k5 * z24)));
    const double z26 = s_theta * (2.0 * (e * (z14 * k6)) - (z13 * z17 - I3 * z24)) - c_theta * (theta_dot *
        z18 - 2.0 * (s_theta * (k2 * z23 + k7 * z24)));
    const double z27 = z15 * (z26 - z8 * z25);
    const double z28 = z13 * z19;
    const double z29 = z15 * (z13 * z16 + z8 * z28);
    const double z30 = s_theta * z21;
    const double z31 = z15 * (s_theta * z18 + z8 * z30);
    const double z32 = z13 * z20;
    const double z33 = z15 * (m * (k1 * (c_theta * z13)) + z8 * z32);
    const double z34 = 1.0 / z4;
    const double z35 = k7 - c_theta * k5;
    const double z36 = I3 + (R + Z) * k6;
    const double z37 = phi_dot * z35 - psi_dot * z36;
    const double z38 = phi_dot * z37 + k9 * (g + R * (theta_dot * theta_dot));
    const double z39 = phi_dot * s_theta;
    const double z40 = k5 * (phi_dot * z39) + e * (k6 * (psi_dot * z39) + 2.0 * (R * (m * (s_theta * z38 *
        z34))));
    /* (III.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = s_phi * z11 + c_phi * z12;
    J[3] = -c_theta * (c_phi * z10);
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = R * s_phi;
    J[7] = -R * (s_theta * c_phi);
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = s_phi * z12 - c_phi * z11;
    J[11] = -c_theta * (s_phi * z10);
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = -R * c_phi;
    J[15] = -R * (s_theta * s_phi);
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = 1.0;
    J[22] = 0.0;
    J[23] = 0.0;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = 0.0;
    J[28] = 0.0;
    J[29] = 0.0;
    J[30] = 1.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = 0.0;
    J[35] = 0.0;
    J[36] = 0.0;
    J[37] = 0.0;
    J[38] = 0.0;
    J[39] = 1.0;
    J[40] = 0.0;
    J[41] = 0.0;
    J[42] = 0.0;
    J[43] = z8 * z27 - z7 * z25;
    J[44] = 0.0;
    J[45] = -(z7 * z28 + z8 * z29);
    J[46] = -(z7 * z30 + z8 * z31);
    J[47] = z7 * z32 + z8 * z33;
    J[48] = 0.0;
    J[49] = 0.0;
    J[50] = 0.0;
    J[51] = z34 * (c_theta * z38 + s_theta * z40);
    J[52] = 0.0;
    J[53] = z34 * (s_theta * z37 + z39 * z35);
    J[54] = 2.0 * (z34 * (theta_dot * (R * (s_theta * k9))));
    J[55] = -z34 * (z39 * z36);
    J[56] = 0.0;
    J[57] = 0.0;
    J[58] = 0.0;
    J[59] = -z27;
    J[60] = 0.0;
    J[61] = z29;
    J[62] = z31;
    J[63] = -z33;
    return routh_sphere_finish(64, J);
}

int routh_sphere_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* parameters only */
    const double k1 = I1 * I3;
    const double k2 = I1 * (m * (R * R));
    const double k3 = m * I3;

    /* state */
    const double s_theta = sin(theta);
    const double z1 = s_theta * s_theta;
    const double c_theta = cos(theta);
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z2 = e + R * c_theta;
    /* 33:12 */
    out[0] = R * (phi_dot * (I1 * z1)) + I3 * omega3 * z2; /* jellett */
    /* 34:10 */
    out[1] = omega3 * sqrt(k1 + z1 * k2 + k3 * (z2 * z2)); /* routh */
    return routh_sphere_finish(2, out);
}

int routh_sphere_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */
    const double k1 = R * R;
    const double k2 = m * k1;
    const double k3 = e * e;
    const double k4 = m * k3;
    const double k5 = I3 - (I1 + k4);
    const double k6 = m * R;
    const double k7 = e * k6;
    const double k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4);
    const double k9 = m * e;
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double phi = y[2 * count + i]; /* precession [rad] */
        const double theta = y[3 * count + i]; /* nutation [rad] */
        const double phi_dot = y[5 * count + i];
        const double theta_dot = y[6 * count + i];
        const double psi_dot = y[7 * count + i];
        const double s_theta = sin(theta);
        const double z1 = s_theta * s_theta;
        const double z2 = I3 - z1 * k5;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z2) > 0.0);
        const double c_theta = cos(theta);
        const double Z = e * c_theta;
        const double z3 = R + 2.0 * Z;
        const double z4 = I1 + m * (k3 + R * z3);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z4) > 0.0);
        const double z5 = I3 + z1 * k2;
        const double z6 = I3 * c_theta - z1 * k7;
        const double z7 = 1.0 / z2;
        const double z8 = z6 * z7;
        const double z9 = z5 - z6 * z8;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z9) > 1e-14 * z5);
        const double s_phi = sin(phi);
        const double c_phi = cos(phi);
        const double z10 = theta_dot * s_theta;
        const double z11 = z10 * (phi_dot * (k7 - c_theta * k8) - psi_dot * (I3 + c_theta * k7));
        const double z12 = (z10 * (phi_dot * (I3 + k6 * z3) - c_theta * (k1 * (psi_dot * m))) + z11 * z8) /
            z9;
        const double z13 = phi_dot * (phi_dot * (k7 - c_theta * k5) - psi_dot * (I3 + (R + Z) * k6)) + k9 *
            (g + R * (theta_dot * theta_dot));
        /* (III.3) */
        const double slope1 = R * (theta_dot * s_phi - psi_dot * (s_theta * c_phi)); /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = -R * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = phi_dot; /* phi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = theta_dot; /* theta' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = psi_dot; /* psi' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        /* (III.3) 26:4 */
        const double slope6 = -(z11 * z7 + z8 * z12); /* phi'' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = s_theta * z13 / z4; /* theta'' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = z12; /* psi'' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
    }
    if (singular1) {
        return ROUTH_SPHERE_SINGULAR_2;
    }
    return bad ? ROUTH_SPHERE_NOT_FINITE : ROUTH_SPHERE_OK;
}
