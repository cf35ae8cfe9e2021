/*
 * n_trailer3.c: n_trailer3, emitted by nhc 0.1.0 (nhc:7217e75ab43e1bce)
 * A tractor with three trailers, each hitched to the axle before it; none of the four axles slips sideways.
 * Source: n_trailer3.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * n_trailer3.h says what each function does.
 */
#include "n_trailer3.h"

#include <float.h>
#include <math.h>

const char *const n_trailer3_coordinate_names[] = {
    "x",
    "y",
    "theta0",
    "theta1",
    "theta2",
    "theta3"
};
const char *const n_trailer3_state_names[] = {
    "x",
    "y",
    "theta0",
    "theta1",
    "theta2",
    "theta3",
    "v",
    "w"
};
const char *const n_trailer3_parameter_names[] = {
    "m0",
    "J0",
    "m",
    "J",
    "L"
};
const double n_trailer3_parameter_defaults[] = {
    1.0,
    0.1,
    0.5,
    0.05,
    0.8
};

static int n_trailer3_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? N_TRAILER3_OK : N_TRAILER3_NOT_FINITE;
}

int n_trailer3_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */
    const double v = y[6];
    const double w = y[7];
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* parameters only */
    const double k1 = 1.0 / L;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    const double c_theta0 = cos(theta0);
    const double s_theta0 = sin(theta0);
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double z1 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0);
    const double c_theta2 = cos(theta2);
    const double z2 = s_theta0 - L * (c_theta1 * z1);
    const double s_theta2 = sin(theta2);
    const double z3 = c_theta0 + L * (s_theta1 * z1);
    const double z4 = k1 * (c_theta2 * z2 - s_theta2 * z3);
    const double z5 = c_theta0 * (m0 * c_theta0) + s_theta0 * (m0 * s_theta0) + z1 * (J * z1) + z4 * (J * z4);
    const double c_theta3 = cos(theta3);
    const double z6 = z2 - L * (c_theta2 * z4);
    const double s_theta3 = sin(theta3);
    const double z7 = z3 + L * (s_theta2 * z4);
    const double z8 = k1 * (c_theta3 * z6 - s_theta3 * z7);
    const double z9 = z5 + z8 * (J * z8) + z3 * (m * z3) + z2 * (m * z2) + z7 * (m * z7);
    const double z10 = z7 + L * (s_theta3 * z8);
    const double z11 = z6 - L * (c_theta3 * z8);
    const double z12 = z9 + z6 * (m * z6) + z10 * (m * z10) + z11 * (m * z11);
    /* the mass matrix is singular */
    if (!(fabs(z12) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J0) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    const double z13 = c_theta0 * v;
    const double z14 = s_theta0 * v;
    const double z15 = k1 * (c_theta1 * z14 - s_theta1 * z13);
    const double z16 = c_theta1 * z15;
    const double y1_dot = z14 - L * z16;
    const double z17 = s_theta1 * z15;
    const double x1_dot = z13 + L * z17;
    const double z18 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot);
    const double z19 = c_theta2 * z18;
    const double y2_dot = y1_dot - L * z19;
    const double z20 = s_theta2 * z18;
    const double x2_dot = x1_dot + L * z20;
    const double z21 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot);
    const double z22 = v * (c_theta0 * w);
    const double z23 = v * (s_theta0 * w);
    const double z24 = k1 * (z14 * z17 - c_theta1 * z22 + (z13 * z16 - s_theta1 * z23));
    const double z25 = z22 + L * (z15 * z17 + c_theta1 * z24);
    const double z26 = z23 - L * (z15 * z16 - s_theta1 * z24);
    const double z27 = k1 * (y1_dot * z20 - c_theta2 * z25 + (x1_dot * z19 - s_theta2 * z26));
    const double z28 = z25 + L * (z18 * z20 + c_theta2 * z27);
    const double z29 = s_theta3 * z21;
    const double z30 = c_theta3 * z21;
    const double z31 = z26 - L * (z18 * z19 - s_theta2 * z27);
    const double z32 = k1 * (y2_dot * z29 - c_theta3 * z28 + (x2_dot * z30 - s_theta3 * z31));
    const double z33 = z4 * (J * z27) + (z1 * (J * z24) + (c_theta0 * (m0 * z23) - s_theta0 * (m0 * z22)));
    const double z34 = z7 * (m * z31) - (z2 * (m * z25) - (z3 * (m * z26) + (z8 * (J * z32) + z33)));
    const double z35 = z10 * (m * (z31 - L * (z21 * z30 - s_theta3 * z32))) - (z6 * (m * z28) - z34);
    /* (I.2.15) */
    dydt[0] = z13; /* x' */
    dydt[1] = z14; /* y' */
    dydt[2] = w; /* theta0' */
    dydt[3] = z15; /* theta1' */
    dydt[4] = z18; /* theta2' */
    dydt[5] = z21; /* theta3' */
    /* (I.2.15) 30:4 */
    dydt[6] = -(z11 * (m * (z28 + L * (z21 * z29 + c_theta3 * z32))) - z35) / z12; /* v' */
    dydt[7] = 0.0; /* w' */
    return n_trailer3_finish(8, dydt);
}

