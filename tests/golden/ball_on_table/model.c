/*
 * ball_on_table.c: ball_on_table, emitted by nhc 0.1.0 (nhc:b507c092d088a392)
 * A homogeneous ball that rolls on a turning table; its centre runs on a circle, though nothing holds it
 *     there.
 * Source: ball_on_table.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the affine part b_alpha of the
 *     constraints contains the dependent coordinate `x`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the affine part b_alpha of the
 *     constraints contains the dependent coordinate `y`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the constraints are not
 *     homogeneous (b_alpha is not zero)
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the time t occurs in T, U or the
 *     constraints
 * ball_on_table.h says what each function does.
 */
#include "ball_on_table.h"

#include <float.h>
#include <math.h>

const char *const ball_on_table_coordinate_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const ball_on_table_state_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "phi'",
    "theta'",
    "psi'"
};
const char *const ball_on_table_parameter_names[] = {
    "m",
    "a",
    "k",
    "Omega0",
    "Omega1",
    "nu"
};
const double ball_on_table_parameter_defaults[] = {
    1.0,
    0.3,
    0.4,
    1.4,
    0.0,
    2.0
};

static int ball_on_table_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? BALL_ON_TABLE_OK : BALL_ON_TABLE_NOT_FINITE;
}

int ball_on_table_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* parameters only */
    const double k1 = m * (a * a);
    const double k2 = k * k1;
    const double k3 = 1.0 + k;
    const double k4 = k1 * k3;
    const double k5 = m * a;
    const double k6 = 2.0 * Omega0;
    const double k7 = Omega0 * Omega0;
    const double k8 = k5 / k4;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k4) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = k1 * (k + s_theta * s_theta);
    const double c_theta = cos(theta);
    const double z2 = z1 - c_theta * (c_theta * k2);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 1e-14 * z1)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double z3 = t * nu;
    const double s1 = sin(z3);
    const double z4 = Omega1 * s1;
    const double Omega = Omega0 + z4;
    const double z5 = 1.0 / z2;
    const double z6 = k6 + z4;
    const double z7 = x * c_phi;
    const double z8 = y_2 * s_phi;
    const double z9 = theta_dot * a;
    const double c1 = cos(z3);
    const double z10 = nu * c1;
    const double z11 = x * s_phi;
    const double z12 = y_2 * c_phi;
    const double z13 = z11 - z12;
    const double z14 = z7 + z8;
    const double z15 = phi_dot * k3;
    const double z16 = Omega1 * (s1 * (z6 * z7 + (z6 * z8 - z9)) - z10 * z13) + (z14 * k7 - z9 * (z15 +
        (Omega0 - psi_dot * c_theta * k3)));
    const double z17 = s_theta * (psi_dot * a);
    const double z18 = Omega1 * (s1 * (z11 * z6 - (z6 * z12 + z17)) + z10 * z14) - (z17 * (Omega0 + z15) - k7
        * z13);
    /* (III.3) */
    dydt[0] = a * (theta_dot * s_phi - psi_dot * (c_phi * s_theta)) - y_2 * Omega; /* x' */
    dydt[1] = x * Omega - a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    dydt[4] = psi_dot; /* psi' */
    /* (III.3) 25:4 */
    dydt[5] = s_theta * (theta_dot * psi_dot + z5 * (c_theta * k5) * z16); /* phi'' */
    dydt[6] = z18 * k8; /* theta'' */
    dydt[7] = -z16 * (s_theta * k5 * z5); /* psi'' */
    return ball_on_table_finish(8, dydt);
}

int ball_on_table_velocities(double t, const double *y, const double *p, double *qdot)
{
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double a = p[1]; /* radius [m] */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* state */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);
    const double s1 = sin(t * nu);
    const double Omega = Omega0 + Omega1 * s1;
    /* (I.2.4) */
    qdot[0] = a * (theta_dot * s_phi - psi_dot * (c_phi * s_theta)) - y_2 * Omega; /* x' */
    qdot[1] = x * Omega - a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    qdot[4] = psi_dot; /* psi' */
    return ball_on_table_finish(5, qdot);
}

