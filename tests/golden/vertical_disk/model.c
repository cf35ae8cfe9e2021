/*
 * vertical_disk.c: vertical_disk, emitted by nhc 0.1.0 (nhc:d6fa714d0d60f36a)
 * A disk that stays upright and rolls without slipping.
 * Source: vertical_disk.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * vertical_disk.h says what each function does.
 */
#include "vertical_disk.h"

#include <float.h>
#include <math.h>

const char *const vertical_disk_coordinate_names[] = {
    "x",
    "y",
    "phi",
    "theta"
};
const char *const vertical_disk_state_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "phi'",
    "theta'"
};
const char *const vertical_disk_parameter_names[] = {
    "m",
    "R",
    "I",
    "J"
};
const double vertical_disk_parameter_defaults[] = {
    1.0,
    0.5,
    0.125,
    0.0625
};

static int vertical_disk_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? VERTICAL_DISK_OK : VERTICAL_DISK_NOT_FINITE;
}

int vertical_disk_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */
    const double phi_dot = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I + m * (R * R)) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    /* (III.3) */
    dydt[0] = theta_dot * (R * c_phi); /* x' */
    dydt[1] = theta_dot * (R * s_phi); /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    /* (III.3) 16:4 */
    dydt[4] = 0.0; /* phi'' */
    dydt[5] = 0.0; /* theta'' */
    return vertical_disk_finish(6, dydt);
}

int vertical_disk_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */
    const double phi_dot = y[4];
    const double theta_dot = y[5];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    /* (I.2.4) */
    qdot[0] = theta_dot * (R * c_phi); /* x' */
    qdot[1] = theta_dot * (R * s_phi); /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    return vertical_disk_finish(4, qdot);
}

int vertical_disk_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */
    const double phi_dot = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I + m * (R * R)) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double z1 = R * (phi_dot * theta_dot);
    const double c_phi = cos(phi);
    /* (III.3) */
    qddot[0] = -s_phi * z1; /* x'' */
    qddot[1] = c_phi * z1; /* y'' */
    qddot[2] = 0.0; /* phi'' */
    qddot[3] = 0.0; /* theta'' */
    return vertical_disk_finish(4, qddot);
}

int vertical_disk_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* point of contact [m] */
    const double y_2 = q[1]; /* point of contact [m] */
    const double phi = q[2]; /* heading [rad] */
    const double theta = q[3]; /* angle rolled [rad] */
    const double phi_dot = qdot[2];
    const double theta_dot = qdot[3];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = phi_dot;
    y[5] = theta_dot;
    return vertical_disk_finish(6, y);
}

int vertical_disk_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double phi = q[2]; /* heading [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double theta_dot = qdot[3];
    const double R = p[1]; /* radius [m] */

    /* state */
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    /* (I.1.1) 18:5 */
    r[0] = x_dot - theta_dot * (R * c_phi); /* roll_x = 0 */
    /* (I.1.1) 19:5 */
    r[1] = y_dot - theta_dot * (R * s_phi); /* roll_y = 0 */
    return vertical_disk_finish(2, r);
}

int vertical_disk_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */
    const double phi_dot = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I + m * (R * R)) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double z1 = R * (m * (phi_dot * theta_dot));
    const double c_phi = cos(phi);
    /* (I.4.1) 18:5 */
    lambda[0] = -s_phi * z1; /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 19:5 */
    lambda[1] = c_phi * z1; /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    return vertical_disk_finish(2, lambda);
}

double vertical_disk_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double phi_dot = y[4];
    const double theta_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* parameters only */
    const double k1 = 0.5 * I + 0.5 * (m * (R * R));

    /* state */
    return 0.5 * (J * (phi_dot * phi_dot)) + theta_dot * theta_dot * k1;
}

int vertical_disk_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double phi = y[2]; /* heading [rad] */
    const double theta_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J_2 = p[3]; /* moment of inertia about the vertical [kg*m^2] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(J_2) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I + m * (R * R)) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    const double s_phi = sin(phi);
    const double z1 = theta_dot * R;
    const double c_phi = cos(phi);
    /* (III.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = -s_phi * z1;
    J[3] = 0.0;
    J[4] = 0.0;
    J[5] = R * c_phi;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = c_phi * z1;
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = R * s_phi;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 0.0;
    J[15] = 0.0;
    J[16] = 1.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = 1.0;
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
    J[34] = 0.0;
    J[35] = 0.0;
    return vertical_disk_finish(36, J);
}

int vertical_disk_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double theta_dot = y[5];
    const double R = p[1]; /* radius [m] */

    /* state */
    /* 22:10 */
    out[0] = theta_dot * R; /* speed */
    return vertical_disk_finish(1, out);
}

int vertical_disk_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double I = p[2]; /* moment of inertia about the axle [kg*m^2] */
    const double J = p[3]; /* moment of inertia about the vertical [kg*m^2] */
    /* the mass matrix is singular */
    if (!(fabs(J) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I + m * (R * R)) > 0.0)) {
        return VERTICAL_DISK_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double phi = y[2 * count + i]; /* heading [rad] */
        const double phi_dot = y[4 * count + i];
        const double theta_dot = y[5 * count + i];
        const double c_phi = cos(phi);
        const double s_phi = sin(phi);
        /* (III.3) */
        const double slope1 = theta_dot * (R * c_phi); /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = theta_dot * (R * s_phi); /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = phi_dot; /* phi' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = theta_dot; /* theta' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        /* (III.3) 16:4 */
        const double slope5 = 0.0; /* phi'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = 0.0; /* theta'' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
    }
    return bad ? VERTICAL_DISK_NOT_FINITE : VERTICAL_DISK_OK;
}