int n_trailer3_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */
    const double v = y[6];
    const double w = y[7];
    const double L = p[4]; /* from axle to axle [m] */

    /* parameters only */
    const double k1 = 1.0 / L;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    const double c_theta0 = cos(theta0);
    const double z1 = c_theta0 * v;
    const double s_theta0 = sin(theta0);
    const double z2 = s_theta0 * v;
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double z3 = k1 * (c_theta1 * z2 - s_theta1 * z1);
    const double c_theta2 = cos(theta2);
    const double y1_dot = z2 - L * (c_theta1 * z3);
    const double s_theta2 = sin(theta2);
    const double x1_dot = z1 + L * (s_theta1 * z3);
    const double z4 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot);
    const double c_theta3 = cos(theta3);
    const double s_theta3 = sin(theta3);
    /* (I.2.4) */
    qdot[0] = z1; /* x' */
    qdot[1] = z2; /* y' */
    qdot[2] = w; /* theta0' */
    qdot[3] = z3; /* theta1' */
    qdot[4] = z4; /* theta2' */
    /* theta3' */
    qdot[5] = k1 * (c_theta3 * (y1_dot - L * (c_theta2 * z4)) - s_theta3 * (x1_dot + L * (s_theta2 * z4)));
    return n_trailer3_finish(6, qdot);
}

int n_trailer3_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */
    const double v = y[6];
    const double w = y[7];
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* parameters only */
    const double k1 = 1.0 / L;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    const double c_theta0 = cos(theta0);
    const double s_theta0 = sin(theta0);
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double z1 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0);
    const double c_theta2 = cos(theta2);
    const double z2 = s_theta0 - L * (c_theta1 * z1);
    const double s_theta2 = sin(theta2);
    const double z3 = c_theta0 + L * (s_theta1 * z1);
    const double z4 = k1 * (c_theta2 * z2 - s_theta2 * z3);
    const double z5 = c_theta0 * (m0 * c_theta0) + s_theta0 * (m0 * s_theta0) + z1 * (J * z1) + z4 * (J * z4);
    const double c_theta3 = cos(theta3);
    const double z6 = z2 - L * (c_theta2 * z4);
    const double s_theta3 = sin(theta3);
    const double z7 = z3 + L * (s_theta2 * z4);
    const double z8 = k1 * (c_theta3 * z6 - s_theta3 * z7);
    const double z9 = z5 + z8 * (J * z8) + z3 * (m * z3) + z2 * (m * z2) + z7 * (m * z7);
    const double z10 = z7 + L * (s_theta3 * z8);
    const double z11 = z6 - L * (c_theta3 * z8);
    const double z12 = z9 + z6 * (m * z6) + z10 * (m * z10) + z11 * (m * z11);
    /* the mass matrix is singular */
    if (!(fabs(z12) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J0) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    const double z13 = v * (s_theta0 * w);
    const double z14 = v * (c_theta0 * w);
    const double z15 = s_theta0 * v;
    const double z16 = c_theta0 * v;
    const double z17 = k1 * (c_theta1 * z15 - s_theta1 * z16);
    const double z18 = s_theta1 * z17;
    const double z19 = z17 * z18;
    const double z20 = z15 * z18;
    const double z21 = c_theta1 * z17;
    const double z22 = z16 * z21;
    const double z23 = k1 * (z20 - c_theta1 * z14 + (z22 - s_theta1 * z13));
    const double z24 = z14 + L * (z19 + c_theta1 * z23);
    const double y1_dot = z15 - L * z21;
    const double x1_dot = z16 + L * z18;
    const double z25 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot);
    const double z26 = s_theta2 * z25;
    const double z27 = z25 * z26;
    const double z28 = y1_dot * z26;
    const double z29 = c_theta2 * z25;
    const double z30 = x1_dot * z29;
    const double z31 = z17 * z21;
    const double z32 = z13 - L * (z31 - s_theta1 * z23);
    const double z33 = k1 * (z28 - c_theta2 * z24 + (z30 - s_theta2 * z32));
    const double z34 = z24 + L * (z27 + c_theta2 * z33);
    const double y2_dot = y1_dot - L * z29;
    const double x2_dot = x1_dot + L * z26;
    const double z35 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot);
    const double z36 = s_theta3 * z35;
    const double z37 = y2_dot * z36;
    const double z38 = c_theta3 * z35;
    const double z39 = x2_dot * z38;
    const double z40 = z25 * z29;
    const double z41 = z32 - L * (z40 - s_theta2 * z33);
    const double z42 = k1 * (z37 - c_theta3 * z34 + (z39 - s_theta3 * z41));
    const double z43 = z4 * (J * z33) + (z1 * (J * z23) + (c_theta0 * (m0 * z13) - s_theta0 * (m0 * z14)));
    const double z44 = z7 * (m * z41) - (z2 * (m * z24) - (z3 * (m * z32) + (z8 * (J * z42) + z43)));
    const double z45 = z10 * (m * (z41 - L * (z35 * z38 - s_theta3 * z42))) - (z6 * (m * z34) - z44);
    const double z46 = (z11 * (m * (z34 + L * (z35 * z36 + c_theta3 * z42))) - z45) / z12;
    const double z47 = z13 + c_theta0 * z46;
    const double z48 = z14 - s_theta0 * z46;
    const double z49 = k1 * (z20 - c_theta1 * z48 + (z22 - s_theta1 * z47));
    const double z50 = z48 + L * (z19 + c_theta1 * z49);
    const double z51 = z47 - L * (z31 - s_theta1 * z49);
    const double z52 = k1 * (z28 - c_theta2 * z50 + (z30 - s_theta2 * z51));
    const double z53 = z37 - c_theta3 * (z50 + L * (z27 + c_theta2 * z52)) + (z39 - s_theta3 * (z51 - L *
        (z40 - s_theta2 * z52)));
    /* (I.2.15) */
    qddot[0] = -z47; /* x'' */
    qddot[1] = z48; /* y'' */
    qddot[2] = 0.0; /* theta0'' */
    qddot[3] = -z49; /* theta1'' */
    qddot[4] = -z52; /* theta2'' */
    qddot[5] = -k1 * z53; /* theta3'' */
    return n_trailer3_finish(6, qddot);
}