int ball_on_table_accelerations(double t, const double *y, const double *p, double *qddot)
{
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* parameters only */
    const double k1 = m * (a * a);
    const double k2 = k * k1;
    const double k3 = 1.0 + k;
    const double k4 = k1 * k3;
    const double k5 = m * a;
    const double k6 = 2.0 * Omega0;
    const double k7 = Omega0 * Omega0;
    const double k8 = k5 / k4;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k4) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = k1 * (k + s_theta * s_theta);
    const double c_theta = cos(theta);
    const double z2 = z1 - c_theta * (c_theta * k2);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 1e-14 * z1)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double z3 = t * nu;
    const double c1 = cos(z3);
    const double z4 = nu * c1;
    const double z5 = Omega1 * z4;
    const double s1 = sin(z3);
    const double z6 = Omega1 * s1;
    const double Omega = Omega0 + z6;
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double z7 = s_theta * s_phi;
    const double z8 = phi_dot * c_phi;
    const double z9 = x * s_phi;
    const double z10 = k6 + z6;
    const double z11 = y_2 * c_phi;
    const double z12 = s_theta * (psi_dot * a);
    const double z13 = x * c_phi;
    const double z14 = y_2 * s_phi;
    const double z15 = z13 + z14;
    const double z16 = phi_dot * k3;
    const double z17 = z9 - z11;
    const double z18 = Omega1 * (s1 * (z9 * z10 - (z10 * z11 + z12)) + z4 * z15) - (z12 * (Omega0 + z16) - k7
        * z17);
    const double z19 = z18 * k8;
    const double z20 = phi_dot * s_phi;
    const double z21 = theta_dot * c_theta;
    const double z22 = c_phi * s_theta;
    const double z23 = theta_dot * a;
    const double z24 = Omega1 * (s1 * (z10 * z13 + (z10 * z14 - z23)) - z4 * z17) + (z15 * k7 - z23 * (z16 +
        (Omega0 - psi_dot * c_theta * k3)));
    const double z25 = 1.0 / z2;
    const double z26 = z24 * (s_theta * k5 * z25);
    const double z27 = a * (theta_dot * z8 + s_phi * z19 + (psi_dot * (s_theta * z20 - c_phi * z21) + z22 *
        z26));
    const double z28 = a * (theta_dot * z20 - c_phi * z19 - (psi_dot * (s_phi * z21 + s_theta * z8) - z7 *
        z26));
    /* (III.3) */
    qddot[0] = z27 - (y_2 * z5 - Omega * (a * (theta_dot * c_phi + psi_dot * z7) - x * Omega)); /* x'' */
    qddot[1] = x * z5 + Omega * (a * (theta_dot * s_phi - psi_dot * z22) - y_2 * Omega) + z28; /* y'' */
    qddot[2] = s_theta * (theta_dot * psi_dot + z25 * (c_theta * k5) * z24); /* phi'' */
    qddot[3] = z19; /* theta'' */
    qddot[4] = -z26; /* psi'' */
    return ball_on_table_finish(5, qddot);
}

int ball_on_table_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = phi_dot;
    y[6] = theta_dot;
    y[7] = psi_dot;
    return ball_on_table_finish(8, y);
}

int ball_on_table_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    const double x = q[0]; /* centre [m] */
    const double y = q[1]; /* centre [m] */
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];
    const double a = p[1]; /* radius [m] */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* state */
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);
    const double s1 = sin(t * nu);
    const double Omega = Omega0 + Omega1 * s1;
    /* (I.1.1) 27:5 */
    r[0] = x_dot - a * (theta_dot * s_phi - psi_dot * (c_phi * s_theta)) + y * Omega; /* roll_x = 0 */
    /* (I.1.1) 28:5 */
    r[1] = y_dot + a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)) - x * Omega; /* roll_y = 0 */
    return ball_on_table_finish(2, r);
}

