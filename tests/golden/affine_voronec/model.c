/*
 * affine_voronec.c: affine_voronec, emitted by nhc 0.1.0 (nhc:57d97b4cc9c6a192)
 * A particle with everything at once; affine constraint, time, T of degrees 2, 1 and 0, drag, a driving
 *     force.
 * Source: affine_voronec.yaml
 * Equations of motion: voronec (I.4.9)
 * Why: dependent velocities of the spec
 * affine_voronec.h says what each function does.
 */
#include "affine_voronec.h"

#include <float.h>
#include <math.h>

const char *const affine_voronec_coordinate_names[] = {
    "x",
    "y",
    "z"
};
const char *const affine_voronec_state_names[] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const affine_voronec_parameter_names[] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double affine_voronec_parameter_defaults[] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

static int affine_voronec_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? AFFINE_VORONEC_OK : AFFINE_VORONEC_NOT_FINITE;
}

int affine_voronec_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double s_t = sin(t);
    const double z2 = 1.0 + 0.2 * s_t;
    const double c_z = cos(z);
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = x * x;
    const double z9 = 1.0 + z8;
    const double z10 = z9 * z2;
    const double z11 = z1 * z2 + 0.3 * (z6 * z7) + z6 * (0.3 * z7 + z6 * z10);
    /* the mass matrix is singular */
    if (!(fabs(z11) > 0.0)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z12 = 2.0 + s_z;
    const double z13 = x * z;
    const double z14 = z13 * z10;
    const double z15 = z12 * z2 + 0.25 * (z13 * z14);
    const double z16 = 0.15 * (z13 * z7) + 0.5 * (z6 * z14);
    const double z17 = 1.0 / z11;
    const double z18 = z16 * z17;
    const double z19 = z15 - z16 * z18;
    /* the mass matrix is singular */
    if (!(fabs(z19) > 1e-14 * z15)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double z20 = y_dot * z13;
    const double z21 = 2.0 * t;
    const double s1 = sin(z21);
    const double z22 = 0.3 * z13 + (x_dot * z6 + 0.5 * z20) + 0.2 * s1;
    const double c_t = cos(t);
    const double z23 = x + t * x_dot;
    const double z24 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z23) + (0.3 * (y_dot * z6) - 0.1 * (t *
        z22));
    const double z25 = s_z * z22;
    const double z26 = 0.3 * (z2 * z22 * z25 - 0.2 * (c_z * (c_t * z22))) - x_dot * (2.0 * (z2 * (z * z22)) +
        0.2 * (z1 * c_t));
    const double z27 = x * z22 + z * x_dot;
    const double z28 = x_dot * (z5 * (y_dot * c_z - y_2 * z25) + 0.1 * (c_t * z3)) + 0.5 * (y_dot * z27);
    const double c1 = cos(z21);
    const double z29 = 0.3 * z27 + z28 + 0.4 * c1;
    const double z30 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z25)) + z22 * (2.0 * (z2 * (x *
        x_dot)) + 0.2 * (z9 * c_t));
    const double z31 = z30 + z10 * z29;
    const double z32 = z4 - 0.05 * z22;
    const double z33 = x_dot * x_dot;
    const double z34 = z * z6;
    const double z35 = y_dot * y_dot;
    const double z36 = 0.5 * (2.0 * (z33 * z34) + z35 * (c_z * z6) + 2.0 * (x * (z22 * z22))) - 0.3 * (z22 *
        (x_dot * (s_z * z6)));
    const double z37 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z36 - 0.5 * (2.0 * x + 6.0 * z34);
    const double z38 = z24 - (z26 - 0.3 * (z7 * z29) - z6 * z31) + (0.1 * x_dot - z6 * z32 - z37);
    const double z39 = 0.3 * z22;
    const double z40 = z39 - 0.05 * (z13 * z23) - (0.15 * z20 - 0.4 * (x_dot * c_t)) - (y_dot * (z2 * (c_z *
        z22) + 0.2 * (z12 * c_t)) + 0.5 * (z13 * z31));
    const double z41 = z * z13;
    const double z42 = 0.5 * (z33 * z41 + 0.5 * (z35 * (c_z * z13))) - 0.15 * (z22 * (x_dot * (s_z * z13)));
    const double z43 = 0.2 * y_dot - z39 - 0.5 * (z13 * z32) - (0.1 * (z8 * z13) + z2 * z42 - 0.5 * (4.0 *
        y_2 + 3.0 * z41));
    const double z44 = (z40 - z43 + z38 * z18) / z19;
    /* (I.4.9) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z22; /* z' */
    /* (I.4.9) 11:4 */
    dydt[3] = -(z38 * z17 + z18 * z44); /* x'' */
    dydt[4] = z44; /* y'' */
    return affine_voronec_finish(5, dydt);
}

