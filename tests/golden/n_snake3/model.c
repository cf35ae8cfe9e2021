/*
 * n_snake3.c: n_snake3, emitted by nhc 0.1.0 (nhc:647c32f22053d67d)
 * Three links with a wheeled axle under the middle of each, hinged in a row with springs in the hinges.
 * Source: n_snake3.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * n_snake3.h says what each function does.
 */
#include "n_snake3.h"

#include <float.h>
#include <math.h>

const char *const n_snake3_coordinate_names[] = {
    "x",
    "y",
    "theta1",
    "theta2",
    "theta3"
};
const char *const n_snake3_state_names[] = {
    "x",
    "y",
    "theta1",
    "theta2",
    "theta3",
    "v",
    "w"
};
const char *const n_snake3_parameter_names[] = {
    "m",
    "J",
    "a",
    "k"
};
const double n_snake3_parameter_defaults[] = {
    1.0,
    0.1,
    0.5,
    0.5
};

static int n_snake3_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? N_SNAKE3_OK : N_SNAKE3_NOT_FINITE;
}

int n_snake3_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* parameters only */
    const double k1 = 1.0 / a;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double c_theta2 = cos(theta2);
    const double s_theta2 = sin(theta2);
    const double z1 = c_theta2 * s_theta1 - c_theta1 * s_theta2;
    const double z2 = k1 * z1;
    const double c_theta3 = cos(theta3);
    const double z3 = a * (c_theta2 * z2);
    const double z4 = s_theta1 - z3;
    const double z5 = z3 - z4;
    const double s_theta3 = sin(theta3);
    const double z6 = a * (s_theta2 * z2);
    const double z7 = c_theta1 + z6;
    const double z8 = z6 + z7;
    const double z9 = c_theta3 * z5 + s_theta3 * z8;
    const double z10 = k1 * z9;
    const double z11 = c_theta1 * (m * c_theta1) + s_theta1 * (m * s_theta1) + z2 * (J * z2) + z10 * (J *
        z10);
    const double z12 = z8 - a * (s_theta3 * z10);
    const double z13 = z5 - a * (c_theta3 * z10);
    const double z14 = z11 + z7 * (m * z7) + z4 * (m * z4) + z12 * (m * z12) + z13 * (m * z13);
    /* the mass matrix is singular */
    if (!(fabs(z14) > 0.0)) {
        return N_SNAKE3_SINGULAR_2;
    }
    const double z15 = a * c_theta1 * c_theta2 + a * s_theta1 * s_theta2;
    const double z16 = k1 * z15;
    const double z17 = J * z16;
    const double z18 = c_theta2 * z16;
    const double z19 = c_theta1 - z18;
    const double z20 = z18 - z19;
    const double z21 = s_theta2 * z16;
    const double z22 = s_theta1 - z21;
    const double z23 = z21 - z22;
    const double z24 = c_theta3 * (a * z20) + s_theta3 * (a * z23);
    const double z25 = k1 * z24;
    const double z26 = J * z25;
    const double z27 = a * z22;
    const double z28 = m * z27;
    const double z29 = a * z19;
    const double z30 = m * z29;
    const double z31 = a * (z23 - s_theta3 * z25);
    const double z32 = m * z31;
    const double z33 = a * (z20 - c_theta3 * z25);
    const double z34 = m * z33;
    const double z35 = J + z16 * z17 + z25 * z26 + z27 * z28 + z29 * z30 + z31 * z32 + z33 * z34;
    const double z36 = z2 * z17 + z10 * z26 - z7 * z28 + z4 * z30 + z12 * z32 + z13 * z34;
    const double z37 = 1.0 / z14;
    const double z38 = z36 * z37;
    const double z39 = z35 - z36 * z38;
    /* the mass matrix is singular */
    if (!(fabs(z39) > 1e-14 * z35)) {
        return N_SNAKE3_SINGULAR_2;
    }
    const double z40 = c_theta1 * v;
    const double z41 = s_theta1 * v;
    const double z42 = c_theta1 * w;
    const double z43 = z41 - a * z42;
    const double z44 = s_theta1 * w;
    const double z45 = z40 + a * z44;
    const double z46 = k1 * (c_theta2 * z43 - s_theta2 * z45);
    const double z47 = c_theta2 * z46;
    const double z48 = a * z47;
    const double z49 = z48 - (z43 - z48);
    const double z50 = s_theta2 * z46;
    const double z51 = a * z50;
    const double z52 = z51 + (z45 + z51);
    const double z53 = k1 * (c_theta3 * z49 + s_theta3 * z52);
    const double z54 = v * z42;
    const double z55 = z54 + a * (w * z44);
    const double z56 = v * z44;
    const double z57 = z56 - a * (w * z42);
    const double z58 = k1 * (z43 * z50 - c_theta2 * z55 + (z45 * z47 - s_theta2 * z57));
    const double z59 = a * (z46 * z50 + c_theta2 * z58);
    const double z60 = z55 + z59;
    const double z61 = z59 + z60;
    const double z62 = s_theta3 * z53;
    const double z63 = c_theta3 * z53;
    const double z64 = a * (z46 * z47 - s_theta2 * z58);
    const double z65 = z57 - z64;
    const double z66 = z64 - z65;
    const double z67 = k1 * (z49 * z62 - c_theta3 * z61 - (z52 * z63 - s_theta3 * z66));
    const double z68 = m * (z61 + a * (z53 * z62 + c_theta3 * z67));
    const double z69 = m * (z66 + a * (z53 * z63 - s_theta3 * z67));
    const double z70 = m * z60;
    const double z71 = m * z65;
    const double z72 = J * z67;
    const double z73 = J * z58;
    const double z74 = z7 * z71 - (z10 * z72 - (z2 * z73 + (c_theta1 * (m * z56) - s_theta1 * (m * z54))));
    const double z75 = theta1 - theta2;
    const double z76 = theta2 - theta3;
    const double z77 = z13 * z68 - (z12 * z69 + (z4 * z70 - z74)) + 0.5 * (k * (2.0 * (z75 * z2) - 2.0 * (z76
        * (k1 * (z1 + z9)))));
    const double z78 = z33 * z68 - (z31 * z69 + (z29 * z70 + (z27 * z71 - (z16 * z73 - z25 * z72))));
    const double z79 = z78 + 0.5 * (k * (2.0 * (z75 * (1.0 + z16)) - 2.0 * (z76 * (k1 * (z15 + z24)))));
    const double z80 = (z79 - z77 * z38) / z39;
    /* (I.2.15) */
    dydt[0] = z40; /* x' */
    dydt[1] = z41; /* y' */
    dydt[2] = w; /* theta1' */
    dydt[3] = z46; /* theta2' */
    dydt[4] = -z53; /* theta3' */
    /* (I.2.15) 22:4 */
    dydt[5] = z77 * z37 - z38 * z80; /* v' */
    dydt[6] = -z80; /* w' */
    return n_snake3_finish(7, dydt);
}

