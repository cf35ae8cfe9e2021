/*
 * smooth_tippe_top.c: smooth_tippe_top, emitted by nhc 0.1.0 (nhc:d84f0735b30b9c43)
 * The ball of routh_sphere on a plane without any friction.
 * Source: smooth_tippe_top.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 * smooth_tippe_top.h says what each function does.
 */
#include "smooth_tippe_top.h"

#include <float.h>
#include <math.h>
#include <string.h>

const char *const smooth_tippe_top_coordinate_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi"
};
const char *const smooth_tippe_top_state_names[] = {
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "x'",
    "y'",
    "phi'",
    "theta'",
    "psi'"
};
const char *const smooth_tippe_top_parameter_names[] = {
    "m",
    "R",
    "e",
    "I1",
    "I3",
    "g"
};
const double smooth_tippe_top_parameter_defaults[] = {
    1.0,
    1.0,
    -0.2,
    0.38,
    0.42,
    9.81
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define SMOOTH_TIPPE_TOP_SLOW __attribute__((cold, optimize("O1")))
#else
#define SMOOTH_TIPPE_TOP_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* it is seldom called, and would cost its callers registers */
#endif
static int smooth_tippe_top_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return SMOOTH_TIPPE_TOP_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return SMOOTH_TIPPE_TOP_NOT_FINITE;
        }
    }
    return SMOOTH_TIPPE_TOP_OK;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef SMOOTH_TIPPE_TOP_LANES
#if !defined(__GNUC__)
#define SMOOTH_TIPPE_TOP_LANES 1
#elif defined(__AVX512F__)
#define SMOOTH_TIPPE_TOP_LANES 8
#elif defined(__AVX__)
#define SMOOTH_TIPPE_TOP_LANES 4
#else
#define SMOOTH_TIPPE_TOP_LANES 2
#endif
#endif
#if SMOOTH_TIPPE_TOP_LANES > 1
typedef double smooth_tippe_top_lanes __attribute__((vector_size(8 * SMOOTH_TIPPE_TOP_LANES)));
#else
typedef double smooth_tippe_top_lanes;
#endif

