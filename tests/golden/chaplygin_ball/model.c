/*
 * chaplygin_ball.c: chaplygin_ball, emitted by nhc 0.1.0 (nhc:1aa346b1f62bbb69)
 * A ball with three different moments of inertia and its centre of mass at its centre rolls on a horizontal
 *     plane.
 * Source: chaplygin_ball.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * chaplygin_ball.h says what each function does.
 */
#include "chaplygin_ball.h"

#include <float.h>
#include <math.h>

const char *const chaplygin_ball_coordinate_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const chaplygin_ball_state_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "w1",
    "w2",
    "w3"
};
const char *const chaplygin_ball_parameter_names[] = {
    "m",
    "a",
    "I1",
    "I2",
    "I3"
};
const double chaplygin_ball_parameter_defaults[] = {
    1.0,
    1.0,
    0.4,
    0.5,
    0.7
};

static int chaplygin_ball_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? CHAPLYGIN_BALL_OK : CHAPLYGIN_BALL_NOT_FINITE;
}

int chaplygin_ball_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */
    const double w1 = y[5];
    const double w2 = y[6];
    const double w3 = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * (a * a);
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return CHAPLYGIN_BALL_SINGULAR_1;
    }
    const double s_psi = sin(psi);
    const double z1 = s_theta * s_theta;
    const double z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double c_psi = cos(psi);
    const double z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1);
    const double z4 = k1 * z1;
    const double z5 = c_psi * (s_psi * z4);
    const double z6 = 1.0 / z2;
    const double z7 = z5 * z6;
    const double z8 = z3 - z5 * z7;
    /* the mass matrix is singular */
    if (!(fabs(z8) > 1e-14 * z3)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double z9 = I3 + z4;
    const double c_theta = cos(theta);
    const double z10 = s_theta * k1;
    const double z11 = c_theta * (s_psi * z10);
    const double z12 = z11 * z6;
    const double z13 = c_theta * (c_psi * z10) + z5 * z12;
    const double z14 = 1.0 / z8;
    const double z15 = z13 * z14;
    const double z16 = z9 - z11 * z12 - z13 * z15;
    /* the mass matrix is singular */
    if (!(fabs(z16) > 1e-14 * z9)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z17 = 1.0 / s_theta;
    const double z18 = (c_psi * w2 + s_psi * w1) * z17;
    const double z19 = w3 - c_theta * z18;
    const double s_phi = sin(phi);
    const double z20 = z17 * (s_theta * c_psi * w1 - s_theta * s_psi * w2);
    const double z21 = w2 * w3 * k2;
    const double z22 = w1 * w3 * k3 - z21 * z7;
    const double z23 = (w1 * w2 * k4 + z21 * z12 - z15 * z22) / z16;
    const double z24 = z14 * z22 - z15 * z23;
    /* (I.2.15) */
    dydt[0] = -a * (s_theta * c_phi * z19 - s_phi * z20); /* x' */
    dydt[1] = -a * (s_theta * s_phi * z19 + c_phi * z20); /* y' */
    dydt[2] = z18; /* phi' */
    dydt[3] = z20; /* theta' */
    dydt[4] = z19; /* psi' */
    /* (I.2.15) 25:4 */
    dydt[5] = z21 * z6 - z7 * z24 + z12 * z23; /* w1' */
    dydt[6] = -z24; /* w2' */
    dydt[7] = z23; /* w3' */
    return chaplygin_ball_finish(8, dydt);
}

int chaplygin_ball_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */
    const double w1 = y[5];
    const double w2 = y[6];
    const double w3 = y[7];
    const double a = p[1]; /* radius [m] */

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return CHAPLYGIN_BALL_SINGULAR_1;
    }
    const double c_phi = cos(phi);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double z1 = 1.0 / s_theta;
    const double z2 = (c_psi * w2 + s_psi * w1) * z1;
    const double z3 = w3 - c_theta * z2;
    const double s_phi = sin(phi);
    const double z4 = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2);
    /* (I.2.4) */
    qdot[0] = -a * (s_theta * c_phi * z3 - s_phi * z4); /* x' */
    qdot[1] = -a * (s_theta * s_phi * z3 + c_phi * z4); /* y' */
    qdot[2] = z2; /* phi' */
    qdot[3] = z4; /* theta' */
    qdot[4] = z3; /* psi' */
    return chaplygin_ball_finish(5, qdot);
}

