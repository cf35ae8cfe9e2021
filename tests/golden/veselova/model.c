/*
 * veselova.c: veselova, emitted by nhc 0.1.0 (nhc:73b588e15cd78034)
 * A rigid body with a fixed point that must not turn about the vertical.
 * Source: veselova.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * veselova.h says what each function does.
 */
#include "veselova.h"

#include <float.h>
#include <math.h>

const char *const veselova_coordinate_names[] = {
    "phi",
    "theta",
    "psi"
};
const char *const veselova_state_names[] = {
    "phi",
    "theta",
    "psi",
    "w_x",
    "w_y"
};
const char *const veselova_parameter_names[] = {
    "I1",
    "I2",
    "I3"
};
const double veselova_parameter_defaults[] = {
    1.0,
    1.7,
    2.3
};

static int veselova_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? VESELOVA_OK : VESELOVA_NOT_FINITE;
}

int veselova_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = 2.0 * I1 - 2.0 * I2;
    const double k2 = I1 - I2;
    const double k3 = I2 - I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return VESELOVA_SINGULAR_1;
    }
    const double s_phi = sin(phi);
    const double z1 = s_theta * s_theta;
    const double s_psi = sin(psi);
    const double z2 = s_psi * s_psi;
    const double z3 = 1.0 - z2;
    const double z4 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + (I1 * (1.0 - z2 * (2.0 - z1)) - I3 * z1);
    const double c_phi = cos(phi);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double z5 = c_theta * (s_psi * c_psi);
    const double z6 = I1 * z3 + I2 * z2;
    const double z7 = s_phi * (s_phi * z4 + c_phi * z5 * k1) - z6;
    /* the mass matrix is singular */
    if (!(fabs(-z7) > 0.0)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z8 = k1 * (s_phi * z5);
    const double z9 = c_theta * c_theta;
    const double z10 = z8 + c_phi * (z2 * (k2 * (1.0 + z9)) + (I3 * (1.0 - z9) - (I1 - I2 * z9)));
    const double z11 = z6 + c_phi * z10;
    const double z12 = s_phi * (c_phi * z4 - z8) + z5 * k2;
    const double z13 = 1.0 / z7;
    const double z14 = z12 * z13;
    const double z15 = z11 + z12 * z14;
    /* the mass matrix is singular */
    if (!(fabs(z15) > 1e-14 * z11)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z16 = 1.0 / s_theta;
    const double z17 = s_phi * w_x - c_phi * w_y;
    const double z18 = z16 * z17;
    const double z19 = s_psi * (k2 * (z17 * (s_psi * c_theta) - c_psi * (c_phi * w_x + s_phi * w_y))) +
        c_theta * (z17 * k3);
    const double z20 = s_theta * w_y * z19;
    const double z21 = (z19 * (s_theta * w_x) - z20 * z14) / z15;
    /* (I.2.15) */
    dydt[0] = -c_theta * z18; /* phi' */
    dydt[1] = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z16; /* theta' */
    dydt[2] = z18; /* psi' */
    /* (I.2.15) 24:4 */
    dydt[3] = -(z20 * z13 + z14 * z21); /* w_x' */
    dydt[4] = -z21; /* w_y' */
    return veselova_finish(5, dydt);
}

int veselova_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double w_x = y[3];
    const double w_y = y[4];

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return VESELOVA_SINGULAR_1;
    }
    const double c_theta = cos(theta);
    const double z1 = 1.0 / s_theta;
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double z2 = z1 * (s_phi * w_x - c_phi * w_y);
    /* (I.2.4) */
    qdot[0] = -c_theta * z2; /* phi' */
    qdot[1] = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1; /* theta' */
    qdot[2] = z2; /* psi' */
    return veselova_finish(3, qdot);
}

