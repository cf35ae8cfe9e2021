/*
 * voronec_particle.c: voronec_particle, emitted by nhc 0.1.0 (nhc:8c91a2c255aa344b)
 * A particle whose T, U and constraint depend on the dependent coordinate, so that Caplygin's hypotheses
 *     fail.
 * Source: voronec_particle.yaml
 * Equations of motion: voronec (I.4.9)
 * Why: dependent velocities of the spec
 * voronec_particle.h says what each function does.
 */
#include "voronec_particle.h"

#include <float.h>
#include <math.h>

const char *const voronec_particle_coordinate_names[] = {
    "x",
    "y",
    "z"
};
const char *const voronec_particle_state_names[] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const voronec_particle_parameter_names[] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double voronec_particle_parameter_defaults[] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

static int voronec_particle_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? VORONEC_PARTICLE_OK : VORONEC_PARTICLE_NOT_FINITE;
}

int voronec_particle_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double c_z = cos(z);
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 1.0 + z * z + 0.3 * z2 + z1 * (0.3 * c_z + z3 * z1);
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z5 = x * z;
    const double z6 = z3 * z5;
    const double z7 = 2.0 + s_z + 0.25 * (z5 * z6);
    const double z8 = c_z * z5;
    const double z9 = 0.15 * z8 + 0.5 * (z1 * z6);
    const double z10 = 1.0 / z4;
    const double z11 = z9 * z10;
    const double z12 = z7 - z9 * z11;
    /* the mass matrix is singular */
    if (!(fabs(z12) > 1e-14 * z7)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double z13 = x_dot * z1 + 0.5 * (y_dot * z5);
    const double z14 = s_z * z13;
    const double z15 = x_dot * (y_dot * c_z - y_2 * z14) + 0.5 * (y_dot * (z * x_dot + x * z13));
    const double z16 = 0.3 * (x_dot * z14) - 2.0 * (z13 * (x * x_dot)) - z3 * z15;
    const double z17 = 0.3 * (z13 * z14) - 2.0 * (x_dot * (z * z13)) - 0.3 * (c_z * z15) + z1 * z16;
    const double z18 = x_dot * x_dot;
    const double z19 = z * z1;
    const double z20 = y_dot * y_dot;
    const double z21 = 0.5 * (2.0 * (z18 * z19) + z20 * z2 + 2.0 * (x * (z13 * z13))) - 0.3 * (z13 * (x_dot *
        (s_z * z1)));
    const double z22 = z17 + (z21 - 0.5 * (2.0 * x + 6.0 * z19));
    const double z23 = z * z5;
    const double z24 = 0.5 * (z18 * z23 + 0.5 * (z20 * z8)) - 0.15 * (z13 * (x_dot * (s_z * z5))) - 0.5 *
        (4.0 * y_2 + 3.0 * z23);
    const double z25 = (y_dot * (c_z * z13) - 0.5 * (z5 * z16) - z24 + z22 * z11) / z12;
    /* (I.4.9) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z13; /* z' */
    /* (I.4.9) 7:4 */
    dydt[3] = z22 * z10 + z11 * z25; /* x'' */
    dydt[4] = -z25; /* y'' */
    return voronec_particle_finish(5, dydt);
}

int voronec_particle_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double c_z = cos(z);
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = x_dot * (y_2 * c_z) + 0.5 * (y_dot * (x * z)); /* z' */
    return voronec_particle_finish(3, qdot);
}