#if SMOOTH_TIPPE_TOP_LANES >= 2
static inline smooth_tippe_top_lanes smooth_tippe_top_get(const double *from)
{
    smooth_tippe_top_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void smooth_tippe_top_put(double *to, smooth_tippe_top_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int smooth_tippe_top_one_by_one(size_t count, size_t first, size_t number, const double *t, const double *y, const double *p, double *dydt)
{
    int status = SMOOTH_TIPPE_TOP_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[SMOOTH_TIPPE_TOP_NY];
        double slope[SMOOTH_TIPPE_TOP_NY];
        for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = NAN;
        }
        const int one = smooth_tippe_top_rhs(t[i], state, p, slope);
        status = status == SMOOTH_TIPPE_TOP_OK ? one : status;
        for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if SMOOTH_TIPPE_TOP_LANES >= 2
#define SMOOTH_TIPPE_TOP_SPREAD(x) ((x) - (smooth_tippe_top_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long smooth_tippe_top_bits __attribute__((vector_size(8 * SMOOTH_TIPPE_TOP_LANES)));

/* all bits where value is not above bound, or is no number */
static inline smooth_tippe_top_bits smooth_tippe_top_misses(smooth_tippe_top_lanes value, smooth_tippe_top_lanes bound)
{
    return ~(smooth_tippe_top_bits)(value > bound);
}

/* no number where a bit is set */
static inline smooth_tippe_top_lanes smooth_tippe_top_mark(smooth_tippe_top_lanes value, smooth_tippe_top_bits bad)
{
    return (smooth_tippe_top_lanes)((smooth_tippe_top_bits)value | bad);
}

static inline smooth_tippe_top_lanes smooth_tippe_top_size(smooth_tippe_top_lanes x)
{
    return (smooth_tippe_top_lanes)((smooth_tippe_top_bits)x & 0x7fffffffffffffffULL);
}
/* whether none of the states must be asked again: no singular block, no infinity, no angle anywhere near 1e5 */
static inline int smooth_tippe_top_is_good(int count, const double *check)
{
    double sum = check[0] + check[1];
    int k = 2;
    if (count >= 8) { /* pairs of pairs: sums that need not wait for one another */
        sum = (sum + (check[2] + check[3])) + ((check[4] + check[5]) + (check[6] + check[7]));
        k = 8;
    }
    for (; k < count; k += 2) {
        sum += check[k] + check[k + 1];
    }
    return sum <= 1e10;
}

/* the last states, fewer than there are lanes; the others repeat the last one */
static inline void smooth_tippe_top_fill(size_t left, size_t count, const double *t, const double *y, double *time, double *state)
{
    for (size_t l = 0; l < SMOOTH_TIPPE_TOP_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
            state[k * SMOOTH_TIPPE_TOP_LANES + l] = y[k * count + i];
        }
    }
}

static inline void smooth_tippe_top_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < SMOOTH_TIPPE_TOP_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * SMOOTH_TIPPE_TOP_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void smooth_tippe_top_turn_lanes(smooth_tippe_top_lanes x, smooth_tippe_top_lanes *far, smooth_tippe_top_lanes *sine, smooth_tippe_top_lanes *cosine)
{
    double angle[SMOOTH_TIPPE_TOP_LANES];
    double up[SMOOTH_TIPPE_TOP_LANES];
    double along[SMOOTH_TIPPE_TOP_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < SMOOTH_TIPPE_TOP_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}
#endif

int smooth_tippe_top_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = I1 + m * (e * e);
    const double k3 = I3 - k2;
    const double k4 = g * k1;
    const double k5 = 1.0 / m;

    /* state */
    const double z1 = I3 - s_theta * s_theta * k3;
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double z4 = z3 * k5;
    const double z5 = s_phi * z2;
    const double z6 = z5 * k5;
    const double z7 = z1 - z3 * z4 - z5 * z6;
    const double z8 = c_theta * k1;
    const double z9 = s_phi * z8;
    const double z10 = k5 * z9;
    const double z11 = c_phi * z8;
    const double z12 = k5 * z11;
    const double z13 = z3 * z10 - z5 * z12;
    const double z14 = 1.0 / z7;
    const double z15 = z14 * z13;
    const double z16 = k2 - z9 * z10 - z11 * z12 - z13 * z15;
    const double z17 = I3 * c_theta;
    const double z18 = z17 * z14;
    const double z19 = z18 * z13;
    const double z20 = 1.0 / z16;
    const double z21 = z19 * z20;
    const double z22 = I3 - z17 * z18 - z19 * z21;
    const double z23 = s_theta * theta_dot * theta_dot;
    const double z24 = phi_dot * s_theta;
    const double z25 = theta_dot * c_theta;
    const double z26 = k1 * (s_phi * z23 + phi_dot * (s_phi * z24 - 2.0 * (c_phi * z25)));
    const double z27 = phi_dot * c_theta * k3;
    const double z28 = psi_dot * I3;
    const double z29 = k1 * (c_phi * z23 + phi_dot * (c_phi * z24 + 2.0 * (s_phi * z25)));
    const double z30 = theta_dot * s_theta * (2.0 * z27 + z28) - z4 * z26 + z6 * z29;
    const double z31 = s_theta * (phi_dot * (z27 + z28) - k4) + z26 * z10 + z29 * z12 - z15 * z30;
    const double z32 = (I3 * (theta_dot * z24) - z18 * z30 + z21 * z31) / z22;
    const double z33 = z20 * z31 + z21 * z32;
    const double z34 = z14 * z30 - z15 * z33 - z18 * z32;
    /* (II.3) */
    dydt[0] = x_dot; /* x' */
    dydt[1] = y_dot; /* y' */
    dydt[2] = phi_dot; /* phi' */
    dydt[3] = theta_dot; /* theta' */
    dydt[4] = psi_dot; /* psi' */
    /* (II.3) 24:4 */
    dydt[5] = k5 * z26 - z4 * z34 + z10 * z33; /* x'' */
    dydt[6] = -(k5 * z29 + z6 * z34 + z12 * z33); /* y'' */
    dydt[7] = z34; /* phi'' */
    dydt[8] = -z33; /* theta'' */
    dydt[9] = z32; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[5] + dydt[6] + dydt[8]) <= DBL_MAX
        && fabs(z7) > 1e-14 * z1
        && fabs(z16) > 1e-14 * k2
        && fabs(z22) > 1e-14 * I3)) {
        /* the mass matrix is singular */
        if (!(fabs(m) > 0.0)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z7) > 1e-14 * z1)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * k2)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * I3)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        return smooth_tippe_top_finish(10, dydt);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    (void)p;
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];

    /* state */
    /* (I.2.4) */
    qdot[0] = x_dot; /* x' */
    qdot[1] = y_dot; /* y' */
    qdot[2] = phi_dot; /* phi' */
    qdot[3] = theta_dot; /* theta' */
    qdot[4] = psi_dot; /* psi' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4]) <= DBL_MAX)) {
        return smooth_tippe_top_finish(5, qdot);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

SMOOTH_TIPPE_TOP_SLOW
int smooth_tippe_top_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = I1 + m * (e * e);
    const double k3 = I3 - k2;
    const double k4 = g * k1;
    const double k5 = 1.0 / m;

    /* state */
    const double z1 = I3 - s_theta * s_theta * k3;
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double z4 = z3 * k5;
    const double z5 = s_phi * z2;
    const double z6 = z5 * k5;
    const double z7 = z1 - z3 * z4 - z5 * z6;
    const double z8 = c_theta * k1;
    const double z9 = s_phi * z8;
    const double z10 = k5 * z9;
    const double z11 = c_phi * z8;
    const double z12 = k5 * z11;
    const double z13 = z3 * z10 - z5 * z12;
    const double z14 = 1.0 / z7;
    const double z15 = z14 * z13;
    const double z16 = k2 - z9 * z10 - z11 * z12 - z13 * z15;
    const double z17 = I3 * c_theta;
    const double z18 = z17 * z14;
    const double z19 = z18 * z13;
    const double z20 = 1.0 / z16;
    const double z21 = z19 * z20;
    const double z22 = I3 - z17 * z18 - z19 * z21;
    const double z23 = s_theta * theta_dot * theta_dot;
    const double z24 = phi_dot * s_theta;
    const double z25 = theta_dot * c_theta;
    const double z26 = k1 * (s_phi * z23 + phi_dot * (s_phi * z24 - 2.0 * (c_phi * z25)));
    const double z27 = phi_dot * c_theta * k3;
    const double z28 = psi_dot * I3;
    const double z29 = k1 * (c_phi * z23 + phi_dot * (c_phi * z24 + 2.0 * (s_phi * z25)));
    const double z30 = theta_dot * s_theta * (2.0 * z27 + z28) - z4 * z26 + z6 * z29;
    const double z31 = s_theta * (phi_dot * (z27 + z28) - k4) + z26 * z10 + z29 * z12 - z15 * z30;
    const double z32 = (I3 * (theta_dot * z24) - z18 * z30 + z21 * z31) / z22;
    const double z33 = z20 * z31 + z21 * z32;
    const double z34 = z14 * z30 - z15 * z33 - z18 * z32;
    /* (II.3) */
    qddot[0] = k5 * z26 - z4 * z34 + z10 * z33; /* x'' */
    qddot[1] = -(k5 * z29 + z6 * z34 + z12 * z33); /* y'' */
    qddot[2] = z34; /* phi'' */
    qddot[3] = -z33; /* theta'' */
    qddot[4] = z32; /* psi'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[3]) <= DBL_MAX
        && fabs(z7) > 1e-14 * z1
        && fabs(z16) > 1e-14 * k2
        && fabs(z22) > 1e-14 * I3)) {
        /* the mass matrix is singular */
        if (!(fabs(m) > 0.0)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z7) > 1e-14 * z1)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z16) > 1e-14 * k2)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z22) > 1e-14 * I3)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        return smooth_tippe_top_finish(5, qddot);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* geometric centre [m] */
    const double y_2 = q[1]; /* geometric centre [m] */
    const double phi = q[2]; /* precession [rad] */
    const double theta = q[3]; /* nutation [rad] */
    const double psi = q[4]; /* spin [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double phi_dot = qdot[2];
    const double theta_dot = qdot[3];
    const double psi_dot = qdot[4];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = phi;
    y[3] = theta;
    y[4] = psi;
    y[5] = x_dot;
    y[6] = y_dot;
    y[7] = phi_dot;
    y[8] = theta_dot;
    y[9] = psi_dot;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5] + y[6] + y[7] + y[8] + y[9]) <= DBL_MAX)) {
        return smooth_tippe_top_finish(10, y);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    (void)q;
    (void)qdot;
    (void)p;
    (void)r;
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = I1 + m * (e * e);
    const double k3 = I3 - k2;
    const double k4 = 1.0 / m;

    /* state */
    const double z1 = I3 - s_theta * s_theta * k3;
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double z4 = s_phi * z2;
    const double z5 = z1 - k4 * (z3 * z3) - k4 * (z4 * z4);
    const double z6 = c_theta * k1;
    const double z7 = s_phi * z6;
    const double z8 = k4 * z7;
    const double z9 = c_phi * z6;
    const double z10 = k4 * z9;
    const double z11 = 1.0 / z5;
    const double z12 = z3 * z8 - z4 * z10;
    const double z13 = k2 - z7 * z8 - z9 * z10 - z11 * (z12 * z12);
    const double z14 = I3 * c_theta;
    const double z15 = z14 * z11;
    const double z16 = z12 * z15;
    /* the mass matrix is singular */
    if (!(fabs(m) > 0.0)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z5) > 1e-14 * z1)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z13) > 1e-14 * k2)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(I3 - z14 * z15 - z16 * z16 / z13) > 1e-14 * I3)) {
        return SMOOTH_TIPPE_TOP_SINGULAR_2;
    }
    (void)lambda;
    return SMOOTH_TIPPE_TOP_OK;
}