int veselova_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = 2.0 * I1 - 2.0 * I2;
    const double k2 = I1 - I2;
    const double k3 = I2 - I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return VESELOVA_SINGULAR_1;
    }
    const double s_phi = sin(phi);
    const double z1 = s_theta * s_theta;
    const double s_psi = sin(psi);
    const double z2 = s_psi * s_psi;
    const double z3 = 1.0 - z2;
    const double z4 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + (I1 * (1.0 - z2 * (2.0 - z1)) - I3 * z1);
    const double c_phi = cos(phi);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double z5 = c_theta * (s_psi * c_psi);
    const double z6 = I1 * z3 + I2 * z2;
    const double z7 = s_phi * (s_phi * z4 + c_phi * z5 * k1) - z6;
    /* the mass matrix is singular */
    if (!(fabs(-z7) > 0.0)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z8 = k1 * (s_phi * z5);
    const double z9 = c_theta * c_theta;
    const double z10 = z8 + c_phi * (z2 * (k2 * (1.0 + z9)) + (I3 * (1.0 - z9) - (I1 - I2 * z9)));
    const double z11 = z6 + c_phi * z10;
    const double z12 = s_phi * (c_phi * z4 - z8) + z5 * k2;
    const double z13 = 1.0 / z7;
    const double z14 = z12 * z13;
    const double z15 = z11 + z12 * z14;
    /* the mass matrix is singular */
    if (!(fabs(z15) > 1e-14 * z11)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z16 = s_theta * s_phi;
    const double z17 = s_theta * c_phi;
    const double z18 = z16 * w_y + z17 * w_x;
    const double z19 = 1.0 / s_theta;
    const double z20 = s_phi * w_x - c_phi * w_y;
    const double z21 = z19 * z20;
    const double z22 = c_theta * (z18 * z19);
    const double z23 = z22 / (s_theta * s_theta);
    const double z24 = c_theta * z21;
    const double z25 = c_phi * z24;
    const double z26 = s_psi * (k2 * (z20 * (s_psi * c_theta) - c_psi * (c_phi * w_x + s_phi * w_y))) +
        c_theta * (z20 * k3);
    const double z27 = s_theta * w_y * z26;
    const double z28 = (z26 * (s_theta * w_x) - z27 * z14) / z15;
    const double z29 = z27 * z13 + z14 * z28;
    const double z30 = s_phi * z24;
    const double z31 = z20 * z23 + z19 * (w_x * z25 + s_phi * z29 + (w_y * z30 - c_phi * z28));
    const double z32 = w_y * (s_phi * z22 - s_theta * z25) - z16 * z28 + (w_x * (c_phi * z22 + s_theta * z30)
        - z17 * z29);
    /* (I.2.15) */
    qddot[0] = z18 * z21 + c_theta * z31; /* phi'' */
    qddot[1] = z19 * z32 - z18 * z23; /* theta'' */
    qddot[2] = -z31; /* psi'' */
    return veselova_finish(3, qddot);
}

int veselova_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double phi = q[0]; /* precession [rad] */
    const double theta = q[1]; /* nutation [rad] */
    const double psi = q[2]; /* spin [rad] */
    const double theta_dot = qdot[1];
    const double psi_dot = qdot[2];

    /* state */
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);
    const double s_phi = sin(phi);
    y[0] = phi;
    y[1] = theta;
    y[2] = psi;
    y[3] = theta_dot * c_phi + psi_dot * (s_theta * s_phi);
    y[4] = theta_dot * s_phi - psi_dot * (s_theta * c_phi);
    return veselova_finish(5, y);
}

int veselova_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double theta = q[1]; /* nutation [rad] */
    const double phi_dot = qdot[0];
    const double psi_dot = qdot[2];

    /* state */
    const double c_theta = cos(theta);
    /* (I.1.1) 26:5 */
    r[0] = phi_dot + psi_dot * c_theta; /* no_turn = 0 */
    return veselova_finish(1, r);
}

