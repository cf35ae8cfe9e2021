/*
 * roller_racer.c: roller_racer, emitted by nhc 0.1.0 (nhc:aead8343f66d2aee)
 * Two wheeled bodies with a hinge; it is driven by moving the hinge to and fro.
 * Source: roller_racer.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, theta': the dependent velocities that nhc would choose (x', y') are
 *     singular somewhere
 * roller_racer.h says what each function does.
 */
#include "roller_racer.h"

#include <float.h>
#include <math.h>

const char *const roller_racer_coordinate_names[] = {
    "x",
    "y",
    "theta",
    "phi"
};
const char *const roller_racer_state_names[] = {
    "x",
    "y",
    "theta",
    "phi",
    "v",
    "theta'"
};
const char *const roller_racer_parameter_names[] = {
    "m",
    "I1",
    "I2",
    "d1",
    "d2"
};
const double roller_racer_parameter_defaults[] = {
    1.0,
    0.2,
    0.05,
    0.6,
    0.25
};

static int roller_racer_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? ROLLER_RACER_OK : ROLLER_RACER_NOT_FINITE;
}

int roller_racer_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */
    const double v = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* parameters only */
    const double k1 = 1.0 / d2;

    /* state */
    /* the coframe is singular */
    if (!(fabs(d2) > 0.0)) {
        return ROLLER_RACER_SINGULAR_1;
    }
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double z1 = theta + phi;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double z2 = (s_theta * c1 - c_theta * s1) * k1;
    const double z3 = c_theta * (m * c_theta) + s_theta * (m * s_theta) + z2 * (I2 * z2);
    /* the mass matrix is singular */
    if (!(fabs(z3) > 0.0)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z4 = d2 + d1 * c_phi;
    const double z5 = 1.0 - z4 * k1;
    const double z6 = I2 * z5;
    const double z7 = I1 + z5 * z6;
    const double z8 = z2 * z6;
    const double z9 = 1.0 / z3;
    const double z10 = z8 * z9;
    const double z11 = z7 - z8 * z10;
    /* the mass matrix is singular */
    if (!(fabs(z11) > 1e-14 * z7)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double z12 = c_theta * v;
    const double z13 = s_theta * v;
    const double z14 = k1 * (theta_dot * z4 + (c1 * z13 - s1 * z12));
    const double s_phi = sin(phi);
    const double z15 = theta_dot - z14;
    const double z16 = v * (theta_dot * c_theta);
    const double z17 = v * (theta_dot * s_theta);
    const double z18 = theta_dot * (d1 * (z14 * s_phi)) - (z13 * (s1 * z15) - c1 * z16 + (z12 * (c1 * z15) -
        s1 * z17));
    const double z19 = I2 * (k1 * z18);
    const double z20 = z2 * z19 - (c_theta * (m * z17) - s_theta * (m * z16));
    const double z21 = (z5 * z19 - z20 * z10) / z11;
    /* (I.2.15) */
    dydt[0] = z12; /* x' */
    dydt[1] = z13; /* y' */
    dydt[2] = theta_dot; /* theta' */
    dydt[3] = -z14; /* phi' */
    /* (I.2.15) 17:4 */
    dydt[4] = z10 * z21 - z20 * z9; /* v' */
    dydt[5] = z21; /* theta'' */
    return roller_racer_finish(6, dydt);
}

int roller_racer_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */
    const double v = y[4];
    const double theta_dot = y[5];
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* parameters only */
    const double k1 = 1.0 / d2;

    /* state */
    /* the coframe is singular */
    if (!(fabs(d2) > 0.0)) {
        return ROLLER_RACER_SINGULAR_1;
    }
    const double c_theta = cos(theta);
    const double z1 = c_theta * v;
    const double s_theta = sin(theta);
    const double z2 = s_theta * v;
    const double c_phi = cos(phi);
    const double z3 = theta + phi;
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    /* (I.2.4) */
    qdot[0] = z1; /* x' */
    qdot[1] = z2; /* y' */
    qdot[2] = theta_dot; /* theta' */
    qdot[3] = -k1 * (theta_dot * (d2 + d1 * c_phi) + (c1 * z2 - s1 * z1)); /* phi' */
    return roller_racer_finish(4, qdot);
}

