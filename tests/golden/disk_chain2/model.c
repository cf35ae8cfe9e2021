/*
 * disk_chain2.c: disk_chain2, emitted by nhc 0.1.0 (nhc:299c9f2ca419b77a)
 * Two upright rolling disks joined by a spring; the first link of a chain that may be made as long as one
 *     likes.
 * Source: disk_chain2.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x1`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `x2` contains the
 *     dependent coordinate `x1`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `y1`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `y2` contains the
 *     dependent coordinate `y1`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `x1` contains the
 *     dependent coordinate `x2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `y2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `y1` contains the
 *     dependent coordinate `y2`
 * disk_chain2.h says what each function does.
 */
#include "disk_chain2.h"

#include <float.h>
#include <math.h>

const char *const disk_chain2_coordinate_names[] = {
    "x1",
    "y1",
    "phi1",
    "theta1",
    "x2",
    "y2",
    "phi2",
    "theta2"
};
const char *const disk_chain2_state_names[] = {
    "x1",
    "y1",
    "phi1",
    "theta1",
    "x2",
    "y2",
    "phi2",
    "theta2",
    "phi1'",
    "theta1'",
    "phi2'",
    "theta2'"
};
const char *const disk_chain2_parameter_names[] = {
    "m",
    "R",
    "I",
    "J",
    "k"
};
const double disk_chain2_parameter_defaults[] = {
    1.0,
    0.5,
    0.125,
    0.0625,
    1.0
};

static int disk_chain2_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? DISK_CHAIN2_OK : DISK_CHAIN2_NOT_FINITE;
}

int disk_chain2_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* first disk [m] */
    const double phi1 = y[2]; /* heading [rad] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi2 = y[6]; /* heading [rad] */
    const double phi1_dot = y[8];
    const double theta1_dot = y[9];
    const double phi2_dot = y[10];
    const double theta2_dot = y[11];
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* parameters only */
    const double k1 = I + m * (R * R);
    const double k2 = R * k / k1;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    const double c_phi1 = cos(phi1);
    const double s_phi1 = sin(phi1);
    const double c_phi2 = cos(phi2);
    const double s_phi2 = sin(phi2);
    const double z1 = x1 - x2;
    const double z2 = y1_ - y2;
    /* (III.3) */
    dydt[0] = theta1_dot * (R * c_phi1); /* x1' */
    dydt[1] = theta1_dot * (R * s_phi1); /* y1' */
    dydt[2] = phi1_dot; /* phi1' */
    dydt[3] = theta1_dot; /* theta1' */
    dydt[4] = theta2_dot * (R * c_phi2); /* x2' */
    dydt[5] = theta2_dot * (R * s_phi2); /* y2' */
    dydt[6] = phi2_dot; /* phi2' */
    dydt[7] = theta2_dot; /* theta2' */
    /* (III.3) 24:4 */
    dydt[8] = 0.0; /* phi1'' */
    dydt[9] = -(z1 * c_phi1 + z2 * s_phi1) * k2; /* theta1'' */
    dydt[10] = 0.0; /* phi2'' */
    dydt[11] = (z1 * c_phi2 + z2 * s_phi2) * k2; /* theta2'' */
    return disk_chain2_finish(12, dydt);
}

int disk_chain2_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi1 = y[2]; /* heading [rad] */
    const double phi2 = y[6]; /* heading [rad] */
    const double phi1_dot = y[8];
    const double theta1_dot = y[9];
    const double phi2_dot = y[10];
    const double theta2_dot = y[11];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double c_phi1 = cos(phi1);
    const double s_phi1 = sin(phi1);
    const double c_phi2 = cos(phi2);
    const double s_phi2 = sin(phi2);
    /* (I.2.4) */
    qdot[0] = theta1_dot * (R * c_phi1); /* x1' */
    qdot[1] = theta1_dot * (R * s_phi1); /* y1' */
    qdot[2] = phi1_dot; /* phi1' */
    qdot[3] = theta1_dot; /* theta1' */
    qdot[4] = theta2_dot * (R * c_phi2); /* x2' */
    qdot[5] = theta2_dot * (R * s_phi2); /* y2' */
    qdot[6] = phi2_dot; /* phi2' */
    qdot[7] = theta2_dot; /* theta2' */
    return disk_chain2_finish(8, qdot);
}