int veselova_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = 2.0 * I1 - 2.0 * I2;
    const double k2 = I1 - I2;
    const double k3 = I2 - I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return VESELOVA_SINGULAR_1;
    }
    const double s_phi = sin(phi);
    const double z1 = s_theta * s_theta;
    const double s_psi = sin(psi);
    const double z2 = s_psi * s_psi;
    const double z3 = 1.0 - z2;
    const double z4 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + (I1 * (1.0 - z2 * (2.0 - z1)) - I3 * z1);
    const double c_phi = cos(phi);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double z5 = c_theta * (s_psi * c_psi);
    const double z6 = I1 * z3 + I2 * z2;
    const double z7 = s_phi * (s_phi * z4 + c_phi * z5 * k1) - z6;
    /* the mass matrix is singular */
    if (!(fabs(-z7) > 0.0)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z8 = k1 * (s_phi * z5);
    const double z9 = c_theta * c_theta;
    const double z10 = z8 + c_phi * (z2 * (k2 * (1.0 + z9)) + (I3 * (1.0 - z9) - (I1 - I2 * z9)));
    const double z11 = z6 + c_phi * z10;
    const double z12 = s_phi * (c_phi * z4 - z8) + z5 * k2;
    const double z13 = 1.0 / z7;
    const double z14 = z12 * z13;
    const double z15 = z11 + z12 * z14;
    /* the mass matrix is singular */
    if (!(fabs(z15) > 1e-14 * z11)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z16 = s_theta * s_phi * w_y + s_theta * c_phi * w_x;
    const double z17 = 1.0 / s_theta;
    const double z18 = s_phi * w_x - c_phi * w_y;
    const double z19 = z17 * z18;
    const double z20 = c_theta * z19;
    const double z21 = z16 * z17;
    const double z22 = c_theta * z21;
    const double z23 = z22 / (s_theta * s_theta);
    const double z24 = c_phi * z20;
    const double z25 = s_phi * z20;
    const double z26 = z18 * z23 + z17 * (w_x * z24 + w_y * z25);
    const double z27 = z16 * z19 + c_theta * z26;
    const double z28 = s_theta * c_psi;
    const double z29 = s_psi * z19;
    const double z30 = c_psi * z22 - s_theta * z29;
    const double z31 = c_psi * z19;
    const double z32 = z17 * (w_y * (s_phi * z22 - s_theta * z24) + w_x * (c_phi * z22 + s_theta * z25)) -
        z16 * z23;
    const double z33 = s_theta * s_psi;
    const double z34 = s_psi * z22 + s_theta * z31;
    const double z35 = z33 * (I1 * (z20 * z34 - z33 * z27 + (z21 * z29 - c_psi * z32))) + I1 * (z33 * z20 -
        c_psi * z21) * z34;
    const double z36 = I2 * (z28 * z20 + s_psi * z21) * z30 + (z28 * (I2 * (z20 * z30 - z28 * z27 + (z21 *
        z31 + s_psi * z32))) + z35);
    const double z37 = z16 * (I3 * (z19 - c_theta * z20)) + (c_theta * (I3 * (z26 - (z16 * z20 + c_theta *
        z27))) + z36);
    const double z38 = s_psi * c_theta;
    const double z39 = s_psi * (k2 * (z18 * z38 - c_psi * (c_phi * w_x + s_phi * w_y))) + c_theta * (z18 *
        k3);
    const double z40 = s_theta * w_y * z39;
    const double z41 = (z39 * (s_theta * w_x) - z40 * z14) / z15;
    const double z42 = s_theta * (s_psi * (k2 * (c_psi * c_phi - s_phi * z38)) - c_theta * s_phi * k3) * (z40
        * z13 + z14 * z41);
    const double z43 = z42 + s_theta * (s_psi * (k2 * (c_psi * s_phi + c_phi * z38)) + c_theta * c_phi * k3)
        * z41;
    /* (I.4.1) 26:5 */
    lambda[0] = -(z37 + z43); /* reaction of no_turn: Q_i gains lambda_1 a_1i */
    return veselova_finish(1, lambda);
}

double veselova_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* state */
    const double s_theta = sin(theta);
    const double s_psi = sin(psi);
    const double c_theta = cos(theta);
    const double z1 = 1.0 / s_theta;
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double z2 = z1 * (s_phi * w_x - c_phi * w_y);
    const double z3 = c_theta * z2;
    const double c_psi = cos(psi);
    const double z4 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1;
    const double z5 = s_theta * s_psi * z3 - c_psi * z4;
    const double z6 = s_theta * c_psi * z3 + s_psi * z4;
    const double omega3 = z2 - c_theta * z3;
    return 0.5 * (I1 * (z5 * z5) + I2 * (z6 * z6) + I3 * (omega3 * omega3));
}

