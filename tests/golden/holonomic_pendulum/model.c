/*
 * holonomic_pendulum.c: holonomic_pendulum, emitted by nhc 0.1.0 (nhc:44ca4a20bc7381e8)
 * The plane pendulum in Cartesian coordinates with the rod as a constraint on the positions.
 * Source: holonomic_pendulum.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v: the dependent velocities that nhc would choose (x') are singular
 *     somewhere
 * holonomic_pendulum.h says what each function does.
 */
#include "holonomic_pendulum.h"

#include <float.h>
#include <math.h>

const char *const holonomic_pendulum_coordinate_names[] = {
    "x",
    "y"
};
const char *const holonomic_pendulum_state_names[] = {
    "x",
    "y",
    "v"
};
const char *const holonomic_pendulum_parameter_names[] = {
    "m",
    "g",
    "l"
};
const double holonomic_pendulum_parameter_defaults[] = {
    1.0,
    9.81,
    1.0
};

static int holonomic_pendulum_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? HOLONOMIC_PENDULUM_OK : HOLONOMIC_PENDULUM_NOT_FINITE;
}

int holonomic_pendulum_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* up [m] */
    const double v = y[2];
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */

    /* state */
    const double z1 = x * x + y_2 * y_2;
    const double z2 = fabs(y_2) + fabs(x);
    /* the coframe is singular */
    if (!(fabs(z1) > 1e-12 * (z2 * z2))) {
        return HOLONOMIC_PENDULUM_SINGULAR_1;
    }
    const double z3 = 1.0 / z1;
    /* the mass matrix is singular */
    if (!(fabs(m * z3) > 0.0)) {
        return HOLONOMIC_PENDULUM_SINGULAR_2;
    }
    /* (I.2.15) */
    dydt[0] = y_2 * v * z3; /* x' */
    dydt[1] = -z3 * (x * v); /* y' */
    /* (I.2.15) 13:4 */
    dydt[2] = x * g; /* v' */
    return holonomic_pendulum_finish(3, dydt);
}

int holonomic_pendulum_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* up [m] */
    const double v = y[2];

    /* state */
    const double z1 = x * x + y_2 * y_2;
    const double z2 = fabs(y_2) + fabs(x);
    /* the coframe is singular */
    if (!(fabs(z1) > 1e-12 * (z2 * z2))) {
        return HOLONOMIC_PENDULUM_SINGULAR_1;
    }
    const double z3 = 1.0 / z1;
    /* (I.2.4) */
    qdot[0] = y_2 * v * z3; /* x' */
    qdot[1] = -z3 * (x * v); /* y' */
    return holonomic_pendulum_finish(2, qdot);
}

int holonomic_pendulum_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* up [m] */
    const double v = y[2];
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */

    /* state */
    const double z1 = x * x;
    const double z2 = z1 + y_2 * y_2;
    const double z3 = fabs(y_2) + fabs(x);
    /* the coframe is singular */
    if (!(fabs(z2) > 1e-12 * (z3 * z3))) {
        return HOLONOMIC_PENDULUM_SINGULAR_1;
    }
    const double z4 = 1.0 / z2;
    /* the mass matrix is singular */
    if (!(fabs(m * z4) > 0.0)) {
        return HOLONOMIC_PENDULUM_SINGULAR_2;
    }
    const double z5 = v * v;
    /* (I.2.15) */
    qddot[0] = x * z4 * (y_2 * g - z4 * z5); /* x'' */
    qddot[1] = -z4 * (g * z1 + z4 * (y_2 * z5)); /* y'' */
    return holonomic_pendulum_finish(2, qddot);
}

int holonomic_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* across [m] */
    const double y_2 = q[1]; /* up [m] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = y_2 * x_dot - x * y_dot;
    return holonomic_pendulum_finish(3, y);
}

int holonomic_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* across [m] */
    const double y = q[1]; /* up [m] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];

    /* state */
    /* (I.1.1) 16:5 */
    r[0] = 0.5 * (2.0 * (x * x_dot) + 2.0 * (y * y_dot)); /* rod = 0 */
    return holonomic_pendulum_finish(1, r);
}

int holonomic_pendulum_positions(double t, const double *q, const double *p, double *f)
{
    (void)t;
    const double x = q[0]; /* across [m] */
    const double y = q[1]; /* up [m] */
    const double l = p[2]; /* length of the rod [m] */

    /* parameters only */
    const double k1 = l * l;

    /* state */
    /* 16:5 */
    f[0] = 0.5 * (x * x + y * y - k1); /* rod = 0 */
    return holonomic_pendulum_finish(1, f);
}

