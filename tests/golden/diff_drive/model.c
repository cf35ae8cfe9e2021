/*
 * diff_drive.c: diff_drive, emitted by nhc 0.1.0 (nhc:3932127cd18c8595)
 * A cart with two driven wheels and a caster; three velocity constraints, one of which is holonomic in
 *     disguise.
 * Source: diff_drive.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * diff_drive.h says what each function does.
 */
#include "diff_drive.h"

#include <float.h>
#include <math.h>

const char *const diff_drive_coordinate_names[] = {
    "x",
    "y",
    "theta",
    "p_R",
    "p_L"
};
const char *const diff_drive_state_names[] = {
    "x",
    "y",
    "theta",
    "p_R",
    "p_L",
    "v",
    "w"
};
const char *const diff_drive_parameter_names[] = {
    "m",
    "I",
    "J_w",
    "r",
    "b",
    "d",
    "tau_R",
    "tau_L"
};
const double diff_drive_parameter_defaults[] = {
    10.0,
    0.6,
    0.02,
    0.1,
    0.25,
    0.1,
    0.3,
    0.2
};

static int diff_drive_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? DIFF_DRIVE_OK : DIFF_DRIVE_NOT_FINITE;
}

int diff_drive_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */

    /* parameters only */
    const double k1 = 1.0 / r;
    const double k2 = k1 * (tau_R + tau_L);
    const double k3 = b * k1 * (tau_R - tau_L);
    const double k4 = 1.0 / (r * r);
    const double k5 = m + 2.0 * (J_w * k4);
    const double k6 = m * d;
    const double k7 = 2.0 * (k4 * (J_w * (b * b))) + (I + m * (d * d));
    const double k8 = 1.0 / k5;
    const double k9 = 1.0 / k7;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k5) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k7) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    const double c_theta = cos(theta);
    const double z1 = c_theta * v;
    const double s_theta = sin(theta);
    const double z2 = s_theta * v;
    const double z3 = b * w;
    const double v_2 = s_theta * z2 + c_theta * z1;
    /* (I.2.15) */
    dydt[0] = z1; /* x' */
    dydt[1] = z2; /* y' */
    dydt[2] = w; /* theta' */
    dydt[3] = k1 * (z3 + v_2); /* p_R' */
    dydt[4] = -k1 * (z3 - v_2); /* p_L' */
    /* (I.2.15) 24:4 */
    dydt[5] = (k2 + w * w * k6) * k8; /* v' */
    dydt[6] = (k3 - w * (v * k6)) * k9; /* w' */
    return diff_drive_finish(7, dydt);
}

int diff_drive_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[5];
    const double w = y[6];
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */

    /* parameters only */
    const double k1 = 1.0 / r;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    const double c_theta = cos(theta);
    const double z1 = c_theta * v;
    const double s_theta = sin(theta);
    const double z2 = s_theta * v;
    const double z3 = b * w;
    const double v_2 = s_theta * z2 + c_theta * z1;
    /* (I.2.4) */
    qdot[0] = z1; /* x' */
    qdot[1] = z2; /* y' */
    qdot[2] = w; /* theta' */
    qdot[3] = k1 * (z3 + v_2); /* p_R' */
    qdot[4] = -k1 * (z3 - v_2); /* p_L' */
    return diff_drive_finish(5, qdot);
}

