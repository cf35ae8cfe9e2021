/*
 * bead_on_rod.c: bead_on_rod, emitted by nhc 0.1.0 (nhc:13f1ca1e9eccdbae)
 * A bead on a straight horizontal rod that turns at a constant rate; T has a part without velocities.
 * Source: bead_on_rod.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * bead_on_rod.h says what each function does.
 */
#include "bead_on_rod.h"

#include <float.h>
#include <math.h>

const char *const bead_on_rod_coordinate_names[] = {
    "r"
};
const char *const bead_on_rod_state_names[] = {
    "r",
    "r'"
};
const char *const bead_on_rod_parameter_names[] = {
    "m",
    "Omega"
};
const double bead_on_rod_parameter_defaults[] = {
    1.0,
    2.0
};

static int bead_on_rod_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? BEAD_ON_ROD_OK : BEAD_ON_ROD_NOT_FINITE;
}

int bead_on_rod_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double r = y[0]; /* distance from the axis [m] */
    const double r_dot = y[1];
    const double m = p[0]; /* mass of the bead [kg] */
    const double Omega = p[1]; /* rate of the rod [rad/s] */

    /* parameters only */
    const double k1 = Omega * Omega;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return BEAD_ON_ROD_SINGULAR_2;
    }
    /* (II.3) */
    dydt[0] = r_dot; /* r' */
    /* (II.3) 14:4 */
    dydt[1] = r * k1; /* r'' */
    return bead_on_rod_finish(2, dydt);
}

int bead_on_rod_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double r_dot = y[1];

    /* state */
    /* (I.2.4) */
    qdot[0] = r_dot; /* r' */
    return bead_on_rod_finish(1, qdot);
}

int bead_on_rod_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double r = y[0]; /* distance from the axis [m] */
    const double m = p[0]; /* mass of the bead [kg] */
    const double Omega = p[1]; /* rate of the rod [rad/s] */

    /* parameters only */
    const double k1 = Omega * Omega;

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return BEAD_ON_ROD_SINGULAR_2;
    }
    /* (II.3) */
    qddot[0] = r * k1; /* r'' */
    return bead_on_rod_finish(1, qddot);
}

int bead_on_rod_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double r = q[0]; /* distance from the axis [m] */
    const double r_dot = qdot[0];

    /* state */
    y[0] = r;
    y[1] = r_dot;
    return bead_on_rod_finish(2, y);
}

int bead_on_rod_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return BEAD_ON_ROD_OK;
}

int bead_on_rod_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)y;
    const double m = p[0]; /* mass of the bead [kg] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return BEAD_ON_ROD_SINGULAR_2;
    }
    (void)lambda;
    return BEAD_ON_ROD_OK;
}

double bead_on_rod_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double r = y[0]; /* distance from the axis [m] */
    const double r_dot = y[1];
    const double m = p[0]; /* mass of the bead [kg] */
    const double Omega = p[1]; /* rate of the rod [rad/s] */

    /* parameters only */
    const double k1 = Omega * Omega;

    /* state */
    return m * (0.5 * (r_dot * r_dot) + 0.5 * (k1 * (r * r)));
}

int bead_on_rod_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    (void)y;
    const double m = p[0]; /* mass of the bead [kg] */
    const double Omega = p[1]; /* rate of the rod [rad/s] */

    /* state */
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return BEAD_ON_ROD_SINGULAR_2;
    }
    /* (II.3) */
    J[0] = 0.0;
    J[1] = 1.0;
    J[2] = Omega * Omega;
    J[3] = 0.0;
    return bead_on_rod_finish(4, J);
}

int bead_on_rod_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double r = y[0]; /* distance from the axis [m] */
    const double r_dot = y[1];
    const double m = p[0]; /* mass of the bead [kg] */
    const double Omega = p[1]; /* rate of the rod [rad/s] */

    /* parameters only */
    const double k1 = Omega * Omega;
    const double k2 = m * Omega;

    /* state */
    /* 16:11 */
    out[0] = 0.5 * (m * (r_dot * r_dot - k1 * (r * r))); /* jacobi */
    /* 17:11 */
    out[1] = 2.0 * (r_dot * (r * k2)); /* torque */
    return bead_on_rod_finish(2, out);
}

int bead_on_rod_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0]; /* mass of the bead [kg] */
    const double Omega = p[1]; /* rate of the rod [rad/s] */
    const double k1 = Omega * Omega;
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return BEAD_ON_ROD_SINGULAR_2;
    }
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double r = y[i]; /* distance from the axis [m] */
        const double r_dot = y[count + i];
        /* (II.3) */
        const double slope1 = r_dot; /* r' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        /* (II.3) 14:4 */
        const double slope2 = r * k1; /* r'' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
    }
    return bad ? BEAD_ON_ROD_NOT_FINITE : BEAD_ON_ROD_OK;
}
