/*
 * chaotic.c: chaotic, emitted by nhc 0.1.0 (nhc:1ca92c3bc42f1d30)
 * Seven coupled oscillators with one contact constraint; reversible and chaotic.
 * Source: chaotic.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x`
 * chaotic.h says what each function does.
 */
#include "chaotic.h"

#include <float.h>
#include <math.h>

const char *const chaotic_coordinate_names[] = {
    "x",
    "y1",
    "y2",
    "y3",
    "z1",
    "z2",
    "z3"
};
const char *const chaotic_state_names[] = {
    "x",
    "y1",
    "y2",
    "y3",
    "z1",
    "z2",
    "z3",
    "y1'",
    "y2'",
    "y3'",
    "z1'",
    "z2'",
    "z3'"
};
const char *const chaotic_parameter_names[] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double chaotic_parameter_defaults[] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

static int chaotic_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? CHAOTIC_OK : CHAOTIC_NOT_FINITE;
}

int chaotic_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y1_ = y[1];
    const double y2 = y[2];
    const double y3 = y[3];
    const double z1 = y[4];
    const double z2 = y[5];
    const double z3 = y[6];
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];

    /* state */
    const double z4 = 1.0 + y1_ * y1_;
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z5 = 1.0 + y2 * y2;
    const double z6 = y1_ * y2;
    const double z7 = 1.0 / z4;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    /* the mass matrix is singular */
    if (!(fabs(z9) > 1e-14 * z5)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z10 = 1.0 + y3 * y3;
    const double z11 = y1_ * y3;
    const double z12 = z11 * z7;
    const double z13 = y2 * y3 - z6 * z12;
    const double z14 = 1.0 / z9;
    const double z15 = z13 * z14;
    const double z16 = z10 - z11 * z12 - z13 * z15;
    /* the mass matrix is singular */
    if (!(fabs(z16) > 1e-14 * z10)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z17 = 1.0 + z1 * z1;
    const double z18 = 1.0 + z2 * z2;
    const double z19 = y3_dot * z3_dot;
    const double z20 = y2_dot * z2_dot;
    const double z21 = y1_dot * z1_dot;
    const double z22 = y1_ * (z19 + (z20 + (z21 - (x - y1_ * z1)))) + z1 * z18;
    const double z23 = y2 * (z19 + (z20 + (z21 - (x - y2 * z2)))) + z2 * z17 - z22 * z8;
    const double z24 = z3 + y3 * (z19 + (z20 + (z21 - (x - y3 * z3)))) - z22 * z12 - z15 * z23;
    const double z25 = z24 / z16;
    const double z26 = z14 * z23 - z15 * z25;
    /* (III.3) */
    dydt[0] = -(y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot)); /* x' */
    dydt[1] = y1_dot; /* y1' */
    dydt[2] = y2_dot; /* y2' */
    dydt[3] = y3_dot; /* y3' */
    dydt[4] = z1_dot; /* z1' */
    dydt[5] = z2_dot; /* z2' */
    dydt[6] = z3_dot; /* z3' */
    /* (III.3) 10:4 */
    dydt[7] = -y1_ * z17; /* y1'' */
    dydt[8] = -y2 * z18; /* y2'' */
    dydt[9] = -y3 * (1.0 + z3 * z3); /* y3'' */
    dydt[10] = z12 * z25 - (z22 * z7 - z8 * z26); /* z1'' */
    dydt[11] = -z26; /* z2'' */
    dydt[12] = -z25; /* z3'' */
    return chaotic_finish(13, dydt);
}

int chaotic_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double y1_ = y[1];
    const double y2 = y[2];
    const double y3 = y[3];
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];

    /* state */
    /* (I.2.4) */
    qdot[0] = -(y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot)); /* x' */
    qdot[1] = y1_dot; /* y1' */
    qdot[2] = y2_dot; /* y2' */
    qdot[3] = y3_dot; /* y3' */
    qdot[4] = z1_dot; /* z1' */
    qdot[5] = z2_dot; /* z2' */
    qdot[6] = z3_dot; /* z3' */
    return chaotic_finish(7, qdot);
}