int n_snake3_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */
    const double v = y[5];
    const double w = y[6];
    const double a = p[2]; /* half the length of a link [m] */

    /* parameters only */
    const double k1 = 1.0 / a;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    const double c_theta1 = cos(theta1);
    const double z1 = c_theta1 * v;
    const double s_theta1 = sin(theta1);
    const double z2 = s_theta1 * v;
    const double c_theta2 = cos(theta2);
    const double z3 = z2 - a * (c_theta1 * w);
    const double s_theta2 = sin(theta2);
    const double z4 = z1 + a * (s_theta1 * w);
    const double z5 = k1 * (c_theta2 * z3 - s_theta2 * z4);
    const double c_theta3 = cos(theta3);
    const double z6 = a * (c_theta2 * z5);
    const double s_theta3 = sin(theta3);
    const double z7 = a * (s_theta2 * z5);
    /* (I.2.4) */
    qdot[0] = z1; /* x' */
    qdot[1] = z2; /* y' */
    qdot[2] = w; /* theta1' */
    qdot[3] = z5; /* theta2' */
    qdot[4] = -k1 * (c_theta3 * (z6 - (z3 - z6)) + s_theta3 * (z7 + (z4 + z7))); /* theta3' */
    return n_snake3_finish(5, qdot);
}

int n_snake3_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* parameters only */
    const double k1 = 1.0 / a;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double c_theta2 = cos(theta2);
    const double s_theta2 = sin(theta2);
    const double z1 = c_theta2 * s_theta1 - c_theta1 * s_theta2;
    const double z2 = k1 * z1;
    const double c_theta3 = cos(theta3);
    const double z3 = a * (c_theta2 * z2);
    const double z4 = s_theta1 - z3;
    const double z5 = z3 - z4;
    const double s_theta3 = sin(theta3);
    const double z6 = a * (s_theta2 * z2);
    const double z7 = c_theta1 + z6;
    const double z8 = z6 + z7;
    const double z9 = c_theta3 * z5 + s_theta3 * z8;
    const double z10 = k1 * z9;
    const double z11 = c_theta1 * (m * c_theta1) + s_theta1 * (m * s_theta1) + z2 * (J * z2) + z10 * (J *
        z10);
    const double z12 = z8 - a * (s_theta3 * z10);
    const double z13 = z5 - a * (c_theta3 * z10);
    const double z14 = z11 + z7 * (m * z7) + z4 * (m * z4) + z12 * (m * z12) + z13 * (m * z13);
    /* the mass matrix is singular */
    if (!(fabs(z14) > 0.0)) {
        return N_SNAKE3_SINGULAR_2;
    }
    const double z15 = a * c_theta1 * c_theta2 + a * s_theta1 * s_theta2;
    const double z16 = k1 * z15;
    const double z17 = J * z16;
    const double z18 = c_theta2 * z16;
    const double z19 = c_theta1 - z18;
    const double z20 = z18 - z19;
    const double z21 = s_theta2 * z16;
    const double z22 = s_theta1 - z21;
    const double z23 = z21 - z22;
    const double z24 = c_theta3 * (a * z20) + s_theta3 * (a * z23);
    const double z25 = k1 * z24;
    const double z26 = J * z25;
    const double z27 = a * z22;
    const double z28 = m * z27;
    const double z29 = a * z19;
    const double z30 = m * z29;
    const double z31 = a * (z23 - s_theta3 * z25);
    const double z32 = m * z31;
    const double z33 = a * (z20 - c_theta3 * z25);
    const double z34 = m * z33;
    const double z35 = J + z16 * z17 + z25 * z26 + z27 * z28 + z29 * z30 + z31 * z32 + z33 * z34;
    const double z36 = z2 * z17 + z10 * z26 - z7 * z28 + z4 * z30 + z12 * z32 + z13 * z34;
    const double z37 = 1.0 / z14;
    const double z38 = z36 * z37;
    const double z39 = z35 - z36 * z38;
    /* the mass matrix is singular */
    if (!(fabs(z39) > 1e-14 * z35)) {
        return N_SNAKE3_SINGULAR_2;
    }
    const double z40 = s_theta1 * w;
    const double z41 = v * z40;
    const double z42 = c_theta1 * w;
    const double z43 = s_theta1 * v - a * z42;
    const double z44 = c_theta1 * v + a * z40;
    const double z45 = k1 * (c_theta2 * z43 - s_theta2 * z44);
    const double z46 = s_theta2 * z45;
    const double z47 = z45 * z46;
    const double z48 = z43 * z46;
    const double z49 = v * z42;
    const double z50 = w * z40;
    const double z51 = z49 + a * z50;
    const double z52 = c_theta2 * z45;
    const double z53 = z44 * z52;
    const double z54 = w * z42;
    const double z55 = z41 - a * z54;
    const double z56 = k1 * (z48 - c_theta2 * z51 + (z53 - s_theta2 * z55));
    const double z57 = a * (z47 + c_theta2 * z56);
    const double z58 = z51 + z57;
    const double z59 = z57 + z58;
    const double z60 = a * z52;
    const double z61 = z60 - (z43 - z60);
    const double z62 = a * z46;
    const double z63 = z62 + (z44 + z62);
    const double z64 = k1 * (c_theta3 * z61 + s_theta3 * z63);
    const double z65 = s_theta3 * z64;
    const double z66 = z61 * z65;
    const double z67 = c_theta3 * z64;
    const double z68 = z63 * z67;
    const double z69 = z45 * z52;
    const double z70 = a * (z69 - s_theta2 * z56);
    const double z71 = z55 - z70;
    const double z72 = z70 - z71;
    const double z73 = k1 * (z66 - c_theta3 * z59 - (z68 - s_theta3 * z72));
    const double z74 = m * (z59 + a * (z64 * z65 + c_theta3 * z73));
    const double z75 = m * (z72 + a * (z64 * z67 - s_theta3 * z73));
    const double z76 = m * z58;
    const double z77 = m * z71;
    const double z78 = J * z73;
    const double z79 = J * z56;
    const double z80 = z7 * z77 - (z10 * z78 - (z2 * z79 + (c_theta1 * (m * z41) - s_theta1 * (m * z49))));
    const double z81 = theta1 - theta2;
    const double z82 = theta2 - theta3;
    const double z83 = z13 * z74 - (z12 * z75 + (z4 * z76 - z80)) + 0.5 * (k * (2.0 * (z81 * z2) - 2.0 * (z82
        * (k1 * (z1 + z9)))));
    const double z84 = z33 * z74 - (z31 * z75 + (z29 * z76 + (z27 * z77 - (z16 * z79 - z25 * z78))));
    const double z85 = z84 + 0.5 * (k * (2.0 * (z81 * (1.0 + z16)) - 2.0 * (z82 * (k1 * (z15 + z24)))));
    const double z86 = (z85 - z83 * z38) / z39;
    const double z87 = z83 * z37 - z38 * z86;
    const double z88 = z41 - c_theta1 * z87;
    const double z89 = z49 + s_theta1 * z87;
    const double z90 = z89 + a * (z50 + c_theta1 * z86);
    const double z91 = z88 - a * (z54 - s_theta1 * z86);
    const double z92 = k1 * (z48 - c_theta2 * z90 + (z53 - s_theta2 * z91));
    const double z93 = a * (z47 + c_theta2 * z92);
    const double z94 = a * (z69 - s_theta2 * z92);
    /* (I.2.15) */
    qddot[0] = -z88; /* x'' */
    qddot[1] = z89; /* y'' */
    qddot[2] = -z86; /* theta1'' */
    qddot[3] = -z92; /* theta2'' */
    /* theta3'' */
    qddot[4] = -k1 * (z66 - c_theta3 * (z93 + (z90 + z93)) - (z68 - s_theta3 * (z94 - (z91 - z94))));
    return n_snake3_finish(5, qddot);
}