double smooth_tippe_top_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double c_theta = cos(theta);
    const double s_theta = sin(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = e * (m * g);

    /* state */
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z1 = theta_dot * e;
    const double z2 = c_theta * z1;
    const double z3 = phi_dot * (e * s_theta);
    const double X_dot = x_dot + (s_phi * z2 + c_phi * z3);
    const double Y_dot = y_dot - (c_phi * z2 - s_phi * z3);
    const double z4 = s_theta * z1;
    const double z5 = I1 * (theta_dot * theta_dot + s_theta * s_theta * (phi_dot * phi_dot)) + m * (X_dot *
        X_dot + Y_dot * Y_dot + z4 * z4);
    return 0.5 * (I3 * (omega3 * omega3) + z5) + c_theta * k1;
}

SMOOTH_TIPPE_TOP_SLOW
int smooth_tippe_top_jacobian(double t, const double *y, const double *p, double *J)
{
    for (int entry = 0; entry < 100; ++entry) {
        J[entry] = 0.0;
    }
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double c_phi = cos(phi);
    const double s_phi = sin(phi);
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */

    /* parameters only */
    const double k1 = m * e;
    const double k2 = I1 + m * (e * e);
    const double k3 = I3 - k2;
    const double k4 = g * k1;
    const double k5 = 1.0 / m;

    /* state */
    const double z1 = I3 - s_theta * s_theta * k3;
    const double z2 = s_theta * k1;
    const double z3 = c_phi * z2;
    const double z4 = z3 * k5;
    const double z5 = s_phi * z2;
    const double z6 = z5 * k5;
    const double z7 = z1 - z3 * z4 - z5 * z6;
    const double z8 = s_phi * k1;
    const double z9 = c_theta * z8;
    const double z10 = z9 * k5;
    const double z11 = c_phi * k1;
    const double z12 = c_theta * z11;
    const double z13 = z12 * k5;
    const double z14 = z3 * z10 - z5 * z13;
    const double z15 = 1.0 / z7;
    const double z16 = z14 * z15;
    const double z17 = k2 - z9 * z10 - z12 * z13 - z14 * z16;
    const double z18 = I3 * c_theta;
    const double z19 = z18 * z15;
    const double z20 = z14 * z19;
    const double z21 = 1.0 / z17;
    const double z22 = z20 * z21;
    const double z23 = I3 - z18 * z19 - z20 * z22;
    const double z24 = phi_dot * k1;
    const double z25 = c_theta * z24;
    const double z26 = theta_dot * s_theta;
    const double z27 = phi_dot * c_theta * k3;
    const double z28 = psi_dot * I3;
    const double z29 = 2.0 * z27 + z28;
    const double z30 = phi_dot * s_theta;
    const double z31 = theta_dot * c_phi;
    const double z32 = s_phi * z30 - 2.0 * (c_theta * z31);
    const double z33 = theta_dot * theta_dot;
    const double z34 = s_theta * z33;
    const double z35 = k1 * (phi_dot * z32 + s_phi * z34);
    const double z36 = theta_dot * s_phi;
    const double z37 = c_phi * z30 + 2.0 * (c_theta * z36);
    const double z38 = k1 * (phi_dot * z37 + c_phi * z34);
    const double z39 = z26 * z29 - z35 * z4 + z38 * z6;
    const double z40 = z27 + z28;
    const double z41 = phi_dot * z40 - k4;
    const double z42 = s_theta * z41 + z35 * z10 + z38 * z13 - z16 * z39;
    const double z43 = 1.0 / z23;
    const double z44 = I3 * (phi_dot * theta_dot);
    const double z45 = z43 * (s_theta * z44 - z19 * z39 + z22 * z42);
    const double z46 = z21 * z42 + z22 * z45;
    const double z47 = z15 * z39 - z16 * z46 - z19 * z45;
    const double z48 = 2.0 * (theta_dot * z25) + z2 * z47;
    const double z49 = k1 * z34 + z30 * z24 + k1 * (c_theta * z46);
    const double z50 = s_phi * z48 + c_phi * z49;
    const double z51 = s_phi * z49 - c_phi * z48;
    const double z52 = z35 * k5 - z4 * z47 + z10 * z46;
    const double z53 = z38 * k5 + z6 * z47 + z13 * z46;
    const double z54 = z6 * z51 + (z4 * z50 - (z5 * z52 + z3 * z53));
    const double z55 = z13 * z51 - (z10 * z50 - (z9 * z53 - z12 * z52)) - z16 * z54;
    const double z56 = z43 * (z19 * z54 - z22 * z55);
    const double z57 = z21 * z55 - z22 * z56;
    const double z58 = z15 * z54 - z16 * z57 + z19 * z56;
    const double z59 = s_phi * z24;
    const double z60 = s_theta * (2.0 * (z31 * z24) - z8 * z46) + c_theta * (phi_dot * z59 + (z33 * z8 - z11
        * z47));
    const double z61 = z26 * k3;
    const double z62 = c_theta * (theta_dot * z29 + (k1 * (s_phi * z53 - c_phi * z52) + 2.0 * (k3 * (s_theta
        * z47))));
    const double z63 = c_phi * z24;
    const double z64 = s_theta * (2.0 * (z36 * z24) + z11 * z46) - c_theta * (phi_dot * z63 + (z33 * z11 + z8
        * z47));
    const double z65 = s_theta * (2.0 * (phi_dot * z61) - I3 * z45) - z62 + z4 * z60 + z6 * z64;
    const double z66 = z30 * k3;
    const double z67 = c_theta * z41 - s_theta * (phi_dot * z66 + (z11 * z53 + z8 * z52)) + z10 * z60 - z13 *
        z64;
    const double z68 = z67 + z16 * z65;
    const double z69 = I3 * s_theta;
    const double z70 = z43 * (c_theta * z44 + z69 * z47 + z19 * z65 + z22 * z68);
    const double z71 = z21 * z68 + z22 * z70;
    const double z72 = z15 * z65 + z16 * z71 + z19 * z70;
    const double z73 = k1 * z32 + s_theta * z59;
    const double z74 = k1 * z37 + s_theta * z63;
    const double z75 = 2.0 * (c_theta * z61) - z4 * z73 + z6 * z74;
    const double z76 = s_theta * z40 + c_theta * z66 + z10 * z73 + z13 * z74 - z16 * z75;
    const double z77 = z43 * (theta_dot * z69 - z19 * z75 + z22 * z76);
    const double z78 = z21 * z76 + z22 * z77;
    const double z79 = z15 * z75 - z16 * z78 - z19 * z77;
    const double z80 = c_phi * z25 - z26 * z8;
    const double z81 = s_phi * z25 + z26 * z11;
    const double z82 = s_theta * z29 + 2.0 * (z4 * z80) + 2.0 * (z6 * z81);
    const double z83 = 2.0 * (z10 * z80 - z13 * z81) + z16 * z82;
    const double z84 = z43 * (phi_dot * z69 - z19 * z82 - z22 * z83);
    const double z85 = z21 * z83 - z22 * z84;
    const double z86 = z15 * z82 + z16 * z85 - z19 * z84;
    const double z87 = I3 * z26;
    const double z88 = I3 * z30 - z16 * z87;
    const double z89 = z43 * (z19 * z87 - z22 * z88);
    const double z90 = z21 * z88 - z22 * z89;
    const double z91 = z15 * z87 - z16 * z90 + z19 * z89;
    /* (II.3) */
    J[5] = 1.0;
    J[16] = 1.0;
    J[27] = 1.0;
    J[38] = 1.0;
    J[49] = 1.0;
    J[52] = k5 * z50 + z4 * z58 - z10 * z57;
    J[53] = k5 * z60 + z4 * z72 + z10 * z71;
    J[57] = k5 * z73 - z4 * z79 + z10 * z78;
    J[58] = -(2.0 * (k5 * z80) + z4 * z86 + z10 * z85);
    J[59] = z10 * z90 - z4 * z91;
    J[62] = k5 * z51 + z6 * z58 + z13 * z57;
    J[63] = k5 * z64 + z6 * z72 - z13 * z71;
    J[67] = -(k5 * z74 + z6 * z79 + z13 * z78);
    J[68] = z13 * z85 - (2.0 * (k5 * z81) + z6 * z86);
    J[69] = -(z6 * z91 + z13 * z90);
    J[72] = -z58;
    J[73] = -z72;
    J[77] = z79;
    J[78] = z86;
    J[79] = z91;
    J[82] = z57;
    J[83] = -z71;
    J[87] = -z78;
    J[88] = z85;
    J[89] = -z90;
    J[92] = z56;
    J[93] = z70;
    J[97] = z77;
    J[98] = z84;
    J[99] = -z89;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(J[52] + J[53] + J[57] + J[58] + J[59] + J[62] + J[63] + J[67] + J[68] + J[69] + J[72] + J[73]
        + J[83] + J[87] + J[89] + J[99]) <= DBL_MAX
        && fabs(z7) > 1e-14 * z1
        && fabs(z17) > 1e-14 * k2
        && fabs(z23) > 1e-14 * I3)) {
        /* the mass matrix is singular */
        if (!(fabs(m) > 0.0)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z7) > 1e-14 * z1)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z17) > 1e-14 * k2)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z23) > 1e-14 * I3)) {
            return SMOOTH_TIPPE_TOP_SINGULAR_2;
        }
        return smooth_tippe_top_finish(100, J);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