int chaplygin_ball_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */
    const double w1 = y[5];
    const double w2 = y[6];
    const double w3 = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * (a * a);
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return CHAPLYGIN_BALL_SINGULAR_1;
    }
    const double s_psi = sin(psi);
    const double z1 = s_theta * s_theta;
    const double z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double c_psi = cos(psi);
    const double z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1);
    const double z4 = k1 * z1;
    const double z5 = c_psi * (s_psi * z4);
    const double z6 = 1.0 / z2;
    const double z7 = z5 * z6;
    const double z8 = z3 - z5 * z7;
    /* the mass matrix is singular */
    if (!(fabs(z8) > 1e-14 * z3)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double z9 = I3 + z4;
    const double c_theta = cos(theta);
    const double z10 = s_theta * k1;
    const double z11 = c_theta * (s_psi * z10);
    const double z12 = z11 * z6;
    const double z13 = c_theta * (c_psi * z10) + z5 * z12;
    const double z14 = 1.0 / z8;
    const double z15 = z13 * z14;
    const double z16 = z9 - z11 * z12 - z13 * z15;
    /* the mass matrix is singular */
    if (!(fabs(z16) > 1e-14 * z9)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double z17 = c_psi * w2 + s_psi * w1;
    const double z18 = 1.0 / s_theta;
    const double z19 = z17 * z18;
    const double z20 = w3 - c_theta * z19;
    const double c_phi = cos(phi);
    const double z21 = s_theta * c_psi;
    const double z22 = s_theta * s_psi;
    const double z23 = z21 * w1 - z22 * w2;
    const double z24 = z18 * z23;
    const double z25 = c_theta * z24;
    const double s_phi = sin(phi);
    const double z26 = s_phi * z19;
    const double z27 = w2 * w3 * k2;
    const double z28 = w1 * w3 * k3 - z27 * z7;
    const double z29 = (w1 * w2 * k4 + z27 * z12 - z15 * z28) / z16;
    const double z30 = z25 / (s_theta * s_theta);
    const double z31 = s_psi * z20;
    const double z32 = z14 * z28 - z15 * z29;
    const double z33 = c_psi * z20;
    const double z34 = z27 * z6 - z7 * z32 + z12 * z29;
    const double z35 = z17 * z30 + z18 * (w2 * z31 + c_psi * z32 - (w1 * z33 + s_psi * z34));
    const double z36 = z29 + (z19 * z23 + c_theta * z35);
    const double z37 = c_phi * z19;
    const double z38 = w1 * (c_psi * z25 - s_theta * z31) + z21 * z34 - (w2 * (s_psi * z25 + s_theta * z33) -
        z22 * z32);
    const double z39 = z23 * z30 - z18 * z38;
    const double z40 = z20 * (c_phi * z25 - s_theta * z26) + s_theta * c_phi * z36 - (z24 * z37 - s_phi *
        z39);
    const double z41 = z20 * (s_phi * z25 + s_theta * z37) + s_theta * s_phi * z36 - (z24 * z26 + c_phi *
        z39);
    /* (I.2.15) */
    qddot[0] = -a * z40; /* x'' */
    qddot[1] = -a * z41; /* y'' */
    qddot[2] = -z35; /* phi'' */
    qddot[3] = -z39; /* theta'' */
    qddot[4] = z36; /* psi'' */
    return chaplygin_ball_finish(5, qddot);
}

int chaplygin_ball_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* centre [m] */
    const double y_2 = q[1]; /* centre [m] */
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double psi = q[4]; /* spin [rad] */
    const double phi_dot = qdot[2];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];

    /* state */
    const double s_theta = sin(theta);
    const double s_psi = sin(psi);
    const double c_psi = cos(psi);
    const double c_theta = cos(theta);
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = phi_dot * (s_theta * s_psi) + theta_dot * c_psi;
    y[6] = phi_dot * (s_theta * c_psi) - theta_dot * s_psi;
    y[7] = psi_dot + phi_dot * c_theta;
    return chaplygin_ball_finish(8, y);
}