int chaotic_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y1_ = y[1];
    const double y2 = y[2];
    const double y3 = y[3];
    const double z1 = y[4];
    const double z2 = y[5];
    const double z3 = y[6];
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];

    /* state */
    const double z4 = 1.0 + y1_ * y1_;
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z5 = 1.0 + y2 * y2;
    const double z6 = y1_ * y2;
    const double z7 = 1.0 / z4;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    /* the mass matrix is singular */
    if (!(fabs(z9) > 1e-14 * z5)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z10 = 1.0 + y3 * y3;
    const double z11 = y1_ * y3;
    const double z12 = z11 * z7;
    const double z13 = y2 * y3 - z6 * z12;
    const double z14 = 1.0 / z9;
    const double z15 = z13 * z14;
    const double z16 = z10 - z11 * z12 - z13 * z15;
    /* the mass matrix is singular */
    if (!(fabs(z16) > 1e-14 * z10)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z17 = y3_dot * z3_dot;
    const double z18 = y2_dot * z2_dot;
    const double z19 = y1_dot * z1_dot;
    const double z20 = 1.0 + z2 * z2;
    const double z21 = y1_ * (z17 + (z18 + (z19 - (x - y1_ * z1)))) + z1 * z20;
    const double z22 = 1.0 + z1 * z1;
    const double z23 = y2 * (z17 + (z18 + (z19 - (x - y2 * z2)))) + z2 * z22 - z21 * z8;
    const double z24 = z3 + y3 * (z17 + (z18 + (z19 - (x - y3 * z3)))) - z21 * z12 - z15 * z23;
    const double z25 = z24 / z16;
    const double z26 = z14 * z23 - z15 * z25;
    const double z27 = z21 * z7 - z8 * z26 - z12 * z25;
    /* (III.3) */
    qddot[0] = -(z17 - y3 * z25 + (z19 - y1_ * z27 + (z18 - y2 * z26))); /* x'' */
    qddot[1] = -y1_ * z22; /* y1'' */
    qddot[2] = -y2 * z20; /* y2'' */
    qddot[3] = -y3 * (1.0 + z3 * z3); /* y3'' */
    qddot[4] = -z27; /* z1'' */
    qddot[5] = -z26; /* z2'' */
    qddot[6] = -z25; /* z3'' */
    return chaotic_finish(7, qddot);
}

int chaotic_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0];
    const double y1_ = q[1];
    const double y2 = q[2];
    const double y3 = q[3];
    const double z1 = q[4];
    const double z2 = q[5];
    const double z3 = q[6];
    const double y1_dot = qdot[1];
    const double y2_dot = qdot[2];
    const double y3_dot = qdot[3];
    const double z1_dot = qdot[4];
    const double z2_dot = qdot[5];
    const double z3_dot = qdot[6];

    /* state */
    y[0] = x;
    y[1] = y1_;
    y[2] = y2;
    y[3] = y3;
    y[4] = z1;
    y[5] = z2;
    y[6] = z3;
    y[7] = y1_dot;
    y[8] = y2_dot;
    y[9] = y3_dot;
    y[10] = z1_dot;
    y[11] = z2_dot;
    y[12] = z3_dot;
    return chaotic_finish(13, y);
}

int chaotic_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double y1_ = q[1];
    const double y2 = q[2];
    const double y3 = q[3];
    const double x_dot = qdot[0];
    const double z1_dot = qdot[4];
    const double z2_dot = qdot[5];
    const double z3_dot = qdot[6];

    /* state */
    /* (I.1.1) 13:5 */
    r[0] = x_dot + y1_ * z1_dot + y2 * z2_dot + y3 * z3_dot; /* contact = 0 */
    return chaotic_finish(1, r);
}