int affine_voronec_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = x * z;
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double s1 = sin(2.0 * t);
    const double z2 = 0.3 * z1 + (x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)) + 0.2 * s1;
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = z2; /* z' */
    return affine_voronec_finish(3, qdot);
}

int affine_voronec_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double s_t = sin(t);
    const double z2 = 1.0 + 0.2 * s_t;
    const double c_z = cos(z);
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = x * x;
    const double z9 = 1.0 + z8;
    const double z10 = z9 * z2;
    const double z11 = z1 * z2 + 0.3 * (z6 * z7) + z6 * (0.3 * z7 + z6 * z10);
    /* the mass matrix is singular */
    if (!(fabs(z11) > 0.0)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z12 = 2.0 + s_z;
    const double z13 = x * z;
    const double z14 = z13 * z10;
    const double z15 = z12 * z2 + 0.25 * (z13 * z14);
    const double z16 = 0.15 * (z13 * z7) + 0.5 * (z6 * z14);
    const double z17 = 1.0 / z11;
    const double z18 = z16 * z17;
    const double z19 = z15 - z16 * z18;
    /* the mass matrix is singular */
    if (!(fabs(z19) > 1e-14 * z15)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double c_t = cos(t);
    const double z20 = x + t * x_dot;
    const double z21 = y_dot * z13;
    const double z22 = 2.0 * t;
    const double s1 = sin(z22);
    const double z23 = 0.3 * z13 + (x_dot * z6 + 0.5 * z21) + 0.2 * s1;
    const double z24 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z20) + (0.3 * (y_dot * z6) - 0.1 * (t *
        z23));
    const double z25 = s_z * z23;
    const double z26 = 0.3 * (z2 * z23 * z25 - 0.2 * (c_z * (c_t * z23))) - x_dot * (2.0 * (z2 * (z * z23)) +
        0.2 * (z1 * c_t));
    const double z27 = x * z23 + z * x_dot;
    const double z28 = 0.3 * z27;
    const double z29 = x_dot * (z5 * (y_dot * c_z - y_2 * z25) + 0.1 * (c_t * z3));
    const double z30 = y_dot * z27;
    const double c1 = cos(z22);
    const double z31 = 0.4 * c1;
    const double z32 = z28 + (z29 + 0.5 * z30) + z31;
    const double z33 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z25)) + z23 * (2.0 * (z2 * (x *
        x_dot)) + 0.2 * (z9 * c_t));
    const double z34 = z33 + z10 * z32;
    const double z35 = z4 - 0.05 * z23;
    const double z36 = x_dot * x_dot;
    const double z37 = z * z6;
    const double z38 = y_dot * y_dot;
    const double z39 = 0.5 * (2.0 * (z36 * z37) + z38 * (c_z * z6) + 2.0 * (x * (z23 * z23))) - 0.3 * (z23 *
        (x_dot * (s_z * z6)));
    const double z40 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z39 - 0.5 * (2.0 * x + 6.0 * z37);
    const double z41 = z24 - (z26 - 0.3 * (z7 * z32) - z6 * z34) + (0.1 * x_dot - z6 * z35 - z40);
    const double z42 = 0.3 * z23;
    const double z43 = z42 - 0.05 * (z13 * z20) - (0.15 * z21 - 0.4 * (x_dot * c_t)) - (y_dot * (z2 * (c_z *
        z23) + 0.2 * (z12 * c_t)) + 0.5 * (z13 * z34));
    const double z44 = z * z13;
    const double z45 = 0.5 * (z36 * z44 + 0.5 * (z38 * (c_z * z13))) - 0.15 * (z23 * (x_dot * (s_z * z13)));
    const double z46 = 0.2 * y_dot - z42 - 0.5 * (z13 * z35) - (0.1 * (z8 * z13) + z2 * z45 - 0.5 * (4.0 *
        y_2 + 3.0 * z44));
    const double z47 = (z43 - z46 + z41 * z18) / z19;
    const double z48 = z41 * z17 + z18 * z47;
    /* (I.4.9) */
    qddot[0] = -z48; /* x'' */
    qddot[1] = z47; /* y'' */
    qddot[2] = z31 + (z28 + (z29 - z6 * z48 + 0.5 * (z30 + z13 * z47))); /* z'' */
    return affine_voronec_finish(3, qddot);
}

