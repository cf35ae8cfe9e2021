/*
 * rolling_disk.c: rolling_disk, emitted by nhc 0.1.0 (nhc:c13ea24b4b1dd408)
 * A thin disk that rolls on a horizontal plane and may lean and fall (Euler's disk).
 * Source: rolling_disk.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * rolling_disk.h says what each function does.
 */
#include "rolling_disk.h"

#include <float.h>
#include <math.h>

const char *const rolling_disk_coordinate_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const rolling_disk_state_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "w_t",
    "w_u",
    "w_n"
};
const char *const rolling_disk_parameter_names[] = {
    "m",
    "R",
    "A",
    "C",
    "g"
};
const double rolling_disk_parameter_defaults[] = {
    1.0,
    0.5,
    0.0625,
    0.125,
    9.81
};

static int rolling_disk_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? ROLLING_DISK_OK : ROLLING_DISK_NOT_FINITE;
}

int rolling_disk_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double w_t = y[5];
    const double w_u = y[6];
    const double w_n = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * (R * R);
    const double k2 = A + k1;
    const double k3 = C + k1;
    const double k4 = g * (m * R);
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / A;
    const double k7 = 1.0 / k3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12)) {
        return ROLLING_DISK_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(A) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k3) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    const double z = R * s_theta;
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double z1 = R * w_n;
    const double z2 = 1.0 / s_theta;
    const double z3 = w_u * z2;
    const double c_theta = cos(theta);
    const double z4 = z2 * (w_u * (A * c_theta));
    /* (I.2.15) */
    dydt[0] = z * s_phi * w_t - c_phi * z1; /* x' */
    dydt[1] = -(z * c_phi * w_t + s_phi * z1); /* y' */
    dydt[2] = z3; /* phi' */
    dydt[3] = w_t; /* theta' */
    dydt[4] = w_n - c_theta * z3; /* psi' */
    /* (I.2.15) 22:4 */
    dydt[5] = -(w_u * (w_n * k3 - z4) + c_theta * k4) * k5; /* w_t' */
    dydt[6] = w_t * (C * w_n - z4) * k6; /* w_u' */
    dydt[7] = w_u * (w_t * k1) * k7; /* w_n' */
    return rolling_disk_finish(8, dydt);
}

int rolling_disk_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double w_t = y[5];
    const double w_u = y[6];
    const double w_n = y[7];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12)) {
        return ROLLING_DISK_SINGULAR_1;
    }
    const double z = R * s_theta;
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double z1 = R * w_n;
    const double z2 = w_u / s_theta;
    const double c_theta = cos(theta);
    /* (I.2.4) */
    qdot[0] = z * s_phi * w_t - c_phi * z1; /* x' */
    qdot[1] = -(z * c_phi * w_t + s_phi * z1); /* y' */
    qdot[2] = z2; /* phi' */
    qdot[3] = w_t; /* theta' */
    qdot[4] = w_n - c_theta * z2; /* psi' */
    return rolling_disk_finish(5, qdot);
}

int rolling_disk_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double w_t = y[5];
    const double w_u = y[6];
    const double w_n = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * (R * R);
    const double k2 = A + k1;
    const double k3 = C + k1;
    const double k4 = g * (m * R);
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / A;
    const double k7 = 1.0 - k1 / k3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12)) {
        return ROLLING_DISK_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(A) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k3) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double z1 = 1.0 / s_theta;
    const double c_theta = cos(theta);
    const double z2 = w_u * (A * c_theta);
    const double z3 = w_u * (w_n * (z1 - k3 * (s_theta * k5)) + z2 * k5) + c_theta * (w_t * w_t - k5 *
        (s_theta * k4));
    const double c_phi = cos(phi);
    const double z4 = w_t * (w_u * (2.0 / (s_theta * s_theta) - k7) - w_n * (C * c_theta) / (A * s_theta));
    /* (I.2.15) */
    qddot[0] = R * (s_phi * z3 + w_u * (c_phi * w_t) * k7); /* x'' */
    qddot[1] = -R * (c_phi * z3 - w_u * (s_phi * w_t) * k7); /* y'' */
    qddot[2] = w_t * z1 * (C * w_n * k6 - 2.0 * (z1 * (c_theta * w_u))); /* phi'' */
    qddot[3] = -(w_u * (w_n * k3 - z1 * z2) + c_theta * k4) * k5; /* theta'' */
    qddot[4] = z4; /* psi'' */
    return rolling_disk_finish(5, qddot);
}