int veselova_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* parameters only */
    const double k1 = 2.0 * I1 - 2.0 * I2;
    const double k2 = I1 - I2;
    const double k3 = I2 - I3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return VESELOVA_SINGULAR_1;
    }
    const double s_phi = sin(phi);
    const double z1 = s_theta * s_theta;
    const double s_psi = sin(psi);
    const double z2 = s_psi * s_psi;
    const double z3 = 1.0 - z2;
    const double z4 = 2.0 - z1;
    const double z5 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + (I1 * (1.0 - z2 * z4) - I3 * z1);
    const double c_phi = cos(phi);
    const double c_theta = cos(theta);
    const double c_psi = cos(psi);
    const double z6 = s_psi * c_psi;
    const double z7 = c_theta * z6;
    const double z8 = s_phi * z5 + c_phi * z7 * k1;
    const double z9 = I1 * z3 + I2 * z2;
    const double z10 = s_phi * z8 - z9;
    /* the mass matrix is singular */
    if (!(fabs(-z10) > 0.0)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z11 = k1 * (s_phi * z7);
    const double z12 = c_theta * c_theta;
    const double z13 = k2 * (1.0 + z12);
    const double z14 = z2 * z13 + (I3 * (1.0 - z12) - (I1 - I2 * z12));
    const double z15 = z11 + c_phi * z14;
    const double z16 = z9 + c_phi * z15;
    const double z17 = c_phi * z5 - z11;
    const double z18 = s_phi * z17 + z7 * k2;
    const double z19 = 1.0 / z10;
    const double z20 = z18 * z19;
    const double z21 = z16 + z18 * z20;
    /* the mass matrix is singular */
    if (!(fabs(z21) > 1e-14 * z16)) {
        return VESELOVA_SINGULAR_2;
    }
    const double z22 = 1.0 / s_theta;
    const double z23 = c_theta * z22;
    const double z24 = s_phi * w_x - c_phi * w_y;
    const double z25 = 1.0 / (s_theta * s_theta);
    const double z26 = c_phi * (w_x * z22);
    const double z27 = s_phi * (w_y * z22);
    const double z28 = s_theta * w_y;
    const double z29 = s_psi * c_theta;
    const double z30 = k2 * (s_psi * z28);
    const double z31 = k3 * (c_theta * z28) + z29 * z30;
    const double z32 = c_psi * z30;
    const double z33 = 1.0 / z21;
    const double z34 = c_phi * w_x + s_phi * w_y;
    const double z35 = k2 * (z24 * z29 - c_psi * z34);
    const double z36 = z24 * k3;
    const double z37 = s_psi * z35 + c_theta * z36;
    const double z38 = s_theta * w_x;
    const double z39 = z28 * z37;
    const double z40 = z33 * (z37 * z38 - z39 * z20);
    const double z41 = s_phi * z40;
    const double z42 = k1 * z41;
    const double z43 = z39 * z19 + z20 * z40;
    const double z44 = s_phi * z43;
    const double z45 = z5 * z44;
    const double z46 = c_phi * (w_x * z31 - (w_y * z32 - z17 * z40 + z7 * z42 + z8 * z43 + z45));
    const double z47 = k1 * z44;
    const double z48 = z46 + s_phi * (w_y * z31 + (w_x * z32 - z5 * z41 + z7 * z47));
    const double z49 = k2 * (s_psi * z38);
    const double z50 = k3 * (c_theta * z38) + z29 * z49;
    const double z51 = c_psi * z49;
    const double z52 = c_phi * z40;
    const double z53 = k1 * (z44 - z52);
    const double z54 = c_phi * (w_x * z50 - (w_y * z51 + z17 * z43 - z7 * z53)) + s_phi * (w_y * z50 + (z45 +
        (w_x * z51 + (z15 * z40 + z14 * z52))));
    const double z55 = z33 * (z54 - z20 * z48);
    const double z56 = z24 * z30;
    const double z57 = k2 * z40 - s_phi * z42 - c_phi * z47;
    const double z58 = c_phi * z41 - s_phi * z44;
    const double z59 = I1 * z58;
    const double z60 = I2 * z58;
    const double z61 = s_theta * (z28 * z36 + s_psi * z56 + z6 * z57) - c_theta * (w_y * z37 - 2.0 * (s_theta
        * (I3 * z58 - z2 * z59 - z3 * z60)));
    const double z62 = z24 * z49;
    const double z63 = c_phi * z52;
    const double z64 = k2 * z43 - s_phi * z53;
    const double z65 = s_psi * z62 + (z36 * z38 - 2.0 * (c_theta * (k2 * (z2 * z63) + k3 * z63))) - z6 * z64;
    const double z66 = c_phi * z44;
    const double z67 = I1 * z66;
    const double z68 = I2 * z66;
    const double z69 = s_theta * z65 - c_theta * (w_x * z37 + 2.0 * (s_theta * (I3 * z66 - z2 * z67 - z3 *
        z68)));
    const double z70 = z33 * (z69 - z20 * z61);
    const double z71 = c_theta * z57;
    const double z72 = 2.0 * (s_psi * (2.0 * z60 + (I2 * z43 - z4 * z59) - (I1 * z43 + z1 * z60)));
    const double z73 = s_psi * (z34 * z30 - s_psi * z71) + c_psi * (z28 * z35 + c_theta * z56 + c_psi * z71 +
        z72);
    const double z74 = c_theta * z64;
    const double z75 = 2.0 * z68 + (z13 * z63 + I2 * z40 - z4 * z67) - (I1 * z40 + z1 * z68);
    const double z76 = s_psi * (z34 * z49 + s_psi * z74) + c_psi * (z35 * z38 + c_theta * z62 - c_psi * z74 -
        2.0 * (s_psi * z75));
    const double z77 = z33 * (z76 - z20 * z73);
    const double z78 = c_phi * z32 - s_phi * z31;
    const double z79 = s_theta * z37;
    const double z80 = z33 * (z79 - c_phi * z51 + s_phi * z50 + z20 * z78);
    const double z81 = s_phi * z32 - z79 + c_phi * z31;
    const double z82 = z33 * (s_phi * z51 + c_phi * z50 - z20 * z81);
    /* (I.2.15) */
    J[0] = -(c_phi * (w_x * z23) + s_phi * (w_y * z23));
    J[1] = z24 + c_theta * (z25 * (c_theta * z24));
    J[2] = 0.0;
    J[3] = -s_phi * z23;
    J[4] = c_phi * z23;
    J[5] = -z24;
    J[6] = -c_theta * ((s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z25 - z26 - z27);
    J[7] = 0.0;
    J[8] = c_phi;
    J[9] = s_phi;
    J[10] = z26 + z27;
    J[11] = -c_theta * (z24 * z25);
    J[12] = 0.0;
    J[13] = s_phi * z22;
    J[14] = -c_phi * z22;
    J[15] = -(z19 * z48 + z20 * z55);
    J[16] = z19 * z61 + z20 * z70;
    J[17] = -(z19 * z73 + z20 * z77);
    J[18] = z19 * z78 - z20 * z80;
    J[19] = z19 * z81 + z20 * z82;
    J[20] = -z55;
    J[21] = z70;
    J[22] = -z77;
    J[23] = -z80;
    J[24] = z82;
    return veselova_finish(25, J);
}

int veselova_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double phi = y[0]; /* precession [rad] */
    const double theta = y[1]; /* nutation [rad] */
    const double psi = y[2]; /* spin [rad] */
    const double w_x = y[3];
    const double w_y = y[4];
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12 * 4.0)) {
        return VESELOVA_SINGULAR_1;
    }
    const double c_phi = cos(phi);
    const double c_psi = cos(psi);
    const double s_psi = sin(psi);
    const double c_theta = cos(theta);
    const double z1 = 1.0 / s_theta;
    const double s_phi = sin(phi);
    const double z2 = z1 * (s_phi * w_x - c_phi * w_y);
    const double z3 = c_theta * z2;
    const double z4 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1;
    const double z5 = I1 * (s_theta * s_psi * z3 - c_psi * z4);
    const double z6 = I2 * (s_theta * c_psi * z3 + s_psi * z4);
    const double z7 = c_psi * z5 - s_psi * z6;
    const double z8 = c_theta * (s_psi * z5 + c_psi * z6) + s_theta * (I3 * (z2 - c_theta * z3));
    /* 32:8 */
    out[0] = s_phi * z8 - c_phi * z7; /* L_x */
    /* 33:8 */
    out[1] = -(s_phi * z7 + c_phi * z8); /* L_y */
    return veselova_finish(2, out);
}