int affine_voronec_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
    return affine_voronec_finish(5, y);
}

int affine_voronec_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)p;
    const double x = q[0];
    const double y = q[1];
    const double z = q[2];
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];

    /* state */
    const double z1 = x * z;
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double s1 = sin(2.0 * t);
    const double z2 = 0.3 * z1 + (x_dot * (y * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)) + 0.2 * s1;
    /* (I.1.1) 18:5 */
    r[0] = z_dot - z2; /* contact = 0 */
    return affine_voronec_finish(1, r);
}

int affine_voronec_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double s_t = sin(t);
    const double z2 = 1.0 + 0.2 * s_t;
    const double c_z = cos(z);
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = x * x;
    const double z9 = 1.0 + z8;
    const double z10 = z9 * z2;
    const double z11 = 0.3 * z7 + z6 * z10;
    const double z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11;
    /* the mass matrix is singular */
    if (!(fabs(z12) > 0.0)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z13 = 2.0 + s_z;
    const double z14 = x * z;
    const double z15 = z14 * z10;
    const double z16 = z13 * z2 + 0.25 * (z14 * z15);
    const double z17 = 0.15 * (z14 * z7) + 0.5 * (z6 * z15);
    const double z18 = 1.0 / z12;
    const double z19 = z17 * z18;
    const double z20 = z16 - z17 * z19;
    /* the mass matrix is singular */
    if (!(fabs(z20) > 1e-14 * z16)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double c_t = cos(t);
    const double z21 = y_dot * z14;
    const double z22 = 2.0 * t;
    const double s1 = sin(z22);
    const double z23 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.2 * s1;
    const double z24 = s_z * z23;
    const double z25 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z24)) + z23 * (2.0 * (z2 * (x *
        x_dot)) + 0.2 * (z9 * c_t));
    const double z26 = x * z23 + z * x_dot;
    const double z27 = x_dot * (z5 * (y_dot * c_z - y_2 * z24) + 0.1 * (c_t * z3)) + 0.5 * (y_dot * z26);
    const double c1 = cos(z22);
    const double z28 = 0.3 * z26 + z27 + 0.4 * c1;
    const double z29 = z25 + z10 * z28;
    const double z30 = x + t * x_dot;
    const double z31 = z4 - 0.05 * z23;
    const double z32 = x_dot * x_dot;
    const double z33 = y_dot * y_dot;
    const double z34 = 0.2 * z8 + z2 * (0.5 * (2.0 * (z * z32) + z33 * c_z) - 0.3 * (z23 * (x_dot * s_z)));
    const double z35 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z30) + (0.3 * (y_dot * z6) - 0.1 * (t *
        z23));
    const double z36 = 0.3 * (z2 * z23 * z24 - 0.2 * (c_z * (c_t * z23))) - x_dot * (2.0 * (z2 * (z * z23)) +
        0.2 * (z1 * c_t));
    const double z37 = z * z6;
    const double z38 = 0.5 * (2.0 * (z32 * z37) + z33 * (c_z * z6) + 2.0 * (x * (z23 * z23))) - 0.3 * (z23 *
        (x_dot * (s_z * z6)));
    const double z39 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z38 - 0.5 * (2.0 * x + 6.0 * z37);
    const double z40 = z35 - (z36 - 0.3 * (z7 * z28) - z6 * z29) + (0.1 * x_dot - z6 * z31 - z39);
    const double z41 = 0.3 * z23;
    const double z42 = z41 - 0.05 * (z14 * z30) - (0.15 * z21 - 0.4 * (x_dot * c_t)) - (y_dot * (z2 * (c_z *
        z23) + 0.2 * (z13 * c_t)) + 0.5 * (z14 * z29));
    const double z43 = z * z14;
    const double z44 = 0.5 * (z32 * z43 + 0.5 * (z33 * (c_z * z14))) - 0.15 * (z23 * (x_dot * (s_z * z14)));
    const double z45 = 0.2 * y_dot - z41 - 0.5 * (z14 * z31) - (0.1 * (z8 * z14) + z2 * z44 - 0.5 * (4.0 *
        y_2 + 3.0 * z43));
    const double z46 = (z42 - z45 + z40 * z19) / z20;
    const double z47 = z29 + (0.3 * y_dot + 0.1 * z30) - (z31 - (3.0 * z - z34)) - (z11 * (z40 * z18 + z19 *
        z46) - 0.5 * (z15 * z46));
    /* (I.4.1) 18:5 */
    lambda[0] = z47; /* reaction of contact: Q_i gains lambda_1 a_1i */
    return affine_voronec_finish(1, lambda);
}