int rolling_disk_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* centre [m] */
    const double y_2 = q[1]; /* centre [m] */
    const double phi = q[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = q[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double psi = q[4]; /* spin [rad] */
    const double phi_dot = qdot[2];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];

    /* state */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = theta_dot;
    y[6] = phi_dot * s_theta;
    y[7] = psi_dot + phi_dot * c_theta;
    return rolling_disk_finish(8, y);
}

int rolling_disk_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = q[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double phi_dot = qdot[2];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double c_theta = cos(theta);
    const double z1 = R * (psi_dot + phi_dot * c_theta);
    const double c_phi = cos(phi);
    const double s_theta = sin(theta);
    const double z = R * s_theta;
    const double s_phi = sin(phi);
    /* (I.1.1) 25:5 */
    r[0] = x_dot + z1 * c_phi - theta_dot * (z * s_phi); /* roll_x = 0 */
    /* (I.1.1) 26:5 */
    r[1] = y_dot + z1 * s_phi + theta_dot * (z * c_phi); /* roll_y = 0 */
    return rolling_disk_finish(2, r);
}

int rolling_disk_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double w_t = y[5];
    const double w_u = y[6];
    const double w_n = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * (R * R);
    const double k2 = A + k1;
    const double k3 = C + k1;
    const double k4 = m * R;
    const double k5 = g * k4;
    const double k6 = 1.0 / k2;
    const double k7 = 1.0 - k1 / k3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12)) {
        return ROLLING_DISK_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(A) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k3) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double c_theta = cos(theta);
    const double z1 = w_u * (w_n * (1.0 / s_theta - k3 * (s_theta * k6)) + w_u * (A * c_theta) * k6) +
        c_theta * (w_t * w_t - k6 * (s_theta * k5));
    const double c_phi = cos(phi);
    /* (I.4.1) 25:5 */
    /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    lambda[0] = k4 * (s_phi * z1 + w_u * (c_phi * w_t) * k7);
    /* (I.4.1) 26:5 */
    /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    lambda[1] = -k4 * (c_phi * z1 - w_u * (s_phi * w_t) * k7);
    return rolling_disk_finish(2, lambda);
}

double rolling_disk_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double w_t = y[5];
    const double w_u = y[6];
    const double w_n = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * R;

    /* state */
    const double z1 = 0.5 * (w_t * w_t);
    const double z2 = w_n * w_n;
    const double s_theta = sin(theta);
    const double z3 = k1 * (R * (z1 + 0.5 * z2) + g * s_theta) + (0.5 * (C * z2) + A * (z1 + 0.5 * (w_u *
        w_u)));
    return z3;
}

int rolling_disk_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double w_t = y[5];
    const double w_u = y[6];
    const double w_n = y[7];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * (R * R);
    const double k2 = A + k1;
    const double k3 = C + k1;
    const double k4 = g * (m * R);
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / A;
    const double k7 = 1.0 / k3;

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12)) {
        return ROLLING_DISK_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(A) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k3) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double z1 = R * w_n;
    const double c_phi = cos(phi);
    const double z = R * s_theta;
    const double z2 = z * w_t;
    const double c_theta = cos(theta);
    const double z3 = 1.0 / (s_theta * s_theta);
    const double z4 = 1.0 / s_theta;
    const double z5 = c_theta * w_u;
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = s_phi * z1 + c_phi * z2;
    J[3] = c_theta * (R * (s_phi * w_t));
    J[4] = 0.0;
    J[5] = z * s_phi;
    J[6] = 0.0;
    J[7] = -R * c_phi;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = s_phi * z2 - c_phi * z1;
    J[11] = -c_theta * (R * (c_phi * w_t));
    J[12] = 0.0;
    J[13] = -z * c_phi;
    J[14] = 0.0;
    J[15] = -R * s_phi;
    J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = -c_theta * (w_u * z3);
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = z4;
    J[23] = 0.0;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = 0.0;
    J[28] = 0.0;
    J[29] = 1.0;
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = 0.0;
    J[35] = w_u + c_theta * (z3 * z5);
    J[36] = 0.0;
    J[37] = 0.0;
    J[38] = -c_theta * z4;
    J[39] = 1.0;
    J[40] = 0.0;
    J[41] = 0.0;
    J[42] = 0.0;
    J[43] = k5 * (s_theta * k4 - z3 * (A * (w_u * w_u)));
    J[44] = 0.0;
    J[45] = 0.0;
    J[46] = -k5 * (w_n * k3 - 2.0 * (z4 * (w_u * (A * c_theta))));
    J[47] = -k3 * (w_u * k5);
    J[48] = 0.0;
    J[49] = 0.0;
    J[50] = 0.0;
    J[51] = z3 * (w_t * w_u);
    J[52] = 0.0;
    J[53] = C * w_n * k6 - z4 * z5;
    J[54] = -z4 * (c_theta * w_t);
    J[55] = k6 * (C * w_t);
    J[56] = 0.0;
    J[57] = 0.0;
    J[58] = 0.0;
    J[59] = 0.0;
    J[60] = 0.0;
    J[61] = k7 * (w_u * k1);
    J[62] = w_t * k1 * k7;
    J[63] = 0.0;
    return rolling_disk_finish(64, J);
}