int n_trailer3_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* axle of the tractor [m] */
    const double y_2 = q[1]; /* axle of the tractor [m] */
    const double theta0 = q[2]; /* heading of the tractor [rad] */
    const double theta1 = q[3]; /* first trailer [rad] */
    const double theta2 = q[4]; /* second trailer [rad] */
    const double theta3 = q[5]; /* third trailer [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta0_dot = qdot[2];

    /* state */
    const double c_theta0 = cos(theta0);
    const double s_theta0 = sin(theta0);
    y[0] = x;
    y[1] = y_2;
    y[2] = theta0;
    y[3] = theta1;
    y[4] = theta2;
    y[5] = theta3;
    y[6] = x_dot * c_theta0 + y_dot * s_theta0;
    y[7] = theta0_dot;
    return n_trailer3_finish(8, y);
}

int n_trailer3_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta0 = q[2]; /* heading of the tractor [rad] */
    const double theta1 = q[3]; /* first trailer [rad] */
    const double theta2 = q[4]; /* second trailer [rad] */
    const double theta3 = q[5]; /* third trailer [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta1_dot = qdot[3];
    const double theta2_dot = qdot[4];
    const double theta3_dot = qdot[5];
    const double L = p[4]; /* from axle to axle [m] */

    /* state */
    const double s_theta0 = sin(theta0);
    const double c_theta0 = cos(theta0);
    const double s_theta1 = sin(theta1);
    const double x1_dot = x_dot + L * (theta1_dot * s_theta1);
    const double c_theta1 = cos(theta1);
    const double y1_dot = y_dot - L * (theta1_dot * c_theta1);
    const double s_theta2 = sin(theta2);
    const double x2_dot = x1_dot + L * (theta2_dot * s_theta2);
    const double c_theta2 = cos(theta2);
    const double y2_dot = y1_dot - L * (theta2_dot * c_theta2);
    const double s_theta3 = sin(theta3);
    const double c_theta3 = cos(theta3);
    /* (I.1.1) 32:5 */
    r[0] = y_dot * c_theta0 - x_dot * s_theta0; /* axle0 = 0 */
    /* (I.1.1) 33:5 */
    r[1] = c_theta1 * y1_dot - s_theta1 * x1_dot; /* axle1 = 0 */
    /* (I.1.1) 34:5 */
    r[2] = c_theta2 * y2_dot - s_theta2 * x2_dot; /* axle2 = 0 */
    /* (I.1.1) 35:5 */
    /* axle3 = 0 */
    r[3] = c_theta3 * (y2_dot - L * (theta3_dot * c_theta3)) - s_theta3 * (x2_dot + L * (theta3_dot *
        s_theta3));
    return n_trailer3_finish(4, r);
}