int chaotic_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y1_ = y[1];
    const double y2 = y[2];
    const double y3 = y[3];
    const double z1 = y[4];
    const double z2 = y[5];
    const double z3 = y[6];
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];

    /* state */
    const double z4 = 1.0 + y1_ * y1_;
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z5 = 1.0 + y2 * y2;
    const double z6 = y1_ * y2;
    const double z7 = 1.0 / z4;
    const double z8 = z6 * z7;
    const double z9 = z5 - z6 * z8;
    /* the mass matrix is singular */
    if (!(fabs(z9) > 1e-14 * z5)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z10 = 1.0 + y3 * y3;
    const double z11 = y1_ * y3;
    const double z12 = z11 * z7;
    const double z13 = y2 * y3 - z6 * z12;
    const double z14 = 1.0 / z9;
    const double z15 = z13 * z14;
    const double z16 = z10 - z11 * z12 - z13 * z15;
    /* the mass matrix is singular */
    if (!(fabs(z16) > 1e-14 * z10)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z17 = y3_dot * z3_dot;
    const double z18 = y1_dot * z1_dot;
    const double z19 = y2_dot * z2_dot;
    const double z20 = y1_ * (z17 + (z19 + (z18 - (x - y1_ * z1)))) + z1 * (1.0 + z2 * z2);
    const double z21 = y2 * (z17 + (z19 + (z18 - (x - y2 * z2)))) + z2 * (1.0 + z1 * z1) - z20 * z8;
    const double z22 = z3 + y3 * (z17 + (z19 + (z18 - (x - y3 * z3)))) - z20 * z12 - z15 * z21;
    const double z23 = z22 / z16;
    const double z24 = z14 * z21 - z15 * z23;
    const double z25 = x - (z17 + (z18 + z19)) + (y3 * z23 + (y1_ * (z20 * z7 - z8 * z24 - z12 * z23) + y2 *
        z24));
    /* (I.4.1) 13:5 */
    lambda[0] = z25; /* reaction of contact: Q_i gains lambda_1 a_1i */
    return chaotic_finish(1, lambda);
}

double chaotic_energy(double t, const double *y, const double *p)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y1_ = y[1];
    const double y2 = y[2];
    const double y3 = y[3];
    const double z1 = y[4];
    const double z2 = y[5];
    const double z3 = y[6];
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];

    /* state */
    const double z4 = y1_ * y1_;
    const double z5 = y2 * y2;
    const double z6 = y3 * y3;
    const double z7 = z1 * z1;
    const double z8 = z2 * z2;
    const double z9 = z3 * z3;
    const double z10 = x * x + z4 + z5 + z6 + z7 + z8 + z9 + (z4 * z7 + z5 * z8 + z6 * z9 + z7 * z8);
    const double z11 = y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot);
    const double z12 = z2_dot * z2_dot + (z1_dot * z1_dot + (y3_dot * y3_dot + (y2_dot * y2_dot + (y1_dot *
        y1_dot + z11 * z11))));
    return 0.5 * z10 + 0.5 * (z3_dot * z3_dot + z12);
}

