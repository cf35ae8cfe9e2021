/*
 * pumped_pendulum.h: pumped_pendulum, emitted by nhc 0.1.0 (nhc:c5db6b5e863ab9a1)
 * A pendulum whose pivot is moved to and fro; T depends on time and is not homogeneous in the velocities.
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
 * p[3]: a = 0.3 [m]: amplitude of the pivot
 * p[4]: nu = 3.0 [rad/s]: frequency of the pivot
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 1 +-, 9 *, 1 /, 3 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 1 +-, 9 *, 1 /, 3 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 2 *, 0 /, 0 calls
 * energy: 3 +-, 13 *, 0 /, 3 calls
 * jacobian: 1 +-, 9 *, 1 /, 3 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has PUMPED_PENDULUM_NY entries, p has PUMPED_PENDULUM_NP;
 *     pumped_pendulum_parameter_defaults may be passed as p. pumped_pendulum_state makes y from coordinates
 *     and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: PUMPED_PENDULUM_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_PUMPED_PENDULUM_H
#define NHC_PUMPED_PENDULUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    PUMPED_PENDULUM_NQ = 1, /* coordinates */
    PUMPED_PENDULUM_NY = 2, /* state: the coordinates and the velocities that are kept */
    PUMPED_PENDULUM_NP = 5, /* parameters */
    PUMPED_PENDULUM_NC = 0, /* constraints */
    PUMPED_PENDULUM_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    PUMPED_PENDULUM_OK = 0, /* the result is good */
    PUMPED_PENDULUM_SINGULAR_2 = 2, /* the mass matrix is singular */
    PUMPED_PENDULUM_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const pumped_pendulum_coordinate_names[PUMPED_PENDULUM_NQ];
extern const char *const pumped_pendulum_state_names[PUMPED_PENDULUM_NY];
extern const char *const pumped_pendulum_parameter_names[PUMPED_PENDULUM_NP];
extern const char *const pumped_pendulum_constraint_names[1];
extern const char *const pumped_pendulum_output_names[1];
extern const double pumped_pendulum_parameter_defaults[PUMPED_PENDULUM_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 2 entries
 */
int pumped_pendulum_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state
 * qdot: 1 entry
 */
int pumped_pendulum_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 1 entry
 */
int pumped_pendulum_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 2 entries
 */
int pumped_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int pumped_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int pumped_pendulum_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double pumped_pendulum_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (II.3)
 * J: 4 entries, row by row: d rhs_i / d y_j stands at 2*i + j
 */
int pumped_pendulum_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int pumped_pendulum_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int pumped_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