int ball_on_table_reactions(double t, const double *y, const double *p, double *lambda)
{
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* parameters only */
    const double k1 = m * (a * a);
    const double k2 = k * k1;
    const double k3 = 1.0 + k;
    const double k4 = k1 * k3;
    const double k5 = m * a;
    const double k6 = 2.0 * Omega0;
    const double k7 = Omega0 * Omega0;
    const double k8 = Omega1 * Omega1;
    const double k9 = k5 / k4;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k4) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = k1 * (k + s_theta * s_theta);
    const double c_theta = cos(theta);
    const double z2 = z1 - c_theta * (c_theta * k2);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 1e-14 * z1)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double z3 = t * nu;
    const double s1 = sin(z3);
    const double z4 = Omega1 * s1;
    const double z5 = psi_dot * c_theta;
    const double z6 = z4 + (Omega0 + (phi_dot - z5));
    const double s_phi = sin(phi);
    const double z7 = z4 + (phi_dot + Omega0);
    const double z8 = Omega0 * (Omega0 + 2.0 * z4) + k8 * (s1 * s1);
    const double c1 = cos(z3);
    const double z9 = a * (theta_dot * c_phi * z6 + s_phi * (psi_dot * s_theta) * z7) - (x * z8 + c1 * (nu *
        (y_2 * Omega1)));
    const double z10 = x * s_phi;
    const double z11 = k6 + z4;
    const double z12 = y_2 * c_phi;
    const double z13 = s_theta * (psi_dot * a);
    const double z14 = nu * c1;
    const double z15 = x * c_phi;
    const double z16 = y_2 * s_phi;
    const double z17 = z15 + z16;
    const double z18 = phi_dot * k3;
    const double z19 = z10 - z12;
    const double z20 = Omega1 * (s1 * (z10 * z11 - (z11 * z12 + z13)) + z14 * z17) - (z13 * (Omega0 + z18) -
        k7 * z19);
    const double z21 = z20 * k9;
    const double z22 = c_phi * k5;
    const double z23 = theta_dot * a;
    const double z24 = Omega1 * (s1 * (z11 * z15 + (z11 * z16 - z23)) - z14 * z19) + (z17 * k7 - z23 * (z18 +
        (Omega0 - z5 * k3)));
    const double z25 = s_theta * k5;
    const double z26 = z24 * (z25 / z2);
    const double z27 = a * (theta_dot * s_phi * z6 - z7 * (s_theta * (psi_dot * c_phi))) - (y_2 * z8 - c1 *
        (nu * (x * Omega1)));
    /* (I.4.1) 27:5 */
    /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    lambda[0] = m * z9 + (s_phi * k5 * z21 + s_theta * z22 * z26);
    /* (I.4.1) 28:5 */
    lambda[1] = m * z27 - (z22 * z21 - s_phi * z25 * z26); /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    return ball_on_table_finish(2, lambda);
}

double ball_on_table_energy(double t, const double *y, const double *p)
{
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* parameters only */
    const double I = m * k * (a * a);

    /* state */
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);
    const double s_phi = sin(phi);
    const double omega_x = theta_dot * c_phi + psi_dot * (s_theta * s_phi);
    const double omega_y = theta_dot * s_phi - psi_dot * (c_phi * s_theta);
    const double c_theta = cos(theta);
    const double omega_z = phi_dot + psi_dot * c_theta;
    const double s1 = sin(t * nu);
    const double Omega = Omega0 + Omega1 * s1;
    const double z1 = a * omega_y - y_2 * Omega;
    const double z2 = a * omega_x - x * Omega;
    const double z3 = 0.5 * (I * (omega_x * omega_x + omega_y * omega_y + omega_z * omega_z)) + 0.5 * (m *
        (z1 * z1 + z2 * z2));
    return z3;
}