int chaotic_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y1_ = y[1];
    const double y2 = y[2];
    const double y3 = y[3];
    const double z1 = y[4];
    const double z2 = y[5];
    const double z3 = y[6];
    const double y1_dot = y[7];
    const double y2_dot = y[8];
    const double y3_dot = y[9];
    const double z1_dot = y[10];
    const double z2_dot = y[11];
    const double z3_dot = y[12];

    /* state */
    const double z4 = y1_ * y1_;
    const double z5 = 1.0 + z4;
    /* the mass matrix is singular */
    if (!(fabs(z5) > 0.0)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z6 = y2 * y2;
    const double z7 = 1.0 + z6;
    const double z8 = y1_ * y2;
    const double z9 = 1.0 / z5;
    const double z10 = z8 * z9;
    const double z11 = z7 - z8 * z10;
    /* the mass matrix is singular */
    if (!(fabs(z11) > 1e-14 * z7)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z12 = 1.0 + y3 * y3;
    const double z13 = y1_ * y3;
    const double z14 = z13 * z9;
    const double z15 = y2 * y3 - z8 * z14;
    const double z16 = 1.0 / z11;
    const double z17 = z15 * z16;
    const double z18 = z12 - z13 * z14 - z15 * z17;
    /* the mass matrix is singular */
    if (!(fabs(z18) > 1e-14 * z12)) {
        return CHAOTIC_SINGULAR_2;
    }
    const double z19 = 1.0 + z1 * z1;
    const double z20 = y1_ * z1;
    const double z21 = 1.0 + z2 * z2;
    const double z22 = y2 * z2;
    const double z23 = y3 * z3;
    const double z24 = y2 - y1_ * z10;
    const double z25 = 1.0 / z18;
    const double z26 = z25 * (y3 - y1_ * z14 - z17 * z24);
    const double z27 = z16 * z24 - z17 * z26;
    const double z28 = y3_dot * z3_dot;
    const double z29 = y2_dot * z2_dot;
    const double z30 = y1_dot * z1_dot;
    const double z31 = z28 + (z29 + (z30 - (x - z20)));
    const double z32 = y1_ * z31 + z1 * z21;
    const double z33 = z28 + (z29 + (z30 - (x - z22)));
    const double z34 = y2 * z33 + z2 * z19 - z32 * z10;
    const double z35 = z28 + (z29 + (z30 - (x - z23)));
    const double z36 = z25 * (z3 + y3 * z35 - z32 * z14 - z17 * z34);
    const double z37 = z16 * z34 - z17 * z36;
    const double z38 = z32 * z9 - z10 * z37 - z14 * z36;
    const double z39 = y1_ * z38;
    const double z40 = y2 * z37;
    const double z41 = y3 * z36;
    const double z42 = 2.0 * z39 + (z40 + (z41 - (z20 + z31)));
    const double z43 = y2 * z38 - z10 * z42;
    const double z44 = z25 * (y3 * z38 - z14 * z42 - z17 * z43);
    const double z45 = z16 * z43 - z17 * z44;
    const double z46 = y1_ * z37;
    const double z47 = 2.0 * z40 + (z39 + (z41 - (z22 + z33))) - z10 * z46;
    const double z48 = z25 * (y3 * z37 - z14 * z46 - z17 * z47);
    const double z49 = z16 * z47 - z17 * z48;
    const double z50 = y1_ * z36;
    const double z51 = y2 * z36 - z10 * z50;
    const double z52 = z25 * (2.0 * z41 + (z39 + (z40 - (z23 + z35))) - z14 * z50 - z17 * z51);
    const double z53 = z16 * z51 - z17 * z52;
    const double z54 = z4 + z21;
    const double z55 = z1 * z2;
    const double z56 = 2.0 * z55 - z10 * z54;
    const double z57 = z25 * (z14 * z54 + z17 * z56);
    const double z58 = z16 * z56 + z17 * z57;
    const double z59 = z6 + z19 - 2.0 * (z10 * z55);
    const double z60 = z25 * (2.0 * (z14 * z55) + z17 * z59);
    const double z61 = z16 * z59 + z17 * z60;
    const double z62 = z12 * z25;
    const double z63 = z17 * z62;
    const double z64 = y1_ * z1_dot;
    const double z65 = y2 * z1_dot - z64 * z10;
    const double z66 = z25 * (y3 * z1_dot - z64 * z14 - z17 * z65);
    const double z67 = z16 * z65 - z17 * z66;
    const double z68 = y1_ * z2_dot;
    const double z69 = y2 * z2_dot - z10 * z68;
    const double z70 = z25 * (y3 * z2_dot - z14 * z68 - z17 * z69);
    const double z71 = z16 * z69 - z17 * z70;
    const double z72 = y1_ * z3_dot;
    const double z73 = y2 * z3_dot - z10 * z72;
    const double z74 = z25 * (y3 * z3_dot - z14 * z72 - z17 * z73);
    const double z75 = z16 * z73 - z17 * z74;
    const double z76 = y1_ * y1_dot;
    const double z77 = y2 * y1_dot - z10 * z76;
    const double z78 = z25 * (y3 * y1_dot - z14 * z76 - z17 * z77);
    const double z79 = z16 * z77 - z17 * z78;
    const double z80 = y1_ * y2_dot;
    const double z81 = y2 * y2_dot - z10 * z80;
    const double z82 = z25 * (y3 * y2_dot - z14 * z80 - z17 * z81);
    const double z83 = z16 * z81 - z17 * z82;
    const double z84 = y1_ * y3_dot;
    const double z85 = y2 * y3_dot - z10 * z84;
    const double z86 = z25 * (y3 * y3_dot - z14 * z84 - z17 * z85);
    const double z87 = z16 * z85 - z17 * z86;
    /* (III.3) */
    J[0] = 0.0;
    J[1] = -z1_dot;
    J[2] = -z2_dot;
    J[3] = -z3_dot;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = -y1_;
    J[11] = -y2;
    J[12] = -y3;
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
    J[23] = 0.0;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = 0.0;
    J[28] = 0.0;
    J[29] = 0.0;
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = 1.0;
    J[35] = 0.0;
    J[36] = 0.0;
    J[37] = 0.0;
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
    J[59] = 0.0;
    J[60] = 0.0;
    J[61] = 0.0;
    J[62] = 1.0;
    J[63] = 0.0;
    J[64] = 0.0;
    J[65] = 0.0;
    J[66] = 0.0;
    J[67] = 0.0;
    J[68] = 0.0;
    J[69] = 0.0;
    J[70] = 0.0;
    J[71] = 0.0;
    J[72] = 0.0;
    J[73] = 0.0;
    J[74] = 0.0;
    J[75] = 0.0;
    J[76] = 1.0;
    J[77] = 0.0;
    J[78] = 0.0;
    J[79] = 0.0;
    J[80] = 0.0;
    J[81] = 0.0;
    J[82] = 0.0;
    J[83] = 0.0;
    J[84] = 0.0;
    J[85] = 0.0;
    J[86] = 0.0;
    J[87] = 0.0;
    J[88] = 0.0;
    J[89] = 0.0;
    J[90] = 1.0;
    J[91] = 0.0;
    J[92] = -z19;
    J[93] = 0.0;
    J[94] = 0.0;
    J[95] = -2.0 * z20;
    J[96] = 0.0;
    J[97] = 0.0;
    J[98] = 0.0;
    J[99] = 0.0;
    J[100] = 0.0;
    J[101] = 0.0;
    J[102] = 0.0;
    J[103] = 0.0;
    J[104] = 0.0;
    J[105] = 0.0;
    J[106] = -z21;
    J[107] = 0.0;
    J[108] = 0.0;
    J[109] = -2.0 * z22;
    J[110] = 0.0;
    J[111] = 0.0;
    J[112] = 0.0;
    J[113] = 0.0;
    J[114] = 0.0;
    J[115] = 0.0;
    J[116] = 0.0;
    J[117] = 0.0;
    J[118] = 0.0;
    J[119] = 0.0;
    J[120] = -(1.0 + z3 * z3);
    J[121] = 0.0;
    J[122] = 0.0;
    J[123] = -2.0 * z23;
    J[124] = 0.0;
    J[125] = 0.0;
    J[126] = 0.0;
    J[127] = 0.0;
    J[128] = 0.0;
    J[129] = 0.0;
    J[130] = y1_ * z9 - z10 * z27 - z14 * z26;
    J[131] = z9 * z42 - z10 * z45 - z14 * z44;
    J[132] = z9 * z46 - z10 * z49 - z14 * z48;
    J[133] = z9 * z50 - z10 * z53 - z14 * z52;
    J[134] = -(z9 * z54 - z10 * z58 + z14 * z57);
    J[135] = -(2.0 * (z9 * z55) - z10 * z61 + z14 * z60);
    J[136] = z14 * z62 - z10 * z63;
    J[137] = z14 * z66 - (z64 * z9 - z10 * z67);
    J[138] = z14 * z70 - (z9 * z68 - z10 * z71);
    J[139] = z14 * z74 - (z9 * z72 - z10 * z75);
    J[140] = z14 * z78 - (z9 * z76 - z10 * z79);
    J[141] = z14 * z82 - (z9 * z80 - z10 * z83);
    J[142] = z14 * z86 - (z9 * z84 - z10 * z87);
    J[143] = z27;
    J[144] = z45;
    J[145] = z49;
    J[146] = z53;
    J[147] = -z58;
    J[148] = -z61;
    J[149] = z63;
    J[150] = -z67;
    J[151] = -z71;
    J[152] = -z75;
    J[153] = -z79;
    J[154] = -z83;
    J[155] = -z87;
    J[156] = z26;
    J[157] = z44;
    J[158] = z48;
    J[159] = z52;
    J[160] = z57;
    J[161] = z60;
    J[162] = -z62;
    J[163] = -z66;
    J[164] = -z70;
    J[165] = -z74;
    J[166] = -z78;
    J[167] = -z82;
    J[168] = -z86;
    return chaotic_finish(169, J);
}

int chaotic_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return CHAOTIC_OK;
}

