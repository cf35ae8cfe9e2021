/*
 * pendulum.h: pendulum, emitted by nhc 0.1.0 (nhc:40bdc1ecfe04c7bd)
 * The plane pendulum, large swings.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 *
 * State y:
 * y[0] = theta [rad]: angle from the downward vertical
 * y[1] = theta' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass of the bob
 * p[1]: l = 1.0 [m]: length of the rod
 * p[2]: g = 9.81 [m/s^2]: acceleration of gravity
 *
 * Outputs:
 * out[0] = rate [rad/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 0 +-, 3 *, 1 /, 1 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 0 +-, 3 *, 1 /, 1 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 2 *, 0 /, 0 calls
 * energy: 1 +-, 6 *, 0 /, 1 calls
 * jacobian: 0 +-, 3 *, 1 /, 1 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has PENDULUM_NY entries, p has PENDULUM_NP; pendulum_parameter_defaults may be
 *     passed as p. pendulum_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: PENDULUM_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_PENDULUM_H
#define NHC_PENDULUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    PENDULUM_NQ = 1, /* coordinates */
    PENDULUM_NY = 2, /* state: the coordinates and the velocities that are kept */
    PENDULUM_NP = 3, /* parameters */
    PENDULUM_NC = 0, /* constraints */
    PENDULUM_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    PENDULUM_OK = 0, /* the result is good */
    PENDULUM_SINGULAR_2 = 2, /* the mass matrix is singular */
    PENDULUM_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const pendulum_coordinate_names[PENDULUM_NQ];
extern const char *const pendulum_state_names[PENDULUM_NY];
extern const char *const pendulum_parameter_names[PENDULUM_NP];
extern const char *const pendulum_constraint_names[1];
extern const char *const pendulum_output_names[PENDULUM_NOUT];
extern const double pendulum_parameter_defaults[PENDULUM_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 2 entries
 */
int pendulum_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state
 * qdot: 1 entry
 */
int pendulum_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 1 entry
 */
int pendulum_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 2 entries
 */
int pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int pendulum_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double pendulum_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (II.3)
 * J: 4 entries, row by row: d rhs_i / d y_j stands at 2*i + j
 */
int pendulum_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int pendulum_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