int disk_chain2_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* first disk [m] */
    const double phi1 = y[2]; /* heading [rad] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi2 = y[6]; /* heading [rad] */
    const double phi1_dot = y[8];
    const double theta1_dot = y[9];
    const double phi2_dot = y[10];
    const double theta2_dot = y[11];
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* parameters only */
    const double k1 = I + m * (R * R);
    const double k2 = R * k / k1;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    const double s_phi1 = sin(phi1);
    const double c_phi1 = cos(phi1);
    const double z1 = x1 - x2;
    const double z2 = y1_ - y2;
    const double z3 = (z1 * c_phi1 + z2 * s_phi1) * k2;
    const double s_phi2 = sin(phi2);
    const double c_phi2 = cos(phi2);
    const double z4 = (z1 * c_phi2 + z2 * s_phi2) * k2;
    /* (III.3) */
    qddot[0] = -(theta1_dot * (R * (phi1_dot * s_phi1)) + R * c_phi1 * z3); /* x1'' */
    qddot[1] = theta1_dot * (R * (phi1_dot * c_phi1)) - R * s_phi1 * z3; /* y1'' */
    qddot[2] = 0.0; /* phi1'' */
    qddot[3] = -z3; /* theta1'' */
    qddot[4] = R * c_phi2 * z4 - theta2_dot * (R * (phi2_dot * s_phi2)); /* x2'' */
    qddot[5] = theta2_dot * (R * (phi2_dot * c_phi2)) + R * s_phi2 * z4; /* y2'' */
    qddot[6] = 0.0; /* phi2'' */
    qddot[7] = z4; /* theta2'' */
    return disk_chain2_finish(8, qddot);
}

int disk_chain2_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x1 = q[0]; /* first disk [m] */
    const double y1_ = q[1]; /* first disk [m] */
    const double phi1 = q[2]; /* heading [rad] */
    const double theta1 = q[3]; /* angle rolled [rad] */
    const double x2 = q[4]; /* second disk [m] */
    const double y2 = q[5]; /* second disk [m] */
    const double phi2 = q[6]; /* heading [rad] */
    const double theta2 = q[7]; /* angle rolled [rad] */
    const double phi1_dot = qdot[2];
    const double theta1_dot = qdot[3];
    const double phi2_dot = qdot[6];
    const double theta2_dot = qdot[7];

    /* state */
    y[0] = x1;
    y[1] = y1_;
    y[2] = phi1;
    y[3] = theta1;
    y[4] = x2;
    y[5] = y2;
    y[6] = phi2;
    y[7] = theta2;
    y[8] = phi1_dot;
    y[9] = theta1_dot;
    y[10] = phi2_dot;
    y[11] = theta2_dot;
    return disk_chain2_finish(12, y);
}

int disk_chain2_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi1 = q[2]; /* heading [rad] */
    const double phi2 = q[6]; /* heading [rad] */
    const double x1_dot = qdot[0];
    const double y1_dot = qdot[1];
    const double theta1_dot = qdot[3];
    const double x2_dot = qdot[4];
    const double y2_dot = qdot[5];
    const double theta2_dot = qdot[7];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double c_phi1 = cos(phi1);
    const double s_phi1 = sin(phi1);
    const double c_phi2 = cos(phi2);
    const double s_phi2 = sin(phi2);
    /* (I.1.1) 27:5 */
    r[0] = x1_dot - theta1_dot * (R * c_phi1); /* roll_x1 = 0 */
    /* (I.1.1) 28:5 */
    r[1] = y1_dot - theta1_dot * (R * s_phi1); /* roll_y1 = 0 */
    /* (I.1.1) 29:5 */
    r[2] = x2_dot - theta2_dot * (R * c_phi2); /* roll_x2 = 0 */
    /* (I.1.1) 30:5 */
    r[3] = y2_dot - theta2_dot * (R * s_phi2); /* roll_y2 = 0 */
    return disk_chain2_finish(4, r);
}