int n_snake3_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* middle of the first link [m] */
    const double y_2 = q[1]; /* middle of the first link [m] */
    const double theta1 = q[2]; /* first link [rad] */
    const double theta2 = q[3]; /* second link [rad] */
    const double theta3 = q[4]; /* third link [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta1_dot = qdot[2];

    /* state */
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    y[0] = x;
    y[1] = y_2;
    y[2] = theta1;
    y[3] = theta2;
    y[4] = theta3;
    y[5] = x_dot * c_theta1 + y_dot * s_theta1;
    y[6] = theta1_dot;
    return n_snake3_finish(7, y);
}

int n_snake3_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta1 = q[2]; /* first link [rad] */
    const double theta2 = q[3]; /* second link [rad] */
    const double theta3 = q[4]; /* third link [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta1_dot = qdot[2];
    const double theta2_dot = qdot[3];
    const double theta3_dot = qdot[4];
    const double a = p[2]; /* half the length of a link [m] */

    /* state */
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);
    const double s_theta2 = sin(theta2);
    const double z1 = a * (theta2_dot * s_theta2);
    const double x2_dot = x_dot + a * (theta1_dot * s_theta1) + z1;
    const double c_theta2 = cos(theta2);
    const double z2 = a * (theta2_dot * c_theta2);
    const double y2_dot = y_dot - a * (theta1_dot * c_theta1) - z2;
    const double s_theta3 = sin(theta3);
    const double c_theta3 = cos(theta3);
    const double z3 = s_theta3 * (z1 + x2_dot + a * (theta3_dot * s_theta3)) + c_theta3 * (z2 - y2_dot + a *
        (theta3_dot * c_theta3));
    /* (I.1.1) 25:5 */
    r[0] = y_dot * c_theta1 - x_dot * s_theta1; /* wheel1 = 0 */
    /* (I.1.1) 26:5 */
    r[1] = c_theta2 * y2_dot - s_theta2 * x2_dot; /* wheel2 = 0 */
    /* (I.1.1) 27:5 */
    r[2] = -z3; /* wheel3 = 0 */
    return n_snake3_finish(3, r);
}

