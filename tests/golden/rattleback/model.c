/*
 * rattleback.c: rattleback, emitted by nhc 0.1.0 (nhc:f42933b3ec18b005)
 * A loaded ellipsoid that rolls on a plane and prefers one sense of spin (celt, wobblestone).
 * Source: rattleback.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * rattleback.h says what each function does.
 */
#include "rattleback.h"

#include <float.h>
#include <math.h>

const char *const rattleback_coordinate_names[] = {
    "x",
    "y",
    "z",
    "alpha",
    "beta",
    "gamma"
};
const char *const rattleback_state_names[] = {
    "x",
    "y",
    "z",
    "alpha",
    "beta",
    "gamma",
    "w1",
    "w2",
    "w3"
};
const char *const rattleback_parameter_names[] = {
    "a",
    "b",
    "c",
    "h",
    "I_a",
    "I_b",
    "I_c",
    "I_d",
    "g"
};
const double rattleback_parameter_defaults[] = {
    20.0,
    3.0,
    2.0,
    1.0,
    2.0,
    16.0,
    17.0,
    -0.2,
    981.0
};

static int rattleback_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? RATTLEBACK_OK : RATTLEBACK_NOT_FINITE;
}

int rattleback_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double k4 = b * b * b * b;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;

    /* state */
    const double c_alpha = cos(alpha);
    /* the coframe is singular */
    if (!(fabs(-c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    const double s_beta = sin(beta);
    const double z1 = c_alpha * s_beta;
    const double mu2 = sin(alpha);
    const double z2 = mu2 * mu2;
    const double c_beta = cos(beta);
    const double mu3 = c_beta * c_alpha;
    const double z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3);
    const double z4 = 1.0 / sqrt(z3);
    const double z5 = c_beta * k3;
    const double z6 = 1.0 - z2;
    const double z7 = z2 * k4;
    const double z8 = z4 * (z5 * (z4 * z5 * z6 - 2.0 * (h * c_alpha)) + z4 * z7) + k5;
    /* the mass matrix is singular */
    if (!(fabs(z8) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double s_gamma = sin(gamma_);
    const double z9 = z1 * k1;
    const double r1 = z9 * z4;
    const double z10 = mu3 * k3;
    const double r3 = h - z4 * z10;
    const double z11 = c_beta * r1 + s_beta * r3;
    const double z12 = mu2 * z11;
    const double c_gamma = cos(gamma_);
    const double z13 = s_beta * r1 - c_beta * r3;
    const double z14 = s_gamma * z12 + c_gamma * z13;
    const double z15 = c_gamma * z12 - s_gamma * z13;
    const double z16 = c_alpha * z11;
    const double z17 = I_b + (z14 * z14 + z15 * z15 + z16 * z16);
    const double z18 = mu2 * k2;
    const double z19 = z4 * z18;
    const double z20 = 1.0 / c_alpha;
    const double z21 = s_beta * z20;
    const double z22 = z1 * z21 + c_beta * c_beta;
    const double z23 = z19 * z22;
    const double z24 = c_beta * s_beta;
    const double z25 = mu3 * z21 - z24;
    const double z26 = z19 * z25;
    const double z27 = c_beta * z23 - s_beta * z26;
    const double z28 = r3 * z22 + r1 * z25;
    const double z29 = mu2 * z27 - c_alpha * z28;
    const double z30 = s_beta * z23 + c_beta * z26;
    const double z31 = s_gamma * z29 + c_gamma * z30;
    const double z32 = c_gamma * z29 - s_gamma * z30;
    const double z33 = c_alpha * z27 + mu2 * z28;
    const double z34 = z31 * z14 + z32 * z15 + z33 * z16 + I_d * z22;
    const double z35 = 1.0 / z8;
    const double z36 = z34 * z35;
    const double z37 = z17 - z34 * z36;
    /* the mass matrix is singular */
    if (!(fabs(z37) > 1e-14 * z17)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z38 = 1.0 / z3;
    const double z39 = s_beta * s_beta;
    const double z40 = I_c + z38 * (z7 + z6 * (z39 * k6));
    const double z41 = h - z4 * (c_alpha * z5);
    const double z42 = z4 * (s_beta * (c_alpha * k1)) * z41;
    const double z43 = z42 * z35;
    const double z44 = z19 * z41 + z34 * z43;
    const double z45 = 1.0 / z37;
    const double z46 = z44 * z45;
    const double z47 = z40 - z42 * z43 - z44 * z46;
    /* the mass matrix is singular */
    if (!(fabs(z47) > 1e-14 * z40)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z48 = s_beta * w1 - c_beta * w3;
    const double z49 = z20 * z48;
    const double z50 = z1 * z49;
    const double z51 = z1 * w3 + mu3 * w1;
    const double z52 = z51 * z20;
    const double omega1 = z50 + c_beta * z52;
    const double z53 = r1 * w2 + z19 * omega1;
    const double z54 = mu3 * z49;
    const double z55 = z54 - s_beta * z52;
    const double z56 = z19 * z55 - r3 * w2;
    const double z57 = c_beta * z53 - s_beta * z56;
    const double z58 = r3 * omega1 + r1 * z55;
    const double e2 = mu2 * z57 - c_alpha * z58;
    const double z59 = s_beta * z53 + c_beta * z56;
    const double z60 = w2 + mu2 * z49;
    const double z61 = I_c * z55;
    const double z62 = c_beta * z60;
    const double z63 = s_beta * z60;
    const double z64 = mu2 * z52;
    const double z65 = c_alpha * z63 + c_beta * z64;
    const double z66 = mu2 * z21;
    const double z67 = c_beta * z66;
    const double z68 = s_beta * z66;
    const double z69 = c_beta * mu2;
    const double z70 = z61 * (c_beta * z62 + z21 * z65 - (z52 * z67 + z49 * (c_alpha * z68 + c_beta * z69)));
    const double z71 = z64 / (c_alpha * c_alpha);
    const double z72 = z48 * z71 + z20 * (w1 * z62 + w3 * z63);
    const double z73 = s_beta * z64 - c_alpha * z62;
    const double z74 = z20 * (w3 * z73 + w1 * z65) - z51 * z71;
    const double z75 = z49 * z65 - mu3 * z72 + (z52 * z62 - s_beta * z74);
    const double z76 = I_c * z75;
    const double z77 = I_d * omega1 + I_b * w2;
    const double z78 = I_d * w2 + I_a * omega1;
    const double z79 = z78 * (c_beta * z63 + z21 * z73 - (z52 * z68 + z49 * (s_beta * z69 - c_alpha * z67)));
    const double z80 = z49 * z73 - z1 * z72 + (z52 * z63 + c_beta * z74);
    const double z81 = I_a * z80;
    const double z82 = 2.0 * (k1 * (z1 * z73)) - 2.0 * (k2 * (mu2 * z51)) + 2.0 * (k3 * (mu3 * z65));
    const double z83 = z4 * z82 * z38;
    const double z84 = z4 * (k1 * z73) - 0.5 * (z9 * z83);
    const double z85 = 0.5 * (z18 * z83) + z4 * (k2 * z51);
    const double z86 = w2 * z84 - (omega1 * z85 - z19 * z80);
    const double z87 = 0.5 * (z10 * z83) - z4 * (k3 * z65);
    const double z88 = z55 * z85 - z19 * z75 + w2 * z87;
    const double z89 = z53 * z63 + c_beta * z86 + (z56 * z62 + s_beta * z88);
    const double z90 = omega1 * z87 + r3 * z80 + (z55 * z84 + r1 * z75);
    const double z91 = z57 * z64 + c_alpha * z89 - (z51 * z58 - mu2 * z90);
    const double z92 = c_gamma * z49;
    const double z93 = z51 * z57 - mu2 * z89 + (z58 * z64 + c_alpha * z90);
    const double z94 = s_gamma * z49;
    const double z95 = z53 * z62 - s_beta * z86 - (z56 * z63 - c_beta * z88);
    const double z96 = e2 * z92 - s_gamma * z93 - (z59 * z94 + c_gamma * z95);
    const double z97 = e2 * z94 + c_gamma * z93 + (z59 * z92 - s_gamma * z95);
    const double z98 = z77 * (z54 - z51 * z21) - (z79 + (z22 * z81 + (z33 * z91 + (z31 * z96 - z32 * z97))));
    const double z99 = z70 + (z25 * z76 - z98) - g * z33;
    const double z100 = omega1 * z61 - (I_d * z80 + (z55 * z78 + (z16 * z91 + (z14 * z96 - z15 * z97))));
    const double z101 = z100 + g * z16 + z99 * z36;
    const double z102 = c_beta * z20;
    const double z103 = mu2 * z102;
    const double z104 = c_beta * z103;
    const double z105 = s_beta * z103;
    const double z106 = s_beta * mu2;
    const double z107 = z61 * (s_beta * z62 - z102 * z65 + (z52 * z104 + z49 * (c_alpha * z105 - c_beta *
        z106)));
    const double z108 = mu3 * z102 + z39;
    const double z109 = z78 * (s_beta * z63 - z102 * z73 + (z52 * z105 - z49 * (s_beta * z106 + c_alpha *
        z104)));
    const double z110 = z24 - z1 * z102;
    const double z111 = z19 * z110;
    const double z112 = z19 * z108;
    const double z113 = c_beta * z111 + s_beta * z112;
    const double z114 = r3 * z110 - r1 * z108;
    const double z115 = c_alpha * z113 + mu2 * z114;
    const double z116 = mu2 * z113 - c_alpha * z114;
    const double z117 = s_beta * z111 - c_beta * z112;
    const double z118 = z115 * z91 + ((s_gamma * z116 + c_gamma * z117) * z96 - (c_gamma * z116 - s_gamma *
        z117) * z97);
    const double z119 = z107 - (z108 * z76 + (z77 * (z50 + z51 * z102) - (z109 + (z110 * z81 + z118)))) - g *
        z115;
    const double z120 = (z119 + z99 * z43 + z46 * z101) / z47;
    const double z121 = z45 * z101 + z46 * z120;
    /* (I.2.15) */
    dydt[0] = -(s_gamma * e2 + c_gamma * z59); /* x' */
    dydt[1] = c_gamma * e2 - s_gamma * z59; /* y' */
    dydt[2] = -(c_alpha * z57 + mu2 * z58); /* z' */
    dydt[3] = z52; /* alpha' */
    dydt[4] = z60; /* beta' */
    dydt[5] = -z49; /* gamma' */
    /* (I.2.15) 41:4 */
    dydt[6] = z99 * z35 + z36 * z121 + z43 * z120; /* w1' */
    dydt[7] = -z121; /* w2' */
    dydt[8] = z120; /* w3' */
    return rattleback_finish(9, dydt);
}

int rattleback_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double c_alpha = cos(alpha);
    /* the coframe is singular */
    if (!(fabs(-c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    const double s_gamma = sin(gamma_);
    const double mu2 = sin(alpha);
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r1 = z1 * k1 * z2;
    const double z3 = z2 * (mu2 * k2);
    const double z4 = 1.0 / c_alpha;
    const double z5 = z4 * (s_beta * w1 - c_beta * w3);
    const double z6 = (z1 * w3 + mu3 * w1) * z4;
    const double omega1 = z1 * z5 + c_beta * z6;
    const double z7 = r1 * w2 + z3 * omega1;
    const double z8 = mu3 * z5 - s_beta * z6;
    const double r3 = h - z2 * (mu3 * k3);
    const double z9 = z3 * z8 - r3 * w2;
    const double z10 = c_beta * z7 - s_beta * z9;
    const double z11 = r3 * omega1 + r1 * z8;
    const double e2 = mu2 * z10 - c_alpha * z11;
    const double c_gamma = cos(gamma_);
    const double z12 = s_beta * z7 + c_beta * z9;
    /* (I.2.4) */
    qdot[0] = -(s_gamma * e2 + c_gamma * z12); /* x' */
    qdot[1] = c_gamma * e2 - s_gamma * z12; /* y' */
    qdot[2] = -(c_alpha * z10 + mu2 * z11); /* z' */
    qdot[3] = z6; /* alpha' */
    qdot[4] = w2 + mu2 * z5; /* beta' */
    qdot[5] = -z5; /* gamma' */
    return rattleback_finish(6, qdot);
}

int rattleback_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double k4 = b * b * b * b;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;

    /* state */
    const double c_alpha = cos(alpha);
    /* the coframe is singular */
    if (!(fabs(-c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    const double s_beta = sin(beta);
    const double z1 = c_alpha * s_beta;
    const double mu2 = sin(alpha);
    const double z2 = mu2 * mu2;
    const double c_beta = cos(beta);
    const double mu3 = c_beta * c_alpha;
    const double z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3);
    const double z4 = 1.0 / sqrt(z3);
    const double z5 = c_beta * k3;
    const double z6 = 1.0 - z2;
    const double z7 = z2 * k4;
    const double z8 = z4 * (z5 * (z4 * z5 * z6 - 2.0 * (h * c_alpha)) + z4 * z7) + k5;
    /* the mass matrix is singular */
    if (!(fabs(z8) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double s_gamma = sin(gamma_);
    const double z9 = z1 * k1;
    const double r1 = z9 * z4;
    const double z10 = mu3 * k3;
    const double r3 = h - z4 * z10;
    const double z11 = c_beta * r1 + s_beta * r3;
    const double z12 = mu2 * z11;
    const double c_gamma = cos(gamma_);
    const double z13 = s_beta * r1 - c_beta * r3;
    const double z14 = s_gamma * z12 + c_gamma * z13;
    const double z15 = c_gamma * z12 - s_gamma * z13;
    const double z16 = c_alpha * z11;
    const double z17 = I_b + (z14 * z14 + z15 * z15 + z16 * z16);
    const double z18 = mu2 * k2;
    const double z19 = z4 * z18;
    const double z20 = 1.0 / c_alpha;
    const double z21 = s_beta * z20;
    const double z22 = z1 * z21 + c_beta * c_beta;
    const double z23 = z19 * z22;
    const double z24 = c_beta * s_beta;
    const double z25 = mu3 * z21 - z24;
    const double z26 = z19 * z25;
    const double z27 = c_beta * z23 - s_beta * z26;
    const double z28 = r3 * z22 + r1 * z25;
    const double z29 = mu2 * z27 - c_alpha * z28;
    const double z30 = s_beta * z23 + c_beta * z26;
    const double z31 = s_gamma * z29 + c_gamma * z30;
    const double z32 = c_gamma * z29 - s_gamma * z30;
    const double z33 = c_alpha * z27 + mu2 * z28;
    const double z34 = z31 * z14 + z32 * z15 + z33 * z16 + I_d * z22;
    const double z35 = 1.0 / z8;
    const double z36 = z34 * z35;
    const double z37 = z17 - z34 * z36;
    /* the mass matrix is singular */
    if (!(fabs(z37) > 1e-14 * z17)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z38 = 1.0 / z3;
    const double z39 = s_beta * s_beta;
    const double z40 = I_c + z38 * (z7 + z6 * (z39 * k6));
    const double z41 = h - z4 * (c_alpha * z5);
    const double z42 = z4 * (s_beta * (c_alpha * k1)) * z41;
    const double z43 = z42 * z35;
    const double z44 = z19 * z41 + z34 * z43;
    const double z45 = 1.0 / z37;
    const double z46 = z44 * z45;
    const double z47 = z40 - z42 * z43 - z44 * z46;
    /* the mass matrix is singular */
    if (!(fabs(z47) > 1e-14 * z40)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z48 = s_beta * w1 - c_beta * w3;
    const double z49 = z20 * z48;
    const double z50 = z1 * z49;
    const double z51 = z1 * w3 + mu3 * w1;
    const double z52 = z51 * z20;
    const double omega1 = z50 + c_beta * z52;
    const double z53 = r1 * w2 + z19 * omega1;
    const double z54 = mu3 * z49;
    const double z55 = z54 - s_beta * z52;
    const double z56 = z19 * z55 - r3 * w2;
    const double z57 = c_beta * z53 - s_beta * z56;
    const double z58 = r3 * omega1 + r1 * z55;
    const double e2 = mu2 * z57 - c_alpha * z58;
    const double z59 = c_gamma * z49;
    const double z60 = e2 * z59;
    const double z61 = z51 * z57;
    const double z62 = w2 + mu2 * z49;
    const double z63 = s_beta * z62;
    const double z64 = z53 * z63;
    const double z65 = mu2 * z52;
    const double z66 = c_beta * z62;
    const double z67 = s_beta * z65 - c_alpha * z66;
    const double z68 = c_alpha * z63 + c_beta * z65;
    const double z69 = 2.0 * (k1 * (z1 * z67)) - 2.0 * (k2 * (mu2 * z51)) + 2.0 * (k3 * (mu3 * z68));
    const double z70 = z4 * z69 * z38;
    const double z71 = z4 * (k1 * z67) - 0.5 * (z9 * z70);
    const double z72 = w2 * z71;
    const double z73 = I_c * z55;
    const double z74 = z49 * z67;
    const double z75 = z65 / (c_alpha * c_alpha);
    const double z76 = z48 * z75;
    const double z77 = w1 * z66;
    const double z78 = w3 * z63;
    const double z79 = z76 + z20 * (z77 + z78);
    const double z80 = z52 * z63;
    const double z81 = w3 * z67;
    const double z82 = w1 * z68;
    const double z83 = z51 * z75;
    const double z84 = z20 * (z81 + z82) - z83;
    const double z85 = z74 - z1 * z79 + (z80 + c_beta * z84);
    const double z86 = I_d * w2 + I_a * omega1;
    const double z87 = z57 * z65;
    const double z88 = 0.5 * (z18 * z70) + z4 * (k2 * z51);
    const double z89 = omega1 * z88;
    const double z90 = z72 - (z89 - z19 * z85);
    const double z91 = z56 * z66;
    const double z92 = z55 * z88;
    const double z93 = z49 * z68;
    const double z94 = z52 * z66;
    const double z95 = z93 - mu3 * z79 + (z94 - s_beta * z84);
    const double z96 = 0.5 * (z10 * z70) - z4 * (k3 * z68);
    const double z97 = w2 * z96;
    const double z98 = z92 - z19 * z95 + z97;
    const double z99 = z64 + c_beta * z90 + (z91 + s_beta * z98);
    const double z100 = z51 * z58;
    const double z101 = omega1 * z96;
    const double z102 = z55 * z71;
    const double z103 = z101 + r3 * z85 + (z102 + r1 * z95);
    const double z104 = z87 + c_alpha * z99 - (z100 - mu2 * z103);
    const double z105 = z58 * z65;
    const double z106 = z61 - mu2 * z99 + (z105 + c_alpha * z103);
    const double z107 = s_beta * z53 + c_beta * z56;
    const double z108 = s_gamma * z49;
    const double z109 = z107 * z108;
    const double z110 = z53 * z66;
    const double z111 = z56 * z63;
    const double z112 = z110 - s_beta * z90 - (z111 - c_beta * z98);
    const double z113 = z60 - s_gamma * z106 - (z109 + c_gamma * z112);
    const double z114 = e2 * z108;
    const double z115 = z107 * z59;
    const double z116 = z114 + c_gamma * z106 + (z115 - s_gamma * z112);
    const double z117 = omega1 * z73 - (I_d * z85 + (z55 * z86 + (z16 * z104 + (z14 * z113 - z15 * z116))));
    const double z118 = mu2 * z21;
    const double z119 = c_beta * z118;
    const double z120 = s_beta * z118;
    const double z121 = c_beta * mu2;
    const double z122 = z73 * (c_beta * z66 + z21 * z68 - (z52 * z119 + z49 * (c_alpha * z120 + c_beta *
        z121)));
    const double z123 = I_c * z95;
    const double z124 = I_d * omega1 + I_b * w2;
    const double z125 = z86 * (c_beta * z63 + z21 * z67 - (z52 * z120 + z49 * (s_beta * z121 - c_alpha *
        z119)));
    const double z126 = I_a * z85;
    const double z127 = z124 * (z54 - z51 * z21) - (z125 + (z22 * z126 + (z33 * z104 + (z31 * z113 - z32 *
        z116))));
    const double z128 = z122 + (z25 * z123 - z127) - g * z33;
    const double z129 = z117 + g * z16 + z128 * z36;
    const double z130 = c_beta * z20;
    const double z131 = mu2 * z130;
    const double z132 = c_beta * z131;
    const double z133 = s_beta * z131;
    const double z134 = s_beta * mu2;
    const double z135 = z73 * (s_beta * z66 - z130 * z68 + (z52 * z132 + z49 * (c_alpha * z133 - c_beta *
        z134)));
    const double z136 = mu3 * z130 + z39;
    const double z137 = z86 * (s_beta * z63 - z130 * z67 + (z52 * z133 - z49 * (s_beta * z134 + c_alpha *
        z132)));
    const double z138 = z24 - z1 * z130;
    const double z139 = z19 * z138;
    const double z140 = z19 * z136;
    const double z141 = c_beta * z139 + s_beta * z140;
    const double z142 = r3 * z138 - r1 * z136;
    const double z143 = c_alpha * z141 + mu2 * z142;
    const double z144 = mu2 * z141 - c_alpha * z142;
    const double z145 = s_beta * z139 - c_beta * z140;
    const double z146 = z143 * z104 + ((s_gamma * z144 + c_gamma * z145) * z113 - (c_gamma * z144 - s_gamma *
        z145) * z116);
    const double z147 = z135 - (z136 * z123 + (z124 * (z50 + z51 * z130) - (z137 + (z138 * z126 + z146)))) -
        g * z143;
    const double z148 = (z147 + z128 * z43 + z46 * z129) / z47;
    const double z149 = z45 * z129 + z46 * z148;
    const double z150 = z128 * z35 + z36 * z149 + z43 * z148;
    const double z151 = z76 + z20 * (z77 + s_beta * z150 + (z78 - c_beta * z148));
    const double z152 = z83 - z20 * (z81 - z1 * z148 + (z82 - mu3 * z150));
    const double z153 = z74 - z1 * z151 + (z80 - c_beta * z152);
    const double z154 = z72 + r1 * z149 - (z89 - z19 * z153);
    const double z155 = z93 - mu3 * z151 + (z94 + s_beta * z152);
    const double z156 = z92 - z19 * z155 + (z97 + r3 * z149);
    const double z157 = z64 + c_beta * z154 + (z91 + s_beta * z156);
    const double z158 = z101 + r3 * z153 + (z102 + r1 * z155);
    const double z159 = z61 - mu2 * z157 + (z105 + c_alpha * z158);
    const double z160 = z110 - s_beta * z154 - (z111 - c_beta * z156);
    /* (I.2.15) */
    qddot[0] = z60 - s_gamma * z159 - (z109 + c_gamma * z160); /* x'' */
    qddot[1] = z114 + c_gamma * z159 + (z115 - s_gamma * z160); /* y'' */
    qddot[2] = z87 + c_alpha * z157 - (z100 - mu2 * z158); /* z'' */
    qddot[3] = z152; /* alpha'' */
    qddot[4] = z51 * z49 + mu2 * z151 - z149; /* beta'' */
    qddot[5] = -z151; /* gamma'' */
    return rattleback_finish(6, qddot);
}

int rattleback_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* centre of mass [cm] */
    const double y_2 = q[1]; /* centre of mass [cm] */
    const double z = q[2]; /* centre of mass, downwards [cm] */
    const double alpha = q[3]; /* roll about the long axis [rad] */
    const double beta = q[4]; /* pitch [rad] */
    const double gamma_ = q[5]; /* heading [rad] */
    const double alpha_dot = qdot[3];
    const double beta_dot = qdot[4];
    const double gamma_dot = qdot[5];

    /* state */
    const double c_beta = cos(beta);
    const double c_alpha = cos(alpha);
    const double s_beta = sin(beta);
    const double mu2 = sin(alpha);
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = alpha;
    y[4] = beta;
    y[5] = gamma_;
    y[6] = alpha_dot * c_beta - gamma_dot * (c_alpha * s_beta);
    y[7] = beta_dot + gamma_dot * mu2;
    y[8] = alpha_dot * s_beta + gamma_dot * (c_beta * c_alpha);
    return rattleback_finish(9, y);
}

int rattleback_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double alpha = q[3]; /* roll about the long axis [rad] */
    const double beta = q[4]; /* pitch [rad] */
    const double gamma_ = q[5]; /* heading [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];
    const double alpha_dot = qdot[3];
    const double beta_dot = qdot[4];
    const double gamma_dot = qdot[5];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double c_beta = cos(beta);
    const double mu2 = sin(alpha);
    const double omega2 = beta_dot + gamma_dot * mu2;
    const double c_alpha = cos(alpha);
    const double s_beta = sin(beta);
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r3 = h - z2 * (mu3 * k3);
    const double omega3 = alpha_dot * s_beta + gamma_dot * mu3;
    const double z3 = z2 * (mu2 * k2);
    const double u1 = omega2 * r3 + omega3 * z3;
    const double omega1 = alpha_dot * c_beta - gamma_dot * z1;
    const double r1 = z1 * k1 * z2;
    const double z4 = omega1 * z3 + omega2 * r1;
    const double v1 = c_beta * u1 - s_beta * z4;
    const double c_gamma = cos(gamma_);
    const double u2 = omega3 * r1 - omega1 * r3;
    const double z5 = s_beta * u1 + c_beta * z4;
    const double e2 = c_alpha * u2 + mu2 * z5;
    const double s_gamma = sin(gamma_);
    /* (I.1.1) 44:5 */
    r[0] = x_dot - v1 * c_gamma + e2 * s_gamma; /* roll_x = 0 */
    /* (I.1.1) 45:5 */
    r[1] = y_dot - v1 * s_gamma - e2 * c_gamma; /* roll_y = 0 */
    /* (I.1.1) 46:5 */
    r[2] = z_dot - (mu2 * u2 - c_alpha * z5); /* roll_z = 0 */
    return rattleback_finish(3, r);
}

int rattleback_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double k4 = b * b * b * b;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;
    const double k7 = k1 - k3;
    const double k8 = k2 - k3;
    const double k9 = k1 - k2;

    /* state */
    const double c_alpha = cos(alpha);
    /* the coframe is singular */
    if (!(fabs(-c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    const double s_beta = sin(beta);
    const double z1 = c_alpha * s_beta;
    const double mu2 = sin(alpha);
    const double z2 = mu2 * mu2;
    const double z3 = k2 * z2;
    const double c_beta = cos(beta);
    const double mu3 = c_beta * c_alpha;
    const double z4 = k1 * (z1 * z1) + z3 + k3 * (mu3 * mu3);
    const double z5 = 1.0 / sqrt(z4);
    const double z6 = c_beta * k3;
    const double z7 = 1.0 - z2;
    const double z8 = h * c_alpha;
    const double z9 = z2 * k4;
    const double z10 = z5 * (z6 * (z5 * z6 * z7 - 2.0 * z8) + z5 * z9) + k5;
    /* the mass matrix is singular */
    if (!(fabs(z10) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double s_gamma = sin(gamma_);
    const double z11 = z1 * k1;
    const double r1 = z11 * z5;
    const double z12 = mu3 * k3;
    const double r3 = h - z5 * z12;
    const double z13 = c_beta * r1 + s_beta * r3;
    const double z14 = mu2 * z13;
    const double c_gamma = cos(gamma_);
    const double z15 = s_beta * r1 - c_beta * r3;
    const double z16 = s_gamma * z14 + c_gamma * z15;
    const double z17 = c_gamma * z14 - s_gamma * z15;
    const double z18 = c_alpha * z13;
    const double z19 = I_b + (z16 * z16 + z17 * z17 + z18 * z18);
    const double z20 = mu2 * k2;
    const double z21 = z5 * z20;
    const double z22 = 1.0 / c_alpha;
    const double z23 = s_beta * z22;
    const double z24 = z1 * z23 + c_beta * c_beta;
    const double z25 = z21 * z24;
    const double z26 = c_beta * s_beta;
    const double z27 = mu3 * z23 - z26;
    const double z28 = z21 * z27;
    const double z29 = c_beta * z25 - s_beta * z28;
    const double z30 = r3 * z24 + r1 * z27;
    const double z31 = mu2 * z29 - c_alpha * z30;
    const double z32 = s_beta * z25 + c_beta * z28;
    const double z33 = s_gamma * z31 + c_gamma * z32;
    const double z34 = c_gamma * z31 - s_gamma * z32;
    const double z35 = c_alpha * z29 + mu2 * z30;
    const double z36 = z33 * z16 + z34 * z17 + z35 * z18 + I_d * z24;
    const double z37 = 1.0 / z10;
    const double z38 = z36 * z37;
    const double z39 = z19 - z36 * z38;
    /* the mass matrix is singular */
    if (!(fabs(z39) > 1e-14 * z19)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z40 = 1.0 / z4;
    const double z41 = s_beta * s_beta;
    const double z42 = I_c + z40 * (z9 + z7 * (z41 * k6));
    const double z43 = h - z5 * (c_alpha * z6);
    const double z44 = z5 * (s_beta * (c_alpha * k1)) * z43;
    const double z45 = z44 * z37;
    const double z46 = z21 * z43 + z36 * z45;
    const double z47 = 1.0 / z39;
    const double z48 = z46 * z47;
    const double z49 = z42 - z44 * z45 - z46 * z48;
    /* the mass matrix is singular */
    if (!(fabs(z49) > 1e-14 * z42)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z50 = s_beta * w1 - c_beta * w3;
    const double z51 = z22 * z50;
    const double z52 = z1 * z51;
    const double z53 = z1 * w3 + mu3 * w1;
    const double z54 = z53 * z22;
    const double omega1 = z52 + c_beta * z54;
    const double z55 = r1 * w2 + z21 * omega1;
    const double z56 = mu3 * z51;
    const double z57 = z56 - s_beta * z54;
    const double z58 = z21 * z57 - r3 * w2;
    const double z59 = c_beta * z55 - s_beta * z58;
    const double z60 = r3 * omega1 + r1 * z57;
    const double e2 = mu2 * z59 - c_alpha * z60;
    const double z61 = c_gamma * z51;
    const double z62 = w2 + mu2 * z51;
    const double z63 = s_beta * z62;
    const double z64 = mu2 * z54;
    const double z65 = c_beta * z62;
    const double z66 = s_beta * z64 - c_alpha * z65;
    const double z67 = c_alpha * z63 + c_beta * z64;
    const double z68 = 2.0 * (k1 * (z1 * z66)) - 2.0 * (k2 * (mu2 * z53)) + 2.0 * (k3 * (mu3 * z67));
    const double z69 = z5 * z68 * z40;
    const double z70 = z5 * (k1 * z66) - 0.5 * (z11 * z69);
    const double z71 = 0.5 * (z20 * z69) + z5 * (k2 * z53);
    const double z72 = z64 / (c_alpha * c_alpha);
    const double z73 = z50 * z72 + z22 * (w1 * z65 + w3 * z63);
    const double z74 = z22 * (w3 * z66 + w1 * z67) - z53 * z72;
    const double z75 = z51 * z66 - z1 * z73 + (z54 * z63 + c_beta * z74);
    const double z76 = w2 * z70 - (omega1 * z71 - z21 * z75);
    const double z77 = z51 * z67 - mu3 * z73 + (z54 * z65 - s_beta * z74);
    const double z78 = 0.5 * (z12 * z69) - z5 * (k3 * z67);
    const double z79 = z57 * z71 - z21 * z77 + w2 * z78;
    const double z80 = z55 * z63 + c_beta * z76 + (z58 * z65 + s_beta * z79);
    const double z81 = omega1 * z78 + r3 * z75 + (z57 * z70 + r1 * z77);
    const double z82 = z53 * z59 - mu2 * z80 + (z60 * z64 + c_alpha * z81);
    const double z83 = s_beta * z55 + c_beta * z58;
    const double z84 = s_gamma * z51;
    const double z85 = z55 * z65 - s_beta * z76 - (z58 * z63 - c_beta * z79);
    const double z86 = e2 * z61 - s_gamma * z82 - (z83 * z84 + c_gamma * z85);
    const double z87 = s_beta * s_gamma;
    const double z88 = z3 + k1 * z7;
    const double z89 = mu2 * (c_beta * k2);
    const double z90 = I_c * z57;
    const double z91 = c_beta * z22;
    const double z92 = mu2 * z91;
    const double z93 = c_beta * z92;
    const double z94 = s_beta * z92;
    const double z95 = s_beta * mu2;
    const double z96 = z90 * (s_beta * z65 - z91 * z67 + (z54 * z93 + z51 * (c_alpha * z94 - c_beta * z95)));
    const double z97 = mu3 * z91 + z41;
    const double z98 = I_c * z77;
    const double z99 = I_d * omega1 + I_b * w2;
    const double z100 = I_d * w2 + I_a * omega1;
    const double z101 = z100 * (s_beta * z63 - z91 * z66 + (z54 * z94 - z51 * (s_beta * z95 + c_alpha *
        z93)));
    const double z102 = z26 - z1 * z91;
    const double z103 = I_a * z75;
    const double z104 = z21 * z102;
    const double z105 = z21 * z97;
    const double z106 = c_beta * z104 + s_beta * z105;
    const double z107 = r3 * z102 - r1 * z97;
    const double z108 = c_alpha * z106 + mu2 * z107;
    const double z109 = z59 * z64 + c_alpha * z80 - (z53 * z60 - mu2 * z81);
    const double z110 = mu2 * z106 - c_alpha * z107;
    const double z111 = s_beta * z104 - c_beta * z105;
    const double z112 = e2 * z84 + c_gamma * z82 + (z83 * z61 - s_gamma * z85);
    const double z113 = z108 * z109 + ((s_gamma * z110 + c_gamma * z111) * z86 - (c_gamma * z110 - s_gamma *
        z111) * z112);
    const double z114 = z96 - (z97 * z98 + (z99 * (z52 + z53 * z91) - (z101 + (z102 * z103 + z113)))) - g *
        z108;
    const double z115 = mu2 * z23;
    const double z116 = c_beta * z115;
    const double z117 = s_beta * z115;
    const double z118 = c_beta * mu2;
    const double z119 = z90 * (c_beta * z65 + z23 * z67 - (z54 * z116 + z51 * (c_alpha * z117 + c_beta *
        z118)));
    const double z120 = z100 * (c_beta * z63 + z23 * z66 - (z54 * z117 + z51 * (s_beta * z118 - c_alpha *
        z116)));
    const double z121 = z99 * (z56 - z53 * z23) - (z120 + (z24 * z103 + (z35 * z109 + (z33 * z86 - z34 *
        z112))));
    const double z122 = z119 + (z27 * z98 - z121) - g * z35;
    const double z123 = omega1 * z90 - (I_d * z75 + (z57 * z100 + (z18 * z109 + (z16 * z86 - z17 * z112))));
    const double z124 = z123 + g * z18 + z122 * z38;
    const double z125 = (z114 + z122 * z45 + z48 * z124) / z49;
    const double z126 = c_beta * s_gamma;
    const double z127 = z3 + k3 * z7;
    const double z128 = mu2 * (s_beta * k2);
    const double z129 = z47 * z124 + z48 * z125;
    const double z130 = z122 * z37 + z38 * z129 + z45 * z125;
    const double z131 = c_alpha * z5;
    const double z132 = s_beta * c_gamma;
    const double z133 = c_beta * c_gamma;
    const double z134 = z131 * (s_beta * ((z132 + s_gamma * z118) * k7) + k3 * c_gamma) - h * (z133 - s_gamma
        * z95);
    const double z135 = z5 * (z87 * z88 - c_gamma * z89) * z125 + ((z5 * (z126 * z127 + c_gamma * z128) -
        s_gamma * z8) * z130 - z134 * z129);
    const double z136 = z131 * (s_beta * (k7 * (z87 - c_gamma * z118)) + k3 * s_gamma) - h * (z126 + c_gamma
        * z95);
    const double z137 = z5 * (z132 * z88 + s_gamma * z89) * z125 + ((z5 * (z133 * z127 - s_gamma * z128) -
        c_gamma * z8) * z130 + z136 * z129);
    const double z138 = mu3 * z5;
    const double z139 = z5 * (z1 * mu2) * k9 * z125 - (mu2 * (h + z138 * k8) * z130 - z1 * (h + k7 * z138) *
        z129);
    /* (I.4.1) 44:5 */
    lambda[0] = z86 - z135; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 45:5 */
    lambda[1] = z112 + z137; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 46:5 */
    lambda[2] = z139 - (g - z109); /* reaction of roll_z: Q_i gains lambda_3 a_3i */
    return rattleback_finish(3, lambda);
}

double rattleback_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double z = y[2]; /* centre of mass, downwards [cm] */
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* state */
    const double s_gamma = sin(gamma_);
    const double mu2 = sin(alpha);
    const double c_beta = cos(beta);
    const double c_alpha = cos(alpha);
    const double s_beta = sin(beta);
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r1 = z1 * k1 * z2;
    const double z3 = z2 * (mu2 * k2);
    const double z4 = 1.0 / c_alpha;
    const double z5 = z4 * (s_beta * w1 - c_beta * w3);
    const double z6 = (z1 * w3 + mu3 * w1) * z4;
    const double omega1 = z1 * z5 + c_beta * z6;
    const double z7 = r1 * w2 + z3 * omega1;
    const double z8 = mu3 * z5 - s_beta * z6;
    const double r3 = h - z2 * (mu3 * k3);
    const double z9 = z3 * z8 - r3 * w2;
    const double z10 = c_beta * z7 - s_beta * z9;
    const double z11 = r3 * omega1 + r1 * z8;
    const double e2 = mu2 * z10 - c_alpha * z11;
    const double c_gamma = cos(gamma_);
    const double z12 = s_beta * z7 + c_beta * z9;
    const double z13 = s_gamma * e2 + c_gamma * z12;
    const double z14 = c_gamma * e2 - s_gamma * z12;
    const double z15 = c_alpha * z10 + mu2 * z11;
    const double z16 = 0.5 * (z13 * z13 + z14 * z14 + z15 * z15) + 0.5 * (I_a * (omega1 * omega1) + I_b * (w2
        * w2) + I_c * (z8 * z8));
    return z16 + w2 * (I_d * omega1) - z * g;
}

int rattleback_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* heading [rad] */
    const double w1 = y[6];
    const double w2 = y[7];
    const double w3 = y[8];
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* parameters only */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double k4 = b * b * b * b;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;

    /* state */
    const double c_alpha = cos(alpha);
    /* the coframe is singular */
    if (!(fabs(-c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    const double s_beta = sin(beta);
    const double z1 = c_alpha * s_beta;
    const double mu2 = sin(alpha);
    const double z2 = mu2 * mu2;
    const double c_beta = cos(beta);
    const double mu3 = c_beta * c_alpha;
    const double z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3);
    const double z4 = 1.0 / sqrt(z3);
    const double z5 = c_beta * k3;
    const double z6 = z4 * z5;
    const double z7 = 1.0 - z2;
    const double z8 = z6 * z7 - 2.0 * (h * c_alpha);
    const double z9 = z2 * k4;
    const double z10 = z5 * z8 + z4 * z9;
    const double z11 = z4 * z10 + k5;
    /* the mass matrix is singular */
    if (!(fabs(z11) > 0.0)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double s_gamma = sin(gamma_);
    const double z12 = z1 * k1;
    const double r1 = z12 * z4;
    const double z13 = mu3 * k3;
    const double r3 = h - z4 * z13;
    const double z14 = c_beta * r1 + s_beta * r3;
    const double z15 = mu2 * z14;
    const double c_gamma = cos(gamma_);
    const double z16 = s_beta * r1 - c_beta * r3;
    const double z17 = s_gamma * z15 + c_gamma * z16;
    const double z18 = c_gamma * z15 - s_gamma * z16;
    const double z19 = c_alpha * z14;
    const double z20 = I_b + (z17 * z17 + z18 * z18 + z19 * z19);
    const double z21 = mu2 * k2;
    const double z22 = z4 * z21;
    const double z23 = 1.0 / c_alpha;
    const double z24 = s_beta * z23;
    const double z25 = z1 * z24 + c_beta * c_beta;
    const double z26 = z22 * z25;
    const double z27 = c_beta * s_beta;
    const double z28 = mu3 * z24 - z27;
    const double z29 = z22 * z28;
    const double z30 = c_beta * z26 - s_beta * z29;
    const double z31 = r3 * z25 + r1 * z28;
    const double z32 = mu2 * z30 - c_alpha * z31;
    const double z33 = s_beta * z26 + c_beta * z29;
    const double z34 = s_gamma * z32 + c_gamma * z33;
    const double z35 = c_gamma * z32 - s_gamma * z33;
    const double z36 = c_alpha * z30 + mu2 * z31;
    const double z37 = z34 * z17 + z35 * z18 + z36 * z19 + I_d * z25;
    const double z38 = 1.0 / z11;
    const double z39 = z37 * z38;
    const double z40 = z20 - z37 * z39;
    /* the mass matrix is singular */
    if (!(fabs(z40) > 1e-14 * z20)) {
        return RATTLEBACK_SINGULAR_2;
    }
    const double z41 = 1.0 / z3;
    const double z42 = s_beta * s_beta;
    const double z43 = z42 * k6;
    const double z44 = z9 + z7 * z43;
    const double z45 = I_c + z41 * z44;
    const double z46 = c_alpha * k1;
    const double z47 = s_beta * z46;
    const double z48 = z4 * z47;
    const double z49 = c_alpha * z5;
    const double z50 = h - z4 * z49;
    const double z51 = z48 * z50;
    const double z52 = z51 * z38;
    const double z53 = z22 * z50 + z37 * z52;
    const double z54 = 1.0 / z40;
    const double z55 = z53 * z54;
    const double z56 = z45 - z51 * z52 - z53 * z55;
    /* the mass matrix is singular */
    if (!(fabs(z56) > 1e-14 * z45)) {
        return RATTLEBACK_SINGULAR_2;
    }
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    const double z57 = s_beta * w1 - c_beta * w3;
    const double z58 = z23 * z57;
    const double z59 = z1 * z58;
    const double z60 = z1 * w3 + mu3 * w1;
    const double z61 = z60 * z23;
    const double omega1 = z59 + c_beta * z61;
    const double z62 = r1 * w2 + z22 * omega1;
    const double z63 = mu3 * z58;
    const double z64 = z63 - s_beta * z61;
    const double z65 = z22 * z64 - r3 * w2;
    const double z66 = c_beta * z62 - s_beta * z65;
    const double z67 = mu2 * s_gamma;
    const double z68 = s_beta * z67 - c_beta * c_gamma;
    const double z69 = c_beta * z67 + s_beta * c_gamma;
    const double z70 = z68 * z64 - z69 * omega1;
    const double z71 = c_alpha * s_gamma;
    const double z72 = z71 * omega1 - z68 * w2;
    const double z73 = z71 * z64 - z69 * w2;
    const double z74 = z4 * (z41 * (z13 * z72 - z21 * z70 - z12 * z73));
    const double z75 = r3 * omega1 + r1 * z64;
    const double z76 = 1.0 / (c_alpha * c_alpha);
    const double z77 = r1 * z71 + z22 * z68;
    const double z78 = z22 * z69 - r3 * z71;
    const double z79 = mu3 * z77 - z1 * z78;
    const double z80 = s_beta * z77 + c_beta * z78;
    const double z81 = z80 * z23;
    const double z82 = z77 * z58 - w1 * z81 - k3 * (z4 * z72) + mu3 * (k3 * z74);
    const double z83 = z78 * z58 + w3 * z81 - k1 * (z4 * z73) - z1 * (k1 * z74);
    const double z84 = mu2 * (s_gamma * z75 - z76 * (z57 * z79 - z80 * z60) + c_beta * z82 - s_beta * z83);
    J[3] = -(c_alpha * (s_gamma * z66 - k2 * (z4 * z70) - mu2 * (k2 * z74)) + z84);
    const double z85 = z23 * z79;
    const double z86 = c_beta * (c_gamma * z62 - z67 * z65 + z77 * z61 - w1 * z85 + c_alpha * z83) - s_beta *
        (c_gamma * z65 + z67 * z62 + z78 * z61 + w3 * z85 - c_alpha * z82);
    J[4] = -z86;
    const double e2 = mu2 * z66 - c_alpha * z75;
    const double z87 = s_beta * z62 + c_beta * z65;
    J[5] = s_gamma * z87 - c_gamma * e2;
    J[6] = s_beta * z85 - mu3 * z81;
    J[7] = -(r1 * z69 + r3 * z68);
    J[8] = -(c_beta * z85 + z1 * z81);
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 0.0;
    const double z88 = mu2 * c_gamma;
    const double z89 = s_beta * z88 + c_beta * s_gamma;
    const double z90 = c_beta * z88 - s_beta * s_gamma;
    const double z91 = z89 * z64 - z90 * omega1;
    const double z92 = c_alpha * c_gamma;
    const double z93 = z92 * omega1 - z89 * w2;
    const double z94 = z92 * z64 - z90 * w2;
    const double z95 = z4 * (z41 * (z13 * z93 - z21 * z91 - z12 * z94));
    const double z96 = r1 * z92 + z22 * z89;
    const double z97 = z22 * z90 - r3 * z92;
    const double z98 = mu3 * z96 - z1 * z97;
    const double z99 = s_beta * z96 + c_beta * z97;
    const double z100 = z99 * z23;
    const double z101 = z96 * z58 - w1 * z100 - k3 * (z4 * z93) + mu3 * (k3 * z95);
    const double z102 = z97 * z58 + w3 * z100 - k1 * (z4 * z94) - z1 * (k1 * z95);
    const double z103 = mu2 * (c_gamma * z75 - z76 * (z57 * z98 - z99 * z60) + c_beta * z101 - s_beta * z102);
    J[12] = c_alpha * (c_gamma * z66 - k2 * (z4 * z91) - mu2 * (k2 * z95)) + z103;
    const double z104 = z23 * z98;
    const double z105 = c_beta * (s_gamma * z62 + z88 * z65 - z96 * z61 + w1 * z104 - c_alpha * z102) -
        s_beta * (s_gamma * z65 - z88 * z62 - z97 * z61 - w3 * z104 + c_alpha * z101);
    J[13] = -z105;
    J[14] = -(s_gamma * e2 + c_gamma * z87);
    J[15] = mu3 * z100 - s_beta * z104;
    J[16] = r1 * z90 + r3 * z89;
    J[17] = c_beta * z104 + z1 * z100;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    const double z106 = z1 * z64 - mu3 * omega1;
    const double z107 = mu2 * omega1 + z1 * w2;
    const double z108 = mu2 * z64 + mu3 * w2;
    const double z109 = z4 * (z41 * (z13 * z107 + z21 * z106 - z12 * z108));
    const double z110 = mu2 * r1 - z1 * z22;
    const double z111 = mu3 * z22 + mu2 * r3;
    const double z112 = mu3 * z110 + z1 * z111;
    const double z113 = s_beta * z110 - c_beta * z111;
    const double z114 = z113 * z23;
    const double z115 = z110 * z58 - w1 * z114 - k3 * (z4 * z107) + mu3 * (k3 * z109);
    const double z116 = z111 * z58 - w3 * z114 + k1 * (z4 * z108) + z1 * (k1 * z109);
    const double z117 = c_alpha * (z75 - k2 * (z4 * z106) + mu2 * (k2 * z109)) - mu2 * (z66 - z76 * (z57 *
        z112 - z113 * z60) + c_beta * z115 + s_beta * z116);
    J[21] = -z117;
    const double z118 = z23 * z112;
    const double z119 = c_beta * (c_alpha * z65 + z110 * z61 - w1 * z118 - c_alpha * z116) + s_beta *
        (c_alpha * z62 + z111 * z61 - w3 * z118 + c_alpha * z115);
    J[22] = z119;
    J[23] = 0.0;
    J[24] = mu3 * z114 - s_beta * z118;
    J[25] = -(mu3 * r1 + z1 * r3);
    J[26] = c_beta * z118 + z1 * z114;
    J[27] = 0.0;
    J[28] = 0.0;
    J[29] = 0.0;
    const double z120 = c_beta * (w1 * z23);
    const double z121 = s_beta * (w3 * z23);
    J[30] = mu2 * (z60 * z76 - z120 - z121);
    J[31] = -z57;
    J[32] = 0.0;
    J[33] = c_beta;
    J[34] = 0.0;
    J[35] = s_beta;
    J[36] = 0.0;
    J[37] = 0.0;
    J[38] = 0.0;
    J[39] = z57 + mu2 * (z76 * (mu2 * z57));
    const double z122 = mu2 * z23;
    J[40] = c_beta * (w1 * z122) + s_beta * (w3 * z122);
    J[41] = 0.0;
    J[42] = s_beta * z122;
    J[43] = 1.0;
    J[44] = -c_beta * z122;
    J[45] = 0.0;
    J[46] = 0.0;
    J[47] = 0.0;
    J[48] = -mu2 * (z57 * z76);
    J[49] = -(z120 + z121);
    J[50] = 0.0;
    J[51] = -z24;
    J[52] = 0.0;
    const double z123 = c_beta * z23;
    J[53] = z123;
    J[54] = 0.0;
    J[55] = 0.0;
    J[56] = 0.0;
    const double z124 = I_c * z64;
    const double z125 = s_gamma * z35 - c_gamma * z34;
    const double z126 = c_gamma * z35 + s_gamma * z34;
    const double z127 = c_alpha * z36 + mu2 * z126;
    const double z128 = mu2 * z36 - c_alpha * z126;
    const double z129 = c_beta * z125 + s_beta * z127;
    const double z130 = I_c * z28 + r1 * z128 - z22 * z129;
    const double z131 = s_beta * z125 - c_beta * z127;
    const double z132 = I_a * z25 + r3 * z128 - z22 * z131;
    const double z133 = mu3 * z130 + z1 * z132;
    const double z134 = z23 * z133;
    const double z135 = I_d * w2 + I_a * omega1;
    const double z136 = s_beta * z130 - c_beta * z132;
    const double z137 = z23 * z136;
    const double z138 = z64 * z128 - w2 * z131;
    const double z139 = omega1 * z128 + w2 * z129;
    const double z140 = z64 * z129 + omega1 * z131;
    const double z141 = 0.5 * (z13 * z139) + 0.5 * (z21 * z140) - 0.5 * (z12 * z138);
    const double z142 = z41 * z141;
    const double z143 = z4 * z142;
    const double z144 = k1 * z143;
    const double z145 = z24 * z135 + z58 * z132 - w3 * z137 + k1 * (z4 * z138) + 2.0 * (z1 * z144);
    const double z146 = c_beta * z124 + z62 * z125 + z65 * z127 + z61 * z130 - w1 * z134 - c_alpha * z145;
    const double z147 = k3 * z143;
    const double z148 = z24 * z124 + z58 * z130 - w1 * z137 - k3 * (z4 * z139) + 2.0 * (mu3 * z147);
    const double z149 = c_beta * z135 - z65 * z125 + z62 * z127 + z61 * z132 - w3 * z134 + c_alpha * z148;
    const double z150 = c_beta * z146 + s_beta * z149;
    const double z151 = s_gamma * z58;
    const double z152 = c_gamma * z58;
    const double z153 = z35 * z151 - z34 * z152;
    const double z154 = z58 * z135;
    const double z155 = z61 * z124 - c_alpha * z154;
    const double z156 = z58 * z124;
    const double z157 = c_alpha * z156 + z61 * z135;
    const double z158 = c_beta * z155 + s_beta * z157;
    const double z159 = c_beta * z156 + s_beta * z154;
    const double z160 = mu2 * z61;
    const double z161 = w2 + mu2 * z58;
    const double z162 = c_beta * z161;
    const double z163 = s_beta * z160 - c_alpha * z162;
    const double z164 = s_beta * z161;
    const double z165 = c_alpha * z164 + c_beta * z160;
    const double z166 = 2.0 * (k1 * (z1 * z163)) - 2.0 * (k2 * (mu2 * z60)) + 2.0 * (k3 * (mu3 * z165));
    const double z167 = z4 * z166;
    const double z168 = z167 * z41;
    const double z169 = k3 * z165;
    const double z170 = 0.5 * (z13 * z168) - z4 * z169;
    const double z171 = z160 * z76;
    const double z172 = w1 * z162 + w3 * z164;
    const double z173 = z57 * z171 + z23 * z172;
    const double z174 = w3 * z163 + w1 * z165;
    const double z175 = z23 * z174 - z60 * z171;
    const double z176 = z58 * z163 - z1 * z173 + (z61 * z164 + c_beta * z175);
    const double z177 = k1 * z163;
    const double z178 = z4 * z177 - 0.5 * (z12 * z168);
    const double z179 = z58 * z165 - mu3 * z173 + (z61 * z162 - s_beta * z175);
    const double z180 = omega1 * z170 + r3 * z176 + (z64 * z178 + r1 * z179);
    const double z181 = k2 * z60;
    const double z182 = 0.5 * (z21 * z168) + z4 * z181;
    const double z183 = w2 * z178 - (omega1 * z182 - z22 * z176);
    const double z184 = z64 * z182 - z22 * z179 + w2 * z170;
    const double z185 = z62 * z164 + c_beta * z183 + (z65 * z162 + s_beta * z184);
    const double z186 = k2 * z143;
    const double z187 = z57 * z133 - z60 * z136;
    const double z188 = z66 * z36 - z75 * z126 - z76 * z187 + c_beta * z148 + s_beta * z145;
    const double z189 = z66 * z160 + c_alpha * z185 - (z60 * z75 - mu2 * z180);
    const double z190 = z60 * z66 - mu2 * z185 + (z75 * z160 + c_alpha * z180);
    const double z191 = z62 * z162 - s_beta * z183 - (z65 * z164 - c_beta * z184);
    const double z192 = e2 * z152 - s_gamma * z190 - (z87 * z151 + c_gamma * z191);
    const double z193 = e2 * z151 + c_gamma * z190 + (z87 * z152 - s_gamma * z191);
    const double z194 = omega1 * z124 - (I_d * z176 + (z64 * z135 + (z19 * z189 + (z17 * z192 - z18 *
        z193))));
    const double z195 = mu2 * z24;
    const double z196 = c_beta * z195;
    const double z197 = s_beta * z195;
    const double z198 = c_beta * mu2;
    const double z199 = c_alpha * z197 + c_beta * z198;
    const double z200 = c_beta * z162 + z24 * z165 - (z61 * z196 + z58 * z199);
    const double z201 = I_c * z179;
    const double z202 = I_d * omega1 + I_b * w2;
    const double z203 = z63 - z60 * z24;
    const double z204 = s_beta * z198 - c_alpha * z196;
    const double z205 = c_beta * z164 + z24 * z163 - (z61 * z197 + z58 * z204);
    const double z206 = I_a * z176;
    const double z207 = z202 * z203 - (z135 * z205 + (z25 * z206 + (z36 * z189 + (z34 * z192 - z35 * z193))));
    const double z208 = z124 * z200 + (z28 * z201 - z207) - g * z36;
    const double z209 = z194 + g * z19 + z208 * z39;
    const double z210 = 1.0 / z56;
    const double z211 = mu2 * z123;
    const double z212 = c_beta * z211;
    const double z213 = s_beta * z211;
    const double z214 = s_beta * mu2;
    const double z215 = c_alpha * z213 - c_beta * z214;
    const double z216 = s_beta * z162 - z123 * z165 + (z61 * z212 + z58 * z215);
    const double z217 = mu3 * z123 + z42;
    const double z218 = z59 + z60 * z123;
    const double z219 = s_beta * z214 + c_alpha * z212;
    const double z220 = s_beta * z164 - z123 * z163 + (z61 * z213 - z58 * z219);
    const double z221 = z27 - z1 * z123;
    const double z222 = z22 * z221;
    const double z223 = z22 * z217;
    const double z224 = c_beta * z222 + s_beta * z223;
    const double z225 = r3 * z221 - r1 * z217;
    const double z226 = c_alpha * z224 + mu2 * z225;
    const double z227 = mu2 * z224 - c_alpha * z225;
    const double z228 = s_beta * z222 - c_beta * z223;
    const double z229 = s_gamma * z227 + c_gamma * z228;
    const double z230 = c_gamma * z227 - s_gamma * z228;
    const double z231 = z202 * z218 - (z135 * z220 + (z221 * z206 + (z226 * z189 + (z229 * z192 - z230 *
        z193))));
    const double z232 = z210 * (z124 * z216 - (z217 * z201 + z231) - g * z226 + z208 * z52 + z55 * z209);
    const double z233 = z54 * z209 + z55 * z232;
    const double z234 = z35 * z233;
    const double z235 = z34 * z233;
    const double z236 = c_gamma * z234 + s_gamma * z235;
    const double z237 = c_beta * z159 - z36 * z180 - z185 * z126 + 2.0 * (z60 * z186) - z61 * z188 - z14 *
        z236;
    const double z238 = g - z189;
    const double z239 = z19 * z233;
    const double z240 = z238 - z239;
    const double z241 = z18 * z233;
    const double z242 = z193 - z241;
    const double z243 = z17 * z233;
    const double z244 = z192 + z243;
    const double z245 = c_gamma * z242 - s_gamma * z244;
    const double z246 = z35 * z152 + z34 * z151;
    const double z247 = z36 * z160 - z60 * z126 - mu2 * z153;
    const double z248 = z162 * z125 + z164 * z127 - s_beta * z246 + c_beta * z247;
    const double z249 = z164 * z125 - z162 * z127 + c_beta * z246 + s_beta * z247;
    const double z250 = s_gamma * z242 + c_gamma * z244;
    const double z251 = c_alpha * z240 + mu2 * z245;
    const double z252 = c_beta * z250 + s_beta * z251;
    const double z253 = s_beta * z250 - c_beta * z251;
    const double z254 = omega1 * z248 - (z64 * z249 + (z179 * z129 + z176 * z131 - z28 * z252 - z25 * z253));
    const double z255 = z58 * z150 - (z66 * z153 + (z24 * z158 + (z237 + z31 * z240 + z30 * z245))) + k2 *
        (0.5 * (z168 * z140) + z4 * z254);
    const double z256 = z208 * z38 + z39 * z233 + z52 * z232;
    const double z257 = z4 * z256;
    const double z258 = z5 * z257;
    const double z259 = 1.0 / (z3 * z3);
    const double z260 = z48 * z232;
    const double z261 = z50 * z232;
    const double z262 = z7 * z258;
    const double z263 = z169 * z139 + (z49 * z260 - z47 * z261 + z10 * z256 + z9 * z257 + z5 * z262);
    const double z264 = z60 * z36 + z160 * z126 - c_alpha * z153;
    const double z265 = s_gamma * z234 - c_gamma * z235;
    const double z266 = z36 * z233;
    const double z267 = c_alpha * z266 + mu2 * z236;
    const double z268 = mu2 * z240 - c_alpha * z245;
    const double z269 = w2 * z249 - (omega1 * z264 - (z176 * z128 + c_beta * z265 + s_beta * z267 - z25 *
        z268));
    const double z270 = w2 * z248 - (z64 * z264 - (z179 * z128 - s_beta * z265 + c_beta * z267 - z28 * z268));
    const double z271 = z166 * z142 + (z177 * z138 + (z181 * z140 - z263)) - z13 * z269 + z21 * z254 + z12 *
        z270;
    const double z272 = z167 * z141 * z259 + 0.5 * (z4 * (z41 * z271));
    const double z273 = 1.0 / (c_alpha * c_alpha * c_alpha);
    const double z274 = z4 * z260;
    const double z275 = z4 * z261;
    const double z276 = z196 * z154 - (z197 * z156 + (z5 * z274 - k1 * (s_beta * z275) - 2.0 * (h * z258)));
    const double z277 = z162 * z145 - (z164 * z148 + (2.0 * (z160 * z187 * z273) - (z180 * z126 - (z36 * z185
        + z276))));
    const double z278 = z178 * z128 + z182 * z129 + I_c * z200 - r1 * z264 - z22 * z249;
    const double z279 = z124 * z196 + z135 * z197 - z162 * z130 - z164 * z132 - mu2 * z188 + s_beta * z278;
    const double z280 = z170 * z128 + z182 * z131 + I_a * z205 - I_d * z203 - r3 * z264 + z22 * z248;
    const double z281 = z279 - c_beta * z280;
    const double z282 = z87 * z35 - e2 * z34;
    const double z283 = e2 * z35 + z87 * z34;
    const double z284 = z124 * z199 + z135 * z204 - z165 * z130 - z163 * z132 + c_gamma * z282 + s_gamma *
        z283;
    const double z285 = z202 - z278;
    const double z286 = z284 + mu3 * z285 - z1 * z280 - mu2 * z150;
    const double z287 = mu2 * z158;
    const double z288 = z124 * z165 + z60 * z202 + z135 * z163;
    const double z289 = z201 - r1 * z268 + z22 * z252;
    const double z290 = z206 + I_d * z233 - r3 * z268 + z22 * z253;
    const double z291 = z287 - (z288 + mu3 * z289 + z1 * z290);
    const double z292 = z75 * z153 - (z277 - z14 * z266 + z30 * z240 - z31 * z245) + z76 * (z60 * z281 + (z57
        * z286 + (z172 * z133 + z174 * z136 + s_beta * z291)));
    const double z293 = z24 * z202 - z75 * z36 - z66 * z126 + z171 * z136 + k2 * (z4 * z140) - 2.0 * (mu2 *
        z186);
    const double z294 = z293 - z23 * z281;
    const double z295 = w1 * z294 - (z58 * z285 + (z173 * z130 - 2.0 * (z165 * z147) - z24 * z289)) + k3 *
        (0.5 * (z168 * z139) - z4 * z269);
    const double z296 = z295 - 2.0 * (mu3 * (k3 * z272));
    const double z297 = w3 * z294 + (z58 * z280 - (z173 * z132 - 2.0 * (z163 * z144) - z24 * z290)) - k1 *
        (0.5 * (z168 * z138) - z4 * z270);
    const double z298 = z297 - 2.0 * (z1 * (k1 * z272));
    const double z299 = c_alpha * (z255 - 2.0 * (mu2 * (k4 * (z4 * z257) - z6 * z258 + k2 * z272))) - mu2 *
        (z292 + c_beta * z296 + s_beta * z298);
    const double z300 = s_gamma * z18 - c_gamma * z17;
    const double z301 = c_gamma * z18 + s_gamma * z17;
    const double z302 = c_alpha * z19 + mu2 * z301;
    const double z303 = mu2 * z19 - c_alpha * z301;
    const double z304 = c_beta * z300 + s_beta * z302;
    const double z305 = r1 * z303 - z22 * z304;
    const double z306 = s_beta * z300 - c_beta * z302;
    const double z307 = I_d + r3 * z303 - z22 * z306;
    const double z308 = mu3 * z305 + z1 * z307;
    const double z309 = z23 * z308;
    const double z310 = s_beta * z305 - c_beta * z307;
    const double z311 = z23 * z310;
    const double z312 = z64 * z303 - w2 * z306;
    const double z313 = omega1 * z303 + w2 * z304;
    const double z314 = z64 * z304 + omega1 * z306;
    const double z315 = 0.5 * (z13 * z313) + 0.5 * (z21 * z314) - 0.5 * (z12 * z312);
    const double z316 = z41 * z315;
    const double z317 = z4 * z316;
    const double z318 = k1 * z317;
    const double z319 = z58 * z307 - w3 * z311 + k1 * (z4 * z312) + 2.0 * (z1 * z318);
    const double z320 = z62 * z300 + z65 * z302 + z61 * z305 - w1 * z309 - c_alpha * z319;
    const double z321 = k3 * z317;
    const double z322 = z58 * z305 - w1 * z311 - k3 * (z4 * z313) + 2.0 * (mu3 * z321);
    const double z323 = z65 * z300 - z62 * z302 - z61 * z307 + w3 * z309 - c_alpha * z322;
    const double z324 = c_beta * z320 - s_beta * z323;
    const double z325 = z18 * z151 - z17 * z152;
    const double z326 = k2 * z317;
    const double z327 = z57 * z308 - z60 * z310;
    const double z328 = z66 * z19 - z75 * z301 - z76 * z327 + c_beta * z322 + s_beta * z319;
    const double z329 = z193 - 2.0 * z241 + z35 * z256;
    const double z330 = z192 + 2.0 * z243 - z34 * z256;
    const double z331 = c_gamma * z329 - s_gamma * z330;
    const double z332 = z19 * z256;
    const double z333 = z19 * z180 + z185 * z301 - 2.0 * (z60 * z326) + z61 * z328 - z14 * z331 - z31 * z332;
    const double z334 = z18 * z256;
    const double z335 = z17 * z256;
    const double z336 = c_gamma * z334 + s_gamma * z335;
    const double z337 = z18 * z152 + z17 * z151;
    const double z338 = z19 * z160 - z60 * z301 - mu2 * z325;
    const double z339 = z162 * z300 + z164 * z302 - s_beta * z337 + c_beta * z338;
    const double z340 = z164 * z300 - z162 * z302 + c_beta * z337 + s_beta * z338;
    const double z341 = s_gamma * z334 - c_gamma * z335;
    const double z342 = c_alpha * z332 + mu2 * z336;
    const double z343 = c_beta * z341 + s_beta * z342;
    const double z344 = s_beta * z341 - c_beta * z342;
    const double z345 = omega1 * z339 - (z64 * z340 + (z176 * z306 + (z179 * z304 + z261) - z28 * z343 - z25
        * z344));
    const double z346 = z58 * z324 - (z66 * z325 - (z333 - z30 * z336)) + k2 * (0.5 * (z168 * z314) + z4 *
        z345);
    const double z347 = z22 * z232;
    const double z348 = z60 * z19 + z160 * z301 - c_alpha * z325;
    const double z349 = s_gamma * z329 + c_gamma * z330;
    const double z350 = z238 - 2.0 * z239 + z36 * z256;
    const double z351 = c_alpha * z350 + mu2 * z331;
    const double z352 = mu2 * z332 - c_alpha * z336;
    const double z353 = w2 * z340 - (omega1 * z348 - (z176 * z303 - c_beta * z349 - s_beta * z351 - z25 *
        z352));
    const double z354 = z166 * z316 + (z177 * z312 + (z181 * z314 - (z169 * z313 - z49 * z347))) - z13 * z353;
    const double z355 = w2 * z339 - (z64 * z348 - (z179 * z303 + s_beta * z349 - c_beta * z351 - z28 * z352));
    const double z356 = z259 * (z167 * z315) + 0.5 * (z4 * (z41 * (z354 + z21 * z345 + z12 * z355)));
    const double z357 = z4 * z347;
    const double z358 = z164 * z322 + (2.0 * (z273 * (z160 * z327)) - (z180 * z301 - (z19 * z185 + z5 *
        z357)));
    const double z359 = z135 + z178 * z303 + z182 * z304 - I_c * omega1 - r1 * z348 - z22 * z340;
    const double z360 = z124 - z170 * z303 - z182 * z306 - I_a * z64 + r3 * z348 - z22 * z339;
    const double z361 = z162 * z305 + z164 * z307 + mu2 * z328 - s_beta * z359 - c_beta * z360;
    const double z362 = z87 * z18 - e2 * z17;
    const double z363 = e2 * z18 + z87 * z17;
    const double z364 = z165 * z305 + z163 * z307 - c_gamma * z362 - s_gamma * z363 + mu3 * z359 - z1 * z360;
    const double z365 = z364 + mu2 * z324;
    const double z366 = r1 * z352 - z22 * z343;
    const double z367 = I_d * z256 + r3 * z352 - z22 * z344;
    const double z368 = mu3 * z366 + z1 * z367;
    const double z369 = z75 * z325 - (z162 * z319 - z358 + z14 * z350 + z30 * z332 - z31 * z336) - z76 * (z60
        * z361 + (z57 * z365 - (z172 * z308 + z174 * z310 + s_beta * z368)));
    const double z370 = z75 * z19 + z66 * z301 - z171 * z310 - k2 * (z4 * z314) + 2.0 * (mu2 * z326);
    const double z371 = z370 - z23 * z361;
    const double z372 = w1 * z371 - (z58 * z359 - (z173 * z305 - 2.0 * (z165 * z321) + z24 * z366)) - k3 *
        (0.5 * (z168 * z313) - z4 * z353);
    const double z373 = z372 + 2.0 * (mu3 * (k3 * z356));
    const double z374 = w3 * z371 + (z58 * z360 + (z173 * z307 - 2.0 * (z163 * z318) + z24 * z367)) + k1 *
        (0.5 * (z168 * z312) - z4 * z355);
    const double z375 = z374 + 2.0 * (z1 * (k1 * z356));
    const double z376 = c_alpha * (z346 - 2.0 * (mu2 * (k2 * z356))) - mu2 * (z369 - c_beta * z373 - s_beta *
        z375);
    const double z377 = z376 - z39 * z299;
    const double z378 = c_gamma * z230 + s_gamma * z229;
    const double z379 = mu2 * z226 - c_alpha * z378;
    const double z380 = s_gamma * z230 - c_gamma * z229;
    const double z381 = c_alpha * z226 + mu2 * z378;
    const double z382 = c_beta * z380 + s_beta * z381;
    const double z383 = omega1 * z379 + w2 * z382;
    const double z384 = s_beta * z380 - c_beta * z381;
    const double z385 = z64 * z382 + omega1 * z384;
    const double z386 = z64 * z379 - w2 * z384;
    const double z387 = 0.5 * (z13 * z383) + 0.5 * (z21 * z385) - 0.5 * (z12 * z386);
    const double z388 = z41 * z387;
    const double z389 = z4 * z388;
    const double z390 = k2 * z389;
    const double z391 = I_c * z217 - r1 * z379 + z22 * z382;
    const double z392 = I_a * z221 + r3 * z379 - z22 * z384;
    const double z393 = mu3 * z391 - z1 * z392;
    const double z394 = s_beta * z391 + c_beta * z392;
    const double z395 = z57 * z393 - z60 * z394;
    const double z396 = z23 * z394;
    const double z397 = k3 * z389;
    const double z398 = z123 * z124 + z58 * z391 - w1 * z396 + k3 * (z4 * z383) - 2.0 * (mu3 * z397);
    const double z399 = k1 * z389;
    const double z400 = z123 * z135 - z58 * z392 - w3 * z396 - k1 * (z4 * z386) - 2.0 * (z1 * z399);
    const double z401 = z66 * z226 - z75 * z378 + z76 * z395 - c_beta * z398 - s_beta * z400;
    const double z402 = s_beta * z159 - z226 * z180 - z185 * z378 + 2.0 * (z60 * z390) - z61 * z401 + z225 *
        z238;
    const double z403 = c_gamma * z193 - s_gamma * z192;
    const double z404 = z230 * z151 - z229 * z152;
    const double z405 = z23 * z393;
    const double z406 = s_beta * z124 + z62 * z380 + z65 * z381 - z61 * z391 + w1 * z405 + c_alpha * z400;
    const double z407 = s_beta * z135 - z65 * z380 + z62 * z381 + z61 * z392 + w3 * z405 - c_alpha * z398;
    const double z408 = c_beta * z406 + s_beta * z407;
    const double z409 = z230 * z152 + z229 * z151;
    const double z410 = z226 * z160 - z60 * z378 - mu2 * z404;
    const double z411 = z162 * z380 + z164 * z381 - s_beta * z409 + c_beta * z410;
    const double z412 = z164 * z380 - z162 * z381 + c_beta * z409 + s_beta * z410;
    const double z413 = s_gamma * z193 + c_gamma * z192;
    const double z414 = c_alpha * z238 + mu2 * z403;
    const double z415 = s_beta * z413 - c_beta * z414;
    const double z416 = c_beta * z413 + s_beta * z414;
    const double z417 = z64 * z412 - (z221 * z415 - (z217 * z416 + (z176 * z384 + (z179 * z382 - z50 *
        z233))));
    const double z418 = omega1 * z411 - z417;
    const double z419 = z402 + z224 * z403 - z123 * z158 + z66 * z404 - z58 * z408 - k2 * (0.5 * (z168 *
        z385) + z4 * z418);
    const double z420 = z41 * z232;
    const double z421 = mu2 * z238 - c_alpha * z403;
    const double z422 = z60 * z226 + z160 * z378 - c_alpha * z404;
    const double z423 = z179 * z379 + z217 * z421 - z64 * z422 + w2 * z411;
    const double z424 = z176 * z379 - z221 * z421 - omega1 * z422 + w2 * z412;
    const double z425 = z22 * z233 + z48 * z256;
    const double z426 = z50 * z256;
    const double z427 = z166 * z388 + (z177 * z386 + (z181 * z385 - (z169 * z383 + (z49 * z425 - z47 *
        z426))));
    const double z428 = z259 * (z167 * z387 - z44 * z232) + 0.5 * (z4 * (z41 * (z12 * z423 - (z13 * z424 -
        z427 - z21 * z418))));
    const double z429 = z201 - r1 * z421 + z22 * z416;
    const double z430 = z206 - r3 * z421 + z22 * z415;
    const double z431 = z287 - (z288 + mu3 * z429 + z1 * z430);
    const double z432 = z87 * z230 - e2 * z229;
    const double z433 = e2 * z230 + z87 * z229;
    const double z434 = z124 * z215 - z135 * z219 - z165 * z391 + z163 * z392 - c_gamma * z432 - s_gamma *
        z433;
    const double z435 = z178 * z379 + z182 * z382 + I_c * z216 - r1 * z422 - z22 * z412;
    const double z436 = z170 * z379 + z182 * z384 + I_a * z220 - I_d * z218 - r3 * z422 + z22 * z411;
    const double z437 = z202 - z436;
    const double z438 = z434 + mu3 * z435 - z1 * z437 + mu2 * z408;
    const double z439 = z124 * z212 + z135 * z213 - z162 * z391 + z164 * z392 + mu2 * z401 - s_beta * z435;
    const double z440 = z439 + c_beta * z436;
    const double z441 = z4 * z425;
    const double z442 = z4 * z426;
    const double z443 = z180 * z378 - (z226 * z185 - (z212 * z154 - (z213 * z156 - (z5 * z441 - k1 * (s_beta
        * z442)))));
    const double z444 = z225 * z403 - (z224 * z238 - (z162 * z400 - (z164 * z398 + (2.0 * (z273 * (z160 *
        z395)) + z443))));
    const double z445 = z76 * (z172 * z393 + z174 * z394 + c_beta * z431 + z57 * z438 + z60 * z440) - (z75 *
        z404 + z444);
    const double z446 = z123 * z202 + z75 * z226 + z66 * z378 + z171 * z394 - k2 * (z4 * z385) + 2.0 * (mu2 *
        z390);
    const double z447 = z446 - z23 * z440;
    const double z448 = z173 * z391 + 2.0 * (z165 * z397) - z123 * z429 + z58 * z435 - w1 * z447 + k3 * (0.5
        * (z168 * z383) - z4 * z424);
    const double z449 = z448 - 2.0 * (mu3 * (k3 * z428));
    const double z450 = z173 * z392 - 2.0 * (z163 * z399) + z123 * z430 + z58 * z437 + w3 * z447 + k1 * (0.5
        * (z168 * z386) - z4 * z423);
    const double z451 = z450 + 2.0 * (z1 * (k1 * z428));
    const double z452 = c_alpha * (z419 + 2.0 * (mu2 * ((k4 - z43) * z420 + k2 * z428))) - mu2 * (z445 -
        c_beta * z449 + s_beta * z451);
    const double z453 = z210 * (z452 - z52 * z299 + z55 * z377);
    const double z454 = z54 * z377 + z55 * z453;
    J[57] = z38 * z299 - z39 * z454 - z52 * z453;
    const double z455 = z171 * z133 + z23 * z286;
    const double z456 = z175 * z130 - (z184 * z127 - (z183 * z125 + (z195 * z157 + (z198 * z154 - z46 *
        z275))));
    const double z457 = z161 * z149 + (z160 * z145 - z456) - r1 * z265 + r3 * z267 + z26 * z250 + z29 * z251;
    const double z458 = w1 * z455 + (z61 * z278 + (z65 * z247 + (z62 * z246 - (z457 - c_beta * z289 - z23 *
        z291))));
    const double z459 = mu2 * z159;
    const double z460 = z135 * z164;
    const double z461 = z124 * z162;
    const double z462 = z195 * z155 - (z460 - (z198 * z156 - (z461 - k3 * (c_alpha * z274 + z8 * z257 + z4 *
        z262))));
    const double z463 = z161 * z146 + (z160 * z148 + (z175 * z132 + (z183 * z127 + (z184 * z125 - (z459 +
        z462)))));
    const double z464 = z463 + r3 * z265 + r1 * z267 + z29 * z250 - s_beta * z289 - z26 * z251 + 2.0 *
        (c_beta * z290);
    const double z465 = s_beta * (w3 * z455 + (z61 * z280 + (z62 * z247 - (z65 * z246 - z464))) + c_alpha *
        z296);
    const double z466 = c_beta * (z458 - c_alpha * z298) + z465;
    const double z467 = z171 * z308 - z23 * z365;
    const double z468 = z183 * z300 - z184 * z302 + z175 * z305 - z160 * z319 + z161 * z323 - r1 * z349;
    const double z469 = z62 * z337 + (z468 + r3 * z351 - z26 * z341 - z29 * z342 - c_beta * z366 + z23 *
        z368);
    const double z470 = z161 * z320 + (z160 * z322 + (z175 * z307 + (z183 * z302 + (z184 * z300 + k3 *
        (c_alpha * z357)))));
    const double z471 = z470 - r3 * z349 - r1 * z351 + z29 * z341 + s_beta * z366 - z26 * z342 - 2.0 *
        (c_beta * z367);
    const double z472 = s_beta * (w3 * z467 - (z61 * z360 - (z62 * z338 - (z65 * z337 - z471))) - c_alpha *
        z373);
    const double z473 = c_beta * (w1 * z467 + (z61 * z359 + (z65 * z338 + z469)) + c_alpha * z375) + z472 -
        z39 * z466;
    const double z474 = z171 * z393 + z23 * z438;
    const double z475 = z184 * z381 - (z183 * z380 - (z211 * z157 - (z459 + (z214 * z154 - (z460 + (z461 +
        z46 * z442))))));
    const double z476 = z223 * z414 - (z222 * z413 + (z161 * z407 - (z160 * z400 - (z175 * z391 + z475)))) +
        2.0 * (s_beta * (z429 + k6 * (z7 * z420)));
    const double z477 = w1 * z474 - (z61 * z435 + (z65 * z410 + (z62 * z409 - (c_beta * z430 - z476)))) -
        c_alpha * z451;
    const double z478 = z175 * z392 + (z183 * z381 + (z184 * z380 + (z211 * z155 - (z214 * z156 + k3 *
        (c_alpha * z441)))));
    const double z479 = s_beta * z430 + (z23 * z431 - (z222 * z414 + (z223 * z413 - (z161 * z406 - (z160 *
        z398 - z478)))));
    const double z480 = s_beta * (w3 * z474 - (z61 * z436 + (z62 * z410 - (z65 * z409 - z479))) - c_alpha *
        z449);
    const double z481 = z210 * (c_beta * z477 + z480 - z52 * z466 + z55 * z473);
    const double z482 = z54 * z473 + z55 * z481;
    J[58] = z52 * z481 - (z38 * z466 - z39 * z482);
    const double z483 = z35 * z191 - z34 * z190 - z58 * z283 - z16 * z234 + z15 * z235 + z33 * z242;
    const double z484 = z35 * z190 + z34 * z191 + z58 * z282 - z15 * z234 - z16 * z235 + z32 * z242;
    const double z485 = c_gamma * (z483 + z32 * z244) + s_gamma * (z484 - z33 * z244);
    const double z486 = z18 * z191 - z17 * z190 - z58 * z363 + z16 * z329 + z15 * z330 + z33 * z334;
    const double z487 = z18 * z190 + z17 * z191 + z58 * z362 + z15 * z329 - z16 * z330 + z32 * z334;
    const double z488 = c_gamma * (z486 - z32 * z335) + s_gamma * (z487 + z33 * z335) - z39 * z485;
    const double z489 = c_gamma * (z230 * z191 - z229 * z190 - z58 * z433 + z228 * z193 + z227 * z192) +
        s_gamma * (z230 * z190 + z229 * z191 + z58 * z432 + z227 * z193 - z228 * z192);
    const double z490 = z210 * (z489 + z52 * z485 - z55 * z488);
    const double z491 = z54 * z488 - z55 * z490;
    J[59] = z38 * z485 - z39 * z491 + z52 * z490;
    const double z492 = z162 * z134 + z165 * z137 + s_beta * z455 - mu3 * z294;
    const double z493 = z162 * z309 + z165 * z311 + s_beta * z467 + mu3 * z371 - z39 * z492;
    const double z494 = z162 * z405 + z165 * z396 + s_beta * z474 - mu3 * z447 - z52 * z492 + z55 * z493;
    const double z495 = z210 * z494;
    const double z496 = z54 * z493 + z55 * z495;
    J[60] = z52 * z495 - (z38 * z492 - z39 * z496);
    const double z497 = z170 * z129 - z178 * z131 - I_b * z203 + I_d * z205 + r3 * z249 + r1 * z248;
    const double z498 = z150 + z497;
    const double z499 = z324 + (z170 * z304 - z178 * z306 + I_d * z64 + r3 * z340 + r1 * z339) - z39 * z498;
    const double z500 = z170 * z382 - z178 * z384 - I_b * z218 + I_d * z220 + r3 * z412 + r1 * z411;
    const double z501 = z210 * (z408 + z500 + z52 * z498 - z55 * z499);
    const double z502 = z54 * z499 - z55 * z501;
    J[61] = z38 * z498 - z39 * z502 + z52 * z501;
    const double z503 = z164 * z134 + z163 * z137 - c_beta * z455 - z1 * z294;
    const double z504 = z164 * z309 + z163 * z311 - c_beta * z467 + z1 * z371 - z39 * z503;
    const double z505 = z164 * z405 + z163 * z396 - c_beta * z474 - z1 * z447 - z52 * z503 + z55 * z504;
    const double z506 = z210 * z505;
    const double z507 = z54 * z504 + z55 * z506;
    J[62] = z52 * z506 - (z38 * z503 - z39 * z507);
    J[63] = 0.0;
    J[64] = 0.0;
    J[65] = 0.0;
    J[66] = z454;
    J[67] = -z482;
    J[68] = z491;
    J[69] = -z496;
    J[70] = z502;
    J[71] = -z507;
    J[72] = 0.0;
    J[73] = 0.0;
    J[74] = 0.0;
    J[75] = -z453;
    J[76] = z481;
    J[77] = z490;
    J[78] = z495;
    J[79] = z501;
    J[80] = z506;
    return rattleback_finish(81, J);
}

int rattleback_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double w3 = y[8];

    /* state */
    const double c_alpha = cos(alpha);
    /* the coframe is singular */
    if (!(fabs(-c_alpha) > 1e-12 * 4.0)) {
        return RATTLEBACK_SINGULAR_1;
    }
    /* 53:9 */
    out[0] = w3; /* spin */
    return rattleback_finish(1, out);
}

int rattleback_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double k4 = b * b * b * b;
    const double k5 = I_a + h * h;
    const double k6 = a * a * a * a;
    int singular1 = 0;
    int singular2 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double alpha = y[3 * count + i]; /* roll about the long axis [rad] */
        const double beta = y[4 * count + i]; /* pitch [rad] */
        const double gamma_ = y[5 * count + i]; /* heading [rad] */
        const double w1 = y[6 * count + i];
        const double w2 = y[7 * count + i];
        const double w3 = y[8 * count + i];
        const double c_alpha = cos(alpha);
        /* the coframe is singular */
        singular1 |= !(fabs(-c_alpha) > 1e-12 * 4.0);
        const double s_beta = sin(beta);
        const double z1 = c_alpha * s_beta;
        const double mu2 = sin(alpha);
        const double z2 = mu2 * mu2;
        const double c_beta = cos(beta);
        const double mu3 = c_beta * c_alpha;
        const double z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3);
        const double z4 = 1.0 / sqrt(z3);
        const double z5 = c_beta * k3;
        const double z6 = 1.0 - z2;
        const double z7 = z2 * k4;
        const double z8 = z4 * (z5 * (z4 * z5 * z6 - 2.0 * (h * c_alpha)) + z4 * z7) + k5;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z8) > 0.0);
        const double s_gamma = sin(gamma_);
        const double z9 = z1 * k1;
        const double r1 = z9 * z4;
        const double z10 = mu3 * k3;
        const double r3 = h - z4 * z10;
        const double z11 = c_beta * r1 + s_beta * r3;
        const double z12 = mu2 * z11;
        const double c_gamma = cos(gamma_);
        const double z13 = s_beta * r1 - c_beta * r3;
        const double z14 = s_gamma * z12 + c_gamma * z13;
        const double z15 = c_gamma * z12 - s_gamma * z13;
        const double z16 = c_alpha * z11;
        const double z17 = I_b + (z14 * z14 + z15 * z15 + z16 * z16);
        const double z18 = mu2 * k2;
        const double z19 = z4 * z18;
        const double z20 = 1.0 / c_alpha;
        const double z21 = s_beta * z20;
        const double z22 = z1 * z21 + c_beta * c_beta;
        const double z23 = z19 * z22;
        const double z24 = c_beta * s_beta;
        const double z25 = mu3 * z21 - z24;
        const double z26 = z19 * z25;
        const double z27 = c_beta * z23 - s_beta * z26;
        const double z28 = r3 * z22 + r1 * z25;
        const double z29 = mu2 * z27 - c_alpha * z28;
        const double z30 = s_beta * z23 + c_beta * z26;
        const double z31 = s_gamma * z29 + c_gamma * z30;
        const double z32 = c_gamma * z29 - s_gamma * z30;
        const double z33 = c_alpha * z27 + mu2 * z28;
        const double z34 = z31 * z14 + z32 * z15 + z33 * z16 + I_d * z22;
        const double z35 = 1.0 / z8;
        const double z36 = z34 * z35;
        const double z37 = z17 - z34 * z36;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z37) > 1e-14 * z17);
        const double z38 = 1.0 / z3;
        const double z39 = s_beta * s_beta;
        const double z40 = I_c + z38 * (z7 + z6 * (z39 * k6));
        const double z41 = h - z4 * (c_alpha * z5);
        const double z42 = z4 * (s_beta * (c_alpha * k1)) * z41;
        const double z43 = z42 * z35;
        const double z44 = z19 * z41 + z34 * z43;
        const double z45 = 1.0 / z37;
        const double z46 = z44 * z45;
        const double z47 = z40 - z42 * z43 - z44 * z46;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z47) > 1e-14 * z40);
        const double z48 = s_beta * w1 - c_beta * w3;
        const double z49 = z20 * z48;
        const double z50 = z1 * z49;
        const double z51 = z1 * w3 + mu3 * w1;
        const double z52 = z51 * z20;
        const double omega1 = z50 + c_beta * z52;
        const double z53 = r1 * w2 + z19 * omega1;
        const double z54 = mu3 * z49;
        const double z55 = z54 - s_beta * z52;
        const double z56 = z19 * z55 - r3 * w2;
        const double z57 = c_beta * z53 - s_beta * z56;
        const double z58 = r3 * omega1 + r1 * z55;
        const double e2 = mu2 * z57 - c_alpha * z58;
        const double z59 = s_beta * z53 + c_beta * z56;
        const double z60 = w2 + mu2 * z49;
        const double z61 = I_c * z55;
        const double z62 = c_beta * z60;
        const double z63 = s_beta * z60;
        const double z64 = mu2 * z52;
        const double z65 = c_alpha * z63 + c_beta * z64;
        const double z66 = mu2 * z21;
        const double z67 = c_beta * z66;
        const double z68 = s_beta * z66;
        const double z69 = c_beta * mu2;
        const double z70 = z61 * (c_beta * z62 + z21 * z65 - (z52 * z67 + z49 * (c_alpha * z68 + c_beta *
            z69)));
        const double z71 = z64 / (c_alpha * c_alpha);
        const double z72 = z48 * z71 + z20 * (w1 * z62 + w3 * z63);
        const double z73 = s_beta * z64 - c_alpha * z62;
        const double z74 = z20 * (w3 * z73 + w1 * z65) - z51 * z71;
        const double z75 = z49 * z65 - mu3 * z72 + (z52 * z62 - s_beta * z74);
        const double z76 = I_c * z75;
        const double z77 = I_d * omega1 + I_b * w2;
        const double z78 = I_d * w2 + I_a * omega1;
        const double z79 = z78 * (c_beta * z63 + z21 * z73 - (z52 * z68 + z49 * (s_beta * z69 - c_alpha *
            z67)));
        const double z80 = z49 * z73 - z1 * z72 + (z52 * z63 + c_beta * z74);
        const double z81 = I_a * z80;
        const double z82 = 2.0 * (k1 * (z1 * z73)) - 2.0 * (k2 * (mu2 * z51)) + 2.0 * (k3 * (mu3 * z65));
        const double z83 = z4 * z82 * z38;
        const double z84 = z4 * (k1 * z73) - 0.5 * (z9 * z83);
        const double z85 = 0.5 * (z18 * z83) + z4 * (k2 * z51);
        const double z86 = w2 * z84 - (omega1 * z85 - z19 * z80);
        const double z87 = 0.5 * (z10 * z83) - z4 * (k3 * z65);
        const double z88 = z55 * z85 - z19 * z75 + w2 * z87;
        const double z89 = z53 * z63 + c_beta * z86 + (z56 * z62 + s_beta * z88);
        const double z90 = omega1 * z87 + r3 * z80 + (z55 * z84 + r1 * z75);
        const double z91 = z57 * z64 + c_alpha * z89 - (z51 * z58 - mu2 * z90);
        const double z92 = c_gamma * z49;
        const double z93 = z51 * z57 - mu2 * z89 + (z58 * z64 + c_alpha * z90);
        const double z94 = s_gamma * z49;
        const double z95 = z53 * z62 - s_beta * z86 - (z56 * z63 - c_beta * z88);
        const double z96 = e2 * z92 - s_gamma * z93 - (z59 * z94 + c_gamma * z95);
        const double z97 = e2 * z94 + c_gamma * z93 + (z59 * z92 - s_gamma * z95);
        const double z98 = z77 * (z54 - z51 * z21) - (z79 + (z22 * z81 + (z33 * z91 + (z31 * z96 - z32 *
            z97))));
        const double z99 = z70 + (z25 * z76 - z98) - g * z33;
        const double z100 = omega1 * z61 - (I_d * z80 + (z55 * z78 + (z16 * z91 + (z14 * z96 - z15 * z97))));
        const double z101 = z100 + g * z16 + z99 * z36;
        const double z102 = c_beta * z20;
        const double z103 = mu2 * z102;
        const double z104 = c_beta * z103;
        const double z105 = s_beta * z103;
        const double z106 = s_beta * mu2;
        const double z107 = z61 * (s_beta * z62 - z102 * z65 + (z52 * z104 + z49 * (c_alpha * z105 - c_beta *
            z106)));
        const double z108 = mu3 * z102 + z39;
        const double z109 = z78 * (s_beta * z63 - z102 * z73 + (z52 * z105 - z49 * (s_beta * z106 + c_alpha *
            z104)));
        const double z110 = z24 - z1 * z102;
        const double z111 = z19 * z110;
        const double z112 = z19 * z108;
        const double z113 = c_beta * z111 + s_beta * z112;
        const double z114 = r3 * z110 - r1 * z108;
        const double z115 = c_alpha * z113 + mu2 * z114;
        const double z116 = mu2 * z113 - c_alpha * z114;
        const double z117 = s_beta * z111 - c_beta * z112;
        const double z118 = z115 * z91 + ((s_gamma * z116 + c_gamma * z117) * z96 - (c_gamma * z116 - s_gamma
            * z117) * z97);
        const double z119 = z107 - (z108 * z76 + (z77 * (z50 + z51 * z102) - (z109 + (z110 * z81 + z118)))) -
            g * z115;
        const double z120 = (z119 + z99 * z43 + z46 * z101) / z47;
        const double z121 = z45 * z101 + z46 * z120;
        /* (I.2.15) */
        const double slope1 = -(s_gamma * e2 + c_gamma * z59); /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = c_gamma * e2 - s_gamma * z59; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = -(c_alpha * z57 + mu2 * z58); /* z' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = z52; /* alpha' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = z60; /* beta' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = -z49; /* gamma' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        /* (I.2.15) 41:4 */
        const double slope7 = z99 * z35 + z36 * z121 + z43 * z120; /* w1' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = -z121; /* w2' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
        const double slope9 = z120; /* w3' */
        dydt[8 * count + i] = slope9;
        bad |= !(fabs(slope9) <= DBL_MAX);
    }
    if (singular1) {
        return RATTLEBACK_SINGULAR_1;
    }
    if (singular2) {
        return RATTLEBACK_SINGULAR_2;
    }
    return bad ? RATTLEBACK_NOT_FINITE : RATTLEBACK_OK;
}