int ball_on_table_jacobian(double t, const double *y, const double *p, double *J)
{
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = m * k1;
    const double k3 = k * k2;
    const double k4 = 1.0 + k;
    const double k5 = k2 * k4;
    const double k6 = m * a;
    const double k7 = 2.0 * Omega0;
    const double k8 = Omega0 * Omega0;
    const double k9 = 1.0 / k3;
    const double k10 = 1.0 / k5;
    const double k11 = k6 * k10;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(k3) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k5) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = k2 * (k + s_theta * s_theta);
    const double c_theta = cos(theta);
    const double z2 = z1 - c_theta * (c_theta * k3);
    /* the mass matrix is singular */
    if (!(fabs(z2) > 1e-14 * z1)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    const double z3 = t * nu;
    const double s1 = sin(z3);
    const double z4 = Omega1 * s1;
    const double Omega = Omega0 + z4;
    const double c_phi = cos(phi);
    const double z5 = theta_dot * a;
    const double s_phi = sin(phi);
    const double z6 = psi_dot * a;
    const double z7 = s_theta * z6;
    const double z8 = 1.0 / z2;
    const double z9 = s_theta * k6;
    const double z10 = z8 * (c_theta * z9);
    const double z11 = k7 + z4;
    const double c1 = cos(z3);
    const double z12 = Omega1 * (z11 * (s1 * c_phi) - c1 * (nu * s_phi)) + c_phi * k8;
    const double z13 = Omega1 * (z11 * (s1 * s_phi) + c1 * (nu * c_phi)) + s_phi * k8;
    const double z14 = x * s_phi - y_2 * c_phi;
    const double z15 = nu * c1;
    const double z16 = x * c_phi;
    const double z17 = y_2 * s_phi;
    const double z18 = z16 + z17;
    const double z19 = k8 * z14 + Omega1 * (z15 * z18 + s1 * (z11 * z14));
    const double z20 = theta_dot * psi_dot;
    const double z21 = z15 * z14;
    const double z22 = Omega1 * (s1 * (z11 * z16 + (z11 * z17 - z5)) - z21);
    const double z23 = z18 * k8;
    const double z24 = phi_dot * k4;
    const double z25 = psi_dot * c_theta;
    const double z26 = z25 * k4;
    const double z27 = z22 + (z23 - z5 * (z24 + (Omega0 - z26)));
    const double z28 = z9 * z8;
    const double z29 = z27 * z28;
    const double z30 = c_theta * (k * (k1 * (m * z20))) - s_theta * (k3 * z29);
    const double z31 = c_theta * (k6 * (z22 - (z5 * (z24 + (Omega0 - z25)) - z23)) - 2.0 * (s_theta * (k2 *
        z29)));
    const double z32 = s_theta * (psi_dot * (z9 * z5) + k3 * (s_theta * (z20 + z8 * (c_theta * k6) * z27))) -
        z31;
    const double z33 = z8 * (z32 - c_theta * z30);
    const double z34 = s_theta * (k1 * (theta_dot * m));
    const double z35 = k4 * (z8 * (c_theta * z34));
    const double z36 = z24 + (Omega - z26);
    const double z37 = k1 * (psi_dot * m);
    const double z38 = Omega + z24;
    const double z39 = s_theta * k2;
    /* (III.3) */
    J[0] = 0.0;
    J[1] = -Omega;
    J[2] = c_phi * z5 + s_phi * z7;
    J[3] = -c_theta * (c_phi * z6);
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = a * s_phi;
    J[7] = -a * (c_phi * s_theta);
    J[8] = Omega;
    J[9] = 0.0;
    J[10] = s_phi * z5 - c_phi * z7;
    J[11] = -c_theta * (s_phi * z6);
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = -a * c_phi;
    J[15] = -a * (s_theta * s_phi);
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
    J[40] = z10 * z12;
    J[41] = z10 * z13;
    J[42] = -z10 * z19;
    J[43] = k9 * z30 - c_theta * z33;
    J[44] = 0.0;
    J[45] = -z35;
    J[46] = s_theta * (psi_dot - z8 * (c_theta * k2) * z36);
    J[47] = theta_dot * s_theta * (1.0 + k4 * (z8 * (k2 * (c_theta * c_theta))));
    J[48] = k11 * z13;
    J[49] = -k11 * z12;
    J[50] = k11 * (z23 - Omega1 * (z21 - s1 * (z11 * z18)));
    J[51] = -k10 * (c_theta * z37) * z38;
    J[52] = 0.0;
    J[53] = -k4 * (k10 * (s_theta * z37));
    J[54] = 0.0;
    J[55] = -z38 * (k10 * z39);
    J[56] = -z28 * z12;
    J[57] = -z28 * z13;
    J[58] = z28 * z19;
    J[59] = z33;
    J[60] = 0.0;
    J[61] = k4 * (z8 * z34);
    J[62] = z36 * (z8 * z39);
    J[63] = -z35;
    return ball_on_table_finish(64, J);
}