int holonomic_pendulum_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* up [m] */
    const double v = y[2];
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */

    /* state */
    const double z1 = x * x;
    const double z2 = z1 + y_2 * y_2;
    const double z3 = fabs(y_2) + fabs(x);
    /* the coframe is singular */
    if (!(fabs(z2) > 1e-12 * (z3 * z3))) {
        return HOLONOMIC_PENDULUM_SINGULAR_1;
    }
    const double z4 = m / z2;
    /* the mass matrix is singular */
    if (!(fabs(z4) > 0.0)) {
        return HOLONOMIC_PENDULUM_SINGULAR_2;
    }
    const double z5 = 1.0 / (z2 * z2);
    const double z6 = v * v;
    /* (I.4.1) 16:5 */
    /* reaction of rod: Q_i gains lambda_1 a_1i */
    lambda[0] = z4 * (y_2 * (g - z5 * (y_2 * z6)) - z5 * (z1 * z6));
    return holonomic_pendulum_finish(1, lambda);
}

double holonomic_pendulum_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* up [m] */
    const double v = y[2];
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */

    /* state */
    const double z1 = x * x;
    const double z2 = z1 + y_2 * y_2;
    const double z3 = 1.0 / (z2 * z2);
    const double z4 = v * v;
    return m * (0.5 * (z3 * (z1 * z4)) + y_2 * (g + 0.5 * (z3 * (y_2 * z4))));
}

int holonomic_pendulum_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* up [m] */
    const double v = y[2];
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */

    /* state */
    const double z1 = x * x + y_2 * y_2;
    const double z2 = fabs(y_2) + fabs(x);
    /* the coframe is singular */
    if (!(fabs(z1) > 1e-12 * (z2 * z2))) {
        return HOLONOMIC_PENDULUM_SINGULAR_1;
    }
    const double z3 = 1.0 / z1;
    /* the mass matrix is singular */
    if (!(fabs(m * z3) > 0.0)) {
        return HOLONOMIC_PENDULUM_SINGULAR_2;
    }
    const double z4 = 1.0 / (z1 * z1);
    const double z5 = y_2 * v * z4;
    const double z6 = v * z3;
    const double z7 = x * v * z4;
    /* (I.2.15) */
    J[0] = -2.0 * (x * z5);
    J[1] = z6 - 2.0 * (y_2 * z5);
    J[2] = y_2 * z3;
    J[3] = 2.0 * (x * z7) - z6;
    J[4] = 2.0 * (y_2 * z7);
    J[5] = -x * z3;
    J[6] = g;
    J[7] = 0.0;
    J[8] = 0.0;
    return holonomic_pendulum_finish(9, J);
}

int holonomic_pendulum_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double x = y[0]; /* across [m] */
    const double y_2 = y[1]; /* up [m] */

    /* state */
    const double z1 = fabs(y_2) + fabs(x);
    /* the coframe is singular */
    if (!(fabs(x * x + y_2 * y_2) > 1e-12 * (z1 * z1))) {
        return HOLONOMIC_PENDULUM_SINGULAR_1;
    }
    (void)out;
    return HOLONOMIC_PENDULUM_OK;
}

int holonomic_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
    const double m = p[0]; /* mass of the bob [kg] */
    const double g = p[1]; /* acceleration of gravity [m/s^2] */
    int singular1 = 0;
    int singular2 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x = y[i]; /* across [m] */
        const double y_2 = y[count + i]; /* up [m] */
        const double v = y[2 * count + i];
        const double z1 = x * x + y_2 * y_2;
        const double z2 = fabs(y_2) + fabs(x);
        /* the coframe is singular */
        singular1 |= !(fabs(z1) > 1e-12 * (z2 * z2));
        const double z3 = 1.0 / z1;
        /* the mass matrix is singular */
        singular2 |= !(fabs(m * z3) > 0.0);
        /* (I.2.15) */
        const double slope1 = y_2 * v * z3; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = -z3 * (x * v); /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        /* (I.2.15) 13:4 */
        const double slope3 = x * g; /* v' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
    }
    if (singular1) {
        return HOLONOMIC_PENDULUM_SINGULAR_1;
    }
    if (singular2) {
        return HOLONOMIC_PENDULUM_SINGULAR_2;
    }
    return bad ? HOLONOMIC_PENDULUM_NOT_FINITE : HOLONOMIC_PENDULUM_OK;
}