int chaplygin_ball_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];
    const double a = p[1]; /* radius [m] */

    /* state */
    const double s_phi = sin(phi);
    const double s_theta = sin(theta);
    const double c_phi = cos(phi);
    /* (I.1.1) 27:5 */
    r[0] = x_dot - a * (theta_dot * s_phi - psi_dot * (s_theta * c_phi)); /* roll_x = 0 */
    /* (I.1.1) 28:5 */
    r[1] = y_dot + a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* roll_y = 0 */
    return chaplygin_ball_finish(2, r);
}

int chaplygin_ball_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */
    const double w1 = y[5];
    const double w2 = y[6];
    const double w3 = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * (a * a);
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;
    const double k5 = m * a;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return CHAPLYGIN_BALL_SINGULAR_1;
    }
    const double s_psi = sin(psi);
    const double z1 = s_theta * s_theta;
    const double z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double c_psi = cos(psi);
    const double z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1);
    const double z4 = k1 * z1;
    const double z5 = c_psi * (s_psi * z4);
    const double z6 = 1.0 / z2;
    const double z7 = z5 * z6;
    const double z8 = z3 - z5 * z7;
    /* the mass matrix is singular */
    if (!(fabs(z8) > 1e-14 * z3)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double z9 = I3 + z4;
    const double c_theta = cos(theta);
    const double z10 = s_theta * k1;
    const double z11 = c_theta * (s_psi * z10);
    const double z12 = z11 * z6;
    const double z13 = c_theta * (c_psi * z10) + z5 * z12;
    const double z14 = 1.0 / z8;
    const double z15 = z13 * z14;
    const double z16 = z9 - z11 * z12 - z13 * z15;
    /* the mass matrix is singular */
    if (!(fabs(z16) > 1e-14 * z9)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z17 = s_theta * k5;
    const double z18 = w2 * w3 * k2;
    const double z19 = w1 * w3 * k3 - z18 * z7;
    const double z20 = (w1 * w2 * k4 + z18 * z12 - z15 * z19) / z16;
    const double s_phi = sin(phi);
    const double z21 = s_psi * c_theta;
    const double z22 = z14 * z19 - z15 * z20;
    const double z23 = z18 * z6 - z7 * z22 + z12 * z20;
    const double z24 = c_psi * c_theta;
    const double z25 = k5 * (c_psi * s_phi + c_phi * z21) * z23 + k5 * (s_psi * s_phi - c_phi * z24) * z22;
    const double z26 = k5 * (c_psi * c_phi - s_phi * z21) * z23 + k5 * (s_psi * c_phi + s_phi * z24) * z22;
    /* (I.4.1) 27:5 */
    lambda[0] = z25 - c_phi * z17 * z20; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 28:5 */
    lambda[1] = -(s_phi * z17 * z20 + z26); /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    return chaplygin_ball_finish(2, lambda);
}

double chaplygin_ball_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */
    const double w1 = y[5];
    const double w2 = y[6];
    const double w3 = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * (a * a);

    /* state */
    const double s_theta = sin(theta);
    const double s_psi = sin(psi);
    const double z1 = w1 * w1;
    const double z2 = 0.5 * z1;
    const double z3 = w2 * w2;
    const double z4 = 0.5 * z3;
    const double c_psi = cos(psi);
    const double z5 = w3 * w3;
    const double c_theta = cos(theta);
    const double z6 = s_theta * (s_psi * (s_psi * (z2 - z4) + w2 * (c_psi * w1)) - (0.5 * z5 - z4)) + (c_psi
        * w2 + s_psi * w1) * (c_theta * w3);
    const double z7 = k1 * (s_theta * z6 - (z2 + z4)) - (0.5 * (I3 * z5) + (0.5 * (I1 * z1) + 0.5 * (I2 *
        z3)));
    return -z7;
}

