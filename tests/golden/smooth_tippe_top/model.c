/*
 * smooth_tippe_top.c: smooth_tippe_top, emitted by nhc 0.1.0 (nhc:5cc01631879531e7)
 * The ball of routh_sphere on a plane without any friction.
 * Source: smooth_tippe_top.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * smooth_tippe_top.h says what each function does.
 */
#include "smooth_tippe_top.h"

#include <float.h>
#include <math.h>

const char *const smooth_tippe_top_coordinate_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const smooth_tippe_top_state_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "x'",
    "y'",
    "phi'",
    "theta'",
    "psi'"
};
const char *const smooth_tippe_top_parameter_names[] = {
    "m",
    "R",
    "e",
    "I1",
    "I3",
    "g"
};
const double smooth_tippe_top_parameter_defaults[] = {
    1.0,
    1.0,
    -0.2,
    0.38,
    0.42,
    9.81
};

static int smooth_tippe_top_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? SMOOTH_TIPPE_TOP_OK : SMOOTH_TIPPE_TOP_NOT_FINITE;
}

int smooth_tippe_top_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = m * (e * e);
    const double k3 = I1 + k2;
    const double k4 = I3 - k3;
    const double k5 = 2.0 * I3 - (2.0 * I1 + 2.0 * k2);
    const double k6 = g * k1;
    const double k7 = 1.0 / m;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = I3 - s_theta * s_theta * k4;
    const double c_phi = cos(phi);
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double z4 = z3 * k7;
    const double s_phi = sin(phi);
    const double z5 = s_phi * z2;
    const double z6 = z5 * k7;
    const double z7 = z1 - z3 * z4 - z5 * z6;
    /* the mass matrix is singular */
    if (!(fabs(z7) > 1e-14 * z1)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z8 = c_theta * (s_phi * k1);
    const double z9 = z8 * k7;
    const double z10 = c_theta * (c_phi * k1);
    const double z11 = z10 * k7;
    const double z12 = z3 * z9 - z5 * z11;
    const double z13 = 1.0 / z7;
    const double z14 = z12 * z13;
    const double z15 = k3 - z8 * z9 - z10 * z11 - z12 * z14;
    /* the mass matrix is singular */
    if (!(fabs(z15) > 1e-14 * k3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double z16 = I3 * c_theta;
    const double z17 = z16 * z13;
    const double z18 = z12 * z17;
    const double z19 = 1.0 / z15;
    const double z20 = z18 * z19;
    const double z21 = I3 - z16 * z17 - z18 * z20;
    /* the mass matrix is singular */
    if (!(fabs(z21) > 1e-14 * I3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double z22 = phi_dot * s_theta;
    const double z23 = s_theta * (theta_dot * theta_dot);
    const double z24 = k1 * (phi_dot * (s_phi * z22 - 2.0 * (c_theta * (theta_dot * c_phi))) + s_phi * z23);
    const double z25 = phi_dot * c_theta;
    const double z26 = psi_dot * I3;
    const double z27 = k1 * (phi_dot * (c_phi * z22 + 2.0 * (c_theta * (theta_dot * s_phi))) + c_phi * z23);
    const double z28 = theta_dot * s_theta * (z25 * k5 + z26) - z24 * z4 + z27 * z6;
    const double z29 = s_theta * (phi_dot * (z26 + z25 * k4) - k6) + z24 * z9 + z27 * z11 - z14 * z28;
    const double z30 = (s_theta * (I3 * (phi_dot * theta_dot)) - z17 * z28 + z20 * z29) / z21;
    const double z31 = z19 * z29 + z20 * z30;
    const double z32 = z13 * z28 - z14 * z31 - z17 * z30;
    /* (II.3) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    dydt[4] = psi_dot; /* psi' */
    /* (II.3) 24:4 */
    dydt[5] = z24 * k7 - z4 * z32 + z9 * z31; /* x'' */
    dydt[6] = -(z27 * k7 + z6 * z32 + z11 * z31); /* y'' */
    dydt[7] = z32; /* phi'' */
    dydt[8] = -z31; /* theta'' */
    dydt[9] = z30; /* psi'' */
    return smooth_tippe_top_finish(10, dydt);
}

int smooth_tippe_top_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];

    /* state */
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    qdot[4] = psi_dot; /* psi' */
    return smooth_tippe_top_finish(5, qdot);
}

int smooth_tippe_top_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = m * (e * e);
    const double k3 = I1 + k2;
    const double k4 = I3 - k3;
    const double k5 = 2.0 * I3 - (2.0 * I1 + 2.0 * k2);
    const double k6 = g * k1;
    const double k7 = 1.0 / m;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = I3 - s_theta * s_theta * k4;
    const double c_phi = cos(phi);
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double z4 = z3 * k7;
    const double s_phi = sin(phi);
    const double z5 = s_phi * z2;
    const double z6 = z5 * k7;
    const double z7 = z1 - z3 * z4 - z5 * z6;
    /* the mass matrix is singular */
    if (!(fabs(z7) > 1e-14 * z1)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z8 = c_theta * (s_phi * k1);
    const double z9 = z8 * k7;
    const double z10 = c_theta * (c_phi * k1);
    const double z11 = z10 * k7;
    const double z12 = z3 * z9 - z5 * z11;
    const double z13 = 1.0 / z7;
    const double z14 = z12 * z13;
    const double z15 = k3 - z8 * z9 - z10 * z11 - z12 * z14;
    /* the mass matrix is singular */
    if (!(fabs(z15) > 1e-14 * k3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double z16 = I3 * c_theta;
    const double z17 = z16 * z13;
    const double z18 = z12 * z17;
    const double z19 = 1.0 / z15;
    const double z20 = z18 * z19;
    const double z21 = I3 - z16 * z17 - z18 * z20;
    /* the mass matrix is singular */
    if (!(fabs(z21) > 1e-14 * I3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double z22 = phi_dot * s_theta;
    const double z23 = s_theta * (theta_dot * theta_dot);
    const double z24 = k1 * (phi_dot * (s_phi * z22 - 2.0 * (c_theta * (theta_dot * c_phi))) + s_phi * z23);
    const double z25 = phi_dot * c_theta;
    const double z26 = psi_dot * I3;
    const double z27 = k1 * (phi_dot * (c_phi * z22 + 2.0 * (c_theta * (theta_dot * s_phi))) + c_phi * z23);
    const double z28 = theta_dot * s_theta * (z25 * k5 + z26) - z24 * z4 + z27 * z6;
    const double z29 = s_theta * (phi_dot * (z26 + z25 * k4) - k6) + z24 * z9 + z27 * z11 - z14 * z28;
    const double z30 = (s_theta * (I3 * (phi_dot * theta_dot)) - z17 * z28 + z20 * z29) / z21;
    const double z31 = z19 * z29 + z20 * z30;
    const double z32 = z13 * z28 - z14 * z31 - z17 * z30;
    /* (II.3) */
    qddot[0] = z24 * k7 - z4 * z32 + z9 * z31; /* x'' */
    qddot[1] = -(z27 * k7 + z6 * z32 + z11 * z31); /* y'' */
    qddot[2] = z32; /* phi'' */
    qddot[3] = -z31; /* theta'' */
    qddot[4] = z30; /* psi'' */
    return smooth_tippe_top_finish(5, qddot);
}

int smooth_tippe_top_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* geometric centre [m] */
    const double y_2 = q[1]; /* geometric centre [m] */
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double psi = q[4]; /* spin [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double phi_dot = qdot[2];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = x_dot;
    y[6] = y_dot;
    y[7] = phi_dot;
    y[8] = theta_dot;
    y[9] = psi_dot;
    return smooth_tippe_top_finish(10, y);
}

int smooth_tippe_top_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = I1 + m * (e * e);
    const double k3 = I3 - k2;
    const double k4 = 1.0 / m;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = I3 - s_theta * s_theta * k3;
    const double c_phi = cos(phi);
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double s_phi = sin(phi);
    const double z4 = s_phi * z2;
    const double z5 = z1 - z3 * (z3 * k4) - z4 * (z4 * k4);
    /* the mass matrix is singular */
    if (!(fabs(z5) > 1e-14 * z1)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z6 = c_theta * (s_phi * k1);
    const double z7 = z6 * k4;
    const double z8 = c_theta * (c_phi * k1);
    const double z9 = z8 * k4;
    const double z10 = z3 * z7 - z4 * z9;
    const double z11 = 1.0 / z5;
    const double z12 = k2 - z6 * z7 - z8 * z9 - z10 * (z10 * z11);
    /* the mass matrix is singular */
    if (!(fabs(z12) > 1e-14 * k2)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double z13 = I3 * c_theta;
    const double z14 = z13 * z11;
    const double z15 = z10 * z14;
    /* the mass matrix is singular */
    if (!(fabs(I3 - z13 * z14 - z15 * (z15 / z12)) > 1e-14 * I3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    (void)lambda;
    return SMOOTH_TIPPE_TOP_OK;
}

double smooth_tippe_top_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * g;

    /* state */
    const double s_phi = sin(phi);
    const double c_theta = cos(theta);
    const double z1 = e * (theta_dot * c_theta);
    const double s_theta = sin(theta);
    const double z2 = e * s_theta;
    const double c_phi = cos(phi);
    const double X_dot = x_dot + (s_phi * z1 + z2 * (phi_dot * c_phi));
    const double Y_dot = y_dot - (c_phi * z1 - z2 * (phi_dot * s_phi));
    const double z3 = e * (theta_dot * s_theta);
    const double z4 = 0.5 * (m * (X_dot * X_dot + Y_dot * Y_dot + z3 * z3)) + 0.5 * (I1 * (theta_dot *
        theta_dot + s_theta * s_theta * (phi_dot * phi_dot)));
    const double omega3 = psi_dot + phi_dot * c_theta;
    return z4 + 0.5 * (I3 * (omega3 * omega3)) + e * c_theta * k1;
}

int smooth_tippe_top_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = m * (e * e);
    const double k3 = I1 + k2;
    const double k4 = I3 - k3;
    const double k5 = 2.0 * I3 - (2.0 * I1 + 2.0 * k2);
    const double k6 = g * k1;
    const double k7 = 1.0 / m;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = I3 - s_theta * s_theta * k4;
    const double c_phi = cos(phi);
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double z4 = z3 * k7;
    const double s_phi = sin(phi);
    const double z5 = s_phi * z2;
    const double z6 = z5 * k7;
    const double z7 = z1 - z3 * z4 - z5 * z6;
    /* the mass matrix is singular */
    if (!(fabs(z7) > 1e-14 * z1)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z8 = s_phi * k1;
    const double z9 = c_theta * z8;
    const double z10 = z9 * k7;
    const double z11 = c_phi * k1;
    const double z12 = c_theta * z11;
    const double z13 = z12 * k7;
    const double z14 = z3 * z10 - z5 * z13;
    const double z15 = 1.0 / z7;
    const double z16 = z14 * z15;
    const double z17 = k3 - z9 * z10 - z12 * z13 - z14 * z16;
    /* the mass matrix is singular */
    if (!(fabs(z17) > 1e-14 * k3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double z18 = I3 * c_theta;
    const double z19 = z18 * z15;
    const double z20 = z14 * z19;
    const double z21 = 1.0 / z17;
    const double z22 = z20 * z21;
    const double z23 = I3 - z18 * z19 - z20 * z22;
    /* the mass matrix is singular */
    if (!(fabs(z23) > 1e-14 * I3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    const double z24 = phi_dot * k1;
    const double z25 = c_theta * z24;
    const double z26 = theta_dot * s_theta;
    const double z27 = phi_dot * c_theta;
    const double z28 = psi_dot * I3;
    const double z29 = z27 * k5 + z28;
    const double z30 = phi_dot * s_theta;
    const double z31 = theta_dot * c_phi;
    const double z32 = s_phi * z30 - 2.0 * (c_theta * z31);
    const double z33 = theta_dot * theta_dot;
    const double z34 = s_theta * z33;
    const double z35 = k1 * (phi_dot * z32 + s_phi * z34);
    const double z36 = theta_dot * s_phi;
    const double z37 = c_phi * z30 + 2.0 * (c_theta * z36);
    const double z38 = k1 * (phi_dot * z37 + c_phi * z34);
    const double z39 = z26 * z29 - z35 * z4 + z38 * z6;
    const double z40 = z28 + z27 * k4;
    const double z41 = phi_dot * z40 - k6;
    const double z42 = s_theta * z41 + z35 * z10 + z38 * z13 - z16 * z39;
    const double z43 = 1.0 / z23;
    const double z44 = I3 * (phi_dot * theta_dot);
    const double z45 = z43 * (s_theta * z44 - z19 * z39 + z22 * z42);
    const double z46 = z21 * z42 + z22 * z45;
    const double z47 = z15 * z39 - z16 * z46 - z19 * z45;
    const double z48 = 2.0 * (theta_dot * z25) + z2 * z47;
    const double z49 = k1 * z34 + z30 * z24 + k1 * (c_theta * z46);
    const double z50 = s_phi * z48 + c_phi * z49;
    const double z51 = z35 * k7 - z4 * z47 + z10 * z46;
    const double z52 = z38 * k7 + z6 * z47 + z13 * z46;
    const double z53 = s_phi * z49 - c_phi * z48;
    const double z54 = s_phi * (z2 * z51) + c_phi * (z2 * z52) - z4 * z50 - z6 * z53;
    const double z55 = s_phi * (k1 * (c_theta * z52)) - c_phi * (k1 * (c_theta * z51)) - z10 * z50 + z13 *
        z53;
    const double z56 = z55 + z16 * z54;
    const double z57 = z43 * (z19 * z54 + z22 * z56);
    const double z58 = z21 * z56 + z22 * z57;
    const double z59 = z15 * z54 + z16 * z58 + z19 * z57;
    const double z60 = s_phi * z24;
    const double z61 = s_theta * (2.0 * (z31 * z24) - z8 * z46) + c_theta * (phi_dot * z60 + (z33 * z8 - k1 *
        (c_phi * z47)));
    const double z62 = z26 * k5;
    const double z63 = c_theta * (theta_dot * z29 + (k1 * (s_phi * z52 - c_phi * z51) + 2.0 * (s_theta * (k4
        * z47))));
    const double z64 = c_phi * z24;
    const double z65 = s_theta * (2.0 * (z36 * z24) + z11 * z46) - c_theta * (phi_dot * z64 + (z33 * z11 + k1
        * (s_phi * z47)));
    const double z66 = s_theta * (phi_dot * z62 - I3 * z45) - z63 + z4 * z61 + z6 * z65;
    const double z67 = z30 * k4;
    const double z68 = c_theta * z41 - s_theta * (phi_dot * z67 + (z11 * z52 + z8 * z51)) + z10 * z61 - z13 *
        z65;
    const double z69 = z68 + z16 * z66;
    const double z70 = z43 * (c_theta * z44 + s_theta * (I3 * z47) + z19 * z66 + z22 * z69);
    const double z71 = z21 * z69 + z22 * z70;
    const double z72 = z15 * z66 + z16 * z71 + z19 * z70;
    const double z73 = k1 * z32 + s_theta * z60;
    const double z74 = k1 * z37 + s_theta * z64;
    const double z75 = c_theta * z62 - z4 * z73 + z6 * z74;
    const double z76 = s_theta * z40 + c_theta * z67 + z10 * z73 + z13 * z74 - z16 * z75;
    const double z77 = I3 * s_theta;
    const double z78 = z43 * (theta_dot * z77 - z19 * z75 + z22 * z76);
    const double z79 = z21 * z76 + z22 * z78;
    const double z80 = z15 * z75 - z16 * z79 - z19 * z78;
    const double z81 = 2.0 * (c_phi * z25) - 2.0 * (theta_dot * (s_theta * z8));
    const double z82 = 2.0 * (s_phi * z25) + 2.0 * (theta_dot * (s_theta * z11));
    const double z83 = s_theta * z29 + z4 * z81 + z6 * z82;
    const double z84 = z10 * z81 - z13 * z82 + z16 * z83;
    const double z85 = z43 * (phi_dot * z77 - z19 * z83 - z22 * z84);
    const double z86 = z21 * z84 - z22 * z85;
    const double z87 = z15 * z83 + z16 * z86 - z19 * z85;
    const double z88 = I3 * z26;
    const double z89 = I3 * z30 - z16 * z88;
    const double z90 = z43 * (z19 * z88 - z22 * z89);
    const double z91 = z21 * z89 - z22 * z90;
    const double z92 = z15 * z88 - z16 * z91 + z19 * z90;
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = 1.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 0.0;
    J[15] = 0.0;
    J[16] = 1.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = 0.0;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = 1.0;
    J[28] = 0.0;
    J[29] = 0.0;
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = 0.0;
    J[35] = 0.0;
    J[36] = 0.0;
    J[37] = 0.0;
    J[38] = 1.0;
    J[39] = 0.0;
    J[40] = 0.0;
    J[41] = 0.0;
    J[42] = 0.0;
    J[43] = 0.0;
    J[44] = 0.0;
    J[45] = 0.0;
    J[46] = 0.0;
    J[47] = 0.0;
    J[48] = 0.0;
    J[49] = 1.0;
    J[50] = 0.0;
    J[51] = 0.0;
    J[52] = k7 * z50 - z4 * z59 - z10 * z58;
    J[53] = k7 * z61 + z4 * z72 + z10 * z71;
    J[54] = 0.0;
    J[55] = 0.0;
    J[56] = 0.0;
    J[57] = k7 * z73 - z4 * z80 + z10 * z79;
    J[58] = -(k7 * z81 + z4 * z87 + z10 * z86);
    J[59] = z10 * z91 - z4 * z92;
    J[60] = 0.0;
    J[61] = 0.0;
    J[62] = k7 * z53 - z6 * z59 + z13 * z58;
    J[63] = k7 * z65 + z6 * z72 - z13 * z71;
    J[64] = 0.0;
    J[65] = 0.0;
    J[66] = 0.0;
    J[67] = -(k7 * z74 + z6 * z80 + z13 * z79);
    J[68] = z13 * z86 - (k7 * z82 + z6 * z87);
    J[69] = -(z6 * z92 + z13 * z91);
    J[70] = 0.0;
    J[71] = 0.0;
    J[72] = z59;
    J[73] = -z72;
    J[74] = 0.0;
    J[75] = 0.0;
    J[76] = 0.0;
    J[77] = z80;
    J[78] = z87;
    J[79] = z92;
    J[80] = 0.0;
    J[81] = 0.0;
    J[82] = z58;
    J[83] = -z71;
    J[84] = 0.0;
    J[85] = 0.0;
    J[86] = 0.0;
    J[87] = -z79;
    J[88] = z86;
    J[89] = -z91;
    J[90] = 0.0;
    J[91] = 0.0;
    J[92] = -z57;
    J[93] = z70;
    J[94] = 0.0;
    J[95] = 0.0;
    J[96] = 0.0;
    J[97] = z78;
    J[98] = z85;
    J[99] = -z90;
    return smooth_tippe_top_finish(100, J);
}

int smooth_tippe_top_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double s_phi = sin(phi);
    const double z1 = e * (theta_dot * c_theta);
    const double z2 = e * s_theta;
    const double c_phi = cos(phi);
    /* 27:12 */
    out[0] = R * (phi_dot * (I1 * (s_theta * s_theta))) + I3 * omega3 * (e + R * c_theta); /* jellett */
    /* 28:9 */
    out[1] = omega3; /* spin */
    /* 29:8 */
    out[2] = m * (x_dot + (s_phi * z1 + z2 * (phi_dot * c_phi))); /* p_x */
    /* 30:8 */
    out[3] = m * (y_dot - (c_phi * z1 - z2 * (phi_dot * s_phi))); /* p_y */
    return smooth_tippe_top_finish(4, out);
}

int smooth_tippe_top_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * e;
    const double k2 = m * (e * e);
    const double k3 = I1 + k2;
    const double k4 = I3 - k3;
    const double k5 = 2.0 * I3 - (2.0 * I1 + 2.0 * k2);
    const double k6 = g * k1;
    const double k7 = 1.0 / m;
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double phi = y[2 * count + i]; /* precession [rad] */
        const double theta = y[3 * count + i]; /* nutation [rad] */
        const double x_dot = y[5 * count + i];
        const double y_dot = y[6 * count + i];
        const double phi_dot = y[7 * count + i];
        const double theta_dot = y[8 * count + i];
        const double psi_dot = y[9 * count + i];
        const double s_theta = sin(theta);
        const double z1 = I3 - s_theta * s_theta * k4;
        const double c_phi = cos(phi);
        const double z2 = s_theta * k1;
        const double z3 = c_phi * z2;
        const double z4 = z3 * k7;
        const double s_phi = sin(phi);
        const double z5 = s_phi * z2;
        const double z6 = z5 * k7;
        const double z7 = z1 - z3 * z4 - z5 * z6;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z7) > 1e-14 * z1);
        const double c_theta = cos(theta);
        const double z8 = c_theta * (s_phi * k1);
        const double z9 = z8 * k7;
        const double z10 = c_theta * (c_phi * k1);
        const double z11 = z10 * k7;
        const double z12 = z3 * z9 - z5 * z11;
        const double z13 = 1.0 / z7;
        const double z14 = z12 * z13;
        const double z15 = k3 - z8 * z9 - z10 * z11 - z12 * z14;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z15) > 1e-14 * k3);
        const double z16 = I3 * c_theta;
        const double z17 = z16 * z13;
        const double z18 = z12 * z17;
        const double z19 = 1.0 / z15;
        const double z20 = z18 * z19;
        const double z21 = I3 - z16 * z17 - z18 * z20;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z21) > 1e-14 * I3);
        const double z22 = phi_dot * s_theta;
        const double z23 = s_theta * (theta_dot * theta_dot);
        const double z24 = k1 * (phi_dot * (s_phi * z22 - 2.0 * (c_theta * (theta_dot * c_phi))) + s_phi *
            z23);
        const double z25 = phi_dot * c_theta;
        const double z26 = psi_dot * I3;
        const double z27 = k1 * (phi_dot * (c_phi * z22 + 2.0 * (c_theta * (theta_dot * s_phi))) + c_phi *
            z23);
        const double z28 = theta_dot * s_theta * (z25 * k5 + z26) - z24 * z4 + z27 * z6;
        const double z29 = s_theta * (phi_dot * (z26 + z25 * k4) - k6) + z24 * z9 + z27 * z11 - z14 * z28;
        const double z30 = (s_theta * (I3 * (phi_dot * theta_dot)) - z17 * z28 + z20 * z29) / z21;
        const double z31 = z19 * z29 + z20 * z30;
        const double z32 = z13 * z28 - z14 * z31 - z17 * z30;
        /* (II.3) */
        const double slope1 = x_dot; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = y_dot; /* y' */
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
        /* (II.3) 24:4 */
        const double slope6 = z24 * k7 - z4 * z32 + z9 * z31; /* x'' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = -(z27 * k7 + z6 * z32 + z11 * z31); /* y'' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = z32; /* phi'' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
        const double slope9 = -z31; /* theta'' */
        dydt[8 * count + i] = slope9;
        bad |= !(fabs(slope9) <= DBL_MAX);
        const double slope10 = z30; /* psi'' */
        dydt[9 * count + i] = slope10;
        bad |= !(fabs(slope10) <= DBL_MAX);
    }
    if (singular1) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    return bad ? SMOOTH_TIPPE_TOP_NOT_FINITE : SMOOTH_TIPPE_TOP_OK;
}