int n_trailer3_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */
    const double v = y[6];
    const double w = y[7];
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* parameters only */
    const double k1 = 1.0 / L;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    const double c_theta0 = cos(theta0);
    const double z1 = m0 * c_theta0;
    const double s_theta0 = sin(theta0);
    const double z2 = m0 * s_theta0;
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double z3 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0);
    const double z4 = J * z3;
    const double c_theta2 = cos(theta2);
    const double z5 = s_theta0 - L * (c_theta1 * z3);
    const double s_theta2 = sin(theta2);
    const double z6 = c_theta0 + L * (s_theta1 * z3);
    const double z7 = k1 * (c_theta2 * z5 - s_theta2 * z6);
    const double z8 = J * z7;
    const double c_theta3 = cos(theta3);
    const double z9 = z5 - L * (c_theta2 * z7);
    const double s_theta3 = sin(theta3);
    const double z10 = z6 + L * (s_theta2 * z7);
    const double z11 = k1 * (c_theta3 * z9 - s_theta3 * z10);
    const double z12 = J * z11;
    const double z13 = m * z6;
    const double z14 = c_theta0 * z1 + s_theta0 * z2 + z3 * z4 + z7 * z8 + z11 * z12 + z6 * z13;
    const double z15 = m * z5;
    const double z16 = m * z10;
    const double z17 = m * z9;
    const double z18 = z10 + L * (s_theta3 * z11);
    const double z19 = m * z18;
    const double z20 = z9 - L * (c_theta3 * z11);
    const double z21 = m * z20;
    const double z22 = z14 + z5 * z15 + z10 * z16 + z9 * z17 + z18 * z19 + z20 * z21;
    /* the mass matrix is singular */
    if (!(fabs(z22) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J0) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    const double z23 = v * (c_theta0 * w);
    const double z24 = s_theta0 * v;
    const double z25 = c_theta0 * v;
    const double z26 = k1 * (c_theta1 * z24 - s_theta1 * z25);
    const double z27 = s_theta1 * z26;
    const double z28 = c_theta1 * z26;
    const double z29 = v * (s_theta0 * w);
    const double z30 = k1 * (z24 * z27 - c_theta1 * z23 + (z25 * z28 - s_theta1 * z29));
    const double z31 = z23 + L * (z26 * z27 + c_theta1 * z30);
    const double y1_dot = z24 - L * z28;
    const double x1_dot = z25 + L * z27;
    const double z32 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot);
    const double z33 = s_theta2 * z32;
    const double z34 = c_theta2 * z32;
    const double z35 = z29 - L * (z26 * z28 - s_theta1 * z30);
    const double z36 = k1 * (y1_dot * z33 - c_theta2 * z31 + (x1_dot * z34 - s_theta2 * z35));
    const double z37 = z31 + L * (z32 * z33 + c_theta2 * z36);
    const double y2_dot = y1_dot - L * z34;
    const double x2_dot = x1_dot + L * z33;
    const double z38 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot);
    const double z39 = s_theta3 * z38;
    const double z40 = c_theta3 * z38;
    const double z41 = z35 - L * (z32 * z34 - s_theta2 * z36);
    const double z42 = k1 * (y2_dot * z39 - c_theta3 * z37 + (x2_dot * z40 - s_theta3 * z41));
    const double z43 = m * (z37 + L * (z38 * z39 + c_theta3 * z42));
    const double z44 = k1 * (c_theta1 * c_theta0 + s_theta1 * s_theta0);
    const double z45 = c_theta0 - L * (c_theta1 * z44);
    const double z46 = s_theta0 - L * (s_theta1 * z44);
    const double z47 = k1 * (c_theta2 * z45 + s_theta2 * z46);
    const double z48 = z45 - L * (c_theta2 * z47);
    const double z49 = z46 - L * (s_theta2 * z47);
    const double z50 = k1 * (c_theta3 * z48 + s_theta3 * z49);
    const double z51 = z48 - L * (c_theta3 * z50);
    const double z52 = m * (z41 - L * (z38 * z40 - s_theta3 * z42));
    const double z53 = z49 - L * (s_theta3 * z50);
    const double z54 = m * z37;
    const double z55 = m * z41;
    const double z56 = m * z31;
    const double z57 = m * z35;
    const double z58 = J * z42;
    const double z59 = J * z36;
    const double z60 = J * z30;
    const double z61 = m0 * z29;
    const double z62 = m0 * z23;
    const double z63 = z46 * z57 - (z50 * z58 + (z47 * z59 + (z44 * z60 - (s_theta0 * z61 + c_theta0 *
        z62))));
    const double z64 = s_theta0 * z1 - c_theta0 * z2 - z44 * z4 - z47 * z8 - z50 * z12 + z46 * z13;
    const double z65 = z6 * z57 + (z11 * z58 + (z7 * z59 + (z3 * z60 + (c_theta0 * z61 - s_theta0 * z62))));
    const double z66 = (z20 * z43 - (z18 * z52 - (z9 * z54 - (z10 * z55 - (z5 * z56 - z65))))) / z22;
    const double z67 = (z64 - z45 * z15 + z49 * z16 - z48 * z17 + z19 * z53 - z21 * z51) * z66;
    const double z68 = z43 * z51 + (z52 * z53 + (z48 * z54 + (z49 * z55 + (z45 * z56 + z63)))) + z67;
    const double z69 = k1 * (c_theta1 * c_theta2 + s_theta1 * s_theta2);
    const double z70 = c_theta1 - L * (c_theta2 * z69);
    const double z71 = s_theta1 - L * (s_theta2 * z69);
    const double z72 = k1 * (c_theta3 * z70 + s_theta3 * z71);
    const double z73 = z70 - L * (c_theta3 * z72);
    const double z74 = z71 - L * (s_theta3 * z72);
    const double z75 = z71 * z55 + (c_theta1 * z56 + (s_theta1 * z57 - (z72 * z58 - (k1 * z60 - z69 * z59))));
    const double z76 = k1 * z4 - z69 * z8 - z72 * z12 + s_theta1 * z13 - c_theta1 * z15 + z71 * z16;
    const double z77 = z43 * z73 + (z52 * z74 + (z70 * z54 + z75)) + (z76 - z70 * z17 + z19 * z74 - z21 *
        z73) * z66;
    const double z78 = k1 * (c_theta2 * c_theta3 + s_theta2 * s_theta3);
    const double z79 = c_theta2 - L * (c_theta3 * z78);
    const double z80 = s_theta2 - L * (s_theta3 * z78);
    const double z81 = z43 * z79 + (z52 * z80 + (c_theta2 * z54 + (s_theta2 * z55 + (k1 * z59 - z78 * z58))));
    const double z82 = k1 * z8 - z78 * z12 + s_theta2 * z16 - c_theta2 * z17 + z19 * z80 - z21 * z79;
    const double z83 = c_theta3 * z43 + (k1 * z58 + s_theta3 * z52) + (k1 * z12 + s_theta3 * z19 - c_theta3 *
        z21) * z66;
    /* (I.4.1) 32:5 */
    lambda[0] = z68; /* reaction of axle0: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 33:5 */
    lambda[1] = z77; /* reaction of axle1: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 34:5 */
    lambda[2] = z81 + z82 * z66; /* reaction of axle2: Q_i gains lambda_3 a_3i */
    /* (I.4.1) 35:5 */
    lambda[3] = z83; /* reaction of axle3: Q_i gains lambda_4 a_4i */
    return n_trailer3_finish(4, lambda);
}