int chaplygin_ball_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */
    const double w1 = y[5];
    const double w2 = y[6];
    const double w3 = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * (a * a);
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return CHAPLYGIN_BALL_SINGULAR_1;
    }
    const double s_psi = sin(psi);
    const double z1 = s_psi * s_psi;
    const double z2 = s_theta * s_theta;
    const double z3 = I1 + k1 * (1.0 - z1 * z2);
    /* the mass matrix is singular */
    if (!(fabs(z3) > 0.0)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double c_psi = cos(psi);
    const double z4 = c_psi * c_psi;
    const double z5 = I2 + k1 * (1.0 - z4 * z2);
    const double z6 = k1 * z2;
    const double z7 = s_psi * z6;
    const double z8 = c_psi * z7;
    const double z9 = 1.0 / z3;
    const double z10 = z8 * z9;
    const double z11 = z5 - z8 * z10;
    /* the mass matrix is singular */
    if (!(fabs(z11) > 1e-14 * z5)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double z12 = I3 + z6;
    const double c_theta = cos(theta);
    const double z13 = s_theta * k1;
    const double z14 = s_psi * z13;
    const double z15 = c_theta * z14;
    const double z16 = z15 * z9;
    const double z17 = c_psi * z13;
    const double z18 = c_theta * z17 + z8 * z16;
    const double z19 = 1.0 / z11;
    const double z20 = z18 * z19;
    const double z21 = z12 - z15 * z16 - z18 * z20;
    /* the mass matrix is singular */
    if (!(fabs(z21) > 1e-14 * z12)) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z22 = 1.0 / s_theta;
    const double z23 = s_theta * c_psi;
    const double z24 = s_theta * s_psi;
    const double z25 = z23 * w1 - z24 * w2;
    const double z26 = a * (z22 * z25);
    const double s_phi = sin(phi);
    const double z27 = c_psi * w2 + s_psi * w1;
    const double z28 = z27 * z22;
    const double z29 = a * (w3 - c_theta * z28);
    const double z30 = s_theta * z29;
    const double z31 = a * (s_theta * c_phi);
    const double z32 = 1.0 / (s_theta * s_theta);
    const double z33 = a * s_phi;
    const double z34 = c_theta * z31;
    const double z35 = z33 * z22;
    const double z36 = w1 * z35;
    const double z37 = w2 * z35;
    const double z38 = c_theta * (z32 * (z33 * z25 + z27 * z34) + c_phi * z29 - c_psi * z36 + s_psi * z37);
    const double z39 = z22 * z34;
    const double z40 = a * (s_theta * s_phi);
    const double z41 = a * c_phi;
    const double z42 = c_theta * z40;
    const double z43 = z41 * z22;
    const double z44 = w1 * z43;
    const double z45 = w2 * z43;
    const double z46 = c_theta * (z32 * (z41 * z25 - z27 * z42) - s_phi * z29 - c_psi * z44 + s_psi * z45);
    const double z47 = z22 * z42;
    const double z48 = s_psi * (w2 * z22);
    const double z49 = c_psi * (w1 * z22);
    const double z50 = c_theta * z22;
    const double z51 = 1.0 / z21;
    const double z52 = w2 * w3 * k2;
    const double z53 = w1 * w3 * k3 - z52 * z10;
    const double z54 = z51 * (w1 * w2 * k4 + z52 * z16 - z20 * z53);
    const double z55 = c_theta * z54;
    const double z56 = z19 * z53 - z20 * z54;
    const double z57 = c_psi * z56;
    const double z58 = z52 * z9 - z10 * z56 + z16 * z54;
    const double z59 = k1 * z58;
    const double z60 = s_theta * (z14 * z54) - c_theta * (k1 * (s_psi * z55) - 2.0 * (s_theta * (k1 * (s_psi
        * z57) - z1 * z59)));
    const double z61 = k1 * z56;
    const double z62 = c_psi * z58;
    const double z63 = s_theta * (z17 * z54) - c_theta * (k1 * (c_psi * z55) - 2.0 * (s_theta * (z4 * z61 -
        k1 * (s_psi * z62))));
    const double z64 = z63 + z10 * z60;
    const double z65 = c_theta * z56;
    const double z66 = c_theta * z58;
    const double z67 = s_theta * (z17 * z56 - z14 * z58) - c_theta * (k1 * (c_psi * z65 - s_psi * z66) + 2.0
        * (s_theta * (k1 * z54)));
    const double z68 = z51 * (z67 - z16 * z60 - z20 * z64);
    const double z69 = z19 * z64 - z20 * z68;
    const double z70 = z13 * z55;
    const double z71 = s_psi * (z7 * z56) + c_psi * (z70 - z6 * z57 + 2.0 * (s_psi * (z2 * z59)));
    const double z72 = s_psi * (z70 + z7 * z58 - 2.0 * (c_psi * (z2 * z61))) - c_psi * (z6 * z62) - z10 * z71;
    const double z73 = z51 * (s_psi * (z13 * z65) + c_psi * (z13 * z66) + z16 * z71 - z20 * z72);
    const double z74 = z19 * z72 - z20 * z73;
    const double z75 = w3 * k3;
    const double z76 = z51 * (w2 * k4 - z20 * z75);
    const double z77 = z19 * z75 - z20 * z76;
    const double z78 = w3 * k2;
    const double z79 = z10 * z78;
    const double z80 = z51 * (w1 * k4 + z16 * z78 + z20 * z79);
    const double z81 = z19 * z79 + z20 * z80;
    const double z82 = w2 * k2;
    const double z83 = w1 * k3 - z10 * z82;
    const double z84 = z51 * (z16 * z82 - z20 * z83);
    const double z85 = z19 * z83 - z20 * z84;
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = c_phi * z26 + s_phi * z30;
    J[3] = -(s_theta * (z31 * z28) + z38);
    J[4] = c_psi * (w1 * z39 - s_theta * z37) - s_psi * (w2 * z39 + s_theta * z36);
    J[5] = z23 * z35 + s_psi * z39;
    J[6] = c_psi * z39 - z24 * z35;
    J[7] = -z31;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = s_phi * z26 - c_phi * z30;
    J[11] = z46 - s_theta * (z40 * z28);
    J[12] = c_psi * (w1 * z47 + s_theta * z45) - s_psi * (w2 * z47 - s_theta * z44);
    J[13] = s_psi * z47 - z23 * z43;
    J[14] = z24 * z43 + c_psi * z47;
    J[15] = -z40;
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = -c_theta * (z27 * z32);
    J[20] = z49 - z48;
    J[21] = s_psi * z22;
    J[22] = c_psi * z22;
    J[23] = 0.0;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = -c_theta * (z48 - (z49 - z25 * z32));
    J[28] = -z27;
    J[29] = c_psi;
    J[30] = -s_psi;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = 0.0;
    J[35] = z27 + c_theta * (z32 * (c_theta * z27));
    J[36] = s_psi * (w2 * z50) - c_psi * (w1 * z50);
    J[37] = -s_psi * z50;
    J[38] = -c_psi * z50;
    J[39] = 1.0;
    J[40] = 0.0;
    J[41] = 0.0;
    J[42] = 0.0;
    J[43] = z16 * z68 - (z9 * z60 + z10 * z69);
    J[44] = z9 * z71 - z10 * z74 + z16 * z73;
    J[45] = z16 * z76 - z10 * z77;
    J[46] = z9 * z78 + z10 * z81 + z16 * z80;
    J[47] = z9 * z82 - z10 * z85 + z16 * z84;
    J[48] = 0.0;
    J[49] = 0.0;
    J[50] = 0.0;
    J[51] = -z69;
    J[52] = -z74;
    J[53] = -z77;
    J[54] = z81;
    J[55] = -z85;
    J[56] = 0.0;
    J[57] = 0.0;
    J[58] = 0.0;
    J[59] = z68;
    J[60] = z73;
    J[61] = z76;
    J[62] = z80;
    J[63] = z84;
    return chaplygin_ball_finish(64, J);
}

int chaplygin_ball_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[3]; /* nutation [rad] */
    const double psi = y[4]; /* spin [rad] */
    const double w1 = y[5];
    const double w2 = y[6];
    const double w3 = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = m * (a * a);

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return CHAPLYGIN_BALL_SINGULAR_1;
    }
    const double s_psi = sin(psi);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double z1 = c_psi * w2 + s_psi * w1;
    const double z2 = c_theta * w3 + s_theta * z1;
    /* 35:7 */
    out[0] = k1 * (w1 - s_theta * s_psi * z2) + I1 * w1; /* K1 */
    /* 36:7 */
    out[1] = k1 * (w2 - s_theta * c_psi * z2) + I2 * w2; /* K2 */
    /* 37:7 */
    out[2] = I3 * w3 - s_theta * k1 * (c_theta * z1 - s_theta * w3); /* K3 */
    return chaplygin_ball_finish(3, out);
}

