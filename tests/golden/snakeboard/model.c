/*
 * snakeboard.c: snakeboard, emitted by nhc 0.1.0 (nhc:659df811ddb77a3d)
 * A board on two steerable axles and a rotor; it moves by turning the rotor and the axles to and fro.
 * Source: snakeboard.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, psi', p_b', p_f': the dependent velocities of the spec (x', y') are
 *     singular somewhere
 * snakeboard.h says what each function does.
 */
#include "snakeboard.h"

#include <float.h>
#include <math.h>

const char *const snakeboard_coordinate_names[] = {
    "x",
    "y",
    "theta",
    "psi",
    "p_b",
    "p_f"
};
const char *const snakeboard_state_names[] = {
    "x",
    "y",
    "theta",
    "psi",
    "p_b",
    "p_f",
    "v",
    "psi'",
    "p_b'",
    "p_f'"
};
const char *const snakeboard_parameter_names[] = {
    "m",
    "l",
    "J",
    "J_r",
    "J_w",
    "tau",
    "sigma",
    "nu"
};
const double snakeboard_parameter_defaults[] = {
    1.0,
    0.5,
    0.1,
    0.05,
    0.02,
    0.05,
    0.02,
    1.0
};

static int snakeboard_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? SNAKEBOARD_OK : SNAKEBOARD_NOT_FINITE;
}