int voronec_particle_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double c_z = cos(z);
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 1.0 + z * z + 0.3 * z2 + z1 * (0.3 * c_z + z3 * z1);
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z5 = x * z;
    const double z6 = z3 * z5;
    const double z7 = 2.0 + s_z + 0.25 * (z5 * z6);
    const double z8 = c_z * z5;
    const double z9 = 0.15 * z8 + 0.5 * (z1 * z6);
    const double z10 = 1.0 / z4;
    const double z11 = z9 * z10;
    const double z12 = z7 - z9 * z11;
    /* the mass matrix is singular */
    if (!(fabs(z12) > 1e-14 * z7)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double z13 = x_dot * z1 + 0.5 * (y_dot * z5);
    const double z14 = s_z * z13;
    const double z15 = x_dot * (y_dot * c_z - y_2 * z14);
    const double z16 = y_dot * (z * x_dot + x * z13);
    const double z17 = z15 + 0.5 * z16;
    const double z18 = 0.3 * (x_dot * z14) - 2.0 * (z13 * (x * x_dot)) - z3 * z17;
    const double z19 = 0.3 * (z13 * z14) - 2.0 * (x_dot * (z * z13)) - 0.3 * (c_z * z17) + z1 * z18;
    const double z20 = x_dot * x_dot;
    const double z21 = z * z1;
    const double z22 = y_dot * y_dot;
    const double z23 = 0.5 * (2.0 * (z20 * z21) + z22 * z2 + 2.0 * (x * (z13 * z13))) - 0.3 * (z13 * (x_dot *
        (s_z * z1)));
    const double z24 = z19 + (z23 - 0.5 * (2.0 * x + 6.0 * z21));
    const double z25 = z * z5;
    const double z26 = 0.5 * (z20 * z25 + 0.5 * (z22 * z8)) - 0.15 * (z13 * (x_dot * (s_z * z5))) - 0.5 *
        (4.0 * y_2 + 3.0 * z25);
    const double z27 = (y_dot * (c_z * z13) - 0.5 * (z5 * z18) - z26 + z24 * z11) / z12;
    const double z28 = z24 * z10 + z11 * z27;
    /* (I.4.9) */
    qddot[0] = z28; /* x'' */
    qddot[1] = -z27; /* y'' */
    qddot[2] = z15 + z1 * z28 + 0.5 * (z16 - z5 * z27); /* z'' */
    return voronec_particle_finish(3, qddot);
}

int voronec_particle_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0];
    const double y_2 = q[1];
    const double z = q[2];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = x_dot;
    y[4] = y_dot;
    return voronec_particle_finish(5, y);
}

int voronec_particle_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double x = q[0];
    const double y = q[1];
    const double z = q[2];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];

    /* state */
    const double c_z = cos(z);
    /* (I.1.1) 10:5 */
    r[0] = z_dot - (x_dot * (y * c_z) + 0.5 * (y_dot * (x * z))); /* contact = 0 */
    return voronec_particle_finish(1, r);
}

int voronec_particle_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double c_z = cos(z);
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 0.3 * c_z + z3 * z1;
    const double z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4;
    /* the mass matrix is singular */
    if (!(fabs(z5) > 0.0)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z6 = x * z;
    const double z7 = z3 * z6;
    const double z8 = 2.0 + s_z + 0.25 * (z6 * z7);
    const double z9 = c_z * z6;
    const double z10 = 0.15 * z9 + 0.5 * (z1 * z7);
    const double z11 = 1.0 / z5;
    const double z12 = z10 * z11;
    const double z13 = z8 - z10 * z12;
    /* the mass matrix is singular */
    if (!(fabs(z13) > 1e-14 * z8)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double z14 = x_dot * z1 + 0.5 * (y_dot * z6);
    const double z15 = s_z * z14;
    const double z16 = x_dot * (y_dot * c_z - y_2 * z15) + 0.5 * (y_dot * (z * x_dot + x * z14));
    const double z17 = 0.3 * (x_dot * z15) - 2.0 * (z14 * (x * x_dot)) - z3 * z16;
    const double z18 = x_dot * x_dot;
    const double z19 = y_dot * y_dot;
    const double z20 = 3.0 * z - (0.5 * (2.0 * (z * z18) + z19 * c_z) - 0.3 * (z14 * (x_dot * s_z)));
    const double z21 = 0.3 * (z14 * z15) - 2.0 * (x_dot * (z * z14)) - 0.3 * (c_z * z16) + z1 * z17;
    const double z22 = z * z1;
    const double z23 = 0.5 * (2.0 * (z18 * z22) + z19 * z2 + 2.0 * (x * (z14 * z14))) - 0.3 * (z14 * (x_dot *
        (s_z * z1)));
    const double z24 = z21 + (z23 - 0.5 * (2.0 * x + 6.0 * z22));
    const double z25 = z * z6;
    const double z26 = 0.5 * (z18 * z25 + 0.5 * (z19 * z9)) - 0.15 * (z14 * (x_dot * (s_z * z6))) - 0.5 *
        (4.0 * y_2 + 3.0 * z25);
    const double z27 = (y_dot * (c_z * z14) - 0.5 * (z6 * z17) - z26 + z24 * z12) / z13;
    /* (I.4.1) 10:5 */
    /* reaction of contact: Q_i gains lambda_1 a_1i */
    lambda[0] = z4 * (z24 * z11 + z12 * z27) - 0.5 * (z7 * z27) - (z17 - z20);
    return voronec_particle_finish(1, lambda);
}

double voronec_particle_energy(double t, const double *y, const double *p)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = z * z;
    const double z2 = x * x;
    const double s_z = sin(z);
    const double c_z = cos(z);
    const double z3 = x_dot * (y_2 * c_z) + 0.5 * (y_dot * (x * z));
    const double z4 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot) + (1.0 + z2) * (z3 * z3);
    const double z5 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2))) + (0.5 * z4 + 0.3 * (x_dot * c_z * z3));
    return z5;
}