double n_trailer3_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */
    const double v = y[6];
    const double w = y[7];
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* parameters only */
    const double k1 = 1.0 / L;

    /* state */
    const double c_theta0 = cos(theta0);
    const double z1 = c_theta0 * v;
    const double s_theta1 = sin(theta1);
    const double c_theta1 = cos(theta1);
    const double s_theta0 = sin(theta0);
    const double z2 = s_theta0 * v;
    const double z3 = k1 * (c_theta1 * z2 - s_theta1 * z1);
    const double x1_dot = z1 + L * (s_theta1 * z3);
    const double s_theta2 = sin(theta2);
    const double c_theta2 = cos(theta2);
    const double y1_dot = z2 - L * (c_theta1 * z3);
    const double z4 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot);
    const double x2_dot = x1_dot + L * (s_theta2 * z4);
    const double s_theta3 = sin(theta3);
    const double c_theta3 = cos(theta3);
    const double y2_dot = y1_dot - L * (c_theta2 * z4);
    const double z5 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot);
    const double x3_dot = x2_dot + L * (s_theta3 * z5);
    const double y3_dot = y2_dot - L * (c_theta3 * z5);
    const double z6 = 0.5 * (m0 * (z1 * z1 + z2 * z2)) + 0.5 * (J0 * (w * w)) + (0.5 * (m * (x1_dot * x1_dot
        + y1_dot * y1_dot)) + 0.5 * (J * (z3 * z3)));
    const double z7 = 0.5 * (m * (x3_dot * x3_dot + y3_dot * y3_dot)) + 0.5 * (J * (z5 * z5)) + (0.5 * (m *
        (x2_dot * x2_dot + y2_dot * y2_dot)) + 0.5 * (J * (z4 * z4)) + z6);
    return z7;
}