int diff_drive_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */

    /* parameters only */
    const double k1 = 1.0 / r;
    const double k2 = k1 * (tau_R + tau_L);
    const double k3 = b * k1 * (tau_R - tau_L);
    const double k4 = 1.0 / (r * r);
    const double k5 = m + 2.0 * (J_w * k4);
    const double k6 = m * d;
    const double k7 = 2.0 * (k4 * (J_w * (b * b))) + (I + m * (d * d));
    const double k8 = 1.0 / k5;
    const double k9 = 1.0 / k7;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k5) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k7) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = s_theta * w;
    const double c_theta = cos(theta);
    const double z2 = (k2 + w * w * k6) * k8;
    const double z3 = v * z1 - c_theta * z2;
    const double z4 = c_theta * w;
    const double z5 = v * z4 + s_theta * z2;
    const double z6 = (k3 - w * (v * k6)) * k9;
    const double z7 = b * z6;
    const double z8 = s_theta * v * z4 + s_theta * z5 - (c_theta * v * z1 + c_theta * z3);
    /* (I.2.15) */
    qddot[0] = -z3; /* x'' */
    qddot[1] = z5; /* y'' */
    qddot[2] = z6; /* theta'' */
    qddot[3] = k1 * (z7 + z8); /* p_R'' */
    qddot[4] = -k1 * (z7 - z8); /* p_L'' */
    return diff_drive_finish(5, qddot);
}

int diff_drive_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* midpoint of the axle [m] */
    const double y_2 = q[1]; /* midpoint of the axle [m] */
    const double theta = q[2]; /* heading [rad] */
    const double p_R = q[3]; /* right wheel [rad] */
    const double p_L = q[4]; /* left wheel [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];

    /* state */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    y[0] = x;
    y[1] = y_2;
    y[2] = theta;
    y[3] = p_R;
    y[4] = p_L;
    y[5] = x_dot * c_theta + y_dot * s_theta;
    y[6] = theta_dot;
    return diff_drive_finish(7, y);
}

int diff_drive_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double theta = q[2]; /* heading [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[2];
    const double p_R_dot = qdot[3];
    const double p_L_dot = qdot[4];
    const double r_2 = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double v = x_dot * c_theta + y_dot * s_theta;
    const double z1 = theta_dot * b;
    /* (I.1.1) 29:5 */
    r[0] = y_dot * c_theta - x_dot * s_theta; /* slip = 0 */
    /* (I.1.1) 30:5 */
    r[1] = v + z1 - p_R_dot * r_2; /* roll_R = 0 */
    /* (I.1.1) 31:5 */
    r[2] = v - z1 - p_L_dot * r_2; /* roll_L = 0 */
    return diff_drive_finish(3, r);
}

int diff_drive_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */

    /* parameters only */
    const double k1 = 1.0 / r;
    const double k2 = tau_R * k1;
    const double k3 = tau_L * k1;
    const double k4 = k1 * (tau_R + tau_L);
    const double k5 = b * k1 * (tau_R - tau_L);
    const double k6 = 1.0 / (r * r);
    const double k7 = J_w * k6;
    const double k8 = m + 2.0 * k7;
    const double k9 = m * d;
    const double k10 = 2.0 * (k6 * (J_w * (b * b))) + (I + m * (d * d));
    const double k11 = k6 * (J_w * b);
    const double k12 = 1.0 / k8;
    const double k13 = 1.0 / k10;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k8) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k10) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    const double z1 = (k5 - w * (v * k9)) * k13;
    const double z2 = k7 * ((k4 + w * w * k9) * k12);
    const double z3 = k11 * z1;
    /* (I.4.1) 29:5 */
    lambda[0] = w * (m * v) + k9 * z1; /* reaction of slip: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 30:5 */
    lambda[1] = k2 - (z2 + z3); /* reaction of roll_R: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 31:5 */
    lambda[2] = k3 - (z2 - z3); /* reaction of roll_L: Q_i gains lambda_3 a_3i */
    return diff_drive_finish(3, lambda);
}

double diff_drive_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */

    /* parameters only */
    const double k1 = 1.0 / (r * r);
    const double k2 = k1 * (J_w * (b * b)) + (0.5 * I + 0.5 * (m * (d * d)));
    const double k3 = 0.5 * m + J_w * k1;

    /* state */
    return w * w * k2 + v * v * k3;
}