int chaplygin_ball_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double I1 = p[2]; /* [kg*m^2] */
    const double I2 = p[3]; /* [kg*m^2] */
    const double I3 = p[4]; /* [kg*m^2] */
    const double k1 = m * (a * a);
    const double k2 = I2 - I3;
    const double k3 = I1 - I3;
    const double k4 = I1 - I2;
    int singular1 = 0;
    int singular2 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double phi = y[2 * count + i]; /* precession [rad] */
        const double theta = y[3 * count + i]; /* nutation [rad] */
        const double psi = y[4 * count + i]; /* spin [rad] */
        const double w1 = y[5 * count + i];
        const double w2 = y[6 * count + i];
        const double w3 = y[7 * count + i];
        const double s_theta = sin(theta);
        /* the coframe is singular */
        singular1 |= !(fabs(s_theta) > 1e-12 * 4.0);
        const double s_psi = sin(psi);
        const double z1 = s_theta * s_theta;
        const double z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1);
        /* the mass matrix is singular */
        singular2 |= !(fabs(z2) > 0.0);
        const double c_psi = cos(psi);
        const double z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1);
        const double z4 = k1 * z1;
        const double z5 = c_psi * (s_psi * z4);
        const double z6 = 1.0 / z2;
        const double z7 = z5 * z6;
        const double z8 = z3 - z5 * z7;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z8) > 1e-14 * z3);
        const double z9 = I3 + z4;
        const double c_theta = cos(theta);
        const double z10 = s_theta * k1;
        const double z11 = c_theta * (s_psi * z10);
        const double z12 = z11 * z6;
        const double z13 = c_theta * (c_psi * z10) + z5 * z12;
        const double z14 = 1.0 / z8;
        const double z15 = z13 * z14;
        const double z16 = z9 - z11 * z12 - z13 * z15;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z16) > 1e-14 * z9);
        const double c_phi = cos(phi);
        const double z17 = 1.0 / s_theta;
        const double z18 = (c_psi * w2 + s_psi * w1) * z17;
        const double z19 = w3 - c_theta * z18;
        const double s_phi = sin(phi);
        const double z20 = z17 * (s_theta * c_psi * w1 - s_theta * s_psi * w2);
        const double z21 = w2 * w3 * k2;
        const double z22 = w1 * w3 * k3 - z21 * z7;
        const double z23 = (w1 * w2 * k4 + z21 * z12 - z15 * z22) / z16;
        const double z24 = z14 * z22 - z15 * z23;
        /* (I.2.15) */
        const double slope1 = -a * (s_theta * c_phi * z19 - s_phi * z20); /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = -a * (s_theta * s_phi * z19 + c_phi * z20); /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z18; /* phi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = z20; /* theta' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = z19; /* psi' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        /* (I.2.15) 25:4 */
        const double slope6 = z21 * z6 - z7 * z24 + z12 * z23; /* w1' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = -z24; /* w2' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = z23; /* w3' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
    }
    if (singular1) {
        return CHAPLYGIN_BALL_SINGULAR_1;
    }
    if (singular2) {
        return CHAPLYGIN_BALL_SINGULAR_2;
    }
    return bad ? CHAPLYGIN_BALL_NOT_FINITE : CHAPLYGIN_BALL_OK;
}
