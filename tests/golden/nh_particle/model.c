/*
 * nh_particle.c: nh_particle, emitted by nhc 0.1.0 (nhc:435b87c863a0818d)
 * A free particle with one velocity constraint that cannot be integrated.
 * Source: nh_particle.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * nh_particle.h says what each function does.
 */
#include "nh_particle.h"

#include <float.h>
#include <math.h>

const char *const nh_particle_coordinate_names[] = {
    "x",
    "y",
    "z"
};
const char *const nh_particle_state_names[] = {
    "x",
    "y",
    "z",
    "x'",
    "y'"
};
const char *const nh_particle_parameter_names[] = {
    "m"
};
const double nh_particle_parameter_defaults[] = {
    1.0
};

static int nh_particle_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? NH_PARTICLE_OK : NH_PARTICLE_NOT_FINITE;
}

int nh_particle_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double m = p[0];

    /* state */
    const double z1 = m + y_2 * (y_2 * m);
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    /* (III.3) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = y_2 * x_dot; /* z' */
    /* (III.3) 9:4 */
    dydt[3] = -y_2 * (m * (x_dot * y_dot)) / z1; /* x'' */
    dydt[4] = 0.0; /* y'' */
    return nh_particle_finish(5, dydt);
}

int nh_particle_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];

    /* state */
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = y_2 * x_dot; /* z' */
    return nh_particle_finish(3, qdot);
}

int nh_particle_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double m = p[0];

    /* state */
    const double z1 = m + y_2 * (y_2 * m);
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    const double z2 = x_dot * y_dot;
    const double z3 = y_2 * (m * z2) / z1;
    /* (III.3) */
    qddot[0] = -z3; /* x'' */
    qddot[1] = 0.0; /* y'' */
    qddot[2] = z2 - y_2 * z3; /* z'' */
    return nh_particle_finish(3, qddot);
}

int nh_particle_state(double t, const double *q, const double *qdot, const double *p, double *y)
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
    return nh_particle_finish(5, y);
}

int nh_particle_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double y = q[1];
    const double x_dot = qdot[0];
    const double z_dot = qdot[2];

    /* state */
    /* (I.1.1) 11:5 */
    r[0] = z_dot - y * x_dot; /* contact = 0 */
    return nh_particle_finish(1, r);
}

int nh_particle_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double m = p[0];

    /* state */
    const double z1 = y_2 * m;
    const double z2 = m + y_2 * z1;
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    const double z3 = m * (x_dot * y_dot);
    /* (I.4.1) 11:5 */
    lambda[0] = z3 - z1 * (y_2 * z3 / z2); /* reaction of contact: Q_i gains lambda_1 a_1i */
    return nh_particle_finish(1, lambda);
}

double nh_particle_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double m = p[0];

    /* state */
    const double z1 = y_2 * x_dot;
    return 0.5 * (m * (x_dot * x_dot + y_dot * y_dot + z1 * z1));
}

int nh_particle_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double y_dot = y[4];
    const double m = p[0];

    /* state */
    const double z1 = y_2 * m;
    const double z2 = m + y_2 * z1;
    /* the mass matrix is singular */
    if (!(fabs(z2) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    const double z3 = 1.0 / z2;
    const double z4 = m * (x_dot * y_dot);
    const double z5 = y_2 * z4 * z3;
    /* (III.3) */
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
    J[10] = 0.0;
    J[11] = x_dot;
    J[12] = 0.0;
    J[13] = y_2;
    J[14] = 0.0;
    J[15] = 0.0;
    J[16] = -z3 * (z4 - z1 * z5 - m * (y_2 * z5));
    J[17] = 0.0;
    J[18] = -z3 * (y_dot * z1);
    J[19] = -z3 * (x_dot * z1);
    J[20] = 0.0;
    J[21] = 0.0;
    J[22] = 0.0;
    J[23] = 0.0;
    J[24] = 0.0;
    return nh_particle_finish(25, J);
}

int nh_particle_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double y_2 = y[1];
    const double x_dot = y[3];
    const double m = p[0];

    /* state */
    /* 14:8 */
    out[0] = m * (x_dot + y_2 * (y_2 * x_dot)); /* p_x */
    return nh_particle_finish(1, out);
}

int nh_particle_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict
    dydt)
{
    const double m = p[0];
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return NH_PARTICLE_SINGULAR_2;
    }
    int singular1 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double y_2 = y[count + i];
        const double x_dot = y[3 * count + i];
        const double y_dot = y[4 * count + i];
        const double z1 = m + y_2 * (y_2 * m);
        /* the mass matrix is singular */
        singular1 |= !(fabs(z1) > 0.0);
        /* (III.3) */
        const double slope1 = x_dot; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = y_dot; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = y_2 * x_dot; /* z' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (III.3) 9:4 */
        const double slope4 = -y_2 * (m * (x_dot * y_dot)) / z1; /* x'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = 0.0; /* y'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    if (singular1) {
        return NH_PARTICLE_SINGULAR_2;
    }
    return bad ? NH_PARTICLE_NOT_FINITE : NH_PARTICLE_OK;
}