int snakeboard_rhs(double t, const double *y, const double *p, double *dydt)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;

    /* state */
    const double c_p_b = cos(p_b);
    const double c_p_f = cos(p_f);
    const double z1 = c_p_b * c_p_f;
    const double z2 = theta + p_b;
    const double s1 = sin(z2);
    const double z3 = theta + p_f;
    const double s2 = sin(z3);
    const double c1 = cos(z2);
    const double c2 = cos(z3);
    const double z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2);
    const double s_p_f = sin(p_f);
    const double s_p_b = sin(p_b);
    const double z5 = s2 * s2;
    const double z6 = 1.0 - 2.0 * z5;
    const double z7 = c1 * s2;
    const double z8 = s1 * z6 - 2.0 * (c2 * z7);
    const double z9 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))) + (z5 + s1 * z8);
    /* the coframe is singular */
    if (!(fabs(-z9) > 1e-12 * (k3 * ((2.0 + 4.0 * k2) * k3)))) {
        return SNAKEBOARD_SINGULAR_1;
    }
    const double z10 = s1 * c2 - z7;
    const double z11 = 1.0 / z9;
    const double z12 = z10 * z11;
    const double z13 = J_w * z12;
    const double z14 = z12 * z13;
    const double z15 = l * c_p_f;
    const double z16 = l * c_p_b;
    const double z17 = c1 * z15 + z16 * c2;
    const double z18 = z17 * z11;
    const double z19 = s1 * z15 + z16 * s2;
    const double z20 = z19 * z11;
    const double z21 = J_r * z12;
    const double z22 = z18 * (m * z18) + z20 * (m * z20) + z12 * (J * z12) + z12 * z21 + z14;
    const double z23 = z14 + z22;
    /* the mass matrix is singular */
    if (!(fabs(z23) > 0.0)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z24 = 1.0 / z23;
    const double z25 = z21 * z24;
    const double z26 = J_r - z21 * z25;
    /* the mass matrix is singular */
    if (!(fabs(z26) > 1e-14 * J_r)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z27 = z13 * z24;
    const double z28 = z13 * z27;
    const double z29 = z21 * z27;
    const double z30 = 1.0 / z26;
    const double z31 = z29 * z30;
    const double z32 = z29 * z31;
    const double z33 = J_w - z28 - z32;
    /* the mass matrix is singular */
    if (!(fabs(z33) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z34 = z28 + z32;
    const double z35 = 1.0 / z33;
    const double z36 = z34 * z35;
    const double z37 = z33 - z34 * z36;
    /* the mass matrix is singular */
    if (!(fabs(z37) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z38 = z17 * v;
    const double z39 = z19 * v;
    const double z40 = z10 * v;
    const double z41 = z11 * z40;
    const double z42 = p_b_dot * s_p_b;
    const double z43 = p_f_dot * s_p_f;
    const double z44 = p_b_dot - z41;
    const double z45 = c1 * z44;
    const double z46 = p_f_dot - z41;
    const double z47 = c2 * z46;
    const double z48 = s1 * z44;
    const double z49 = s2 * z46;
    const double z50 = z4 * (c_p_f * z42 + c_p_b * z43) - z1 * (2.0 * (s2 * z45 + s1 * z47) - 2.0 * (c2 * z48
        + c1 * z49));
    const double z51 = s2 * z47;
    const double z52 = s2 * z48 - c1 * z47;
    const double z53 = z8 * z45 + s1 * (z6 * z45 - 4.0 * (s1 * z51) + 2.0 * (z7 * z49 + c2 * z52));
    const double z54 = k1 * (z50 + (2.0 * (s_p_b * (p_b_dot * c_p_b)) + 2.0 * (s_p_f * (p_f_dot * c_p_f)))) -
        (2.0 * z51 + z53);
    const double z55 = z54 / (z9 * z9);
    const double z56 = z40 * z55 + z11 * (v * (c2 * z45 - s1 * z49 + z52));
    const double z57 = J_w * z56;
    const double z58 = z12 * z57;
    const double z59 = J_r * z56;
    const double z60 = l * z43;
    const double z61 = l * z42;
    const double z62 = z11 * (v * (z15 * z48 + c1 * z60 + (c2 * z61 + z16 * z49))) - z38 * z55;
    const double z63 = z39 * z55 + z11 * (v * (z15 * z45 - s1 * z60 - (s2 * z61 - z16 * z47)));
    const double z64 = z58 + (z12 * z59 + (z12 * (J * z56) - (z18 * (m * z62) - z20 * (m * z63))));
    const double z65 = z58 + z64;
    const double z66 = t * nu;
    const double s3 = sin(z66);
    const double z67 = tau * s3 + z59 - z65 * z25;
    const double c3 = cos(z66);
    const double z68 = sigma * c3;
    const double z69 = z65 * z27;
    const double z70 = z31 * z67;
    const double z71 = z68 + z57 - z69 + z70;
    const double z72 = (z70 - (z68 - z57 + z69) + z36 * z71) / z37;
    const double z73 = z35 * z71 + z36 * z72;
    const double z74 = z30 * z67 + z31 * z73 + z31 * z72;
    /* (I.2.15) */
    dydt[0] = z38 * z11; /* x' */
    dydt[1] = z11 * z39; /* y' */
    dydt[2] = -z41; /* theta' */
    dydt[3] = psi_dot; /* psi' */
    dydt[4] = p_b_dot; /* p_b' */
    dydt[5] = p_f_dot; /* p_f' */
    /* (I.2.15) 22:4 */
    dydt[6] = z27 * z72 - (z65 * z24 - z25 * z74 - z27 * z73); /* v' */
    dydt[7] = z74; /* psi'' */
    dydt[8] = z73; /* p_b'' */
    dydt[9] = z72; /* p_f'' */
    return snakeboard_finish(10, dydt);
}

int snakeboard_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;

    /* state */
    const double c_p_b = cos(p_b);
    const double c_p_f = cos(p_f);
    const double z1 = theta + p_b;
    const double s1 = sin(z1);
    const double z2 = theta + p_f;
    const double s2 = sin(z2);
    const double c1 = cos(z1);
    const double c2 = cos(z2);
    const double s_p_f = sin(p_f);
    const double s_p_b = sin(p_b);
    const double z3 = c_p_b * c_p_f * (2.0 * (s1 * s2) + 2.0 * (c1 * c2)) - (s_p_f * s_p_f - (2.0 - s_p_b *
        s_p_b));
    const double z4 = s2 * s2;
    const double z5 = c1 * s2;
    const double z6 = k1 * z3 + (z4 + s1 * (s1 * (1.0 - 2.0 * z4) - 2.0 * (c2 * z5)));
    /* the coframe is singular */
    if (!(fabs(-z6) > 1e-12 * (k3 * ((2.0 + 4.0 * k2) * k3)))) {
        return SNAKEBOARD_SINGULAR_1;
    }
    const double z7 = l * c_p_f;
    const double z8 = l * c_p_b;
    const double z9 = 1.0 / z6;
    /* (I.2.4) */
    qdot[0] = (c1 * z7 + z8 * c2) * v * z9; /* x' */
    qdot[1] = z9 * ((s1 * z7 + z8 * s2) * v); /* y' */
    qdot[2] = -z9 * ((s1 * c2 - z5) * v); /* theta' */
    qdot[3] = psi_dot; /* psi' */
    qdot[4] = p_b_dot; /* p_b' */
    qdot[5] = p_f_dot; /* p_f' */
    return snakeboard_finish(6, qdot);
}

int snakeboard_accelerations(double t, const double *y, const double *p, double *qddot)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double v = y[6];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;

    /* state */
    const double c_p_b = cos(p_b);
    const double c_p_f = cos(p_f);
    const double z1 = c_p_b * c_p_f;
    const double z2 = theta + p_b;
    const double s1 = sin(z2);
    const double z3 = theta + p_f;
    const double s2 = sin(z3);
    const double c1 = cos(z2);
    const double c2 = cos(z3);
    const double z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2);
    const double s_p_f = sin(p_f);
    const double s_p_b = sin(p_b);
    const double z5 = s2 * s2;
    const double z6 = 1.0 - 2.0 * z5;
    const double z7 = c1 * s2;
    const double z8 = s1 * z6 - 2.0 * (c2 * z7);
    const double z9 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))) + (z5 + s1 * z8);
    /* the coframe is singular */
    if (!(fabs(-z9) > 1e-12 * (k3 * ((2.0 + 4.0 * k2) * k3)))) {
        return SNAKEBOARD_SINGULAR_1;
    }
    const double z10 = s1 * c2 - z7;
    const double z11 = 1.0 / z9;
    const double z12 = z10 * z11;
    const double z13 = J_w * z12;
    const double z14 = z12 * z13;
    const double z15 = l * c_p_f;
    const double z16 = l * c_p_b;
    const double z17 = c1 * z15 + z16 * c2;
    const double z18 = z17 * z11;
    const double z19 = s1 * z15 + z16 * s2;
    const double z20 = z19 * z11;
    const double z21 = J_r * z12;
    const double z22 = z18 * (m * z18) + z20 * (m * z20) + z12 * (J * z12) + z12 * z21 + z14;
    const double z23 = z14 + z22;
    /* the mass matrix is singular */
    if (!(fabs(z23) > 0.0)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z24 = 1.0 / z23;
    const double z25 = z21 * z24;
    const double z26 = J_r - z21 * z25;
    /* the mass matrix is singular */
    if (!(fabs(z26) > 1e-14 * J_r)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z27 = z13 * z24;
    const double z28 = z13 * z27;
    const double z29 = z21 * z27;
    const double z30 = 1.0 / z26;
    const double z31 = z29 * z30;
    const double z32 = z29 * z31;
    const double z33 = J_w - z28 - z32;
    /* the mass matrix is singular */
    if (!(fabs(z33) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z34 = z28 + z32;
    const double z35 = 1.0 / z33;
    const double z36 = z34 * z35;
    const double z37 = z33 - z34 * z36;
    /* the mass matrix is singular */
    if (!(fabs(z37) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z38 = p_b_dot * s_p_b;
    const double z39 = p_f_dot * s_p_f;
    const double z40 = z10 * v;
    const double z41 = z11 * z40;
    const double z42 = p_b_dot - z41;
    const double z43 = c1 * z42;
    const double z44 = p_f_dot - z41;
    const double z45 = c2 * z44;
    const double z46 = s1 * z42;
    const double z47 = s2 * z44;
    const double z48 = z4 * (c_p_f * z38 + c_p_b * z39) - z1 * (2.0 * (s2 * z43 + s1 * z45) - 2.0 * (c2 * z46
        + c1 * z47));
    const double z49 = s2 * z45;
    const double z50 = s2 * z46 - c1 * z45;
    const double z51 = z8 * z43 + s1 * (z6 * z43 - 4.0 * (s1 * z49) + 2.0 * (z7 * z47 + c2 * z50));
    const double z52 = k1 * (z48 + (2.0 * (s_p_b * (p_b_dot * c_p_b)) + 2.0 * (s_p_f * (p_f_dot * c_p_f)))) -
        (2.0 * z49 + z51);
    const double z53 = z52 / (z9 * z9);
    const double z54 = z17 * v * z53;
    const double z55 = l * z39;
    const double z56 = l * z38;
    const double z57 = v * (z15 * z46 + c1 * z55 + (c2 * z56 + z16 * z47));
    const double z58 = z40 * z53;
    const double z59 = v * (c2 * z43 - s1 * z47 + z50);
    const double z60 = z58 + z11 * z59;
    const double z61 = J_w * z60;
    const double z62 = z12 * z61;
    const double z63 = J_r * z60;
    const double z64 = z19 * v * z53;
    const double z65 = v * (z15 * z43 - s1 * z55 - (s2 * z56 - z16 * z45));
    const double z66 = z12 * (J * z60) - (z18 * (m * (z11 * z57 - z54)) - z20 * (m * (z64 + z11 * z65)));
    const double z67 = z62 + (z62 + (z12 * z63 + z66));
    const double z68 = t * nu;
    const double s3 = sin(z68);
    const double z69 = tau * s3 + z63 - z67 * z25;
    const double c3 = cos(z68);
    const double z70 = sigma * c3;
    const double z71 = z67 * z27;
    const double z72 = z31 * z69;
    const double z73 = z70 + z61 - z71 + z72;
    const double z74 = (z72 - (z70 - z61 + z71) + z36 * z73) / z37;
    const double z75 = z35 * z73 + z36 * z74;
    const double z76 = z30 * z69 + z31 * z75 + z31 * z74;
    const double z77 = z67 * z24 - z25 * z76 - z27 * z75 - z27 * z74;
    /* (I.2.15) */
    qddot[0] = z54 - z11 * (z57 + z17 * z77); /* x'' */
    qddot[1] = z64 + z11 * (z65 - z19 * z77); /* y'' */
    qddot[2] = -(z58 + z11 * (z59 - z10 * z77)); /* theta'' */
    qddot[3] = z76; /* psi'' */
    qddot[4] = z75; /* p_b'' */
    qddot[5] = z74; /* p_f'' */
    return snakeboard_finish(6, qddot);
}

int snakeboard_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    const double x = q[0]; /* centre of the board [m] */
    const double y_2 = q[1]; /* centre of the board [m] */
    const double theta = q[2]; /* heading of the board [rad] */
    const double psi = q[3]; /* rotor, relative to the board [rad] */
    const double p_b = q[4]; /* back axle, relative to the board [rad] */
    const double p_f = q[5]; /* front axle, relative to the board [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];
    const double psi_dot = qdot[3];
    const double p_b_dot = qdot[4];
    const double p_f_dot = qdot[5];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* state */
    const double z1 = theta + p_b;
    const double s1 = sin(z1);
    const double z2 = theta + p_f;
    const double c1 = cos(z2);
    const double c2 = cos(z1);
    const double s2 = sin(z2);
    const double c_p_f = cos(p_f);
    const double c_p_b = cos(p_b);
    const double z3 = x_dot * (l * (c2 * c_p_f + c_p_b * c1)) + y_dot * (l * (s1 * c_p_f + c_p_b * s2));
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = psi;
    y[4] = p_b;
    y[5] = p_f;
    y[6] = z3 - theta_dot * (s1 * c1 - c2 * s2);
    y[7] = psi_dot;
    y[8] = p_b_dot;
    y[9] = p_f_dot;
    return snakeboard_finish(10, y);
}

int snakeboard_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta = q[2]; /* heading of the board [rad] */
    const double p_b = q[4]; /* back axle, relative to the board [rad] */
    const double p_f = q[5]; /* front axle, relative to the board [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* state */
    const double z1 = theta + p_b;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_p_b = cos(p_b);
    const double z2 = theta + p_f;
    const double s2 = sin(z2);
    const double c2 = cos(z2);
    const double c_p_f = cos(p_f);
    /* (I.1.1) 28:5 */
    r[0] = -(x_dot * s1 - y_dot * c1 + theta_dot * (l * c_p_b)); /* back = 0 */
    /* (I.1.1) 29:5 */
    r[1] = theta_dot * (l * c_p_f) - (x_dot * s2 - y_dot * c2); /* front = 0 */
    return snakeboard_finish(2, r);
}

int snakeboard_reactions(double t, const double *y, const double *p, double *lambda)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double v = y[6];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;

    /* state */
    const double c_p_b = cos(p_b);
    const double c_p_f = cos(p_f);
    const double z1 = c_p_b * c_p_f;
    const double z2 = theta + p_b;
    const double s1 = sin(z2);
    const double z3 = theta + p_f;
    const double s2 = sin(z3);
    const double c1 = cos(z2);
    const double c2 = cos(z3);
    const double z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2);
    const double s_p_f = sin(p_f);
    const double s_p_b = sin(p_b);
    const double z5 = s2 * s2;
    const double z6 = 1.0 - 2.0 * z5;
    const double z7 = c1 * s2;
    const double z8 = s1 * z6 - 2.0 * (c2 * z7);
    const double z9 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))) + (z5 + s1 * z8);
    /* the coframe is singular */
    if (!(fabs(-z9) > 1e-12 * (k3 * ((2.0 + 4.0 * k2) * k3)))) {
        return SNAKEBOARD_SINGULAR_1;
    }
    const double z10 = s1 * c2 - z7;
    const double z11 = 1.0 / z9;
    const double z12 = z10 * z11;
    const double z13 = J_w * z12;
    const double z14 = z12 * z13;
    const double z15 = l * c_p_f;
    const double z16 = l * c_p_b;
    const double z17 = c1 * z15 + z16 * c2;
    const double z18 = z17 * z11;
    const double z19 = m * z18;
    const double z20 = s1 * z15 + z16 * s2;
    const double z21 = z20 * z11;
    const double z22 = m * z21;
    const double z23 = J * z12;
    const double z24 = J_r * z12;
    const double z25 = z14 + (z18 * z19 + z21 * z22 + z12 * z23 + z12 * z24 + z14);
    /* the mass matrix is singular */
    if (!(fabs(z25) > 0.0)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z26 = 1.0 / z25;
    const double z27 = z24 * z26;
    const double z28 = J_r - z24 * z27;
    /* the mass matrix is singular */
    if (!(fabs(z28) > 1e-14 * J_r)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z29 = z13 * z26;
    const double z30 = z13 * z29;
    const double z31 = z24 * z29;
    const double z32 = 1.0 / z28;
    const double z33 = z31 * z32;
    const double z34 = z31 * z33;
    const double z35 = J_w - z30 - z34;
    /* the mass matrix is singular */
    if (!(fabs(z35) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z36 = z30 + z34;
    const double z37 = 1.0 / z35;
    const double z38 = z36 * z37;
    const double z39 = z35 - z36 * z38;
    /* the mass matrix is singular */
    if (!(fabs(z39) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z40 = l * (c1 * c_p_f + c_p_b * c2);
    const double z41 = l * (s1 * c_p_f + c_p_b * s2);
    const double z42 = z11 * (c2 * z40 + s2 * z41);
    const double z43 = z10 * v;
    const double z44 = p_b_dot * s_p_b;
    const double z45 = p_f_dot * s_p_f;
    const double z46 = z11 * z43;
    const double z47 = p_b_dot - z46;
    const double z48 = c1 * z47;
    const double z49 = p_f_dot - z46;
    const double z50 = c2 * z49;
    const double z51 = s1 * z47;
    const double z52 = s2 * z49;
    const double z53 = z4 * (c_p_f * z44 + c_p_b * z45) - z1 * (2.0 * (s2 * z48 + s1 * z50) - 2.0 * (c2 * z51
        + c1 * z52));
    const double z54 = s2 * z50;
    const double z55 = s2 * z51 - c1 * z50;
    const double z56 = z8 * z48 + s1 * (z6 * z48 - 4.0 * (s1 * z54) + 2.0 * (z7 * z52 + c2 * z55));
    const double z57 = k1 * (z53 + (2.0 * (s_p_b * (p_b_dot * c_p_b)) + 2.0 * (s_p_f * (p_f_dot * c_p_f)))) -
        (2.0 * z54 + z56);
    const double z58 = z57 / (z9 * z9);
    const double z59 = z43 * z58 + z11 * (v * (c2 * z48 - s1 * z52 + z55));
    const double z60 = J_w * z59;
    const double z61 = z42 * z60;
    const double z62 = J_r * z59;
    const double z63 = J * z59;
    const double z64 = z11 * (z15 * z41 + c2 * z10);
    const double z65 = l * z45;
    const double z66 = l * z44;
    const double z67 = z11 * (v * (z15 * z51 + c1 * z65 + (c2 * z66 + z16 * z52))) - z17 * v * z58;
    const double z68 = m * z67;
    const double z69 = z11 * (z15 * z40 - s2 * z10);
    const double z70 = z20 * v * z58 + z11 * (v * (z15 * z48 - s1 * z65 - (s2 * z66 - z16 * z50)));
    const double z71 = m * z70;
    const double z72 = J_w * z42;
    const double z73 = t * nu;
    const double s3 = sin(z73);
    const double z74 = z12 * z60;
    const double z75 = z74 + (z74 + (z12 * z62 + (z12 * z63 - (z18 * z68 - z21 * z71))));
    const double z76 = tau * s3 + z62 - z75 * z27;
    const double z77 = z33 * z76;
    const double c3 = cos(z73);
    const double z78 = sigma * c3;
    const double z79 = z75 * z29;
    const double z80 = z78 + z60 - z79 + z77;
    const double z81 = (z77 - (z78 - z60 + z79) + z38 * z80) / z39;
    const double z82 = z37 * z80 + z38 * z81;
    const double z83 = z42 * z13;
    const double z84 = z32 * z76 + z33 * z82 + z33 * z81;
    const double z85 = z75 * z26 - z27 * z84 - z29 * z82 - z29 * z81;
    const double z86 = (z83 - (z64 * z19 - z69 * z22 - z42 * z23 - z42 * z24 - z83)) * z85 + J_r * z42 * z84;
    const double z87 = z61 + (z61 + (z42 * z62 + (z42 * z63 + (z64 * z68 + z69 * z71)))) - (z72 * z81 + (z72
        * z82 + z86));
    const double z88 = z11 * (c1 * z40 + s1 * z41);
    const double z89 = z88 * z60;
    const double z90 = z11 * (z16 * z41 - c1 * z10);
    const double z91 = z11 * (z16 * z40 + s1 * z10);
    const double z92 = J_w * z88;
    const double z93 = z88 * z13;
    const double z94 = (z93 + (z90 * z19 - z91 * z22 + z88 * z23 + z88 * z24 + z93)) * z85 + J_r * z88 * z84;
    const double z95 = z89 + (z89 + (z88 * z62 + (z88 * z63 - (z90 * z68 + z91 * z71)))) - (z92 * z81 + (z92
        * z82 + z94));
    /* (I.4.1) 28:5 */
    lambda[0] = z87; /* reaction of back: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 29:5 */
    lambda[1] = -z95; /* reaction of front: Q_i gains lambda_2 a_2i */
    return snakeboard_finish(2, lambda);
}

double snakeboard_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double v = y[6];
    const double psi_dot = y[7];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */

    /* parameters only */
    const double k1 = l * l;

    /* state */
    const double z1 = theta + p_b;
    const double c1 = cos(z1);
    const double c_p_f = cos(p_f);
    const double z2 = l * c_p_f;
    const double c_p_b = cos(p_b);
    const double z3 = l * c_p_b;
    const double z4 = theta + p_f;
    const double c2 = cos(z4);
    const double s1 = sin(z1);
    const double s2 = sin(z4);
    const double s_p_f = sin(p_f);
    const double s_p_b = sin(p_b);
    const double z5 = c_p_b * c_p_f * (2.0 * (s1 * s2) + 2.0 * (c1 * c2)) - (s_p_f * s_p_f - (2.0 - s_p_b *
        s_p_b));
    const double z6 = s2 * s2;
    const double z7 = c1 * s2;
    const double z8 = 1.0 / (k1 * z5 + (z6 + s1 * (s1 * (1.0 - 2.0 * z6) - 2.0 * (c2 * z7))));
    const double z9 = (c1 * z2 + z3 * c2) * v * z8;
    const double z10 = z8 * ((s1 * z2 + z3 * s2) * v);
    const double z11 = z8 * ((s1 * c2 - z7) * v);
    const double z12 = psi_dot - z11;
    const double z13 = 0.5 * (m * (z9 * z9 + z10 * z10)) + 0.5 * (J * (z11 * z11)) + 0.5 * (J_r * (z12 *
        z12));
    const double z14 = p_b_dot - z11;
    const double z15 = p_f_dot - z11;
    return z13 + 0.5 * (J_w * (z14 * z14 + z15 * z15));
}

int snakeboard_jacobian(double t, const double *y, const double *p, double *J)
{
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double v = y[6];
    const double p_b_dot = y[8];
    const double p_f_dot = y[9];
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J_2 = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;

    /* state */
    const double c_p_b = cos(p_b);
    const double c_p_f = cos(p_f);
    const double z1 = c_p_b * c_p_f;
    const double z2 = theta + p_b;
    const double s1 = sin(z2);
    const double z3 = theta + p_f;
    const double s2 = sin(z3);
    const double c1 = cos(z2);
    const double c2 = cos(z3);
    const double z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2);
    const double s_p_f = sin(p_f);
    const double s_p_b = sin(p_b);
    const double z5 = s2 * s2;
    const double z6 = 1.0 - 2.0 * z5;
    const double z7 = c1 * s2;
    const double z8 = s1 * z6 - 2.0 * (c2 * z7);
    const double z9 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))) + (z5 + s1 * z8);
    /* the coframe is singular */
    if (!(fabs(-z9) > 1e-12 * (k3 * ((2.0 + 4.0 * k2) * k3)))) {
        return SNAKEBOARD_SINGULAR_1;
    }
    const double z10 = s1 * c2 - z7;
    const double z11 = 1.0 / z9;
    const double z12 = z10 * z11;
    const double z13 = J_w * z12;
    const double z14 = z12 * z13;
    const double z15 = l * c_p_f;
    const double z16 = l * c_p_b;
    const double z17 = c1 * z15 + z16 * c2;
    const double z18 = z17 * z11;
    const double z19 = m * z18;
    const double z20 = s1 * z15 + z16 * s2;
    const double z21 = z20 * z11;
    const double z22 = m * z21;
    const double z23 = J_2 * z12;
    const double z24 = J_r * z12;
    const double z25 = z14 + (z18 * z19 + z21 * z22 + z12 * z23 + z12 * z24 + z14);
    /* the mass matrix is singular */
    if (!(fabs(z25) > 0.0)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z26 = 1.0 / z25;
    const double z27 = z24 * z26;
    const double z28 = J_r - z24 * z27;
    /* the mass matrix is singular */
    if (!(fabs(z28) > 1e-14 * J_r)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z29 = z13 * z26;
    const double z30 = z13 * z29;
    const double z31 = z24 * z29;
    const double z32 = 1.0 / z28;
    const double z33 = z31 * z32;
    const double z34 = z31 * z33;
    const double z35 = J_w - z30 - z34;
    /* the mass matrix is singular */
    if (!(fabs(z35) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    const double z36 = z30 + z34;
    const double z37 = 1.0 / z35;
    const double z38 = z36 * z37;
    const double z39 = z35 - z36 * z38;
    /* the mass matrix is singular */
    if (!(fabs(z39) > 1e-14 * J_w)) {
        return SNAKEBOARD_SINGULAR_2;
    }
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    const double z40 = z17 * v;
    const double z41 = 1.0 / (z9 * z9);
    const double z42 = z40 * z41;
    const double z43 = s1 * z42;
    const double z44 = k1 * z42;
    const double z45 = z1 * z44;
    const double z46 = v * z11;
    const double z47 = z16 * z46;
    const double z48 = c2 * z43;
    const double z49 = 2.0 * (s2 * (z42 - 2.0 * (s1 * z43))) + 2.0 * (s1 * z45) - 2.0 * (c1 * z48);
    const double z50 = s2 * (2.0 * (z7 * z43) - 2.0 * (c1 * z45) + z47) + c2 * z49;
    const double z51 = z15 * z46;
    const double z52 = s1 * (2.0 * (c2 * z45) - z51 - 2.0 * (s2 * z48)) - c1 * (z8 * z42 + z6 * z43 + 2.0 *
        (s2 * z45));
    J[2] = z52 - z50;
    J[3] = 0.0;
    const double z53 = z4 * z44;
    const double z54 = c2 * z46;
    J[4] = 2.0 * (c_p_b * (s_p_b * z44)) + s_p_b * (c_p_f * z53 - l * z54) + z52;
    J[5] = 2.0 * (c_p_f * (s_p_f * z44)) + s_p_f * (c_p_b * z53 - l * (c1 * z46)) - z50;
    J[6] = z18;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 0.0;
    const double z55 = z20 * v;
    const double z56 = z55 * z41;
    const double z57 = s1 * z56;
    const double z58 = k1 * z56;
    const double z59 = z1 * z58;
    const double z60 = c2 * z57;
    const double z61 = z47 - (2.0 * (s2 * (z56 - 2.0 * (s1 * z57))) + 2.0 * (s1 * z59)) + 2.0 * (c1 * z60);
    const double z62 = s2 * (2.0 * (z7 * z57) - 2.0 * (c1 * z59)) - c2 * z61;
    const double z63 = s1 * (2.0 * (c2 * z59) - 2.0 * (s2 * z60)) + c1 * (z51 - (z8 * z56 + z6 * z57 + 2.0 *
        (s2 * z59)));
    J[12] = z63 - z62;
    J[13] = 0.0;
    const double z64 = z4 * z58;
    J[14] = 2.0 * (c_p_b * (s_p_b * z58)) + s_p_b * (c_p_f * z64 - l * (s2 * z46)) + z63;
    const double z65 = s1 * z46;
    J[15] = 2.0 * (c_p_f * (s_p_f * z58)) + s_p_f * (c_p_b * z64 - l * z65) - z62;
    J[16] = z21;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = 0.0;
    const double z66 = z10 * v;
    const double z67 = z66 * z41;
    const double z68 = s1 * z67;
    const double z69 = k1 * z67;
    const double z70 = z1 * z69;
    const double z71 = z46 - 2.0 * (c2 * z68);
    const double z72 = c2 * (2.0 * (s2 * (z67 - 2.0 * (s1 * z68))) + 2.0 * (s1 * z70) + c1 * z71);
    const double z73 = s2 * (z65 + (2.0 * (z7 * z68) - 2.0 * (c1 * z70))) + z72;
    const double z74 = s1 * (2.0 * (c2 * z70) + s2 * z71) + c1 * (z54 - (z8 * z67 + z6 * z68 + 2.0 * (s2 *
        z70)));
    J[22] = z73 - z74;
    J[23] = 0.0;
    const double z75 = z4 * z69;
    J[24] = -(2.0 * (c_p_b * (s_p_b * z69)) + s_p_b * (c_p_f * z75) + z74);
    J[25] = z73 - (2.0 * (c_p_f * (s_p_f * z69)) + s_p_f * (c_p_b * z75));
    J[26] = -z12;
    J[27] = 0.0;
    J[28] = 0.0;
    J[29] = 0.0;
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = 0.0;
    J[35] = 0.0;
    J[36] = 0.0;
    J[37] = 1.0;
    J[38] = 0.0;
    J[39] = 0.0;
    J[40] = 0.0;
    J[41] = 0.0;
    J[42] = 0.0;
    J[43] = 0.0;
    J[44] = 0.0;
    J[45] = 0.0;
    J[46] = 0.0;
    J[47] = 0.0;
    J[48] = 1.0;
    J[49] = 0.0;
    J[50] = 0.0;
    J[51] = 0.0;
    J[52] = 0.0;
    J[53] = 0.0;
    J[54] = 0.0;
    J[55] = 0.0;
    J[56] = 0.0;
    J[57] = 0.0;
    J[58] = 0.0;
    J[59] = 1.0;
    J[60] = 0.0;
    J[61] = 0.0;
    const double z76 = z11 * z66;
    const double z77 = p_b_dot - z76;
    const double z78 = s1 * z77;
    const double z79 = p_f_dot - z76;
    const double z80 = c2 * z79;
    const double z81 = s2 * z78 - c1 * z80;
    const double z82 = z23 + (z24 + 2.0 * z13);
    const double z83 = z66 * z82 + z55 * z22 + z40 * z19;
    const double z84 = z41 * z83;
    const double z85 = s1 * z84;
    const double z86 = k1 * z84;
    const double z87 = z1 * z86;
    const double z88 = p_b_dot * s_p_b;
    const double z89 = l * z88;
    const double z90 = z11 * z19;
    const double z91 = v * z90;
    const double z92 = c1 * z77;
    const double z93 = z11 * z82;
    const double z94 = v * z93;
    const double z95 = 2.0 * z84 - 4.0 * (s1 * z85);
    const double z96 = z11 * z22;
    const double z97 = v * z96;
    const double z98 = z94 - 2.0 * (c2 * z85);
    const double z99 = s2 * z95 + 2.0 * (s1 * z87) - z16 * z97 + c1 * z98;
    const double z100 = 2.0 * (z81 * z85) - 2.0 * (z78 * z87) + z89 * z91 - z92 * z94 + z79 * z99;
    const double z101 = p_f_dot * s_p_f;
    const double z102 = c_p_f * z88 + c_p_b * z101;
    const double z103 = s2 * z79;
    const double z104 = 2.0 * (s2 * z92 + s1 * z80) - 2.0 * (c2 * z78 + c1 * z103);
    const double z105 = p_b_dot * c_p_b;
    const double z106 = p_f_dot * c_p_f;
    const double z107 = s2 * z80;
    const double z108 = z6 * z92 - 4.0 * (s1 * z107) + 2.0 * (z7 * z103 + c2 * z81);
    const double z109 = k1 * (z4 * z102 - z1 * z104 + (2.0 * (s_p_b * z105) + 2.0 * (s_p_f * z106))) - (2.0 *
        z107 + (z8 * z92 + s1 * z108));
    const double z110 = 1.0 / (z9 * z9 * z9);
    const double z111 = c2 * z92 - s1 * z103 + z81;
    const double z112 = v * z111;
    const double z113 = l * z101;
    const double z114 = z15 * z92 - s1 * z113 - (s2 * z89 - z16 * z80);
    const double z115 = v * z114;
    const double z116 = z15 * z78 + c1 * z113 + (c2 * z89 + z16 * z103);
    const double z117 = v * z116;
    const double z118 = 2.0 * (z7 * z85) - 2.0 * (c1 * z87) + z16 * z91 + s1 * z94;
    const double z119 = s2 * z118 + c2 * z99;
    const double z120 = 2.0 * (c2 * z87) - z15 * z91 + s2 * z98;
    const double z121 = z8 * z84 + z6 * z85 + 2.0 * (s2 * z87) - z15 * z97 - c2 * z94;
    const double z122 = s1 * z120 - c1 * z121;
    const double z123 = z119 - z122;
    const double z124 = z109 * z41;
    const double z125 = z66 * z124 + z11 * z112;
    const double z126 = J_w * z125;
    const double z127 = z12 * z126;
    const double z128 = J_r * z125;
    const double z129 = J_2 * z125;
    const double z130 = m * (z11 * z117 - z40 * z124);
    const double z131 = m * (z55 * z124 + z11 * z115);
    const double z132 = z127 + (z127 + (z12 * z128 + (z12 * z129 - (z18 * z130 - z21 * z131))));
    const double z133 = t * nu;
    const double s3 = sin(z133);
    const double z134 = tau * s3 + z128 - z132 * z27;
    const double c3 = cos(z133);
    const double z135 = sigma * c3;
    const double z136 = z132 * z29;
    const double z137 = z33 * z134;
    const double z138 = z135 + z126 - z136 + z137;
    const double z139 = 1.0 / z39;
    const double z140 = z139 * (z137 - (z135 - z126 + z136) + z38 * z138);
    const double z141 = z37 * z138 + z38 * z140;
    const double z142 = z32 * z134 + z33 * z141 + z33 * z140;
    const double z143 = z132 * z26 - z27 * z142 - z29 * z141 - z29 * z140;
    const double z144 = z12 * z143;
    const double z145 = z129 + (z128 + 2.0 * z126) - 2.0 * (z13 * z143) - J_w * (z140 + z141 + 2.0 * z144);
    const double z146 = z24 * z143 - z145 + J_r * (z142 + z144) + z23 * z143 + J_2 * z144;
    const double z147 = z131 - z22 * z143 - m * (z21 * z143);
    const double z148 = z112 * z82 + z115 * z22 - z117 * z19 + z66 * z123 - z10 * z146 + z20 * z147;
    const double z149 = z130 + z19 * z143 + m * (z18 * z143);
    const double z150 = 2.0 * (z109 * z83 * z110) + z41 * (z148 - z17 * z149);
    const double z151 = z92 * z84 + s1 * z150;
    const double z152 = k1 * z150;
    const double z153 = z102 * z86 - z1 * z152;
    const double z154 = z124 * z19;
    const double z155 = v * z154 - z11 * z149;
    const double z156 = z124 * z82 + z11 * z123;
    const double z157 = v * z156 - z11 * z146;
    const double z158 = s2 * (z100 - 2.0 * (z7 * z151) - 2.0 * (c1 * z153) - z16 * z155 - s1 * z157);
    const double z159 = z80 * z95 + 2.0 * (z92 * z87) + z89 * z97 - z78 * z98 + z79 * z118 + 2.0 * (s2 *
        (z150 - 2.0 * (z92 * z85 + s1 * z151)));
    const double z160 = z124 * z22;
    const double z161 = v * z160 + z11 * z147;
    const double z162 = z157 + (2.0 * (z103 * z85) - 2.0 * (c2 * z151));
    const double z163 = z158 - c2 * (z159 - 2.0 * (s1 * z153) - z16 * z161 + c1 * z162);
    const double z164 = 2.0 * (z103 * z87) - z113 * z91 - z80 * z98 - z77 * z121 + 2.0 * (c2 * z153);
    const double z165 = z108 * z84 - 4.0 * (z107 * z85) + 2.0 * (z80 * z87) + z113 * z97 + z103 * z94;
    const double z166 = z165 - z77 * z120 + z8 * z150 + z6 * z151 - 2.0 * (s2 * z153) - z15 * z161;
    const double z167 = s1 * (z164 + z15 * z155 - s2 * z162) + c1 * (z166 - c2 * z157);
    const double z168 = z163 - z167;
    const double z169 = J_r * z66;
    const double z170 = z41 * z169;
    const double z171 = s1 * z170;
    const double z172 = k1 * z170;
    const double z173 = z1 * z172;
    const double z174 = J_r * z11;
    const double z175 = v * z174;
    const double z176 = 2.0 * z170 - 4.0 * (s1 * z171);
    const double z177 = z175 - 2.0 * (c2 * z171);
    const double z178 = s2 * z176 + 2.0 * (s1 * z173) + c1 * z177;
    const double z179 = 2.0 * (z7 * z171) - 2.0 * (c1 * z173) + s1 * z175;
    const double z180 = s2 * z179 + c2 * z178;
    const double z181 = 2.0 * (c2 * z173) + s2 * z177;
    const double z182 = z8 * z170 + z6 * z171 + 2.0 * (s2 * z173) - c2 * z175;
    const double z183 = s1 * z181 - c1 * z182;
    const double z184 = z180 - z183;
    const double z185 = J_r * z143;
    const double z186 = 2.0 * (z110 * (z109 * z169)) + z41 * (J_r * z112 + z66 * z184 - z10 * z185);
    const double z187 = z92 * z170 + s1 * z186;
    const double z188 = 2.0 * (z81 * z171) - 2.0 * (z78 * z173) - z92 * z175 + z79 * z178 - 2.0 * (z7 * z187);
    const double z189 = k1 * z186;
    const double z190 = z102 * z172 - z1 * z189;
    const double z191 = J_r * z124 + z11 * z184;
    const double z192 = v * z191 - z11 * z185;
    const double z193 = z80 * z176 + 2.0 * (z92 * z173) - z78 * z177 + z79 * z179 + 2.0 * (s2 * (z186 - 2.0 *
        (z92 * z171 + s1 * z187)));
    const double z194 = z192 + (2.0 * (z103 * z171) - 2.0 * (c2 * z187));
    const double z195 = s2 * (z188 - 2.0 * (c1 * z190) - s1 * z192) - c2 * (z193 - 2.0 * (s1 * z190) + c1 *
        z194);
    const double z196 = 2.0 * (z103 * z173) - z80 * z177 - z77 * z182 + 2.0 * (c2 * z190) - s2 * z194;
    const double z197 = z108 * z170 - 4.0 * (z107 * z171) + 2.0 * (z80 * z173) + z103 * z175 - z77 * z181;
    const double z198 = s1 * z196 + c1 * (z197 + z8 * z186 + z6 * z187 - 2.0 * (s2 * z190) - c2 * z192);
    const double z199 = z195 - z198 - z27 * z168;
    const double z200 = J_w * z66;
    const double z201 = z41 * z200;
    const double z202 = s1 * z201;
    const double z203 = k1 * z201;
    const double z204 = z1 * z203;
    const double z205 = J_w * z11;
    const double z206 = v * z205;
    const double z207 = 2.0 * z201 - 4.0 * (s1 * z202);
    const double z208 = z206 - 2.0 * (c2 * z202);
    const double z209 = s2 * z207 + 2.0 * (s1 * z204) + c1 * z208;
    const double z210 = 2.0 * (z7 * z202) - 2.0 * (c1 * z204) + s1 * z206;
    const double z211 = s2 * z210 + c2 * z209;
    const double z212 = 2.0 * (c2 * z204) + s2 * z208;
    const double z213 = z8 * z201 + z6 * z202 + 2.0 * (s2 * z204) - c2 * z206;
    const double z214 = s1 * z212 - c1 * z213;
    const double z215 = z211 - z214;
    const double z216 = J_w * z143;
    const double z217 = 2.0 * (z110 * (z109 * z200)) + z41 * (J_w * z112 + z66 * z215 - z10 * z216);
    const double z218 = z92 * z201 + s1 * z217;
    const double z219 = 2.0 * (z81 * z202) - 2.0 * (z78 * z204) - z92 * z206 + z79 * z209 - 2.0 * (z7 * z218);
    const double z220 = k1 * z217;
    const double z221 = z102 * z203 - z1 * z220;
    const double z222 = J_w * z124 + z11 * z215;
    const double z223 = v * z222 - z11 * z216;
    const double z224 = z80 * z207 + 2.0 * (z92 * z204) - z78 * z208 + z79 * z210 + 2.0 * (s2 * (z217 - 2.0 *
        (z92 * z202 + s1 * z218)));
    const double z225 = z223 + (2.0 * (z103 * z202) - 2.0 * (c2 * z218));
    const double z226 = s2 * (z219 - 2.0 * (c1 * z221) - s1 * z223) - c2 * (z224 - 2.0 * (s1 * z221) + c1 *
        z225);
    const double z227 = 2.0 * (z103 * z204) - z80 * z208 - z77 * z213 + 2.0 * (c2 * z221) - s2 * z225;
    const double z228 = z108 * z201 - 4.0 * (z107 * z202) + 2.0 * (z80 * z204) + z103 * z206 - z77 * z212;
    const double z229 = s1 * z227 + c1 * (z228 + z8 * z217 + z6 * z218 - 2.0 * (s2 * z221) - c2 * z223);
    const double z230 = z226 - z229 - z29 * z168 + z33 * z199;
    const double z231 = z139 * (z230 + z38 * z230);
    const double z232 = z37 * z230 + z38 * z231;
    const double z233 = z32 * z199 + z33 * z232 + z33 * z231;
    J[62] = z29 * z231 - (z26 * z168 - z27 * z233 - z29 * z232);
    J[63] = 0.0;
    const double z234 = z4 * z86;
    const double z235 = c_p_f * z234 - l * (s2 * z97 + c2 * z91);
    const double z236 = s_p_b * z86;
    const double z237 = z104 * z86 + z4 * z152;
    const double z238 = z101 * z234 + 2.0 * (p_b_dot * z236) - c_p_f * z237 + l * (z80 * z97 - z103 * z91 +
        s2 * z161 + c2 * z155);
    const double z239 = z167 - (c_p_b * (2.0 * (z105 * z86) + p_b_dot * z235 + 2.0 * (s_p_b * z152)) - s_p_b
        * z238);
    const double z240 = z4 * z172;
    const double z241 = c_p_f * z240;
    const double z242 = s_p_b * z172;
    const double z243 = z104 * z172 + z4 * z189;
    const double z244 = c_p_b * (2.0 * (z105 * z172) + p_b_dot * z241 + 2.0 * (s_p_b * z189)) - s_p_b * (z101
        * z240 + 2.0 * (p_b_dot * z242) - c_p_f * z243);
    const double z245 = z198 - z244 - z27 * z239;
    const double z246 = z4 * z203;
    const double z247 = c_p_f * z246;
    const double z248 = s_p_b * z203;
    const double z249 = z104 * z203 + z4 * z220;
    const double z250 = c_p_b * (2.0 * (z105 * z203) + p_b_dot * z247 + 2.0 * (s_p_b * z220)) - s_p_b * (z101
        * z246 + 2.0 * (p_b_dot * z248) - c_p_f * z249);
    const double z251 = z229 - z250 - z29 * z239 + z33 * z245;
    const double z252 = z139 * (z251 + z38 * z251);
    const double z253 = z37 * z251 + z38 * z252;
    const double z254 = z32 * z245 + z33 * z253 + z33 * z252;
    J[64] = z26 * z239 - z27 * z254 - z29 * z253 - z29 * z252;
    const double z255 = c_p_b * z234 - l * (s1 * z97 + c1 * z91);
    const double z256 = s_p_f * z86;
    const double z257 = z88 * z234 + 2.0 * (p_f_dot * z256) - c_p_b * z237 + l * (z92 * z97 - z78 * z91 + s1
        * z161 + c1 * z155);
    const double z258 = z163 + (c_p_f * (2.0 * (z106 * z86) + p_f_dot * z255 + 2.0 * (s_p_f * z152)) - s_p_f
        * z257);
    const double z259 = c_p_b * z240;
    const double z260 = s_p_f * z172;
    const double z261 = c_p_f * (2.0 * (z106 * z172) + p_f_dot * z259 + 2.0 * (s_p_f * z189)) - s_p_f * (z88
        * z240 + 2.0 * (p_f_dot * z260) - c_p_b * z243);
    const double z262 = z195 + z261 - z27 * z258;
    const double z263 = c_p_b * z246;
    const double z264 = s_p_f * z203;
    const double z265 = c_p_f * (2.0 * (z106 * z203) + p_f_dot * z263 + 2.0 * (s_p_f * z220)) - s_p_f * (z88
        * z246 + 2.0 * (p_f_dot * z264) - c_p_b * z249);
    const double z266 = z226 + z265 - z29 * z258 + z33 * z262;
    const double z267 = z139 * (z266 + z38 * z266);
    const double z268 = z37 * z266 + z38 * z267;
    const double z269 = z32 * z262 + z33 * z268 + z33 * z267;
    J[65] = z29 * z267 - (z26 * z258 - z27 * z269 - z29 * z268);
    const double z270 = z111 * z93 + z114 * z96 - z116 * z90 + z10 * z156 + z20 * z160 + z17 * z154;
    const double z271 = z111 * z174 + z10 * z191 - z27 * z270;
    const double z272 = z111 * z205 + z10 * z222 - z29 * z270 + z33 * z271;
    const double z273 = z139 * (z272 + z38 * z272);
    const double z274 = z37 * z272 + z38 * z273;
    const double z275 = z32 * z271 + z33 * z274 + z33 * z273;
    J[66] = z29 * z273 - (z26 * z270 - z27 * z275 - z29 * z274);
    J[67] = 0.0;
    const double z276 = 2.0 * (c_p_b * z236) + s_p_b * z235 + z122;
    const double z277 = 2.0 * (c_p_b * z242) + s_p_b * z241 + z183 - z27 * z276;
    const double z278 = 2.0 * (c_p_b * z248) + s_p_b * z247 + z214 - z29 * z276 + z33 * z277;
    const double z279 = z139 * (z278 + z38 * z278);
    const double z280 = z37 * z278 + z38 * z279;
    const double z281 = z32 * z277 + z33 * z280 + z33 * z279;
    J[68] = z29 * z279 - (z26 * z276 - z27 * z281 - z29 * z280);
    const double z282 = 2.0 * (c_p_f * z256) + s_p_f * z255 - z119;
    const double z283 = 2.0 * (c_p_f * z260) + s_p_f * z259 - z180 - z27 * z282;
    const double z284 = 2.0 * (c_p_f * z264) + s_p_f * z263 - z211 - z29 * z282 + z33 * z283;
    const double z285 = z139 * (z284 + z38 * z284);
    const double z286 = z37 * z284 + z38 * z285;
    const double z287 = z32 * z283 + z33 * z286 + z33 * z285;
    J[69] = z29 * z285 - (z26 * z282 - z27 * z287 - z29 * z286);
    J[70] = 0.0;
    J[71] = 0.0;
    J[72] = z233;
    J[73] = 0.0;
    J[74] = -z254;
    J[75] = z269;
    J[76] = z275;
    J[77] = 0.0;
    J[78] = z281;
    J[79] = z287;
    J[80] = 0.0;
    J[81] = 0.0;
    J[82] = z232;
    J[83] = 0.0;
    J[84] = -z253;
    J[85] = z268;
    J[86] = z274;
    J[87] = 0.0;
    J[88] = z280;
    J[89] = z286;
    J[90] = 0.0;
    J[91] = 0.0;
    J[92] = z231;
    J[93] = 0.0;
    J[94] = -z252;
    J[95] = z267;
    J[96] = z273;
    J[97] = 0.0;
    J[98] = z279;
    J[99] = z285;
    return snakeboard_finish(100, J);
}

int snakeboard_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta = y[2]; /* heading of the board [rad] */
    const double p_b = y[4]; /* back axle, relative to the board [rad] */
    const double p_f = y[5]; /* front axle, relative to the board [rad] */
    const double v = y[6];
    const double l = p[1]; /* from the centre to an axle [m] */

    /* parameters only */
    const double k1 = l * l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;

    /* state */
    const double c_p_b = cos(p_b);
    const double c_p_f = cos(p_f);
    const double z1 = theta + p_b;
    const double s1 = sin(z1);
    const double z2 = theta + p_f;
    const double s2 = sin(z2);
    const double c1 = cos(z1);
    const double c2 = cos(z2);
    const double s_p_f = sin(p_f);
    const double s_p_b = sin(p_b);
    const double z3 = c_p_b * c_p_f * (2.0 * (s1 * s2) + 2.0 * (c1 * c2)) - (s_p_f * s_p_f - (2.0 - s_p_b *
        s_p_b));
    const double z4 = s2 * s2;
    const double z5 = k1 * z3 + (z4 + s1 * (s1 * (1.0 - 2.0 * z4) - 2.0 * (c2 * (c1 * s2))));
    /* the coframe is singular */
    if (!(fabs(-z5) > 1e-12 * (k3 * ((2.0 + 4.0 * k2) * k3)))) {
        return SNAKEBOARD_SINGULAR_1;
    }
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double z6 = l * v / z5 * (c_p_b * (s2 * s_theta + c2 * c_theta) + c_p_f * (s1 * s_theta + c1 *
        c_theta));
    /* 32:10 */
    out[0] = z6; /* speed */
    return snakeboard_finish(1, out);
}

int snakeboard_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass of everything [kg] */
    const double l = p[1]; /* from the centre to an axle [m] */
    const double J = p[2]; /* board [kg*m^2] */
    const double J_r = p[3]; /* rotor [kg*m^2] */
    const double J_w = p[4]; /* each axle [kg*m^2] */
    const double tau = p[5]; /* amplitude of the torque on the rotor [N*m] */
    const double sigma = p[6]; /* amplitude of the torques on the axles [N*m] */
    const double nu = p[7]; /* frequency of the torques [rad/s] */
    const double k1 = l * l;
    const double k2 = fabs(l);
    const double k3 = 2.0 + k2;
    int singular1 = 0;
    int singular2 = 0;
    int bad = 0;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double t_ = t[i]; /* time */
        const double theta = y[2 * count + i]; /* heading of the board [rad] */
        const double p_b = y[4 * count + i]; /* back axle, relative to the board [rad] */
        const double p_f = y[5 * count + i]; /* front axle, relative to the board [rad] */
        const double v = y[6 * count + i];
        const double psi_dot = y[7 * count + i];
        const double p_b_dot = y[8 * count + i];
        const double p_f_dot = y[9 * count + i];
        const double c_p_b = cos(p_b);
        const double c_p_f = cos(p_f);
        const double z1 = c_p_b * c_p_f;
        const double z2 = theta + p_b;
        const double s1 = sin(z2);
        const double z3 = theta + p_f;
        const double s2 = sin(z3);
        const double c1 = cos(z2);
        const double c2 = cos(z3);
        const double z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2);
        const double s_p_f = sin(p_f);
        const double s_p_b = sin(p_b);
        const double z5 = s2 * s2;
        const double z6 = 1.0 - 2.0 * z5;
        const double z7 = c1 * s2;
        const double z8 = s1 * z6 - 2.0 * (c2 * z7);
        const double z9 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))) + (z5 + s1 * z8);
        /* the coframe is singular */
        singular1 |= !(fabs(-z9) > 1e-12 * (k3 * ((2.0 + 4.0 * k2) * k3)));
        const double z10 = s1 * c2 - z7;
        const double z11 = 1.0 / z9;
        const double z12 = z10 * z11;
        const double z13 = J_w * z12;
        const double z14 = z12 * z13;
        const double z15 = l * c_p_f;
        const double z16 = l * c_p_b;
        const double z17 = c1 * z15 + z16 * c2;
        const double z18 = z17 * z11;
        const double z19 = s1 * z15 + z16 * s2;
        const double z20 = z19 * z11;
        const double z21 = J_r * z12;
        const double z22 = z18 * (m * z18) + z20 * (m * z20) + z12 * (J * z12) + z12 * z21 + z14;
        const double z23 = z14 + z22;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z23) > 0.0);
        const double z24 = 1.0 / z23;
        const double z25 = z21 * z24;
        const double z26 = J_r - z21 * z25;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z26) > 1e-14 * J_r);
        const double z27 = z13 * z24;
        const double z28 = z13 * z27;
        const double z29 = z21 * z27;
        const double z30 = 1.0 / z26;
        const double z31 = z29 * z30;
        const double z32 = z29 * z31;
        const double z33 = J_w - z28 - z32;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z33) > 1e-14 * J_w);
        const double z34 = z28 + z32;
        const double z35 = 1.0 / z33;
        const double z36 = z34 * z35;
        const double z37 = z33 - z34 * z36;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z37) > 1e-14 * J_w);
        const double z38 = z17 * v;
        const double z39 = z19 * v;
        const double z40 = z10 * v;
        const double z41 = z11 * z40;
        const double z42 = p_b_dot * s_p_b;
        const double z43 = p_f_dot * s_p_f;
        const double z44 = p_b_dot - z41;
        const double z45 = c1 * z44;
        const double z46 = p_f_dot - z41;
        const double z47 = c2 * z46;
        const double z48 = s1 * z44;
        const double z49 = s2 * z46;
        const double z50 = z4 * (c_p_f * z42 + c_p_b * z43) - z1 * (2.0 * (s2 * z45 + s1 * z47) - 2.0 * (c2 *
            z48 + c1 * z49));
        const double z51 = s2 * z47;
        const double z52 = s2 * z48 - c1 * z47;
        const double z53 = z8 * z45 + s1 * (z6 * z45 - 4.0 * (s1 * z51) + 2.0 * (z7 * z49 + c2 * z52));
        const double z54 = k1 * (z50 + (2.0 * (s_p_b * (p_b_dot * c_p_b)) + 2.0 * (s_p_f * (p_f_dot *
            c_p_f)))) - (2.0 * z51 + z53);
        const double z55 = z54 / (z9 * z9);
        const double z56 = z40 * z55 + z11 * (v * (c2 * z45 - s1 * z49 + z52));
        const double z57 = J_w * z56;
        const double z58 = z12 * z57;
        const double z59 = J_r * z56;
        const double z60 = l * z43;
        const double z61 = l * z42;
        const double z62 = z11 * (v * (z15 * z48 + c1 * z60 + (c2 * z61 + z16 * z49))) - z38 * z55;
        const double z63 = z39 * z55 + z11 * (v * (z15 * z45 - s1 * z60 - (s2 * z61 - z16 * z47)));
        const double z64 = z58 + (z12 * z59 + (z12 * (J * z56) - (z18 * (m * z62) - z20 * (m * z63))));
        const double z65 = z58 + z64;
        const double z66 = t_ * nu;
        const double s3 = sin(z66);
        const double z67 = tau * s3 + z59 - z65 * z25;
        const double c3 = cos(z66);
        const double z68 = sigma * c3;
        const double z69 = z65 * z27;
        const double z70 = z31 * z67;
        const double z71 = z68 + z57 - z69 + z70;
        const double z72 = (z70 - (z68 - z57 + z69) + z36 * z71) / z37;
        const double z73 = z35 * z71 + z36 * z72;
        const double z74 = z30 * z67 + z31 * z73 + z31 * z72;
        /* (I.2.15) */
        const double slope1 = z38 * z11; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = z11 * z39; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = -z41; /* theta' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = psi_dot; /* psi' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = p_b_dot; /* p_b' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = p_f_dot; /* p_f' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        /* (I.2.15) 22:4 */
        const double slope7 = z27 * z72 - (z65 * z24 - z25 * z74 - z27 * z73); /* v' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = z74; /* psi'' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
        const double slope9 = z73; /* p_b'' */
        dydt[8 * count + i] = slope9;
        bad |= !(fabs(slope9) <= DBL_MAX);
        const double slope10 = z72; /* p_f'' */
        dydt[9 * count + i] = slope10;
        bad |= !(fabs(slope10) <= DBL_MAX);
    }
    if (singular1) {
        return SNAKEBOARD_SINGULAR_1;
    }
    if (singular2) {
        return SNAKEBOARD_SINGULAR_2;
    }
    return bad ? SNAKEBOARD_NOT_FINITE : SNAKEBOARD_OK;
}