int n_snake3_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* parameters only */
    const double k1 = 1.0 / a;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    const double c_theta1 = cos(theta1);
    const double z1 = m * c_theta1;
    const double s_theta1 = sin(theta1);
    const double z2 = m * s_theta1;
    const double c_theta2 = cos(theta2);
    const double s_theta2 = sin(theta2);
    const double z3 = c_theta2 * s_theta1 - c_theta1 * s_theta2;
    const double z4 = k1 * z3;
    const double z5 = J * z4;
    const double c_theta3 = cos(theta3);
    const double z6 = a * (c_theta2 * z4);
    const double z7 = s_theta1 - z6;
    const double z8 = z6 - z7;
    const double s_theta3 = sin(theta3);
    const double z9 = a * (s_theta2 * z4);
    const double z10 = c_theta1 + z9;
    const double z11 = z9 + z10;
    const double z12 = c_theta3 * z8 + s_theta3 * z11;
    const double z13 = k1 * z12;
    const double z14 = J * z13;
    const double z15 = m * z10;
    const double z16 = m * z7;
    const double z17 = c_theta1 * z1 + s_theta1 * z2 + z4 * z5 + z13 * z14 + z10 * z15 + z7 * z16;
    const double z18 = z11 - a * (s_theta3 * z13);
    const double z19 = m * z18;
    const double z20 = z8 - a * (c_theta3 * z13);
    const double z21 = m * z20;
    const double z22 = z17 + z18 * z19 + z20 * z21;
    /* the mass matrix is singular */
    if (!(fabs(z22) > 0.0)) {
        return N_SNAKE3_SINGULAR_2;
    }
    const double z23 = a * c_theta1 * c_theta2 + a * s_theta1 * s_theta2;
    const double z24 = k1 * z23;
    const double z25 = J * z24;
    const double z26 = c_theta2 * z24;
    const double z27 = c_theta1 - z26;
    const double z28 = z26 - z27;
    const double z29 = s_theta2 * z24;
    const double z30 = s_theta1 - z29;
    const double z31 = z29 - z30;
    const double z32 = c_theta3 * (a * z28) + s_theta3 * (a * z31);
    const double z33 = k1 * z32;
    const double z34 = J * z33;
    const double z35 = a * z30;
    const double z36 = m * z35;
    const double z37 = a * z27;
    const double z38 = m * z37;
    const double z39 = a * (z31 - s_theta3 * z33);
    const double z40 = m * z39;
    const double z41 = a * (z28 - c_theta3 * z33);
    const double z42 = m * z41;
    const double z43 = J + z24 * z25 + z33 * z34 + z35 * z36 + z37 * z38 + z39 * z40 + z41 * z42;
    const double z44 = z4 * z25 + z13 * z34 - z10 * z36 + z7 * z38 + z18 * z40 + z20 * z42;
    const double z45 = 1.0 / z22;
    const double z46 = z44 * z45;
    const double z47 = z43 - z44 * z46;
    /* the mass matrix is singular */
    if (!(fabs(z47) > 1e-14 * z43)) {
        return N_SNAKE3_SINGULAR_2;
    }
    const double z48 = c_theta1 * w;
    const double z49 = s_theta1 * v - a * z48;
    const double z50 = s_theta1 * w;
    const double z51 = c_theta1 * v + a * z50;
    const double z52 = k1 * (c_theta2 * z49 - s_theta2 * z51);
    const double z53 = s_theta2 * z52;
    const double z54 = v * z48;
    const double z55 = z54 + a * (w * z50);
    const double z56 = c_theta2 * z52;
    const double z57 = v * z50;
    const double z58 = z57 - a * (w * z48);
    const double z59 = k1 * (z49 * z53 - c_theta2 * z55 + (z51 * z56 - s_theta2 * z58));
    const double z60 = a * (z52 * z53 + c_theta2 * z59);
    const double z61 = z55 + z60;
    const double z62 = z60 + z61;
    const double z63 = a * z56;
    const double z64 = z63 - (z49 - z63);
    const double z65 = a * z53;
    const double z66 = z65 + (z51 + z65);
    const double z67 = k1 * (c_theta3 * z64 + s_theta3 * z66);
    const double z68 = s_theta3 * z67;
    const double z69 = c_theta3 * z67;
    const double z70 = a * (z52 * z56 - s_theta2 * z59);
    const double z71 = z58 - z70;
    const double z72 = z70 - z71;
    const double z73 = k1 * (z64 * z68 - c_theta3 * z62 - (z66 * z69 - s_theta3 * z72));
    const double z74 = m * (z62 + a * (z67 * z68 + c_theta3 * z73));
    const double z75 = c_theta1 * c_theta2 + s_theta1 * s_theta2;
    const double z76 = k1 * z75;
    const double z77 = a * (c_theta2 * z76);
    const double z78 = c_theta1 - z77;
    const double z79 = z77 - z78;
    const double z80 = a * (s_theta2 * z76);
    const double z81 = s_theta1 - z80;
    const double z82 = z80 - z81;
    const double z83 = c_theta3 * z79 + s_theta3 * z82;
    const double z84 = k1 * z83;
    const double z85 = z79 - a * (c_theta3 * z84);
    const double z86 = m * (z72 + a * (z67 * z69 - s_theta3 * z73));
    const double z87 = z82 - a * (s_theta3 * z84);
    const double z88 = m * z61;
    const double z89 = m * z71;
    const double z90 = J * z73;
    const double z91 = J * z59;
    const double z92 = m * z57;
    const double z93 = m * z54;
    const double z94 = z78 * z88 + (z81 * z89 + (z84 * z90 - (z76 * z91 - (s_theta1 * z92 + c_theta1 *
        z93))));
    const double z95 = theta1 - theta2;
    const double z96 = theta2 - theta3;
    const double z97 = z74 * z85 - (z86 * z87 + z94) + 0.5 * (k * (2.0 * (z95 * z76) - 2.0 * (z96 * (k1 *
        (z75 + z83)))));
    const double z98 = s_theta1 * z1 - c_theta1 * z2 - z76 * z5 - z84 * z14 + z81 * z15 - z78 * z16;
    const double z99 = z7 * z88 - (z10 * z89 - (z13 * z90 - (z4 * z91 + (c_theta1 * z92 - s_theta1 * z93))));
    const double z100 = z20 * z74 - (z18 * z86 + z99) + 0.5 * (k * (2.0 * (z95 * z4) - 2.0 * (z96 * (k1 * (z3
        + z12)))));
    const double z101 = z41 * z74 - (z39 * z86 + (z37 * z88 + (z35 * z89 - (z24 * z91 - z33 * z90))));
    const double z102 = z101 + 0.5 * (k * (2.0 * (z95 * (1.0 + z24)) - 2.0 * (z96 * (k1 * (z23 + z32)))));
    const double z103 = (z102 - z100 * z46) / z47;
    const double z104 = z100 * z45 - z46 * z103;
    const double z105 = z76 * z25 + z84 * z34 + z81 * z36 + z78 * z38 + z40 * z87 + z42 * z85;
    const double z106 = k1 * (2.0 * (c_theta2 * c_theta3) + 2.0 * (s_theta2 * s_theta3));
    const double z107 = 2.0 * c_theta2 - a * (c_theta3 * z106);
    const double z108 = 2.0 * s_theta2 - a * (s_theta3 * z106);
    const double z109 = z74 * z107 - (z86 * z108 - (c_theta2 * z88 + (s_theta2 * z89 + (k1 * z91 - z106 *
        z90))));
    const double z110 = k1 * z5 + z106 * z14 + s_theta2 * z15 - c_theta2 * z16 + z19 * z108 + z21 * z107;
    const double z111 = k1 * z25 + z106 * z34 - s_theta2 * z36 - c_theta2 * z38 + z40 * z108 + z42 * z107;
    const double z112 = z109 + 0.5 * (k * (2.0 * (z95 * k1) - 2.0 * (z96 * (k1 + z106)))) - (z110 * z104 +
        z111 * z103);
    const double z113 = (k1 * z14 - s_theta3 * z19 - c_theta3 * z21) * z104 + (k1 * z34 - s_theta3 * z40 -
        c_theta3 * z42) * z103;
    /* (I.4.1) 25:5 */
    /* reaction of wheel1: Q_i gains lambda_1 a_1i */
    lambda[0] = -(z97 + ((z98 - z19 * z87 - z21 * z85) * z104 - z105 * z103));
    /* (I.4.1) 26:5 */
    lambda[1] = z112; /* reaction of wheel2: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 27:5 */
    /* reaction of wheel3: Q_i gains lambda_3 a_3i */
    lambda[2] = c_theta3 * z74 + (k1 * z90 - s_theta3 * z86) + k * (z96 * k1) + z113;
    return n_snake3_finish(3, lambda);
}