int disk_chain2_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* first disk [m] */
    const double phi1 = y[2]; /* heading [rad] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi2 = y[6]; /* heading [rad] */
    const double phi1_dot = y[8];
    const double theta1_dot = y[9];
    const double phi2_dot = y[10];
    const double theta2_dot = y[11];
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* parameters only */
    const double k1 = I + m * (R * R);
    const double k2 = m * R;
    const double k3 = R * k / k1;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    const double z1 = x1 - x2;
    const double z2 = k * z1;
    const double s_phi1 = sin(phi1);
    const double z3 = R * (m * (phi1_dot * theta1_dot));
    const double c_phi1 = cos(phi1);
    const double z4 = y1_ - y2;
    const double z5 = (z1 * c_phi1 + z4 * s_phi1) * k3;
    const double z6 = k * z4;
    const double s_phi2 = sin(phi2);
    const double z7 = R * (m * (phi2_dot * theta2_dot));
    const double c_phi2 = cos(phi2);
    const double z8 = (z1 * c_phi2 + z4 * s_phi2) * k3;
    /* (I.4.1) 27:5 */
    lambda[0] = z2 - s_phi1 * z3 - c_phi1 * k2 * z5; /* reaction of roll_x1: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 28:5 */
    lambda[1] = z6 + c_phi1 * z3 - s_phi1 * k2 * z5; /* reaction of roll_y1: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 29:5 */
    lambda[2] = c_phi2 * k2 * z8 - (z2 + s_phi2 * z7); /* reaction of roll_x2: Q_i gains lambda_3 a_3i */
    /* (I.4.1) 30:5 */
    lambda[3] = s_phi2 * k2 * z8 - (z6 - c_phi2 * z7); /* reaction of roll_y2: Q_i gains lambda_4 a_4i */
    return disk_chain2_finish(4, lambda);
}

double disk_chain2_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* first disk [m] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi1_dot = y[8];
    const double theta1_dot = y[9];
    const double phi2_dot = y[10];
    const double theta2_dot = y[11];
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* parameters only */
    const double k1 = 0.5 * I + 0.5 * (m * (R * R));

    /* state */
    const double z1 = x1 * (0.5 * x1 - x2) + (y1_ * (0.5 * y1_ - y2) + (0.5 * (x2 * x2) + 0.5 * (y2 * y2)));
    const double z2 = theta1_dot * theta1_dot * k1 + (theta2_dot * theta2_dot * k1 + J * (0.5 * (phi1_dot *
        phi1_dot) + 0.5 * (phi2_dot * phi2_dot)));
    return k * z1 + z2;
}