int veselova_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
    const double I1 = p[0]; /* [kg*m^2] */
    const double I2 = p[1]; /* [kg*m^2] */
    const double I3 = p[2]; /* [kg*m^2] */
    const double k1 = 2.0 * I1 - 2.0 * I2;
    const double k2 = I1 - I2;
    const double k3 = I2 - I3;
    int singular1 = 0;
    int singular2 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double phi = y[i]; /* precession [rad] */
        const double theta = y[count + i]; /* nutation [rad] */
        const double psi = y[2 * count + i]; /* spin [rad] */
        const double w_x = y[3 * count + i];
        const double w_y = y[4 * count + i];
        const double s_theta = sin(theta);
        /* the coframe is singular */
        singular1 |= !(fabs(s_theta) > 1e-12 * 4.0);
        const double s_phi = sin(phi);
        const double z1 = s_theta * s_theta;
        const double s_psi = sin(psi);
        const double z2 = s_psi * s_psi;
        const double z3 = 1.0 - z2;
        const double z4 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + (I1 * (1.0 - z2 * (2.0 - z1)) - I3 * z1);
        const double c_phi = cos(phi);
        const double c_theta = cos(theta);
        const double c_psi = cos(psi);
        const double z5 = c_theta * (s_psi * c_psi);
        const double z6 = I1 * z3 + I2 * z2;
        const double z7 = s_phi * (s_phi * z4 + c_phi * z5 * k1) - z6;
        /* the mass matrix is singular */
        singular2 |= !(fabs(-z7) > 0.0);
        const double z8 = k1 * (s_phi * z5);
        const double z9 = c_theta * c_theta;
        const double z10 = z8 + c_phi * (z2 * (k2 * (1.0 + z9)) + (I3 * (1.0 - z9) - (I1 - I2 * z9)));
        const double z11 = z6 + c_phi * z10;
        const double z12 = s_phi * (c_phi * z4 - z8) + z5 * k2;
        const double z13 = 1.0 / z7;
        const double z14 = z12 * z13;
        const double z15 = z11 + z12 * z14;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z15) > 1e-14 * z11);
        const double z16 = 1.0 / s_theta;
        const double z17 = s_phi * w_x - c_phi * w_y;
        const double z18 = z16 * z17;
        const double z19 = s_psi * (k2 * (z17 * (s_psi * c_theta) - c_psi * (c_phi * w_x + s_phi * w_y))) +
            c_theta * (z17 * k3);
        const double z20 = s_theta * w_y * z19;
        const double z21 = (z19 * (s_theta * w_x) - z20 * z14) / z15;
        /* (I.2.15) */
        const double slope1 = -c_theta * z18; /* phi' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z16; /* theta' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z18; /* psi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (I.2.15) 24:4 */
        const double slope4 = -(z20 * z13 + z14 * z21); /* w_x' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -z21; /* w_y' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    if (singular1) {
        return VESELOVA_SINGULAR_1;
    }
    if (singular2) {
        return VESELOVA_SINGULAR_2;
    }
    return bad ? VESELOVA_NOT_FINITE : VESELOVA_OK;
}