double n_snake3_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* parameters only */
    const double k1 = 1.0 / a;

    /* state */
    const double z1 = theta1 - theta2;
    const double z2 = theta2 - theta3;
    const double c_theta1 = cos(theta1);
    const double z3 = c_theta1 * v;
    const double s_theta1 = sin(theta1);
    const double z4 = s_theta1 * v;
    const double z5 = z3 + a * (s_theta1 * w);
    const double s_theta2 = sin(theta2);
    const double c_theta2 = cos(theta2);
    const double z6 = z4 - a * (c_theta1 * w);
    const double z7 = k1 * (c_theta2 * z6 - s_theta2 * z5);
    const double z8 = a * (s_theta2 * z7);
    const double x2_dot = z5 + z8;
    const double z9 = a * (c_theta2 * z7);
    const double y2_dot = z6 - z9;
    const double z10 = z8 + x2_dot;
    const double s_theta3 = sin(theta3);
    const double c_theta3 = cos(theta3);
    const double z11 = z9 - y2_dot;
    const double z12 = k1 * (c_theta3 * z11 + s_theta3 * z10);
    const double x3_dot = z10 - a * (s_theta3 * z12);
    const double z13 = z11 - a * (c_theta3 * z12);
    const double z14 = z3 * z3 + z4 * z4 + x2_dot * x2_dot + y2_dot * y2_dot + x3_dot * x3_dot + z13 * z13;
    const double z15 = 0.5 * (k * (z1 * z1 + z2 * z2)) + (0.5 * (m * z14) + 0.5 * (J * (w * w + z7 * z7 + z12
        * z12)));
    return z15;
}