int smooth_tippe_top_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double phi = y[2]; /* precession [rad] */
    const double theta = y[3]; /* nutation [rad] */

    /* sines and cosines */
    const double s_theta = sin(theta);
    const double c_theta = cos(theta);
    const double s_phi = sin(phi);
    const double c_phi = cos(phi);
    const double x_dot = y[5];
    const double y_dot = y[6];
    const double phi_dot = y[7];
    const double theta_dot = y[8];
    const double psi_dot = y[9];
    const double m = p[0]; /* mass [kg] */
    const double R = p[1]; /* radius [m] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */

    /* parameters only */
    const double k1 = R * I1;

    /* state */
    const double omega3 = psi_dot + phi_dot * c_theta;
    const double z1 = e * (theta_dot * c_theta);
    const double z2 = phi_dot * (e * s_theta);
    /* 27:12 */
    out[0] = k1 * (phi_dot * (s_theta * s_theta)) + I3 * (omega3 * (e + R * c_theta)); /* jellett */
    /* 28:9 */
    out[1] = omega3; /* spin */
    /* 29:8 */
    out[2] = m * (x_dot + (s_phi * z1 + c_phi * z2)); /* p_x */
    /* 30:8 */
    out[3] = m * (y_dot - (c_phi * z1 - s_phi * z2)); /* p_y */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[2] + out[3]) <= DBL_MAX)) {
        return smooth_tippe_top_finish(4, out);
    }
    return SMOOTH_TIPPE_TOP_OK;
}