int n_trailer3_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta0 = y[2]; /* heading of the tractor [rad] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */
    const double v = y[6];
    const double w = y[7];
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J_2 = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */

    /* parameters only */
    const double k1 = 1.0 / L;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    const double c_theta0 = cos(theta0);
    const double z1 = m0 * c_theta0;
    const double s_theta0 = sin(theta0);
    const double z2 = m0 * s_theta0;
    const double c_theta1 = cos(theta1);
    const double s_theta1 = sin(theta1);
    const double z3 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0);
    const double z4 = J_2 * z3;
    const double c_theta2 = cos(theta2);
    const double z5 = s_theta0 - L * (c_theta1 * z3);
    const double s_theta2 = sin(theta2);
    const double z6 = c_theta0 + L * (s_theta1 * z3);
    const double z7 = k1 * (c_theta2 * z5 - s_theta2 * z6);
    const double z8 = J_2 * z7;
    const double c_theta3 = cos(theta3);
    const double z9 = z5 - L * (c_theta2 * z7);
    const double s_theta3 = sin(theta3);
    const double z10 = z6 + L * (s_theta2 * z7);
    const double z11 = k1 * (c_theta3 * z9 - s_theta3 * z10);
    const double z12 = J_2 * z11;
    const double z13 = m * z6;
    const double z14 = c_theta0 * z1 + s_theta0 * z2 + z3 * z4 + z7 * z8 + z11 * z12 + z6 * z13;
    const double z15 = m * z5;
    const double z16 = m * z10;
    const double z17 = m * z9;
    const double z18 = z10 + L * (s_theta3 * z11);
    const double z19 = m * z18;
    const double z20 = z9 - L * (c_theta3 * z11);
    const double z21 = m * z20;
    const double z22 = z14 + z5 * z15 + z10 * z16 + z9 * z17 + z18 * z19 + z20 * z21;
    /* the mass matrix is singular */
    if (!(fabs(z22) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J0) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    const double z23 = s_theta0 * v;
    const double z24 = c_theta0 * v;
    const double z25 = c_theta1 * k1;
    const double z26 = s_theta1 * k1;
    const double z27 = k1 * (c_theta1 * c_theta2 + s_theta1 * s_theta2);
    const double z28 = c_theta2 * k1 - c_theta1 * z27;
    const double z29 = s_theta2 * k1 - s_theta1 * z27;
    const double z30 = k1 * (c_theta1 * z23 - s_theta1 * z24);
    const double z31 = s_theta1 * z30;
    const double x1_dot = z24 + L * z31;
    const double z32 = c_theta1 * z30;
    const double y1_dot = z23 - L * z32;
    const double z33 = k1 * (c_theta2 * c_theta3 + s_theta2 * s_theta3);
    const double z34 = c_theta3 * k1 - c_theta2 * z33;
    const double z35 = s_theta3 * k1 - s_theta2 * z33;
    const double z36 = L * z35;
    const double z37 = L * z34;
    const double z38 = k1 * (s_theta1 * z36 + c_theta1 * z37);
    const double z39 = z34 - c_theta1 * z38;
    const double z40 = z35 - s_theta1 * z38;
    const double z41 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot);
    const double z42 = s_theta2 * z41;
    const double x2_dot = x1_dot + L * z42;
    const double z43 = c_theta2 * z41;
    const double y2_dot = y1_dot - L * z43;
    const double z44 = 1.0 / z22;
    const double z45 = L * z21;
    const double z46 = L * z19;
    const double z47 = k1 * (z12 - c_theta3 * z45 + s_theta3 * z46);
    const double z48 = m * (z10 + z18) - s_theta3 * z47;
    const double z49 = L * z48;
    const double z50 = m * (z9 + z20) + c_theta3 * z47;
    const double z51 = L * z50;
    const double z52 = k1 * (z8 + s_theta2 * z49 - c_theta2 * z51);
    const double z53 = z13 + z48 - s_theta2 * z52;
    const double z54 = L * z53;
    const double z55 = z15 + z50 + c_theta2 * z52;
    const double z56 = L * z55;
    const double z57 = k1 * (z4 + s_theta1 * z54 - c_theta1 * z56);
    const double z58 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot);
    const double z59 = s_theta3 * z58;
    const double z60 = c_theta3 * z58;
    const double z61 = z58 * z46 - x2_dot * z47;
    const double z62 = z58 * z45 - y2_dot * z47;
    const double z63 = k1 * (z59 * z45 + z60 * z46 + c_theta3 * z61 + s_theta3 * z62);
    const double z64 = z59 * z47 - c_theta3 * z63;
    const double z65 = z60 * z47 + s_theta3 * z63;
    const double z66 = z41 * z51 - y1_dot * z52 - L * z65;
    const double z67 = z41 * z49 - x1_dot * z52 + L * z64;
    const double z68 = k1 * (z43 * z49 + z42 * z51 + s_theta2 * z66 + c_theta2 * z67);
    const double z69 = z42 * z52 + z64 - c_theta2 * z68;
    const double z70 = z43 * z52 + z65 + s_theta2 * z68;
    const double z71 = z30 * z56 - z23 * z57 - L * z70;
    const double z72 = z30 * z54 - z24 * z57 + L * z69;
    const double z73 = k1 * (z32 * z54 + z31 * z56 + s_theta1 * z71 + c_theta1 * z72);
    const double z74 = z31 * z57 + z69 - c_theta1 * z73;
    const double z75 = z1 + z53 - s_theta1 * z57;
    const double z76 = v * z75;
    const double z77 = c_theta0 * w;
    const double z78 = v * z77;
    const double z79 = m0 * z78;
    const double z80 = s_theta0 * w;
    const double z81 = v * z80;
    const double z82 = k1 * (z23 * z31 - c_theta1 * z78 + (z24 * z32 - s_theta1 * z81));
    const double z83 = z78 + L * (z30 * z31 + c_theta1 * z82);
    const double z84 = z81 - L * (z30 * z32 - s_theta1 * z82);
    const double z85 = k1 * (y1_dot * z42 - c_theta2 * z83 + (x1_dot * z43 - s_theta2 * z84));
    const double z86 = z83 + L * (z41 * z42 + c_theta2 * z85);
    const double z87 = z84 - L * (z41 * z43 - s_theta2 * z85);
    const double z88 = k1 * (y2_dot * z59 - c_theta3 * z86 + (x2_dot * z60 - s_theta3 * z87));
    const double z89 = m * (z86 + L * (z58 * z59 + c_theta3 * z88));
    const double z90 = m * (z87 - L * (z58 * z60 - s_theta3 * z88));
    const double z91 = m * z86;
    const double z92 = m * z87;
    const double z93 = m * z83;
    const double z94 = m * z84;
    const double z95 = J_2 * z88;
    const double z96 = J_2 * z85;
    const double z97 = J_2 * z82;
    const double z98 = m0 * z81;
    const double z99 = z6 * z94 + (z11 * z95 + (z7 * z96 + (z3 * z97 + (c_theta0 * z98 - s_theta0 * z79))));
    const double z100 = (z20 * z89 - (z18 * z90 - (z9 * z91 - (z10 * z92 - (z5 * z93 - z99))))) * z44;
    const double z101 = z89 - z21 * z100 - m * (z20 * z100);
    const double z102 = L * z101;
    const double z103 = z90 + z19 * z100 + m * (z18 * z100);
    const double z104 = L * z103;
    const double z105 = k1 * (z95 + z12 * z100 + J_2 * (z11 * z100) + c_theta3 * z102 + s_theta3 * z104);
    const double z106 = z101 + (z91 - z17 * z100 - m * (z9 * z100)) - c_theta3 * z105;
    const double z107 = z103 + (z92 + z16 * z100 + m * (z10 * z100)) - s_theta3 * z105;
    const double z108 = L * z107;
    const double z109 = L * z106;
    const double z110 = k1 * (z96 + z8 * z100 + J_2 * (z7 * z100) + s_theta2 * z108 + c_theta2 * z109);
    const double z111 = z93 - z15 * z100 - m * (z5 * z100) + z106 - c_theta2 * z110;
    const double z112 = z94 + z13 * z100 + m * (z6 * z100) + z107 - s_theta2 * z110;
    const double z113 = L * z112;
    const double z114 = L * z111;
    const double z115 = k1 * (z97 + z4 * z100 + J_2 * (z3 * z100) + s_theta1 * z113 + c_theta1 * z114);
    const double z116 = v * z74 + (w * z76 - (z79 - z2 * z100 - m0 * (s_theta0 * z100)) - z111 + c_theta1 *
        z115);
    const double z117 = z32 * z57 + z70 + s_theta1 * z73;
    const double z118 = z2 + z55 + c_theta1 * z57;
    const double z119 = v * z118;
    const double z120 = v * z117 - (w * z119 - (z98 + z1 * z100 + m0 * (c_theta0 * z100)) - z112 + s_theta1 *
        z115);
    const double z121 = z82 * z54 - z81 * z57 - z30 * z71 + z24 * z73 + z3 * z113 - c_theta0 * z115;
    const double z122 = z82 * z56 + z78 * z57 + z30 * z72 + z23 * z73 - z3 * z114 - s_theta0 * z115;
    const double z123 = z85 * z49 - z84 * z52 - z41 * z66 + x1_dot * z68 + z7 * z108 - z6 * z110;
    const double z124 = z85 * z51 + z83 * z52 + z41 * z67 + y1_dot * z68 - z7 * z109 - z5 * z110;
    const double z125 = x2_dot * z63 - (z58 * z62 - (z88 * z46 - z87 * z47 + z11 * z104)) - z10 * z105;
    const double z126 = y2_dot * z63 + (z58 * z61 + (z88 * z45 + z86 * z47 - z11 * z102)) - z9 * z105;
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = -z23;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = c_theta0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = z24;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = s_theta0;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = 1.0;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = c_theta0 * (v * z25) + s_theta0 * (v * z26);
    J[27] = -(c_theta1 * (z24 * k1) + s_theta1 * (z23 * k1));
    J[28] = 0.0;
    J[29] = 0.0;
    J[30] = s_theta0 * z25 - c_theta0 * z26;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = c_theta0 * (v * z28) + s_theta0 * (v * z29);
    J[35] = s_theta1 * (c_theta2 * z30 + z23 * z27) - c_theta1 * (s_theta2 * z30 - z24 * z27);
    J[36] = -(c_theta2 * (k1 * x1_dot) + s_theta2 * (k1 * y1_dot));
    J[37] = 0.0;
    J[38] = s_theta0 * z28 - c_theta0 * z29;
    J[39] = 0.0;
    J[40] = 0.0;
    J[41] = 0.0;
    J[42] = c_theta0 * (v * z39) + s_theta0 * (v * z40);
    J[43] = s_theta1 * (z30 * z37 + z23 * z38) - c_theta1 * (z30 * z36 - z24 * z38);
    J[44] = s_theta2 * (c_theta3 * z41 + z33 * y1_dot) - c_theta2 * (s_theta3 * z41 - z33 * x1_dot);
    J[45] = -(c_theta3 * (k1 * x2_dot) + s_theta3 * (k1 * y2_dot));
    J[46] = s_theta0 * z39 - c_theta0 * z40;
    J[47] = 0.0;
    J[48] = 0.0;
    J[49] = 0.0;
    J[50] = z44 * (c_theta0 * z116 - s_theta0 * z120);
    J[51] = z44 * (c_theta1 * z121 + s_theta1 * z122);
    J[52] = z44 * (c_theta2 * z123 + s_theta2 * z124);
    J[53] = z44 * (c_theta3 * z125 + s_theta3 * z126);
    J[54] = -z44 * (z77 * z118 - z80 * z75 - s_theta0 * z74 - c_theta0 * z117);
    J[55] = -z44 * (c_theta0 * z119 - s_theta0 * z76);
    J[56] = 0.0;
    J[57] = 0.0;
    J[58] = 0.0;
    J[59] = 0.0;
    J[60] = 0.0;
    J[61] = 0.0;
    J[62] = 0.0;
    J[63] = 0.0;
    return n_trailer3_finish(64, J);
}