int ball_on_table_outputs(double t, const double *y, const double *p, double *out)
{
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double theta = y[3]; /* nutation [rad] */
    const double phi_dot = y[5];
    const double theta_dot = y[6];
    const double psi_dot = y[7];
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = Omega1 * Omega1;
    const double k3 = 0.5 * Omega0;

    /* state */
    const double c_theta = cos(theta);
    const double z1 = psi_dot * c_theta;
    const double s1 = sin(t * nu);
    const double z2 = Omega1 * s1;
    const double z3 = x * x;
    const double z4 = y_2 * y_2;
    const double z5 = Omega0 * ((k3 + z2) * (z3 + z4)) + k2 * (s1 * s1) * (0.5 * z3 + 0.5 * z4);
    const double z6 = 0.5 * (theta_dot * theta_dot);
    const double z7 = phi_dot * (z2 + (Omega0 - (0.5 * phi_dot + z1))) - (psi_dot * (0.5 * psi_dot - (Omega0
        + z2) * c_theta) + z6);
    const double s_theta = sin(theta);
    /* 31:9 */
    out[0] = phi_dot + z1; /* spin */
    /* 32:18 */
    /* moving_energy */
    out[1] = -m * (z5 + k1 * (k * z7 - (z6 + 0.5 * (s_theta * s_theta * (psi_dot * psi_dot)))));
    return ball_on_table_finish(2, out);
}

int ball_on_table_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double a = p[1]; /* radius [m] */
    const double k_ = p[2]; /* moment of inertia over m a^2; 2/5 for a homogeneous ball */
    const double Omega0 = p[3]; /* mean rate of the table [rad/s] */
    const double Omega1 = p[4]; /* amplitude of its modulation [rad/s] */
    const double nu = p[5]; /* frequency of its modulation [rad/s] */
    const double k1 = m * (a * a);
    const double k2 = k_ * k1;
    const double k3 = 1.0 + k_;
    const double k4 = k1 * k3;
    const double k5 = m * a;
    const double k6 = 2.0 * Omega0;
    const double k7 = Omega0 * Omega0;
    const double k8 = k5 / k4;
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k4) > 0.0)) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double t_ = t[i]; /* time */
        const double x = y[i]; /* centre [m] */
        const double y_2 = y[count + i]; /* centre [m] */
        const double phi = y[2 * count + i]; /* precession [rad] */
        const double theta = y[3 * count + i]; /* nutation [rad] */
        const double phi_dot = y[5 * count + i];
        const double theta_dot = y[6 * count + i];
        const double psi_dot = y[7 * count + i];
        const double s_theta = sin(theta);
        const double z1 = k1 * (k_ + s_theta * s_theta);
        const double c_theta = cos(theta);
        const double z2 = z1 - c_theta * (c_theta * k2);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z2) > 1e-14 * z1);
        const double s_phi = sin(phi);
        const double c_phi = cos(phi);
        const double z3 = t_ * nu;
        const double s1 = sin(z3);
        const double z4 = Omega1 * s1;
        const double Omega = Omega0 + z4;
        const double z5 = 1.0 / z2;
        const double z6 = k6 + z4;
        const double z7 = x * c_phi;
        const double z8 = y_2 * s_phi;
        const double z9 = theta_dot * a;
        const double c1 = cos(z3);
        const double z10 = nu * c1;
        const double z11 = x * s_phi;
        const double z12 = y_2 * c_phi;
        const double z13 = z11 - z12;
        const double z14 = z7 + z8;
        const double z15 = phi_dot * k3;
        const double z16 = Omega1 * (s1 * (z6 * z7 + (z6 * z8 - z9)) - z10 * z13) + (z14 * k7 - z9 * (z15 +
            (Omega0 - psi_dot * c_theta * k3)));
        const double z17 = s_theta * (psi_dot * a);
        const double z18 = Omega1 * (s1 * (z11 * z6 - (z6 * z12 + z17)) + z10 * z14) - (z17 * (Omega0 + z15)
            - k7 * z13);
        /* (III.3) */
        const double slope1 = a * (theta_dot * s_phi - psi_dot * (c_phi * s_theta)) - y_2 * Omega; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = x * Omega - a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)); /* y' */
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
        /* (III.3) 25:4 */
        const double slope6 = s_theta * (theta_dot * psi_dot + z5 * (c_theta * k5) * z16); /* phi'' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = z18 * k8; /* theta'' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = -z16 * (s_theta * k5 * z5); /* psi'' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
    }
    if (singular1) {
        return BALL_ON_TABLE_SINGULAR_2;
    }
    return bad ? BALL_ON_TABLE_NOT_FINITE : BALL_ON_TABLE_OK;
}