double affine_voronec_energy(double t, const double *y, const double *p)
{
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = z * z;
    const double z2 = x * x;
    const double c_t = cos(t);
    const double z3 = x * z;
    const double c_z = cos(z);
    const double s_t = sin(t);
    const double s1 = sin(2.0 * t);
    const double z4 = 0.3 * z3 + (x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z3)) + 0.2 * s1;
    const double s_z = sin(z);
    const double z5 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot) + (1.0 + z2) * (z4 * z4);
    const double z6 = 0.4 * (y_2 * x_dot * c_t) - 0.3 * (z * y_dot) + 0.1 * (t * (x * z4)) + (1.0 + 0.2 *
        s_t) * (0.5 * z5 + 0.3 * (x_dot * c_z * z4));
    return 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2))) + (0.2 * (z * z2) + z6);
}

int affine_voronec_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    const double z1 = 1.0 + z * z;
    const double s_t = sin(t);
    const double z2 = 1.0 + 0.2 * s_t;
    const double c_z = cos(z);
    const double z3 = y_2 * c_z;
    const double z4 = 0.1 * s_t;
    const double z5 = 1.0 + z4;
    const double z6 = z3 * z5;
    const double z7 = c_z * z2;
    const double z8 = x * x;
    const double z9 = 1.0 + z8;
    const double z10 = z9 * z2;
    const double z11 = 0.3 * z7 + z6 * z10;
    const double z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11;
    /* the mass matrix is singular */
    if (!(fabs(z12) > 0.0)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double s_z = sin(z);
    const double z13 = 2.0 + s_z;
    const double z14 = x * z;
    const double z15 = z14 * z10;
    const double z16 = z13 * z2 + 0.25 * (z14 * z15);
    const double z17 = 0.15 * (z14 * z7) + 0.5 * (z6 * z15);
    const double z18 = 1.0 / z12;
    const double z19 = z17 * z18;
    const double z20 = z16 - z17 * z19;
    /* the mass matrix is singular */
    if (!(fabs(z20) > 1e-14 * z16)) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    const double z21 = 0.3 + 0.5 * y_dot;
    const double z22 = x_dot * z5;
    const double z23 = y_dot * z14;
    const double z24 = 2.0 * t;
    const double s1 = sin(z24);
    const double z25 = 0.3 * z14 + (x_dot * z6 + 0.5 * z23) + 0.2 * s1;
    const double z26 = z25 * z25;
    const double z27 = z6 * z25;
    const double z28 = z2 * z27;
    const double z29 = 0.3 * z11 + 0.5 * (y_dot * z11);
    const double z30 = s_z * z6;
    const double z31 = x_dot * z30;
    const double c_t = cos(t);
    const double z32 = 2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t);
    const double z33 = 0.1 * t - (0.05 * z6 + (0.3 * (z2 * z31) - 2.0 * (z25 * (x * z2)))) - z6 * z32;
    const double z34 = x_dot * z2;
    const double z35 = z2 * z25;
    const double z36 = z2 * z6;
    const double z37 = x_dot * z11;
    const double z38 = z5 * z37;
    const double z39 = 0.3 * z35 + 0.3 * (x_dot * z36) + y_2 * z38;
    const double z40 = s_z * z25;
    const double z41 = z33 - 0.06 * (c_z * c_t) - 2.0 * (z * z34) + s_z * z39 + 0.3 * (z2 * z40);
    const double z42 = z41 - x * z29;
    const double z43 = 1.0 / z20;
    const double z44 = 0.3 * z25;
    const double z45 = x + t * x_dot;
    const double z46 = x_dot * c_t;
    const double z47 = z2 * (c_z * z25) + 0.2 * (z13 * c_t);
    const double z48 = x * z25 + z * x_dot;
    const double z49 = z5 * (y_dot * c_z - y_2 * z40) + 0.1 * (c_t * z3);
    const double c1 = cos(z24);
    const double z50 = 0.3 * z48 + (x_dot * z49 + 0.5 * (y_dot * z48)) + 0.4 * c1;
    const double z51 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z40)) + z25 * z32 + z10 * z50;
    const double z52 = z44 - 0.05 * (z14 * z45) - (0.15 * z23 - 0.4 * z46) - (y_dot * z47 + 0.5 * (z14 *
        z51));
    const double z53 = z4 - 0.05 * z25;
    const double z54 = x_dot * x_dot;
    const double z55 = z * z14;
    const double z56 = y_dot * y_dot;
    const double z57 = c_z * z14;
    const double z58 = s_z * z14;
    const double z59 = x_dot * z58;
    const double z60 = 0.1 * (z8 * z14) + z2 * (0.5 * (z54 * z55 + 0.5 * (z56 * z57)) - 0.15 * (z25 * z59));
    const double z61 = 0.2 * y_dot - z44 - 0.5 * (z14 * z53) - (z60 - 0.5 * (4.0 * y_2 + 3.0 * z55));
    const double z62 = y_dot * c_t;
    const double z63 = 0.4 * (z62 - y_2 * s_t) + 0.1 * (z6 * z45) + (0.3 * (y_dot * z6) - 0.1 * (t * z25));
    const double z64 = c_t * z25;
    const double z65 = 2.0 * (z2 * (z * z25)) + 0.2 * (z1 * c_t);
    const double z66 = 0.3 * (z35 * z40 - 0.2 * (c_z * z64)) - x_dot * z65 - 0.3 * (z7 * z50) - z6 * z51;
    const double z67 = z * z6;
    const double z68 = c_z * z6;
    const double z69 = 0.5 * (2.0 * (z54 * z67) + z56 * z68 + 2.0 * (x * z26)) - 0.3 * (z25 * z31);
    const double z70 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z69 - 0.5 * (2.0 * x + 6.0 * z67);
    const double z71 = z63 - z66 + (0.1 * x_dot - z6 * z53 - z70);
    const double z72 = z43 * (z52 - z61 + z71 * z19);
    const double z73 = z6 * z72;
    const double z74 = 0.5 * (y_dot * z42) + (0.3 * z42 + (0.4 - 0.5 * (z10 * z73) - 0.15 * (z7 * z72)));
    const double z75 = 1.0 + (0.1 * z6 - z2 * z26 + 2.0 * (x_dot * z28)) + z25 * z29 - z * z74;
    const double z76 = z71 * z18 + z19 * z72;
    const double z77 = z6 * z76;
    const double z78 = 0.2 * z6 - (0.2 * (c_t * z27) + z2 * (z6 * z50 + (0.5 * (z14 * z73) - z6 * z77)));
    const double z79 = z75 - 2.0 * (x * z78);
    const double z80 = z14 * z25;
    const double z81 = z2 * z80;
    const double z82 = 0.15 * z15 + 0.25 * (y_dot * z15);
    const double z83 = y_dot * z2;
    const double z84 = z2 * z14;
    const double z85 = x_dot * z15;
    const double z86 = z5 * z85;
    const double z87 = 0.15 * (x_dot * z84) + 0.5 * (y_2 * z86);
    const double z88 = 0.6 - (0.025 * z14 + 0.15 * (z2 * z59)) - 0.5 * (z14 * z32) - c_z * z83 + s_z * z87;
    const double z89 = z88 - x * z82;
    const double z90 = 0.15 - 0.5 * z89;
    const double z91 = z7 * z76;
    const double z92 = z15 * z72;
    const double z93 = z56 * z2;
    const double z94 = c_z * z93;
    const double z95 = x_dot * z35;
    const double z96 = s_z * z95;
    const double z97 = z54 * z2;
    const double z98 = 1.5 - 0.5 * z97;
    const double z99 = 0.05 * z45 - (0.5 * z53 + (0.25 * z94 + (0.1 * z8 - 0.15 * z96) - z * z98));
    const double z100 = z14 * z72;
    const double z101 = 0.5 * z77 - 0.25 * z100;
    const double z102 = y_dot * z90 - (0.3 * z89 + (0.15 * z91 - (0.25 * z92 + (0.5 * z51 + z99) - z10 *
        z101)));
    const double z103 = x * (0.1 * z14 - (0.1 * (c_t * z80) + z2 * (0.5 * (z14 * z50) - z14 * z101)));
    const double z104 = 0.05 * z14 + x_dot * z81 + z25 * z82 + z * z102 - 2.0 * z103 - z19 * z79;
    const double z105 = z43 * z104;
    const double z106 = 3.0 - z97;
    const double z107 = 0.1 * z45 + (0.3 * y_dot - (z53 + (0.2 * z8 - 0.3 * z96 + 0.5 * z94 - z * z106)));
    const double z108 = x_dot * z42 + (0.3 * z91 + (z11 * z76 - (0.5 * z92 + (z51 + z107)) + z10 * z77));
    const double z109 = 0.1 * (c_t * z37) - z5 * z108;
    const double z110 = 0.4 * s_t + z40 * z38 - c_z * z109;
    const double z111 = 0.05 * (c_t * z85) - z5 * (x_dot * z89 + 0.5 * (z15 * z76));
    const double z112 = z43 * (2.0 - 0.5 * (z40 * z86) + c_z * z111 + z19 * z110);
    const double z113 = c_t * z6;
    const double z114 = 0.3 * z77;
    const double z115 = 0.06 * z64 - 0.5 * (z6 * z93) + y_dot * z38 - z2 * (z114 - (0.3 * z50 - (z114 - 0.15
        * z100)));
    const double z116 = z6 * z106 + 2.0 * (z25 * z34) + x_dot * z29 - x * z74 - s_z * (0.06 * (x_dot * z113)
        + (z115 + y_2 * z109));
    const double z117 = c_z * (0.3 * (z6 * z95) - z25 * z39) + z116 + 2.0 * (z * (0.2 * z46 - z2 * z76));
    const double z118 = c_t * z14;
    const double z119 = 0.25 * (z14 * z93) - z25 * z83 - 0.5 * (y_dot * z86) + 0.15 * (z2 * (z14 * z76));
    const double z120 = z14 * z98 + x_dot * z82 + x * z102 - s_z * (0.03 * (x_dot * z118) - (z119 - y_2 *
        z111));
    const double z121 = z120 + c_z * (0.15 * (z14 * z95) - z25 * z87 + (0.2 * z62 + z2 * z72)) - z19 * z117;
    const double z122 = z43 * z121;
    const double z123 = z65 + (0.3 * (z35 * z30) + 0.1 * (t * z6)) - 0.3 * (z40 * z36) + 2.0 * (x * z28);
    const double z124 = 0.1 + (z123 + z * z29 + z49 * z11 - z6 * z42) + 0.06 * (c_z * z113) - 2.0 * (x_dot *
        (z2 * z67));
    const double z125 = 0.4 * c_t;
    const double z126 = z125 - 0.15 * (z35 * z58) - 0.05 * (t * z14) + 0.15 * (z40 * z84) - x * z81;
    const double z127 = z126 - z * z82 - 0.5 * (z49 * z15) + z6 * z89 - 0.03 * (c_z * z118) + x_dot * (z2 *
        z55);
    const double z128 = z43 * (z127 + z19 * z124);
    const double z129 = z125 + 0.3 * z6 + 0.5 * (z48 * z11) + c_z * z38 - 0.5 * (z14 * z42) - y_dot * (z2 *
        z68);
    const double z130 = 0.2 + (z47 + 0.25 * (z48 * z15) + 0.5 * (c_z * z86) + z14 * z90) - 0.5 * (y_dot * (z2
        * z57));
    const double z131 = z43 * (z130 - z19 * z129);
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
    J[10] = z * z21;
    J[11] = c_z * z22;
    J[12] = x * z21 - s_z * (y_2 * z22);
    J[13] = z6;
    J[14] = 0.5 * z14;
    J[15] = z19 * z105 - z18 * z79;
    J[16] = z18 * z110 + z19 * z112;
    J[17] = z19 * z122 - z18 * z117;
    J[18] = -(z18 * z124 + z19 * z128);
    J[19] = z19 * z131 - z18 * z129;
    J[20] = -z105;
    J[21] = -z112;
    J[22] = -z122;
    J[23] = z128;
    J[24] = -z131;
    return affine_voronec_finish(25, J);
}

