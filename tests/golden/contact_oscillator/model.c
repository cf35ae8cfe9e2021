/*
 * contact_oscillator.c: contact_oscillator, emitted by nhc 0.1.0 (nhc:c04662270c1b6aa7)
 * Three equal oscillators with one contact constraint; reversible and integrable.
 * Source: contact_oscillator.yaml
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x`
 * contact_oscillator.h says what each function does.
 */
#include "contact_oscillator.h"

#include <float.h>
#include <math.h>

const char *const contact_oscillator_coordinate_names[] = {
    "x",
    "y",
    "z"
};
const char *const contact_oscillator_state_names[] = {
    "x",
    "y",
    "z",
    "y'",
    "z'"
};
const char *const contact_oscillator_parameter_names[] = {
    /* no entry counts: C99 has no empty array */
    ""
};
const double contact_oscillator_parameter_defaults[] = {
    /* no entry counts: C99 has no empty array */
    0.0
};

static int contact_oscillator_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? CONTACT_OSCILLATOR_OK : CONTACT_OSCILLATOR_NOT_FINITE;
}

int contact_oscillator_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double y_dot = y[3];
    const double z_dot = y[4];

    /* state */
    const double z1 = 1.0 + y_2 * y_2;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CONTACT_OSCILLATOR_SINGULAR_2;
    }
    /* (III.3) */
    dydt[0] = -y_2 * z_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = z_dot; /* z' */
    /* (III.3) 7:4 */
    dydt[3] = -y_2; /* y'' */
    dydt[4] = -(z - y_2 * (x - y_dot * z_dot)) / z1; /* z'' */
    return contact_oscillator_finish(5, dydt);
}

int contact_oscillator_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double y_2 = y[1];
    const double y_dot = y[3];
    const double z_dot = y[4];

    /* state */
    /* (I.2.4) */
    qdot[0] = -y_2 * z_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = z_dot; /* z' */
    return contact_oscillator_finish(3, qdot);
}

int contact_oscillator_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double y_dot = y[3];
    const double z_dot = y[4];

    /* state */
    const double z1 = 1.0 + y_2 * y_2;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CONTACT_OSCILLATOR_SINGULAR_2;
    }
    const double z2 = y_dot * z_dot;
    const double z3 = (z - y_2 * (x - z2)) / z1;
    /* (III.3) */
    qddot[0] = y_2 * z3 - z2; /* x'' */
    qddot[1] = -y_2; /* y'' */
    qddot[2] = -z3; /* z'' */
    return contact_oscillator_finish(3, qddot);
}

int contact_oscillator_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0];
    const double y_2 = q[1];
    const double z = q[2];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = y_dot;
    y[4] = z_dot;
    return contact_oscillator_finish(5, y);
}

int contact_oscillator_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)p;
    const double y = q[1];
    const double x_dot = qdot[0];
    const double z_dot = qdot[2];

    /* state */
    /* (I.1.1) 10:5 */
    r[0] = x_dot + y * z_dot; /* contact = 0 */
    return contact_oscillator_finish(1, r);
}

int contact_oscillator_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double y_dot = y[3];
    const double z_dot = y[4];

    /* state */
    const double z1 = 1.0 + y_2 * y_2;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CONTACT_OSCILLATOR_SINGULAR_2;
    }
    const double z2 = x - y_dot * z_dot;
    /* (I.4.1) 10:5 */
    lambda[0] = z2 + y_2 * ((z - y_2 * z2) / z1); /* reaction of contact: Q_i gains lambda_1 a_1i */
    return contact_oscillator_finish(1, lambda);
}

double contact_oscillator_energy(double t, const double *y, const double *p)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double y_dot = y[3];
    const double z_dot = y[4];

    /* state */
    const double z1 = y_2 * z_dot;
    const double z2 = 0.5 * (x * x + y_2 * y_2 + z * z) + 0.5 * (z_dot * z_dot + (y_dot * y_dot + z1 * z1));
    return z2;
}

int contact_oscillator_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double y_dot = y[3];
    const double z_dot = y[4];

    /* state */
    const double z1 = 1.0 + y_2 * y_2;
    /* the mass matrix is singular */
    if (!(fabs(z1) > 0.0)) {
        return CONTACT_OSCILLATOR_SINGULAR_2;
    }
    const double z2 = 1.0 / z1;
    const double z3 = x - y_dot * z_dot;
    /* (III.3) */
    J[0] = 0.0;
    J[1] = -z_dot;
    J[2] = 0.0;
    J[3] = 0.0;
    J[4] = -y_2;
    J[5] = 0.0;
    J[6] = 0.0;
    J[7] = 0.0;
    J[8] = 1.0;
    J[9] = 0.0;
    J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 1.0;
    J[15] = 0.0;
    J[16] = -1.0;
    J[17] = 0.0;
    J[18] = 0.0;
    J[19] = 0.0;
    J[20] = y_2 * z2;
    J[21] = z2 * (z3 + 2.0 * (y_2 * ((z - y_2 * z3) * z2)));
    J[22] = -z2;
    J[23] = -y_2 * z_dot * z2;
    J[24] = -z2 * (y_2 * y_dot);
    return contact_oscillator_finish(25, J);
}

int contact_oscillator_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double x = y[0];
    const double y_2 = y[1];
    const double z = y[2];
    const double y_dot = y[3];
    const double z_dot = y[4];

    /* state */
    const double z1 = y_2 * y_2;
    /* 13:8 */
    out[0] = 0.5 * (y_dot * y_dot + z1); /* H_y */
    /* 14:6 */
    out[1] = 0.5 * (x * x + z * z + z_dot * z_dot * (1.0 + z1)); /* R */
    return contact_oscillator_finish(2, out);
}

int contact_oscillator_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
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
        const double y_2 = y[count + i];
        const double z = y[2 * count + i];
        const double y_dot = y[3 * count + i];
        const double z_dot = y[4 * count + i];
        const double z1 = 1.0 + y_2 * y_2;
        /* the mass matrix is singular */
        singular1 |= !(fabs(z1) > 0.0);
        /* (III.3) */
        const double slope1 = -y_2 * z_dot; /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = y_dot; /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z_dot; /* z' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        /* (III.3) 7:4 */
        const double slope4 = -y_2; /* y'' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = -(z - y_2 * (x - y_dot * z_dot)) / z1; /* z'' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
    }
    if (singular1) {
        return CONTACT_OSCILLATOR_SINGULAR_2;
    }
    return bad ? CONTACT_OSCILLATOR_NOT_FINITE : CONTACT_OSCILLATOR_OK;
}