#if SMOOTH_TIPPE_TOP_LANES >= 2
static __attribute__((noinline)) void smooth_tippe_top_rhs_lanes(const double *fixed, size_t stride, const
    double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    smooth_tippe_top_lanes far = {0}; /* the squares of the angles */
    smooth_tippe_top_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    smooth_tippe_top_bits bad = {0}; /* singular blocks */
    const double I3 = fixed[0];
    const double k1 = fixed[1];
    const double k2 = fixed[2];
    const double k3 = fixed[3];
    const double k4 = fixed[4];
    const double k5 = fixed[5];
    const smooth_tippe_top_lanes phi = smooth_tippe_top_get(y + 2 * stride);
    const smooth_tippe_top_lanes theta = smooth_tippe_top_get(y + 3 * stride);
    const smooth_tippe_top_lanes x_dot = smooth_tippe_top_get(y + 5 * stride);
    const smooth_tippe_top_lanes y_dot = smooth_tippe_top_get(y + 6 * stride);
    const smooth_tippe_top_lanes phi_dot = smooth_tippe_top_get(y + 7 * stride);
    const smooth_tippe_top_lanes theta_dot = smooth_tippe_top_get(y + 8 * stride);
    const smooth_tippe_top_lanes psi_dot = smooth_tippe_top_get(y + 9 * stride);
    smooth_tippe_top_lanes sine1, cosine1;
    smooth_tippe_top_turn_lanes(SMOOTH_TIPPE_TOP_SPREAD(theta), &far, &sine1, &cosine1);
    const smooth_tippe_top_lanes s_theta = sine1;
    const smooth_tippe_top_lanes z1 = I3 - s_theta * s_theta * k3;
    smooth_tippe_top_lanes sine2, cosine2;
    smooth_tippe_top_turn_lanes(SMOOTH_TIPPE_TOP_SPREAD(phi), &far, &sine2, &cosine2);
    const smooth_tippe_top_lanes c_phi = cosine2;
    const smooth_tippe_top_lanes z2 = s_theta * k1;
    const smooth_tippe_top_lanes z3 = c_phi * z2;
    const smooth_tippe_top_lanes z4 = z3 * k5;
    const smooth_tippe_top_lanes s_phi = sine2;
    const smooth_tippe_top_lanes z5 = s_phi * z2;
    const smooth_tippe_top_lanes z6 = z5 * k5;
    const smooth_tippe_top_lanes z7 = z1 - z3 * z4 - z5 * z6;
    /* the mass matrix is singular */
    bad |= smooth_tippe_top_misses(smooth_tippe_top_size(SMOOTH_TIPPE_TOP_SPREAD(z7)), 1e-14 * z1);
    const smooth_tippe_top_lanes c_theta = cosine1;
    const smooth_tippe_top_lanes z8 = c_theta * k1;
    const smooth_tippe_top_lanes z9 = s_phi * z8;
    const smooth_tippe_top_lanes z10 = k5 * z9;
    const smooth_tippe_top_lanes z11 = c_phi * z8;
    const smooth_tippe_top_lanes z12 = k5 * z11;
    const smooth_tippe_top_lanes z13 = z3 * z10 - z5 * z12;
    const smooth_tippe_top_lanes z14 = 1.0 / z7;
    const smooth_tippe_top_lanes z15 = z14 * z13;
    const smooth_tippe_top_lanes z16 = k2 - z9 * z10 - z11 * z12 - z13 * z15;
    /* the mass matrix is singular */
    bad |= smooth_tippe_top_misses(smooth_tippe_top_size(SMOOTH_TIPPE_TOP_SPREAD(z16)),
        SMOOTH_TIPPE_TOP_SPREAD(1e-14 * k2));
    const smooth_tippe_top_lanes z17 = I3 * c_theta;
    const smooth_tippe_top_lanes z18 = z17 * z14;
    const smooth_tippe_top_lanes z19 = z18 * z13;
    const smooth_tippe_top_lanes z20 = 1.0 / z16;
    const smooth_tippe_top_lanes z21 = z19 * z20;
    const smooth_tippe_top_lanes z22 = I3 - z17 * z18 - z19 * z21;
    /* the mass matrix is singular */
    bad |= smooth_tippe_top_misses(smooth_tippe_top_size(SMOOTH_TIPPE_TOP_SPREAD(z22)),
        SMOOTH_TIPPE_TOP_SPREAD(1e-14 * I3));
    const smooth_tippe_top_lanes z23 = s_theta * theta_dot * theta_dot;
    const smooth_tippe_top_lanes z24 = phi_dot * s_theta;
    const smooth_tippe_top_lanes z25 = theta_dot * c_theta;
    const smooth_tippe_top_lanes z26 = k1 * (s_phi * z23 + phi_dot * (s_phi * z24 - 2.0 * (c_phi * z25)));
    const smooth_tippe_top_lanes z27 = phi_dot * c_theta * k3;
    const smooth_tippe_top_lanes z28 = psi_dot * I3;
    const smooth_tippe_top_lanes z29 = k1 * (c_phi * z23 + phi_dot * (c_phi * z24 + 2.0 * (s_phi * z25)));
    const smooth_tippe_top_lanes z30 = theta_dot * s_theta * (2.0 * z27 + z28) - z4 * z26 + z6 * z29;
    const smooth_tippe_top_lanes z31 = s_theta * (phi_dot * (z27 + z28) - k4) + z26 * z10 + z29 * z12 - z15 *
        z30;
    const smooth_tippe_top_lanes z32 = (I3 * (theta_dot * z24) - z18 * z30 + z21 * z31) / z22;
    const smooth_tippe_top_lanes z33 = z20 * z31 + z21 * z32;
    const smooth_tippe_top_lanes z34 = z14 * z30 - z15 * z33 - z18 * z32;
    /* (II.3) */
    const smooth_tippe_top_lanes slope1 = x_dot;
    sum += slope1;
    smooth_tippe_top_put(dydt, slope1);
    const smooth_tippe_top_lanes slope2 = y_dot;
    sum += slope2;
    smooth_tippe_top_put(dydt + 1 * stride, slope2);
    const smooth_tippe_top_lanes slope3 = phi_dot;
    smooth_tippe_top_put(dydt + 2 * stride, slope3);
    const smooth_tippe_top_lanes slope4 = theta_dot;
    smooth_tippe_top_put(dydt + 3 * stride, slope4);
    const smooth_tippe_top_lanes slope5 = psi_dot;
    smooth_tippe_top_put(dydt + 4 * stride, slope5);
    /* (II.3) 24:4 */
    const smooth_tippe_top_lanes slope6 = k5 * z26 - z4 * z34 + z10 * z33;
    sum += slope6;
    smooth_tippe_top_put(dydt + 5 * stride, slope6);
    const smooth_tippe_top_lanes slope7 = -(k5 * z29 + z6 * z34 + z12 * z33);
    sum += slope7;
    smooth_tippe_top_put(dydt + 6 * stride, slope7);
    const smooth_tippe_top_lanes slope8 = z34;
    smooth_tippe_top_put(dydt + 7 * stride, slope8);
    const smooth_tippe_top_lanes slope9 = -z33;
    sum += slope9;
    smooth_tippe_top_put(dydt + 8 * stride, slope9);
    const smooth_tippe_top_lanes slope10 = z32;
    smooth_tippe_top_put(dydt + 9 * stride, slope10);
    smooth_tippe_top_put(check, smooth_tippe_top_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void smooth_tippe_top_rhs_tail(const double *fixed, size_t left, size_t
    count, const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[SMOOTH_TIPPE_TOP_LANES];
    double state[10 * SMOOTH_TIPPE_TOP_LANES];
    double slope[10 * SMOOTH_TIPPE_TOP_LANES];
    smooth_tippe_top_fill(left, count, t, y, time, state);
    smooth_tippe_top_rhs_lanes(fixed, SMOOTH_TIPPE_TOP_LANES, time, state, slope, check);
    smooth_tippe_top_pour(left, count, slope, dydt);
}
#endif

int smooth_tippe_top_rhs_batch(size_t count, const double *t, const double *y, const double *p, double
    *restrict dydt)
{
#if SMOOTH_TIPPE_TOP_LANES >= 2
    const double m = p[0]; /* mass [kg] */
    const double e = p[2]; /* centre of mass along the axis of symmetry [m] */
    const double I1 = p[3]; /* across the axis, at the centre of mass [kg*m^2] */
    const double I3 = p[4]; /* about the axis [kg*m^2] */
    const double g = p[5]; /* acceleration of gravity [m/s^2] */
    const double k1 = m * e;
    const double k2 = I1 + m * (e * e);
    const double k3 = I3 - k2;
    const double k4 = g * k1;
    const double k5 = 1.0 / m;
    const double fixed[] = {I3, k1, k2, k3, k4, k5};
    double check[1 * SMOOTH_TIPPE_TOP_LANES];
    int status = SMOOTH_TIPPE_TOP_OK;
    for (size_t i = 0; i < count; i += SMOOTH_TIPPE_TOP_LANES) {
        const size_t left = count - i < SMOOTH_TIPPE_TOP_LANES ? count - i : SMOOTH_TIPPE_TOP_LANES;
        if (left == SMOOTH_TIPPE_TOP_LANES) {
            smooth_tippe_top_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            smooth_tippe_top_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!smooth_tippe_top_is_good(1 * SMOOTH_TIPPE_TOP_LANES, check)) {
            const int one = smooth_tippe_top_one_by_one(count, i, left, t, y, p, dydt);
            status = status == SMOOTH_TIPPE_TOP_OK ? one : status;
        }
    }
    return status;
#else
    return smooth_tippe_top_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