int chaotic_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
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
        const double y1_ = y[count + i];
        const double y2 = y[2 * count + i];
        const double y3 = y[3 * count + i];
        const double z1 = y[4 * count + i];
        const double z2 = y[5 * count + i];
        const double z3 = y[6 * count + i];
        const double y1_dot = y[7 * count + i];
        const double y2_dot = y[8 * count + i];
        const double y3_dot = y[9 * count + i];
        const double z1_dot = y[10 * count + i];
        const double z2_dot = y[11 * count + i];
        const double z3_dot = y[12 * count + i];
        const double z4 = 1.0 + y1_ * y1_;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z4) > 0.0);
        const double z5 = 1.0 + y2 * y2;
        const double z6 = y1_ * y2;
        const double z7 = 1.0 / z4;
        const double z8 = z6 * z7;
        const double z9 = z5 - z6 * z8;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z9) > 1e-14 * z5);
        const double z10 = 1.0 + y3 * y3;
        const double z11 = y1_ * y3;
        const double z12 = z11 * z7;
        const double z13 = y2 * y3 - z6 * z12;
        const double z14 = 1.0 / z9;
        const double z15 = z13 * z14;
        const double z16 = z10 - z11 * z12 - z13 * z15;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z16) > 1e-14 * z10);
        const double z17 = 1.0 + z1 * z1;
        const double z18 = 1.0 + z2 * z2;
        const double z19 = y3_dot * z3_dot;
        const double z20 = y2_dot * z2_dot;
        const double z21 = y1_dot * z1_dot;
        const double z22 = y1_ * (z19 + (z20 + (z21 - (x - y1_ * z1)))) + z1 * z18;
        const double z23 = y2 * (z19 + (z20 + (z21 - (x - y2 * z2)))) + z2 * z17 - z22 * z8;
        const double z24 = z3 + y3 * (z19 + (z20 + (z21 - (x - y3 * z3)))) - z22 * z12 - z15 * z23;
        const double z25 = z24 / z16;
        const double z26 = z14 * z23 - z15 * z25;
        /* (III.3) */
        const double slope1 = -(y3 * z3_dot + (y1_ * z1_dot + y2 * z2_dot)); /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = y1_dot; /* y1' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = y2_dot; /* y2' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = y3_dot; /* y3' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = z1_dot; /* z1' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = z2_dot; /* z2' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = z3_dot; /* z3' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        /* (III.3) 10:4 */
        const double slope8 = -y1_ * z17; /* y1'' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
        const double slope9 = -y2 * z18; /* y2'' */
        dydt[8 * count + i] = slope9;
        bad |= !(fabs(slope9) <= DBL_MAX);
        const double slope10 = -y3 * (1.0 + z3 * z3); /* y3'' */
        dydt[9 * count + i] = slope10;
        bad |= !(fabs(slope10) <= DBL_MAX);
        const double slope11 = z12 * z25 - (z22 * z7 - z8 * z26); /* z1'' */
        dydt[10 * count + i] = slope11;
        bad |= !(fabs(slope11) <= DBL_MAX);
        const double slope12 = -z26; /* z2'' */
        dydt[11 * count + i] = slope12;
        bad |= !(fabs(slope12) <= DBL_MAX);
        const double slope13 = -z25; /* z3'' */
        dydt[12 * count + i] = slope13;
        bad |= !(fabs(slope13) <= DBL_MAX);
    }
    if (singular1) {
        return CHAOTIC_SINGULAR_2;
    }
    return bad ? CHAOTIC_NOT_FINITE : CHAOTIC_OK;
}