int n_snake3_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta1 = y[2]; /* first link [rad] */
    const double theta2 = y[3]; /* second link [rad] */
    const double theta3 = y[4]; /* third link [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* each link [kg] */
    const double J_2 = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k = p[3]; /* stiffness of the hinges [N*m] */

    /* parameters only */
    const double k1 = 1.0 / a;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    const double c_theta1 = cos(theta1);
    const double z1 = m * c_theta1;
    const double s_theta1 = sin(theta1);
    const double z2 = m * s_theta1;
    const double c_theta2 = cos(theta2);
    const double s_theta2 = sin(theta2);
    const double z3 = c_theta2 * s_theta1 - c_theta1 * s_theta2;
    const double z4 = k1 * z3;
    const double z5 = J_2 * z4;
    const double c_theta3 = cos(theta3);
    const double z6 = a * (c_theta2 * z4);
    const double z7 = s_theta1 - z6;
    const double z8 = z6 - z7;
    const double s_theta3 = sin(theta3);
    const double z9 = a * (s_theta2 * z4);
    const double z10 = c_theta1 + z9;
    const double z11 = z9 + z10;
    const double z12 = c_theta3 * z8 + s_theta3 * z11;
    const double z13 = k1 * z12;
    const double z14 = J_2 * z13;
    const double z15 = m * z10;
    const double z16 = m * z7;
    const double z17 = c_theta1 * z1 + s_theta1 * z2 + z4 * z5 + z13 * z14 + z10 * z15 + z7 * z16;
    const double z18 = z11 - a * (s_theta3 * z13);
    const double z19 = m * z18;
    const double z20 = z8 - a * (c_theta3 * z13);
    const double z21 = m * z20;
    const double z22 = z17 + z18 * z19 + z20 * z21;
    /* the mass matrix is singular */
    if (!(fabs(z22) > 0.0)) {
        return N_SNAKE3_SINGULAR_2;
    }
    const double z23 = a * c_theta1;
    const double z24 = a * s_theta1;
    const double z25 = z23 * c_theta2 + z24 * s_theta2;
    const double z26 = k1 * z25;
    const double z27 = J_2 * z26;
    const double z28 = c_theta2 * z26;
    const double z29 = c_theta1 - z28;
    const double z30 = z28 - z29;
    const double z31 = a * z30;
    const double z32 = s_theta2 * z26;
    const double z33 = s_theta1 - z32;
    const double z34 = z32 - z33;
    const double z35 = a * z34;
    const double z36 = c_theta3 * z31 + s_theta3 * z35;
    const double z37 = k1 * z36;
    const double z38 = J_2 * z37;
    const double z39 = a * z33;
    const double z40 = m * z39;
    const double z41 = a * z29;
    const double z42 = m * z41;
    const double z43 = a * (z34 - s_theta3 * z37);
    const double z44 = m * z43;
    const double z45 = a * (z30 - c_theta3 * z37);
    const double z46 = m * z45;
    const double z47 = J_2 + z26 * z27 + z37 * z38 + z39 * z40 + z41 * z42 + z43 * z44 + z45 * z46;
    const double z48 = z4 * z27 + z13 * z38 - z10 * z40 + z7 * z42 + z18 * z44 + z20 * z46;
    const double z49 = 1.0 / z22;
    const double z50 = z48 * z49;
    const double z51 = z47 - z48 * z50;
    /* the mass matrix is singular */
    if (!(fabs(z51) > 1e-14 * z47)) {
        return N_SNAKE3_SINGULAR_2;
    }
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    const double z52 = s_theta1 * v;
    J[2] = -z52;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = c_theta1;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    const double z53 = c_theta1 * v;
    J[9] = z53;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = s_theta1;
    J[13] = 0.0;
    J[14] = 0.0;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 1.0;
    J[21] = 0.0;
    J[22] = 0.0;
    const double z54 = c_theta2 * k1;
    const double z55 = s_theta2 * k1;
    J[23] = s_theta1 * (c_theta2 * w + v * z55) - c_theta1 * (s_theta2 * w - v * z54);
    const double z56 = s_theta1 * w;
    const double z57 = z53 + a * z56;
    const double z58 = c_theta1 * w;
    const double z59 = z52 - a * z58;
    J[24] = -(c_theta2 * (k1 * z57) + s_theta2 * (k1 * z59));
    J[25] = 0.0;
    J[26] = s_theta1 * z54 - c_theta1 * z55;
    J[27] = -(c_theta1 * c_theta2 + s_theta1 * s_theta2);
    J[28] = 0.0;
    J[29] = 0.0;
    const double z60 = k1 * (2.0 * (c_theta2 * c_theta3) + 2.0 * (s_theta2 * s_theta3));
    const double z61 = s_theta3 * k1 - s_theta2 * z60;
    const double z62 = a * z61;
    const double z63 = c_theta3 * k1 - c_theta2 * z60;
    const double z64 = a * z63;
    J[30] = s_theta1 * (w * z64 + v * z61) - c_theta1 * (w * z62 - v * z63);
    const double z65 = k1 * (c_theta2 * z59 - s_theta2 * z57);
    const double z66 = c_theta2 * (2.0 * (s_theta3 * z65) - z60 * z57) - s_theta2 * (2.0 * (c_theta3 * z65) +
        z60 * z59);
    J[31] = -z66;
    const double z67 = s_theta2 * z65;
    const double z68 = a * z67;
    const double z69 = z68 + (z57 + z68);
    const double z70 = c_theta2 * z65;
    const double z71 = a * z70;
    const double z72 = z71 - (z59 - z71);
    J[32] = s_theta3 * (k1 * z72) - c_theta3 * (k1 * z69);
    J[33] = s_theta1 * z63 - c_theta1 * z61;
    J[34] = -(s_theta1 * z62 + c_theta1 * z64);
    J[35] = 0.0;
    J[36] = 0.0;
    const double z73 = a * z21;
    const double z74 = a * z19;
    const double z75 = k1 * (z14 - c_theta3 * z73 - s_theta3 * z74);
    const double z76 = z19 + s_theta3 * z75;
    const double z77 = z15 + z76;
    const double z78 = a * (z76 + z77);
    const double z79 = z21 + c_theta3 * z75;
    const double z80 = z16 - z79;
    const double z81 = a * (z79 - z80);
    const double z82 = k1 * (z5 + s_theta2 * z78 + c_theta2 * z81);
    const double z83 = k1 * (c_theta3 * z72 + s_theta3 * z69);
    const double z84 = s_theta3 * z83;
    const double z85 = c_theta3 * z83;
    const double z86 = z83 * z74 - z69 * z75;
    const double z87 = z83 * z73 - z72 * z75;
    const double z88 = k1 * (z84 * z73 - z85 * z74 - c_theta3 * z86 + s_theta3 * z87);
    const double z89 = z84 * z75 - c_theta3 * z88;
    const double z90 = z85 * z75 + s_theta3 * z88;
    const double z91 = z65 * z81 + z59 * z82 + 2.0 * (a * z90);
    const double z92 = z65 * z78 - z57 * z82 + 2.0 * (a * z89);
    const double z93 = k1 * (z70 * z78 - z67 * z81 - s_theta2 * z91 + c_theta2 * z92);
    const double z94 = z67 * z82 + z89 - c_theta2 * z93;
    const double z95 = z80 + c_theta2 * z82;
    const double z96 = a * z95;
    const double z97 = z77 - s_theta2 * z82;
    const double z98 = z1 + z97;
    const double z99 = z70 * z82 + z90 + s_theta2 * z93;
    const double z100 = w * z96 - v * z98 - a * z99;
    const double z101 = v * z58;
    const double z102 = m * z101;
    const double z103 = z101 + a * (w * z56);
    const double z104 = v * z56;
    const double z105 = z104 - a * (w * z58);
    const double z106 = k1 * (z59 * z67 - c_theta2 * z103 + (z57 * z70 - s_theta2 * z105));
    const double z107 = a * (z65 * z67 + c_theta2 * z106);
    const double z108 = z103 + z107;
    const double z109 = z107 + z108;
    const double z110 = a * (z65 * z70 - s_theta2 * z106);
    const double z111 = z105 - z110;
    const double z112 = z110 - z111;
    const double z113 = k1 * (z72 * z84 - c_theta3 * z109 - (z69 * z85 - s_theta3 * z112));
    const double z114 = m * (z109 + a * (z83 * z84 + c_theta3 * z113));
    const double z115 = m * (z112 + a * (z83 * z85 - s_theta3 * z113));
    const double z116 = m * z108;
    const double z117 = m * z111;
    const double z118 = J_2 * z113;
    const double z119 = J_2 * z106;
    const double z120 = m * z104;
    const double z121 = z7 * z116 - (z10 * z117 - (z13 * z118 - (z4 * z119 + (c_theta1 * z120 - s_theta1 *
        z102))));
    const double z122 = theta1 - theta2;
    const double z123 = theta2 - theta3;
    const double z124 = z3 + z12;
    const double z125 = k1 * z124;
    const double z126 = z20 * z114 - (z18 * z115 + z121) + 0.5 * (k * (2.0 * (z122 * z4) - 2.0 * (z123 *
        z125)));
    const double z127 = 1.0 / z51;
    const double z128 = z45 * z114 - (z43 * z115 + (z41 * z116 + (z39 * z117 - (z26 * z119 - z37 * z118))));
    const double z129 = 1.0 + z26;
    const double z130 = k1 * (z25 + z36);
    const double z131 = z127 * (z128 + 0.5 * (k * (2.0 * (z122 * z129) - 2.0 * (z123 * z130))) - z126 * z50);
    const double z132 = z126 * z49 - z50 * z131;
    const double z133 = m * (z18 * z131);
    const double z134 = m * (z20 * z131);
    const double z135 = a * z134;
    const double z136 = a * z133;
    const double z137 = k1 * (J_2 * (z13 * z131) - c_theta3 * z135 - s_theta3 * z136);
    const double z138 = z133 + s_theta3 * z137;
    const double z139 = m * (z10 * z131) + z138;
    const double z140 = z116 + z42 * z131;
    const double z141 = z7 * z132;
    const double z142 = z114 - z46 * z131;
    const double z143 = z20 * z132;
    const double z144 = z142 - z21 * z132 - m * z143;
    const double z145 = k * z123;
    const double z146 = z118 + z38 * z131;
    const double z147 = z13 * z132;
    const double z148 = a * z144;
    const double z149 = z115 + z44 * z131;
    const double z150 = z18 * z132;
    const double z151 = z149 + z19 * z132 + m * z150;
    const double z152 = a * z151;
    const double z153 = k1 * (z145 + (z146 + z14 * z132 + J_2 * z147 + c_theta3 * z148 - s_theta3 * z152));
    const double z154 = z144 - c_theta3 * z153;
    const double z155 = z140 + z16 * z132 + m * z141 + z154;
    const double z156 = z119 + k * z122 - z27 * z131;
    const double z157 = z4 * z132;
    const double z158 = z151 + s_theta3 * z153;
    const double z159 = z117 + z40 * z131;
    const double z160 = z10 * z132;
    const double z161 = z159 - z15 * z132 - m * z160 - z158;
    const double z162 = a * (z158 - z161);
    const double z163 = a * (z154 + z155);
    const double z164 = k1 * (z145 - (z156 - z5 * z132 - J_2 * z157 - s_theta2 * z162 + c_theta2 * z163));
    const double z165 = w * z100 + (z102 + z2 * z132 + m * (s_theta1 * z132) - a * z139 + z155 + c_theta2 *
        z164);
    const double z166 = a * (z138 + z139);
    const double z167 = z134 + c_theta3 * z137;
    const double z168 = m * (z7 * z131) - z167;
    const double z169 = a * (z167 - z168);
    const double z170 = k1 * (J_2 * (z4 * z131) + s_theta2 * z166 + c_theta2 * z169);
    const double z171 = a * z97;
    const double z172 = z2 + z95;
    const double z173 = w * z171 + v * z172 + a * z94;
    const double z174 = w * z173 - (z120 - z1 * z132 - m * (c_theta1 * z132) - a * z168 + z161 + s_theta2 *
        z164);
    const double z175 = k * z4 + c_theta1 * (v * z94 - z165 - a * (s_theta2 * z170)) - s_theta1 * (v * z99 -
        z174 - a * (c_theta2 * z170));
    const double z176 = a * z46;
    const double z177 = a * z44;
    const double z178 = k1 * (z38 - c_theta3 * z176 - s_theta3 * z177);
    const double z179 = z44 + s_theta3 * z178;
    const double z180 = z40 - z179;
    const double z181 = a * (z179 - z180);
    const double z182 = z46 + c_theta3 * z178;
    const double z183 = z42 - z182;
    const double z184 = a * (z182 - z183);
    const double z185 = k1 * (z27 + s_theta2 * z181 + c_theta2 * z184);
    const double z186 = z83 * z177 - z69 * z178;
    const double z187 = z83 * z176 - z72 * z178;
    const double z188 = k1 * (z84 * z176 - z85 * z177 - c_theta3 * z186 + s_theta3 * z187);
    const double z189 = z84 * z178 - c_theta3 * z188;
    const double z190 = z85 * z178 + s_theta3 * z188;
    const double z191 = z65 * z184 + z59 * z185 + 2.0 * (a * z190);
    const double z192 = z65 * z181 - z57 * z185 + 2.0 * (a * z189);
    const double z193 = k1 * (z70 * z181 - z67 * z184 - s_theta2 * z191 + c_theta2 * z192);
    const double z194 = z67 * z185 + z189 - c_theta2 * z193;
    const double z195 = z183 + c_theta2 * z185;
    const double z196 = a * z195;
    const double z197 = z180 + s_theta2 * z185;
    const double z198 = z70 * z185 + z190 + s_theta2 * z193;
    const double z199 = w * z196 + v * z197 - a * z198;
    const double z200 = z149 + m * (z150 + z43 * z131);
    const double z201 = z142 - m * (z143 + z45 * z131);
    const double z202 = a * z201;
    const double z203 = a * z200;
    const double z204 = k1 * (z145 + (z146 + J_2 * (z147 + z37 * z131) + c_theta3 * z202 - s_theta3 * z203));
    const double z205 = z200 + s_theta3 * z204;
    const double z206 = z159 - m * (z160 - z39 * z131) - z205;
    const double z207 = z46 * z132;
    const double z208 = a * z207;
    const double z209 = z44 * z132;
    const double z210 = a * z209;
    const double z211 = k1 * (z38 * z132 - c_theta3 * z208 - s_theta3 * z210);
    const double z212 = z207 + c_theta3 * z211;
    const double z213 = z42 * z132 - z212;
    const double z214 = z209 + s_theta3 * z211;
    const double z215 = z40 * z132 - z214;
    const double z216 = a * (z214 - z215);
    const double z217 = a * (z212 - z213);
    const double z218 = k1 * (z27 * z132 + s_theta2 * z216 + c_theta2 * z217);
    const double z219 = a * (z205 - z206);
    const double z220 = z201 - c_theta3 * z204;
    const double z221 = z140 + m * (z141 + z41 * z131) + z220;
    const double z222 = a * (z220 + z221);
    const double z223 = k1 * (z145 - (z156 - J_2 * (z157 + z26 * z131) - s_theta2 * z219 + c_theta2 * z222));
    const double z224 = v * z194 - (w * z199 + (a * z206 + z213 + c_theta2 * z218)) - a * (s_theta2 * z223);
    const double z225 = a * z197;
    const double z226 = w * z225 - v * z195 - a * z194;
    const double z227 = v * z198 + (w * z226 - (a * z221 - z215 - s_theta2 * z218)) - a * (c_theta2 * z223);
    const double z228 = z127 * (k * z129 + c_theta1 * z224 - s_theta1 * z227 - z50 * z175);
    J[37] = z49 * z175 - z50 * z228;
    const double z229 = z106 * z78 - z105 * z82 + z65 * z91 + z57 * z93 - z26 * z166 - z24 * z170;
    const double z230 = z106 * z81 - z103 * z82 - z65 * z92 - z59 * z93 - z26 * z169 - z23 * z170;
    const double z231 = k * (k1 * (z3 + z124)) - c_theta2 * (z229 - z4 * z162 + c_theta1 * z164) + s_theta2 *
        (z230 + z4 * z163 - s_theta1 * z164);
    const double z232 = z106 * z181 - z105 * z185 + z65 * z191 + z57 * z193 - z26 * z219 - z24 * z223;
    const double z233 = z106 * z184 - z103 * z185 - z65 * z192 - z59 * z193 + z26 * z222 - z23 * z223;
    const double z234 = k * (z129 + z130) - c_theta2 * (z232 - z4 * z216 + c_theta1 * z218) + s_theta2 *
        (z233 - z4 * z217 - s_theta1 * z218);
    const double z235 = z127 * (z234 - z50 * z231);
    J[38] = z50 * z235 - z49 * z231;
    const double z236 = z69 * z88 + (z83 * z87 + (z113 * z74 - z112 * z75 + z37 * z136 + z13 * z152));
    const double z237 = z72 * z88 - (z83 * z86 - (z113 * z73 + z109 * z75 + z37 * z135 - z13 * z148));
    const double z238 = k * z125 + c_theta3 * (z236 - z35 * z137 - z11 * z153) - s_theta3 * (z237 - z31 *
        z137 - z8 * z153);
    const double z239 = z69 * z188 + (z83 * z187 + (z113 * z177 - z112 * z178 + z37 * z203 + z13 * z210));
    const double z240 = z72 * z188 - (z83 * z186 - (z113 * z176 + z109 * z178 - z37 * z202 + z13 * z208));
    const double z241 = k * z130 + c_theta3 * (z239 - z35 * z204 - z11 * z211) - s_theta3 * (z240 - z31 *
        z204 - z8 * z211);
    const double z242 = z127 * (z241 - z50 * z238);
    J[39] = z49 * z238 - z50 * z242;
    const double z243 = z58 * z172 - z56 * z98 - s_theta1 * z94 - c_theta1 * z99;
    const double z244 = z127 * (z58 * z195 + z56 * z197 - s_theta1 * z194 - c_theta1 * z198 - z50 * z243);
    J[40] = z50 * z244 - z49 * z243;
    const double z245 = z58 * z171 + z56 * z96 + s_theta1 * z100 + c_theta1 * z173;
    const double z246 = z127 * (z58 * z225 - z56 * z196 - s_theta1 * z199 + c_theta1 * z226 + z50 * z245);
    J[41] = -(z49 * z245 + z50 * z246);
    J[42] = 0.0;
    J[43] = 0.0;
    J[44] = -z228;
    J[45] = z235;
    J[46] = -z242;
    J[47] = z244;
    J[48] = -z246;
    return n_snake3_finish(49, J);
}