int roller_racer_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */
    const double v = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* parameters only */
    const double k1 = 1.0 / d2;

    /* state */
    /* the coframe is singular */
    if (!(fabs(d2) > 0.0)) {
        return ROLLER_RACER_SINGULAR_1;
    }
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double z1 = theta + phi;
    const double c1 = cos(z1);
    const double s1 = sin(z1);
    const double z2 = (s_theta * c1 - c_theta * s1) * k1;
    const double z3 = c_theta * (m * c_theta) + s_theta * (m * s_theta) + z2 * (I2 * z2);
    /* the mass matrix is singular */
    if (!(fabs(z3) > 0.0)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z4 = d2 + d1 * c_phi;
    const double z5 = 1.0 - z4 * k1;
    const double z6 = I2 * z5;
    const double z7 = I1 + z5 * z6;
    const double z8 = z2 * z6;
    const double z9 = 1.0 / z3;
    const double z10 = z8 * z9;
    const double z11 = z7 - z8 * z10;
    /* the mass matrix is singular */
    if (!(fabs(z11) > 1e-14 * z7)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double z12 = v * (theta_dot * s_theta);
    const double z13 = s_theta * v;
    const double z14 = c_theta * v;
    const double z15 = k1 * (theta_dot * z4 + (c1 * z13 - s1 * z14));
    const double s_phi = sin(phi);
    const double z16 = theta_dot * (d1 * (z15 * s_phi));
    const double z17 = theta_dot - z15;
    const double z18 = z13 * (s1 * z17);
    const double z19 = v * (theta_dot * c_theta);
    const double z20 = z14 * (c1 * z17);
    const double z21 = I2 * (k1 * (z16 - (z18 - c1 * z19 + (z20 - s1 * z12))));
    const double z22 = z2 * z21 - (c_theta * (m * z12) - s_theta * (m * z19));
    const double z23 = (z5 * z21 - z22 * z10) / z11;
    const double z24 = z22 * z9 - z10 * z23;
    const double z25 = z12 + c_theta * z24;
    const double z26 = z19 - s_theta * z24;
    /* (I.2.15) */
    qddot[0] = -z25; /* x'' */
    qddot[1] = z26; /* y'' */
    qddot[2] = z23; /* theta'' */
    qddot[3] = -k1 * (z16 + z4 * z23 - (z18 - c1 * z26 + (z20 - s1 * z25))); /* phi'' */
    return roller_racer_finish(4, qddot);
}

int roller_racer_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* axle of the main body [m] */
    const double y_2 = q[1]; /* axle of the main body [m] */
    const double theta = q[2]; /* heading of the main body [rad] */
    const double phi = q[3]; /* second body, relative to the first [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];

    /* state */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = phi;
    y[4] = x_dot * c_theta + y_dot * s_theta;
    y[5] = theta_dot;
    return roller_racer_finish(6, y);
}

int roller_racer_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta = q[2]; /* heading of the main body [rad] */
    const double phi = q[3]; /* second body, relative to the first [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];
    const double phi_dot = qdot[3];
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double z1 = theta + phi;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_phi = cos(phi);
    /* (I.1.1) 19:5 */
    r[0] = y_dot * c_theta - x_dot * s_theta; /* rear = 0 */
    /* (I.1.1) 20:5 */
    r[1] = phi_dot * d2 - (x_dot * s1 - y_dot * c1 - theta_dot * (d2 + d1 * c_phi)); /* front = 0 */
    return roller_racer_finish(2, r);
}

