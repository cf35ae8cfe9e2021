/*
 * double_pendulum.h: double_pendulum, emitted by nhc 0.1.0 (nhc:e0d4b3b5f0fd6e99)
 * Two pendulums in a row, absolute angles; the model gives positions and nhc differentiates them.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 *
 * State y:
 * y[0] = theta1 [rad]: upper rod from the downward vertical
 * y[1] = theta2 [rad]: lower rod from the downward vertical
 * y[2] = theta1' [rad/s]
 * y[3] = theta2' [rad/s]
 *
 * Parameters p:
 * p[0]: m1 = 1.0 [kg]
 * p[1]: m2 = 1.0 [kg]
 * p[2]: l1 = 1.0 [m]
 * p[3]: l2 = 1.0 [m]
 * p[4]: g = 9.81 [m/s^2]: acceleration of gravity
 *
 * Outputs:
 * out[0] = tip_x [m]
 * out[1] = tip_y [m]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 6 +-, 14 *, 3 /, 4 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 6 +-, 14 *, 3 /, 4 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 2 +-, 2 *, 0 /, 1 calls
 * energy: 7 +-, 20 *, 0 /, 4 calls
 * jacobian: 15 +-, 49 *, 3 /, 4 calls
 * outputs: 2 +-, 4 *, 0 /, 4 calls
 *
 * Calls: t is the time; y has DOUBLE_PENDULUM_NY entries, p has DOUBLE_PENDULUM_NP;
 *     double_pendulum_parameter_defaults may be passed as p. double_pendulum_state makes y from coordinates
 *     and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: DOUBLE_PENDULUM_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_DOUBLE_PENDULUM_H
#define NHC_DOUBLE_PENDULUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    DOUBLE_PENDULUM_NQ = 2, /* coordinates */
    DOUBLE_PENDULUM_NY = 4, /* state: the coordinates and the velocities that are kept */
    DOUBLE_PENDULUM_NP = 5, /* parameters */
    DOUBLE_PENDULUM_NC = 0, /* constraints */
    DOUBLE_PENDULUM_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    DOUBLE_PENDULUM_OK = 0, /* the result is good */
    DOUBLE_PENDULUM_SINGULAR_2 = 2, /* the mass matrix is singular */
    DOUBLE_PENDULUM_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const double_pendulum_coordinate_names[DOUBLE_PENDULUM_NQ];
extern const char *const double_pendulum_state_names[DOUBLE_PENDULUM_NY];
extern const char *const double_pendulum_parameter_names[DOUBLE_PENDULUM_NP];
extern const char *const double_pendulum_constraint_names[1];
extern const char *const double_pendulum_output_names[DOUBLE_PENDULUM_NOUT];
extern const double double_pendulum_parameter_defaults[DOUBLE_PENDULUM_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 4 entries
 */
int double_pendulum_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state
 * qdot: 2 entries
 */
int double_pendulum_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 2 entries
 */
int double_pendulum_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 4 entries
 */
int double_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int double_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int double_pendulum_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double double_pendulum_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (II.3)
 * J: 16 entries, row by row: d rhs_i / d y_j stands at 4*i + j
 */
int double_pendulum_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int double_pendulum_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int double_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
