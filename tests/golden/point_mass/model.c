/*
 * point_mass.c: point_mass, emitted by nhc 0.1.0 (nhc:18bafc33357e5efa)
 * A point mass thrown in a uniform field of gravity, with linear drag.
 * Source: point_mass.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * point_mass.h says what each function does.
 */
#include "point_mass.h"

#include <float.h>
#include <math.h>

const char *const point_mass_coordinate_names[] = {
    "x",
    "y",
    "z"
};
const char *const point_mass_state_names[] = {
    "x",
    "y",
    "z",
    "x'",
    "y'",
    "z'"
};
const char *const point_mass_parameter_names[] = {
    "m",
    "g",
    "c"
};
const double point_mass_parameter_defaults[] = {
    2.0,
    9.81,
    0.5
};

static int point_mass_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? POINT_MASS_OK : POINT_MASS_NOT_FINITE;
}

int point_mass_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double z_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double c = p[2]; /* drag coefficient [kg/s] */

    /* parameters only */
    const double k1 = 1.0 / m;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* (II.3) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z_dot; /* z' */
    /* (II.3) 14:4 */
    dydt[3] = -x_dot * c * k1; /* x'' */
    dydt[4] = -y_dot * c * k1; /* y'' */
    dydt[5] = -(g + z_dot * c * k1); /* z'' */
    return point_mass_finish(6, dydt);
}

int point_mass_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double z_dot = y[5];

    /* state */
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = z_dot; /* z' */
    return point_mass_finish(3, qdot);
}

int point_mass_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double z_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double c = p[2]; /* drag coefficient [kg/s] */

    /* parameters only */
    const double k1 = 1.0 / m;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* (II.3) */
    qddot[0] = -x_dot * c * k1; /* x'' */
    qddot[1] = -y_dot * c * k1; /* y'' */
    qddot[2] = -(g + z_dot * c * k1); /* z'' */
    return point_mass_finish(3, qddot);
}

int point_mass_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* horizontal [m] */
    const double y_2 = q[1]; /* horizontal [m] */
    const double z = q[2]; /* height [m] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = x_dot;
    y[4] = y_dot;
    y[5] = z_dot;
    return point_mass_finish(6, y);
}

int point_mass_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return POINT_MASS_OK;
}

int point_mass_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;
    const double m = p[0]; /* mass [kg] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    (void)lambda;
    return POINT_MASS_OK;
}

double point_mass_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double z = y[2]; /* height [m] */
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double z_dot = y[5];
    const double m = p[0]; /* mass [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * g;

    /* state */
    return 0.5 * (m * (x_dot * x_dot + y_dot * y_dot + z_dot * z_dot)) + z * k1;
}

int point_mass_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    (void)y;
    const double m = p[0]; /* mass [kg] */
    const double c = p[2]; /* drag coefficient [kg/s] */

    /* parameters only */
    const double k1 = c / m;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    J[3] = 1.0;
    J[4] = 0.0;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = 0.0;
    J[10] = 1.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 0.0;
    J[15] = 0.0;
    J[16] = 0.0;
    J[17] = 1.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = -k1;
    J[22] = 0.0;
    J[23] = 0.0;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = 0.0;
    J[28] = -k1;
    J[29] = 0.0;
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = 0.0;
    J[34] = 0.0;
    J[35] = -k1;
    return point_mass_finish(36, J);
}

int point_mass_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double z_dot = y[5];

    /* state */
    /* 21:10 */
    out[0] = sqrt(x_dot * x_dot + y_dot * y_dot + z_dot * z_dot); /* speed */
    return point_mass_finish(1, out);
}

int point_mass_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    const double c = p[2]; /* drag coefficient [kg/s] */
    const double k1 = 1.0 / m;
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return POINT_MASS_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x_dot = y[3 * count + i];
        const double y_dot = y[4 * count + i];
        const double z_dot = y[5 * count + i];
        /* (II.3) */
        const double slope1 = x_dot; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = y_dot; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z_dot; /* z' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (II.3) 14:4 */
        const double slope4 = -x_dot * c * k1; /* x'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -y_dot * c * k1; /* y'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = -(g + z_dot * c * k1); /* z'' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
    }
    return bad ? POINT_MASS_NOT_FINITE : POINT_MASS_OK;
}