int roller_racer_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */
    const double v = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* parameters only */
    const double k1 = 1.0 / d2;

    /* state */
    /* the coframe is singular */
    if (!(fabs(d2) > 0.0)) {
        return ROLLER_RACER_SINGULAR_1;
    }
    const double c_theta = cos(theta);
    const double z1 = m * c_theta;
    const double s_theta = sin(theta);
    const double z2 = m * s_theta;
    const double z3 = theta + phi;
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    const double z4 = (s_theta * c1 - c_theta * s1) * k1;
    const double z5 = I2 * z4;
    const double z6 = c_theta * z1 + s_theta * z2 + z4 * z5;
    /* the mass matrix is singular */
    if (!(fabs(z6) > 0.0)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z7 = d2 + d1 * c_phi;
    const double z8 = 1.0 - z7 * k1;
    const double z9 = I2 * z8;
    const double z10 = I1 + z8 * z9;
    const double z11 = z4 * z9;
    const double z12 = 1.0 / z6;
    const double z13 = z11 * z12;
    const double z14 = z10 - z11 * z13;
    /* the mass matrix is singular */
    if (!(fabs(z14) > 1e-14 * z10)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double z15 = k1 * (c_theta * c1 + s_theta * s1);
    const double z16 = s_theta * v;
    const double z17 = c_theta * v;
    const double z18 = k1 * (theta_dot * z7 + (c1 * z16 - s1 * z17));
    const double s_phi = sin(phi);
    const double z19 = theta_dot - z18;
    const double z20 = v * (theta_dot * c_theta);
    const double z21 = v * (theta_dot * s_theta);
    const double z22 = theta_dot * (d1 * (z18 * s_phi)) - (z16 * (s1 * z19) - c1 * z20 + (z17 * (c1 * z19) -
        s1 * z21));
    const double z23 = I2 * (k1 * z22);
    const double z24 = m * z21;
    const double z25 = m * z20;
    const double z26 = z4 * z23 - (c_theta * z24 - s_theta * z25);
    const double z27 = (z8 * z23 - z26 * z13) / z14;
    const double z28 = z26 * z12 - z13 * z27;
    const double z29 = z15 * z23 + (s_theta * z24 + c_theta * z25) + ((s_theta * z1 - c_theta * z2 - z15 *
        z5) * z28 - z15 * z9 * z27);
    /* (I.4.1) 19:5 */
    lambda[0] = z29; /* reaction of rear: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 20:5 */
    lambda[1] = k1 * z5 * z28 + k1 * z9 * z27 - k1 * z23; /* reaction of front: Q_i gains lambda_2 a_2i */
    return roller_racer_finish(2, lambda);
}

double roller_racer_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */
    const double v = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* parameters only */
    const double k1 = 1.0 / d2;

    /* state */
    const double c_theta = cos(theta);
    const double z1 = c_theta * v;
    const double s_theta = sin(theta);
    const double z2 = s_theta * v;
    const double c_phi = cos(phi);
    const double z3 = theta + phi;
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    const double z4 = theta_dot - k1 * (theta_dot * (d2 + d1 * c_phi) + (c1 * z2 - s1 * z1));
    const double z5 = 0.5 * (I1 * (theta_dot * theta_dot)) + 0.5 * (m * (z1 * z1 + z2 * z2)) + 0.5 * (I2 *
        (z4 * z4));
    return z5;
}