int disk_chain2_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double x1 = y[0]; /* first disk [m] */
    const double y1_ = y[1]; /* first disk [m] */
    const double phi1 = y[2]; /* heading [rad] */
    const double x2 = y[4]; /* second disk [m] */
    const double y2 = y[5]; /* second disk [m] */
    const double phi2 = y[6]; /* heading [rad] */
    const double theta1_dot = y[9];
    const double theta2_dot = y[11];
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J_2 = p[3]; /* about the vertical [kg*m^2] */
    const double k = p[4]; /* stiffness of the spring [N/m] */

    /* parameters only */
    const double k1 = I + m * (R * R);
    const double k2 = R * k;
    const double k3 = 1.0 / k1;
    const double k4 = k2 * k3;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J_2) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J_2) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    const double s_phi1 = sin(phi1);
    const double z1 = theta1_dot * R;
    const double c_phi1 = cos(phi1);
    const double s_phi2 = sin(phi2);
    const double z2 = theta2_dot * R;
    const double c_phi2 = cos(phi2);
    const double z3 = k3 * (c_phi1 * k2);
    const double z4 = k3 * (s_phi1 * k2);
    const double z5 = y1_ - y2;
    const double z6 = x1 - x2;
    const double z7 = k3 * (c_phi2 * k2);
    const double z8 = k3 * (s_phi2 * k2);
    /* (III.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = -s_phi1 * z1;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = R * c_phi1;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = c_phi1 * z1;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = R * s_phi1;
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
    J[32] = 1.0;
    J[33] = 0.0;
    J[34] = 0.0;
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
    J[45] = 1.0;
    J[46] = 0.0;
    J[47] = 0.0;
    J[48] = 0.0;
    J[49] = 0.0;
    J[50] = 0.0;
    J[51] = 0.0;
    J[52] = 0.0;
    J[53] = 0.0;
    J[54] = -s_phi2 * z2;
    J[55] = 0.0;
    J[56] = 0.0;
    J[57] = 0.0;
    J[58] = 0.0;
    J[59] = R * c_phi2;
    J[60] = 0.0;
    J[61] = 0.0;
    J[62] = 0.0;
    J[63] = 0.0;
    J[64] = 0.0;
    J[65] = 0.0;
    J[66] = c_phi2 * z2;
    J[67] = 0.0;
    J[68] = 0.0;
    J[69] = 0.0;
    J[70] = 0.0;
    J[71] = R * s_phi2;
    J[72] = 0.0;
    J[73] = 0.0;
    J[74] = 0.0;
    J[75] = 0.0;
    J[76] = 0.0;
    J[77] = 0.0;
    J[78] = 0.0;
    J[79] = 0.0;
    J[80] = 0.0;
    J[81] = 0.0;
    J[82] = 1.0;
    J[83] = 0.0;
    J[84] = 0.0;
    J[85] = 0.0;
    J[86] = 0.0;
    J[87] = 0.0;
    J[88] = 0.0;
    J[89] = 0.0;
    J[90] = 0.0;
    J[91] = 0.0;
    J[92] = 0.0;
    J[93] = 0.0;
    J[94] = 0.0;
    J[95] = 1.0;
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
    J[106] = 0.0;
    J[107] = 0.0;
    J[108] = -z3;
    J[109] = -z4;
    J[110] = -k4 * (z5 * c_phi1 - z6 * s_phi1);
    J[111] = 0.0;
    J[112] = z3;
    J[113] = z4;
    J[114] = 0.0;
    J[115] = 0.0;
    J[116] = 0.0;
    J[117] = 0.0;
    J[118] = 0.0;
    J[119] = 0.0;
    J[120] = 0.0;
    J[121] = 0.0;
    J[122] = 0.0;
    J[123] = 0.0;
    J[124] = 0.0;
    J[125] = 0.0;
    J[126] = 0.0;
    J[127] = 0.0;
    J[128] = 0.0;
    J[129] = 0.0;
    J[130] = 0.0;
    J[131] = 0.0;
    J[132] = z7;
    J[133] = z8;
    J[134] = 0.0;
    J[135] = 0.0;
    J[136] = -z7;
    J[137] = -z8;
    J[138] = k4 * (z5 * c_phi2 - z6 * s_phi2);
    J[139] = 0.0;
    J[140] = 0.0;
    J[141] = 0.0;
    J[142] = 0.0;
    J[143] = 0.0;
    return disk_chain2_finish(144, J);
}

int disk_chain2_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    (void)p;
    (void)out;
    return DISK_CHAIN2_OK;
}

int disk_chain2_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass of each [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* about the axle [kg*m^2] */
    const double J = p[3]; /* about the vertical [kg*m^2] */
    const double k_ = p[4]; /* stiffness of the spring [N/m] */
    const double k1 = I + m * (R * R);
    const double k2 = R * k_ / k1;
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k1) > 0.0)) {
        return DISK_CHAIN2_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x1 = y[i]; /* first disk [m] */
        const double y1_ = y[count + i]; /* first disk [m] */
        const double phi1 = y[2 * count + i]; /* heading [rad] */
        const double x2 = y[4 * count + i]; /* second disk [m] */
        const double y2 = y[5 * count + i]; /* second disk [m] */
        const double phi2 = y[6 * count + i]; /* heading [rad] */
        const double phi1_dot = y[8 * count + i];
        const double theta1_dot = y[9 * count + i];
        const double phi2_dot = y[10 * count + i];
        const double theta2_dot = y[11 * count + i];
        const double c_phi1 = cos(phi1);
        const double s_phi1 = sin(phi1);
        const double c_phi2 = cos(phi2);
        const double s_phi2 = sin(phi2);
        const double z1 = x1 - x2;
        const double z2 = y1_ - y2;
        /* (III.3) */
        const double slope1 = theta1_dot * (R * c_phi1); /* x1' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = theta1_dot * (R * s_phi1); /* y1' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = phi1_dot; /* phi1' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = theta1_dot; /* theta1' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = theta2_dot * (R * c_phi2); /* x2' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = theta2_dot * (R * s_phi2); /* y2' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = phi2_dot; /* phi2' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = theta2_dot; /* theta2' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
        /* (III.3) 24:4 */
        const double slope9 = 0.0; /* phi1'' */
        dydt[8 * count + i] = slope9;
        bad |= !(fabs(slope9) <= DBL_MAX);
        const double slope10 = -(z1 * c_phi1 + z2 * s_phi1) * k2; /* theta1'' */
        dydt[9 * count + i] = slope10;
        bad |= !(fabs(slope10) <= DBL_MAX);
        const double slope11 = 0.0; /* phi2'' */
        dydt[10 * count + i] = slope11;
        bad |= !(fabs(slope11) <= DBL_MAX);
        const double slope12 = (z1 * c_phi2 + z2 * s_phi2) * k2; /* theta2'' */
        dydt[11 * count + i] = slope12;
        bad |= !(fabs(slope12) <= DBL_MAX);
    }
    return bad ? DISK_CHAIN2_NOT_FINITE : DISK_CHAIN2_OK;
}