int n_trailer3_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double x = y[0]; /* axle of the tractor [m] */
    const double y_2 = y[1]; /* axle of the tractor [m] */
    const double theta1 = y[3]; /* first trailer [rad] */
    const double theta2 = y[4]; /* second trailer [rad] */
    const double theta3 = y[5]; /* third trailer [rad] */
    const double L = p[4]; /* from axle to axle [m] */

    /* state */
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    const double c_theta3 = cos(theta3);
    const double c_theta1 = cos(theta1);
    const double c_theta2 = cos(theta2);
    const double s_theta3 = sin(theta3);
    const double s_theta1 = sin(theta1);
    const double s_theta2 = sin(theta2);
    /* 40:11 */
    out[0] = x - L * (c_theta3 + (c_theta1 + c_theta2)); /* tail_x */
    /* 41:11 */
    out[1] = y_2 - L * (s_theta3 + (s_theta1 + s_theta2)); /* tail_y */
    return n_trailer3_finish(2, out);
}

int n_trailer3_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m0 = p[0]; /* tractor [kg] */
    const double J0 = p[1]; /* tractor [kg*m^2] */
    const double m = p[2]; /* each trailer [kg] */
    const double J = p[3]; /* each trailer [kg*m^2] */
    const double L = p[4]; /* from axle to axle [m] */
    const double k1 = 1.0 / L;
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-L) > 0.0)) {
        return N_TRAILER3_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(J0) > 0.0)) {
        return N_TRAILER3_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta0 = y[2 * count + i]; /* heading of the tractor [rad] */
        const double theta1 = y[3 * count + i]; /* first trailer [rad] */
        const double theta2 = y[4 * count + i]; /* second trailer [rad] */
        const double theta3 = y[5 * count + i]; /* third trailer [rad] */
        const double v = y[6 * count + i];
        const double w = y[7 * count + i];
        const double c_theta0 = cos(theta0);
        const double s_theta0 = sin(theta0);
        const double c_theta1 = cos(theta1);
        const double s_theta1 = sin(theta1);
        const double z1 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0);
        const double c_theta2 = cos(theta2);
        const double z2 = s_theta0 - L * (c_theta1 * z1);
        const double s_theta2 = sin(theta2);
        const double z3 = c_theta0 + L * (s_theta1 * z1);
        const double z4 = k1 * (c_theta2 * z2 - s_theta2 * z3);
        const double z5 = c_theta0 * (m0 * c_theta0) + s_theta0 * (m0 * s_theta0) + z1 * (J * z1) + z4 * (J *
            z4);
        const double c_theta3 = cos(theta3);
        const double z6 = z2 - L * (c_theta2 * z4);
        const double s_theta3 = sin(theta3);
        const double z7 = z3 + L * (s_theta2 * z4);
        const double z8 = k1 * (c_theta3 * z6 - s_theta3 * z7);
        const double z9 = z5 + z8 * (J * z8) + z3 * (m * z3) + z2 * (m * z2) + z7 * (m * z7);
        const double z10 = z7 + L * (s_theta3 * z8);
        const double z11 = z6 - L * (c_theta3 * z8);
        const double z12 = z9 + z6 * (m * z6) + z10 * (m * z10) + z11 * (m * z11);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z12) > 0.0);
        const double z13 = c_theta0 * v;
        const double z14 = s_theta0 * v;
        const double z15 = k1 * (c_theta1 * z14 - s_theta1 * z13);
        const double z16 = c_theta1 * z15;
        const double y1_dot = z14 - L * z16;
        const double z17 = s_theta1 * z15;
        const double x1_dot = z13 + L * z17;
        const double z18 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot);
        const double z19 = c_theta2 * z18;
        const double y2_dot = y1_dot - L * z19;
        const double z20 = s_theta2 * z18;
        const double x2_dot = x1_dot + L * z20;
        const double z21 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot);
        const double z22 = v * (c_theta0 * w);
        const double z23 = v * (s_theta0 * w);
        const double z24 = k1 * (z14 * z17 - c_theta1 * z22 + (z13 * z16 - s_theta1 * z23));
        const double z25 = z22 + L * (z15 * z17 + c_theta1 * z24);
        const double z26 = z23 - L * (z15 * z16 - s_theta1 * z24);
        const double z27 = k1 * (y1_dot * z20 - c_theta2 * z25 + (x1_dot * z19 - s_theta2 * z26));
        const double z28 = z25 + L * (z18 * z20 + c_theta2 * z27);
        const double z29 = s_theta3 * z21;
        const double z30 = c_theta3 * z21;
        const double z31 = z26 - L * (z18 * z19 - s_theta2 * z27);
        const double z32 = k1 * (y2_dot * z29 - c_theta3 * z28 + (x2_dot * z30 - s_theta3 * z31));
        const double z33 = z4 * (J * z27) + (z1 * (J * z24) + (c_theta0 * (m0 * z23) - s_theta0 * (m0 *
            z22)));
        const double z34 = z7 * (m * z31) - (z2 * (m * z25) - (z3 * (m * z26) + (z8 * (J * z32) + z33)));
        const double z35 = z10 * (m * (z31 - L * (z21 * z30 - s_theta3 * z32))) - (z6 * (m * z28) - z34);
        /* (I.2.15) */
        const double slope1 = z13; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = z14; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = w; /* theta0' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = z15; /* theta1' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = z18; /* theta2' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = z21; /* theta3' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        /* (I.2.15) 30:4 */
        const double slope7 = -(z11 * (m * (z28 + L * (z21 * z29 + c_theta3 * z32))) - z35) / z12; /* v' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = 0.0; /* w' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
    }
    if (singular1) {
        return N_TRAILER3_SINGULAR_2;
    }
    return bad ? N_TRAILER3_NOT_FINITE : N_TRAILER3_OK;
}