int roller_racer_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[2]; /* heading of the main body [rad] */
    const double phi = y[3]; /* second body, relative to the first [rad] */
    const double v = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* parameters only */
    const double k1 = 1.0 / d2;

    /* state */
    /* the coframe is singular */
    if (!(fabs(d2) > 0.0)) {
        return ROLLER_RACER_SINGULAR_1;
    }
    const double c_theta = cos(theta);
    const double z1 = m * c_theta;
    const double s_theta = sin(theta);
    const double z2 = m * s_theta;
    const double z3 = theta + phi;
    const double c1 = cos(z3);
    const double s1 = sin(z3);
    const double z4 = (s_theta * c1 - c_theta * s1) * k1;
    const double z5 = I2 * z4;
    const double z6 = c_theta * z1 + s_theta * z2 + z4 * z5;
    /* the mass matrix is singular */
    if (!(fabs(z6) > 0.0)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z7 = d2 + d1 * c_phi;
    const double z8 = z7 * k1;
    const double z9 = 1.0 - z8;
    const double z10 = I2 * z9;
    const double z11 = I1 + z9 * z10;
    const double z12 = z4 * z10;
    const double z13 = 1.0 / z6;
    const double z14 = z12 * z13;
    const double z15 = z11 - z12 * z14;
    /* the mass matrix is singular */
    if (!(fabs(z15) > 1e-14 * z11)) {
        return ROLLER_RACER_SINGULAR_2;
    }
    const double z16 = s_theta * v;
    const double z17 = c_theta * v;
    const double z18 = s1 * (z16 * k1) + c1 * (z17 * k1);
    const double z19 = s1 * k1;
    const double z20 = c1 * k1;
    const double s_phi = sin(phi);
    const double z21 = theta_dot * c_theta;
    const double z22 = v * z21;
    const double z23 = k1 * z5;
    const double z24 = k1 * (theta_dot * z7 + (c1 * z16 - s1 * z17));
    const double z25 = theta_dot - z24;
    const double z26 = z17 * z23;
    const double z27 = d1 * (theta_dot * z23);
    const double z28 = z16 * z23;
    const double z29 = s1 * z28 + c1 * z26;
    const double z30 = k1 * (s_phi * z27 + z29);
    const double z31 = d1 * (z24 * s_phi);
    const double z32 = s1 * z25;
    const double z33 = c1 * z25;
    const double z34 = theta_dot * s_theta;
    const double z35 = v * z34;
    const double z36 = I2 * (k1 * (theta_dot * z31 - (z16 * z32 - c1 * z22 + (z17 * z33 - s1 * z35))));
    const double z37 = 1.0 / z15;
    const double z38 = m * z35;
    const double z39 = m * z22;
    const double z40 = z4 * z36 - (c_theta * z38 - s_theta * z39);
    const double z41 = z37 * (z9 * z36 - z40 * z14);
    const double z42 = z36 - z10 * z41;
    const double z43 = z40 * z13 - z14 * z41;
    const double z44 = z4 * z43;
    const double z45 = k1 * (z42 - z5 * z43 - I2 * z44);
    const double z46 = s1 * (z22 * z23 - z25 * z26 + z16 * z30 + s_theta * z45) - c1 * (z35 * z23 - z25 * z28
        - z17 * z30 - c_theta * z45);
    const double z47 = z33 * z23 + s1 * z30;
    const double z48 = z2 + c1 * z23;
    const double z49 = v * z48;
    const double z50 = v * z47 - (theta_dot * z49 - (z38 + z1 * z43 + m * (c_theta * z43))) + s1 * z45;
    const double z51 = z32 * z23 - c1 * z30;
    const double z52 = z1 - s1 * z23;
    const double z53 = v * z52;
    const double z54 = v * z51 + (theta_dot * z53 - (z39 - z2 * z43 - m * (s_theta * z43))) - c1 * z45;
    const double z55 = z46 - s_theta * z50 + c_theta * z54;
    const double z56 = k1 * z10;
    const double z57 = z17 * z56;
    const double z58 = d1 * (theta_dot * z56);
    const double z59 = z16 * z56;
    const double z60 = s1 * z59 + c1 * z57;
    const double z61 = k1 * (s_phi * z58 + z60);
    const double z62 = k1 * (z10 * z43);
    const double z63 = s1 * (z22 * z56 - z25 * z57 + z16 * z61 - s_theta * z62) - c1 * (z35 * z56 - z25 * z59
        - z17 * z61 + c_theta * z62);
    const double z64 = c1 * z56;
    const double z65 = v * z64;
    const double z66 = z33 * z56 + s1 * z61;
    const double z67 = s1 * z56;
    const double z68 = v * z67;
    const double z69 = z32 * z56 - c1 * z61;
    const double z70 = z63 + s_theta * (theta_dot * z65 - v * z66 + s1 * z62) - c_theta * (theta_dot * z68 -
        v * z69 - c1 * z62);
    const double z71 = z37 * (z70 - z14 * z55);
    const double z72 = z46 - (c_phi * (z24 * z27) - s_phi * (d1 * (theta_dot * z30 + k1 * (I2 * (z4 *
        z41)))));
    const double z73 = c_phi * (z24 * z58) - s_phi * (d1 * (theta_dot * z61 - k1 * (z42 - I2 * (z44 + z9 *
        z41))));
    const double z74 = z37 * (z63 - z73 - z14 * z72);
    const double z75 = z21 * z48 - z34 * z52 - s_theta * z51 - c_theta * z47;
    const double z76 = z37 * (z21 * z64 + z34 * z67 - s_theta * z69 - c_theta * z66 - z14 * z75);
    const double z77 = z29 - (z31 * z23 - s_theta * z53 + c_theta * z49) - z7 * z30;
    const double z78 = z37 * (z60 - (z31 * z56 + s_theta * z68 + c_theta * z65) - z7 * z61 - z14 * z77);
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = -z16;
    J[3] = 0.0;
    J[4] = c_theta;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = z17;
    J[9] = 0.0;
    J[10] = s_theta;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 0.0;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 1.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = z18 - s_theta * (v * z19) - c_theta * (v * z20);
    J[21] = s_phi * (d1 * (theta_dot * k1)) + z18;
    J[22] = c_theta * z19 - s_theta * z20;
    J[23] = -z8;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = z13 * z55 - z14 * z71;
    J[27] = z13 * z72 - z14 * z74;
    J[28] = z14 * z76 - z13 * z75;
    J[29] = z13 * z77 - z14 * z78;
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = -z71;
    J[33] = -z74;
    J[34] = z76;
    J[35] = -z78;
    return roller_racer_finish(36, J);
}