int voronec_particle_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double c_z = cos(z);
    const double z1 = y_2 * c_z;
    const double z2 = c_z * z1;
    const double z3 = 1.0 + x * x;
    const double z4 = 0.3 * c_z + z3 * z1;
    const double z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4;
    /* the mass matrix is singular */
    if (!(fabs(z5) > 0.0)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z6 = x * z;
    const double z7 = z3 * z6;
    const double z8 = 2.0 + s_z + 0.25 * (z6 * z7);
    const double z9 = c_z * z6;
    const double z10 = 0.15 * z9 + 0.5 * (z1 * z7);
    const double z11 = 1.0 / z5;
    const double z12 = z10 * z11;
    const double z13 = z8 - z10 * z12;
    /* the mass matrix is singular */
    if (!(fabs(z13) > 1e-14 * z8)) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    const double z14 = x_dot * z1;
    const double z15 = z14 + 0.5 * (y_dot * z6);
    const double z16 = z15 * z15;
    const double z17 = z1 * z15;
    const double z18 = y_dot * z4;
    const double z19 = z * x_dot;
    const double z20 = s_z * z15;
    const double z21 = x * z15;
    const double z22 = s_z * z1;
    const double z23 = x_dot * z22;
    const double z24 = x * x_dot;
    const double z25 = 2.0 * z19 - (0.3 * z20 + (2.0 * z21 - 0.3 * z23 - 2.0 * (z1 * z24))) + 0.5 * (x * z18);
    const double z26 = x_dot * z4;
    const double z27 = 0.3 * z14 + 0.3 * z15 + y_2 * z26;
    const double z28 = z25 - s_z * z27;
    const double z29 = 1.0 / z13;
    const double z30 = c_z * z15;
    const double z31 = y_dot * c_z;
    const double z32 = z31 - y_2 * z20;
    const double z33 = z19 + z21;
    const double z34 = x_dot * z32 + 0.5 * (y_dot * z33);
    const double z35 = 0.3 * (x_dot * z20) - 2.0 * (z15 * z24) - z3 * z34;
    const double z36 = x_dot * x_dot;
    const double z37 = z * z6;
    const double z38 = y_dot * y_dot;
    const double z39 = s_z * z6;
    const double z40 = x_dot * z39;
    const double z41 = 0.5 * (z36 * z37 + 0.5 * (z38 * z9)) - 0.15 * (z15 * z40) - 0.5 * (4.0 * y_2 + 3.0 *
        z37);
    const double z42 = z * z15;
    const double z43 = z * z1;
    const double z44 = 0.5 * (2.0 * (z36 * z43) + z38 * z2 + 2.0 * (x * z16)) - 0.3 * (z15 * z23);
    const double z45 = 0.3 * (z15 * z20) - 2.0 * (x_dot * z42) - 0.3 * (c_z * z34) + z1 * z35 + (z44 - 0.5 *
        (2.0 * x + 6.0 * z43));
    const double z46 = z29 * (y_dot * z30 - 0.5 * (z6 * z35) - z41 + z45 * z12);
    const double z47 = z1 * z46;
    const double z48 = 0.5 * (y_dot * z28) - (0.5 * (z3 * z47) + 0.15 * (c_z * z46));
    const double z49 = z45 * z11 + z12 * z46;
    const double z50 = z1 * z49;
    const double z51 = 1.0 - (z16 - 2.0 * (x_dot * z17)) + 0.5 * (z15 * z18) + z * z48 + 2.0 * (x * (z1 * z34
        - (0.5 * (z6 * z47) - z1 * z50)));
    const double z52 = z6 * z15;
    const double z53 = y_dot * z7;
    const double z54 = x_dot * z7;
    const double z55 = 0.15 * (x_dot * z6) + 0.5 * (y_2 * z54);
    const double z56 = z31 + (0.15 * z40 + z6 * z24 + 0.25 * (x * z53) - s_z * z55);
    const double z57 = z7 * z46;
    const double z58 = x_dot * z15;
    const double z59 = s_z * z58;
    const double z60 = 1.5 - 0.5 * z36;
    const double z61 = z6 * z46;
    const double z62 = 0.5 * z50 - 0.25 * z61;
    const double z63 = 0.25 * z38 - 0.15 * z49;
    const double z64 = 0.25 * z57 + (0.5 * z35 - (0.15 * z59 + z * z60)) - z3 * z62 + c_z * z63;
    const double z65 = 0.5 * (y_dot * z56) - z64;
    const double z66 = x_dot * z52 + 0.25 * (z15 * z53) + z * z65 + 2.0 * (x * (0.5 * (z6 * z34) + z6 * z62));
    const double z67 = z29 * (z66 - z12 * z51);
    const double z68 = 3.0 - z36;
    const double z69 = 0.5 * z38 - 0.3 * z49;
    const double z70 = z4 * z49 - (0.5 * z57 + (z35 - (0.3 * z59 + z * z68))) + z3 * z50 - c_z * z69;
    const double z71 = x_dot * z28 + z70;
    const double z72 = z20 * z26 - c_z * z71;
    const double z73 = x_dot * z56 + 0.5 * (z7 * z49);
    const double z74 = z29 * (2.0 - 0.5 * (z20 * z54) + c_z * z73 + z12 * z72);
    const double z75 = 0.3 * z50 + (y_dot * z26 + (0.3 * z34 - (0.15 * z61 + z1 * z69)) + y_2 * z71);
    const double z76 = c_z * (0.3 * (z1 * z58) - z15 * z27) + (2.0 * z58 + z1 * z68 + 0.5 * (x_dot * z18) + x
        * z48 - s_z * z75);
    const double z77 = z76 + 2.0 * (z * z49);
    const double z78 = z6 * z60 + 0.25 * (x_dot * z53) + x * z65 - s_z * (y_dot * z15 + (0.5 * (y_dot * z54)
        - z6 * z63) + y_2 * z73);
    const double z79 = z29 * (z78 - c_z * (z46 - (0.15 * (z6 * z58) - z15 * z55)) - z12 * z77);
    const double z80 = 2.0 * z42 + 0.3 * (z15 * z22) - 0.3 * (z1 * z20) + 2.0 * (x * z17) + 0.5 * (z * z18);
    const double z81 = z80 + z32 * z4 + z1 * z28 - 2.0 * (x_dot * z43);
    const double z82 = 0.15 * (z15 * z39) - 0.15 * (z6 * z20) + x * z52 + 0.25 * (z * z53) + 0.5 * (z32 * z7);
    const double z83 = z29 * (z82 + z1 * z56 - x_dot * z37 - z12 * z81);
    const double z84 = 0.5 * (z33 * z4) + c_z * z26 + 0.5 * (z6 * z28) - y_dot * z2;
    const double z85 = z30 + 0.25 * (z33 * z7) + 0.5 * (c_z * z54) + 0.5 * (z6 * z56) - 0.5 * (y_dot * z9);
    const double z86 = z29 * (z85 - z12 * z84);
    /* (I.4.9) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    J[3] = 1.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = 1.0;
    J[10] = 0.5 * (z * y_dot);
    J[11] = x_dot * c_z;
    J[12] = 0.5 * (x * y_dot) - s_z * (y_2 * x_dot);
    J[13] = z1;
    J[14] = 0.5 * z6;
    J[15] = z12 * z67 - z11 * z51;
    J[16] = z11 * z72 + z12 * z74;
    J[17] = z12 * z79 - z11 * z77;
    J[18] = z12 * z83 - z11 * z81;
    J[19] = z12 * z86 - z11 * z84;
    J[20] = -z67;
    J[21] = -z74;
    J[22] = -z79;
    J[23] = -z83;
    J[24] = -z86;
    return voronec_particle_finish(25, J);
}

int voronec_particle_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return VORONEC_PARTICLE_OK;
}

int voronec_particle_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    int singular1 = 0;
    int bad = 0;
    (void)t;
    (void)p;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x = y[i];
        const double y_2 = y[count + i];
        const double z = y[2 * count + i];
        const double x_dot = y[3 * count + i];
        const double y_dot = y[4 * count + i];
        const double c_z = cos(z);
        const double z1 = y_2 * c_z;
        const double z2 = c_z * z1;
        const double z3 = 1.0 + x * x;
        const double z4 = 1.0 + z * z + 0.3 * z2 + z1 * (0.3 * c_z + z3 * z1);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z4) > 0.0);
        const double s_z = sin(z);
        const double z5 = x * z;
        const double z6 = z3 * z5;
        const double z7 = 2.0 + s_z + 0.25 * (z5 * z6);
        const double z8 = c_z * z5;
        const double z9 = 0.15 * z8 + 0.5 * (z1 * z6);
        const double z10 = 1.0 / z4;
        const double z11 = z9 * z10;
        const double z12 = z7 - z9 * z11;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z12) > 1e-14 * z7);
        const double z13 = x_dot * z1 + 0.5 * (y_dot * z5);
        const double z14 = s_z * z13;
        const double z15 = x_dot * (y_dot * c_z - y_2 * z14) + 0.5 * (y_dot * (z * x_dot + x * z13));
        const double z16 = 0.3 * (x_dot * z14) - 2.0 * (z13 * (x * x_dot)) - z3 * z15;
        const double z17 = 0.3 * (z13 * z14) - 2.0 * (x_dot * (z * z13)) - 0.3 * (c_z * z15) + z1 * z16;
        const double z18 = x_dot * x_dot;
        const double z19 = z * z1;
        const double z20 = y_dot * y_dot;
        const double z21 = 0.5 * (2.0 * (z18 * z19) + z20 * z2 + 2.0 * (x * (z13 * z13))) - 0.3 * (z13 *
            (x_dot * (s_z * z1)));
        const double z22 = z17 + (z21 - 0.5 * (2.0 * x + 6.0 * z19));
        const double z23 = z * z5;
        const double z24 = 0.5 * (z18 * z23 + 0.5 * (z20 * z8)) - 0.15 * (z13 * (x_dot * (s_z * z5))) - 0.5 *
            (4.0 * y_2 + 3.0 * z23);
        const double z25 = (y_dot * (c_z * z13) - 0.5 * (z5 * z16) - z24 + z22 * z11) / z12;
        /* (I.4.9) */
        const double slope1 = x_dot; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = y_dot; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z13; /* z' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (I.4.9) 7:4 */
        const double slope4 = z22 * z10 + z11 * z25; /* x'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -z25; /* y'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    if (singular1) {
        return VORONEC_PARTICLE_SINGULAR_2;
    }
    return bad ? VORONEC_PARTICLE_NOT_FINITE : VORONEC_PARTICLE_OK;
}