int n_snake3_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    const double a = p[2]; /* half the length of a link [m] */

    /* state */
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    (void)out;
    return N_SNAKE3_OK;
}

int n_snake3_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
    const double m = p[0]; /* each link [kg] */
    const double J = p[1]; /* each link [kg*m^2] */
    const double a = p[2]; /* half the length of a link [m] */
    const double k_ = p[3]; /* stiffness of the hinges [N*m] */
    const double k1 = 1.0 / a;
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-a) > 0.0)) {
        return N_SNAKE3_SINGULAR_1;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta1 = y[2 * count + i]; /* first link [rad] */
        const double theta2 = y[3 * count + i]; /* second link [rad] */
        const double theta3 = y[4 * count + i]; /* third link [rad] */
        const double v = y[5 * count + i];
        const double w = y[6 * count + i];
        const double c_theta1 = cos(theta1);
        const double s_theta1 = sin(theta1);
        const double c_theta2 = cos(theta2);
        const double s_theta2 = sin(theta2);
        const double z1 = c_theta2 * s_theta1 - c_theta1 * s_theta2;
        const double z2 = k1 * z1;
        const double c_theta3 = cos(theta3);
        const double z3 = a * (c_theta2 * z2);
        const double z4 = s_theta1 - z3;
        const double z5 = z3 - z4;
        const double s_theta3 = sin(theta3);
        const double z6 = a * (s_theta2 * z2);
        const double z7 = c_theta1 + z6;
        const double z8 = z6 + z7;
        const double z9 = c_theta3 * z5 + s_theta3 * z8;
        const double z10 = k1 * z9;
        const double z11 = c_theta1 * (m * c_theta1) + s_theta1 * (m * s_theta1) + z2 * (J * z2) + z10 * (J *
            z10);
        const double z12 = z8 - a * (s_theta3 * z10);
        const double z13 = z5 - a * (c_theta3 * z10);
        const double z14 = z11 + z7 * (m * z7) + z4 * (m * z4) + z12 * (m * z12) + z13 * (m * z13);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z14) > 0.0);
        const double z15 = a * c_theta1 * c_theta2 + a * s_theta1 * s_theta2;
        const double z16 = k1 * z15;
        const double z17 = J * z16;
        const double z18 = c_theta2 * z16;
        const double z19 = c_theta1 - z18;
        const double z20 = z18 - z19;
        const double z21 = s_theta2 * z16;
        const double z22 = s_theta1 - z21;
        const double z23 = z21 - z22;
        const double z24 = c_theta3 * (a * z20) + s_theta3 * (a * z23);
        const double z25 = k1 * z24;
        const double z26 = J * z25;
        const double z27 = a * z22;
        const double z28 = m * z27;
        const double z29 = a * z19;
        const double z30 = m * z29;
        const double z31 = a * (z23 - s_theta3 * z25);
        const double z32 = m * z31;
        const double z33 = a * (z20 - c_theta3 * z25);
        const double z34 = m * z33;
        const double z35 = J + z16 * z17 + z25 * z26 + z27 * z28 + z29 * z30 + z31 * z32 + z33 * z34;
        const double z36 = z2 * z17 + z10 * z26 - z7 * z28 + z4 * z30 + z12 * z32 + z13 * z34;
        const double z37 = 1.0 / z14;
        const double z38 = z36 * z37;
        const double z39 = z35 - z36 * z38;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z39) > 1e-14 * z35);
        const double z40 = c_theta1 * v;
        const double z41 = s_theta1 * v;
        const double z42 = c_theta1 * w;
        const double z43 = z41 - a * z42;
        const double z44 = s_theta1 * w;
        const double z45 = z40 + a * z44;
        const double z46 = k1 * (c_theta2 * z43 - s_theta2 * z45);
        const double z47 = c_theta2 * z46;
        const double z48 = a * z47;
        const double z49 = z48 - (z43 - z48);
        const double z50 = s_theta2 * z46;
        const double z51 = a * z50;
        const double z52 = z51 + (z45 + z51);
        const double z53 = k1 * (c_theta3 * z49 + s_theta3 * z52);
        const double z54 = v * z42;
        const double z55 = z54 + a * (w * z44);
        const double z56 = v * z44;
        const double z57 = z56 - a * (w * z42);
        const double z58 = k1 * (z43 * z50 - c_theta2 * z55 + (z45 * z47 - s_theta2 * z57));
        const double z59 = a * (z46 * z50 + c_theta2 * z58);
        const double z60 = z55 + z59;
        const double z61 = z59 + z60;
        const double z62 = s_theta3 * z53;
        const double z63 = c_theta3 * z53;
        const double z64 = a * (z46 * z47 - s_theta2 * z58);
        const double z65 = z57 - z64;
        const double z66 = z64 - z65;
        const double z67 = k1 * (z49 * z62 - c_theta3 * z61 - (z52 * z63 - s_theta3 * z66));
        const double z68 = m * (z61 + a * (z53 * z62 + c_theta3 * z67));
        const double z69 = m * (z66 + a * (z53 * z63 - s_theta3 * z67));
        const double z70 = m * z60;
        const double z71 = m * z65;
        const double z72 = J * z67;
        const double z73 = J * z58;
        const double z74 = z7 * z71 - (z10 * z72 - (z2 * z73 + (c_theta1 * (m * z56) - s_theta1 * (m *
            z54))));
        const double z75 = theta1 - theta2;
        const double z76 = theta2 - theta3;
        const double z77 = z13 * z68 - (z12 * z69 + (z4 * z70 - z74)) + 0.5 * (k_ * (2.0 * (z75 * z2) - 2.0 *
            (z76 * (k1 * (z1 + z9)))));
        const double z78 = z33 * z68 - (z31 * z69 + (z29 * z70 + (z27 * z71 - (z16 * z73 - z25 * z72))));
        const double z79 = z78 + 0.5 * (k_ * (2.0 * (z75 * (1.0 + z16)) - 2.0 * (z76 * (k1 * (z15 + z24)))));
        const double z80 = (z79 - z77 * z38) / z39;
        /* (I.2.15) */
        const double slope1 = z40; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = z41; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = w; /* theta1' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = z46; /* theta2' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -z53; /* theta3' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        /* (I.2.15) 22:4 */
        const double slope6 = z77 * z37 - z38 * z80; /* v' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = -z80; /* w' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
    }
    if (singular1) {
        return N_SNAKE3_SINGULAR_2;
    }
    return bad ? N_SNAKE3_NOT_FINITE : N_SNAKE3_OK;
}