int roller_racer_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double v = y[4];
    const double d2 = p[4]; /* from the hinge to the second axle [m] */

    /* state */
    /* the coframe is singular */
    if (!(fabs(d2) > 0.0)) {
        return ROLLER_RACER_SINGULAR_1;
    }
    /* 22:10 */
    out[0] = v; /* speed */
    return roller_racer_finish(1, out);
}

int roller_racer_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass of the main body [kg] */
    const double I1 = p[1]; /* [kg*m^2] */
    const double I2 = p[2]; /* [kg*m^2] */
    const double d1 = p[3]; /* from the hinge to the first axle [m] */
    const double d2 = p[4]; /* from the hinge to the second axle [m] */
    const double k1 = 1.0 / d2;
    /* the coframe is singular */
    if (!(fabs(d2) > 0.0)) {
        return ROLLER_RACER_SINGULAR_1;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta = y[2 * count + i]; /* heading of the main body [rad] */
        const double phi = y[3 * count + i]; /* second body, relative to the first [rad] */
        const double v = y[4 * count + i];
        const double theta_dot = y[5 * count + i];
        const double c_theta = cos(theta);
        const double s_theta = sin(theta);
        const double z1 = theta + phi;
        const double c1 = cos(z1);
        const double s1 = sin(z1);
        const double z2 = (s_theta * c1 - c_theta * s1) * k1;
        const double z3 = c_theta * (m * c_theta) + s_theta * (m * s_theta) + z2 * (I2 * z2);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z3) > 0.0);
        const double c_phi = cos(phi);
        const double z4 = d2 + d1 * c_phi;
        const double z5 = 1.0 - z4 * k1;
        const double z6 = I2 * z5;
        const double z7 = I1 + z5 * z6;
        const double z8 = z2 * z6;
        const double z9 = 1.0 / z3;
        const double z10 = z8 * z9;
        const double z11 = z7 - z8 * z10;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z11) > 1e-14 * z7);
        const double z12 = c_theta * v;
        const double z13 = s_theta * v;
        const double z14 = k1 * (theta_dot * z4 + (c1 * z13 - s1 * z12));
        const double s_phi = sin(phi);
        const double z15 = theta_dot - z14;
        const double z16 = v * (theta_dot * c_theta);
        const double z17 = v * (theta_dot * s_theta);
        const double z18 = theta_dot * (d1 * (z14 * s_phi)) - (z13 * (s1 * z15) - c1 * z16 + (z12 * (c1 *
            z15) - s1 * z17));
        const double z19 = I2 * (k1 * z18);
        const double z20 = z2 * z19 - (c_theta * (m * z17) - s_theta * (m * z16));
        const double z21 = (z5 * z19 - z20 * z10) / z11;
        /* (I.2.15) */
        const double slope1 = z12; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = z13; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = theta_dot; /* theta' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = -z14; /* phi' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        /* (I.2.15) 17:4 */
        const double slope5 = z10 * z21 - z20 * z9; /* v' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = z21; /* theta'' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
    }
    if (singular1) {
        return ROLLER_RACER_SINGULAR_2;
    }
    return bad ? ROLLER_RACER_NOT_FINITE : ROLLER_RACER_OK;
}