int diff_drive_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double theta = y[2]; /* heading [rad] */
    const double v = y[5];
    const double w = y[6];
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */

    /* parameters only */
    const double k1 = 1.0 / r;
    const double k2 = b * k1;
    const double k3 = 1.0 / (r * r);
    const double k4 = m + 2.0 * (J_w * k3);
    const double k5 = m * d;
    const double k6 = 2.0 * (k3 * (J_w * (b * b))) + (I + m * (d * d));
    const double k7 = 1.0 / k4;
    const double k8 = 1.0 / k6;

    /* state */
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k4) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k6) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    const double s_theta = sin(theta);
    const double z1 = s_theta * v;
    const double c_theta = cos(theta);
    const double z2 = c_theta * v;
    const double z3 = s_theta * k1;
    const double z4 = c_theta * k1;
    const double z5 = c_theta * (z1 * k1 + v * z3) - s_theta * (z2 * k1 + v * z4);
    const double z6 = s_theta * z3 + c_theta * z4;
    const double z7 = w * k5;
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = -z1;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = c_theta;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = z2;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = s_theta;
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
    J[23] = z5;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = z6;
    J[27] = k2;
    J[28] = 0.0;
    J[29] = 0.0;
    J[30] = z5;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = z6;
    J[34] = -k2;
    J[35] = 0.0;
    J[36] = 0.0;
    J[37] = 0.0;
    J[38] = 0.0;
    J[39] = 0.0;
    J[40] = 0.0;
    J[41] = 2.0 * (k7 * z7);
    J[42] = 0.0;
    J[43] = 0.0;
    J[44] = 0.0;
    J[45] = 0.0;
    J[46] = 0.0;
    J[47] = -k8 * z7;
    J[48] = -v * k5 * k8;
    return diff_drive_finish(49, J);
}

int diff_drive_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)y;
    const double r = p[3]; /* radius of the wheels [m] */

    /* state */
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    (void)out;
    return DIFF_DRIVE_OK;
}

int diff_drive_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double I = p[1]; /* of the whole about the vertical through the centre of mass [kg*m^2] */
    const double J_w = p[2]; /* of a wheel about its axle [kg*m^2] */
    const double r = p[3]; /* radius of the wheels [m] */
    const double b = p[4]; /* half the track [m] */
    const double d = p[5]; /* from the axle to the centre of mass [m] */
    const double tau_R = p[6]; /* torque on the right wheel [N*m] */
    const double tau_L = p[7]; /* torque on the left wheel [N*m] */
    const double k1 = 1.0 / r;
    const double k2 = k1 * (tau_R + tau_L);
    const double k3 = b * k1 * (tau_R - tau_L);
    const double k4 = 1.0 / (r * r);
    const double k5 = m + 2.0 * (J_w * k4);
    const double k6 = m * d;
    const double k7 = 2.0 * (k4 * (J_w * (b * b))) + (I + m * (d * d));
    const double k8 = 1.0 / k5;
    const double k9 = 1.0 / k7;
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the coframe is singular */
    if (!(fabs(-r) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k5) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k7) > 0.0)) {
        return DIFF_DRIVE_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double theta = y[2 * count + i]; /* heading [rad] */
        const double v = y[5 * count + i];
        const double w = y[6 * count + i];
        const double c_theta = cos(theta);
        const double z1 = c_theta * v;
        const double s_theta = sin(theta);
        const double z2 = s_theta * v;
        const double z3 = b * w;
        const double v_2 = s_theta * z2 + c_theta * z1;
        /* (I.2.15) */
        const double slope1 = z1; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = z2; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = w; /* theta' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = k1 * (z3 + v_2); /* p_R' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -k1 * (z3 - v_2); /* p_L' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        /* (I.2.15) 24:4 */
        const double slope6 = (k2 + w * w * k6) * k8; /* v' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = (k3 - w * (v * k6)) * k9; /* w' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
    }
    return bad ? DIFF_DRIVE_NOT_FINITE : DIFF_DRIVE_OK;
}