int rolling_disk_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double x = y[0]; /* centre [m] */
    const double y_2 = y[1]; /* centre [m] */
    const double phi = y[2]; /* yaw, direction of the horizontal diameter [rad] */
    const double theta = y[3]; /* tilt of the plane of the disk, pi/2 upright [rad] */
    const double R = p[1]; /* radius [m] */

    /* state */
    const double s_theta = sin(theta);
    /* the coframe is singular */
    if (!(fabs(s_theta) > 1e-12)) {
        return ROLLING_DISK_SINGULAR_1;
    }
    const double s_phi = sin(phi);
    const double c_theta = cos(theta);
    const double z1 = R * c_theta;
    const double c_phi = cos(phi);
    /* 33:11 */
    out[0] = R * s_theta; /* height */
    /* 34:14 */
    out[1] = x - s_phi * z1; /* contact_x */
    /* 35:14 */
    out[2] = y_2 + c_phi * z1; /* contact_y */
    return rolling_disk_finish(3, out);
}

int rolling_disk_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double A = p[2]; /* moment of inertia about a diameter [kg*m^2] */
    const double C = p[3]; /* moment of inertia about the axis [kg*m^2] */
    const double g = p[4]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * (R * R);
    const double k2 = A + k1;
    const double k3 = C + k1;
    const double k4 = g * (m * R);
    const double k5 = 1.0 / k2;
    const double k6 = 1.0 / A;
    const double k7 = 1.0 / k3;
    /* the mass matrix is singular */
    if (!(fabs(k2) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(A) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(k3) > 0.0)) {
        return ROLLING_DISK_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double phi = y[2 * count + i]; /* yaw, direction of the horizontal diameter [rad] */
        const double theta = y[3 * count + i]; /* tilt of the plane of the disk, pi/2 upright [rad] */
        const double w_t = y[5 * count + i];
        const double w_u = y[6 * count + i];
        const double w_n = y[7 * count + i];
        const double s_theta = sin(theta);
        /* the coframe is singular */
        singular1 |= !(fabs(s_theta) > 1e-12);
        const double z = R * s_theta;
        const double s_phi = sin(phi);
        const double c_phi = cos(phi);
        const double z1 = R * w_n;
        const double z2 = 1.0 / s_theta;
        const double z3 = w_u * z2;
        const double c_theta = cos(theta);
        const double z4 = z2 * (w_u * (A * c_theta));
        /* (I.2.15) */
        const double slope1 = z * s_phi * w_t - c_phi * z1; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = -(z * c_phi * w_t + s_phi * z1); /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z3; /* phi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = w_t; /* theta' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = w_n - c_theta * z3; /* psi' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        /* (I.2.15) 22:4 */
        const double slope6 = -(w_u * (w_n * k3 - z4) + c_theta * k4) * k5; /* w_t' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = w_t * (C * w_n - z4) * k6; /* w_u' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = w_u * (w_t * k1) * k7; /* w_n' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
    }
    if (singular1) {
        return ROLLING_DISK_SINGULAR_1;
    }
    return bad ? ROLLING_DISK_NOT_FINITE : ROLLING_DISK_OK;
}