int affine_voronec_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return AFFINE_VORONEC_OK;
}

int affine_voronec_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    int singular1 = 0;
    int bad = 0;
    (void)p;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double t_ = t[i]; /* time */
        const double x = y[i];
        const double y_2 = y[count + i];
        const double z = y[2 * count + i];
        const double x_dot = y[3 * count + i];
        const double y_dot = y[4 * count + i];
        const double z1 = 1.0 + z * z;
        const double s_t = sin(t_);
        const double z2 = 1.0 + 0.2 * s_t;
        const double c_z = cos(z);
        const double z3 = y_2 * c_z;
        const double z4 = 0.1 * s_t;
        const double z5 = 1.0 + z4;
        const double z6 = z3 * z5;
        const double z7 = c_z * z2;
        const double z8 = x * x;
        const double z9 = 1.0 + z8;
        const double z10 = z9 * z2;
        const double z11 = z1 * z2 + 0.3 * (z6 * z7) + z6 * (0.3 * z7 + z6 * z10);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z11) > 0.0);
        const double s_z = sin(z);
        const double z12 = 2.0 + s_z;
        const double z13 = x * z;
        const double z14 = z13 * z10;
        const double z15 = z12 * z2 + 0.25 * (z13 * z14);
        const double z16 = 0.15 * (z13 * z7) + 0.5 * (z6 * z14);
        const double z17 = 1.0 / z11;
        const double z18 = z16 * z17;
        const double z19 = z15 - z16 * z18;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z19) > 1e-14 * z15);
        const double z20 = y_dot * z13;
        const double z21 = 2.0 * t_;
        const double s1 = sin(z21);
        const double z22 = 0.3 * z13 + (x_dot * z6 + 0.5 * z20) + 0.2 * s1;
        const double c_t = cos(t_);
        const double z23 = x + t_ * x_dot;
        const double z24 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z23) + (0.3 * (y_dot * z6) - 0.1 *
            (t_ * z22));
        const double z25 = s_z * z22;
        const double z26 = 0.3 * (z2 * z22 * z25 - 0.2 * (c_z * (c_t * z22))) - x_dot * (2.0 * (z2 * (z *
            z22)) + 0.2 * (z1 * c_t));
        const double z27 = x * z22 + z * x_dot;
        const double z28 = x_dot * (z5 * (y_dot * c_z - y_2 * z25) + 0.1 * (c_t * z3)) + 0.5 * (y_dot * z27);
        const double c1 = cos(z21);
        const double z29 = 0.3 * z27 + z28 + 0.4 * c1;
        const double z30 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z25)) + z22 * (2.0 * (z2 * (x *
            x_dot)) + 0.2 * (z9 * c_t));
        const double z31 = z30 + z10 * z29;
        const double z32 = z4 - 0.05 * z22;
        const double z33 = x_dot * x_dot;
        const double z34 = z * z6;
        const double z35 = y_dot * y_dot;
        const double z36 = 0.5 * (2.0 * (z33 * z34) + z35 * (c_z * z6) + 2.0 * (x * (z22 * z22))) - 0.3 *
            (z22 * (x_dot * (s_z * z6)));
        const double z37 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z36 - 0.5 * (2.0 * x + 6.0 * z34);
        const double z38 = z24 - (z26 - 0.3 * (z7 * z29) - z6 * z31) + (0.1 * x_dot - z6 * z32 - z37);
        const double z39 = 0.3 * z22;
        const double z40 = z39 - 0.05 * (z13 * z23) - (0.15 * z20 - 0.4 * (x_dot * c_t)) - (y_dot * (z2 *
            (c_z * z22) + 0.2 * (z12 * c_t)) + 0.5 * (z13 * z31));
        const double z41 = z * z13;
        const double z42 = 0.5 * (z33 * z41 + 0.5 * (z35 * (c_z * z13))) - 0.15 * (z22 * (x_dot * (s_z *
            z13)));
        const double z43 = 0.2 * y_dot - z39 - 0.5 * (z13 * z32) - (0.1 * (z8 * z13) + z2 * z42 - 0.5 * (4.0
            * y_2 + 3.0 * z41));
        const double z44 = (z40 - z43 + z38 * z18) / z19;
        /* (I.4.9) */
        const double slope1 = x_dot; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = y_dot; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z22; /* z' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (I.4.9) 11:4 */
        const double slope4 = -(z38 * z17 + z18 * z44); /* x'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = z44; /* y'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    if (singular1) {
        return AFFINE_VORONEC_SINGULAR_2;
    }
    return bad ? AFFINE_VORONEC_NOT_FINITE : AFFINE_VORONEC_OK;
}
