/*
 * free_rigid_body.h: free_rigid_body, emitted by nhc 0.1.0 (nhc:2fc2b1db25fc957e)
 * A free rigid body; the components of its angular velocity on body axes are the quasi-velocities.
 * Equations of motion: euler-lagrange (I.2.14)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = phi [rad]: precession
 * y[1] = theta [rad]: nutation
 * y[2] = psi [rad]: spin
 * y[3] = w1 [rad/s]
 * y[4] = w2 [rad/s]
 * y[5] = w3 [rad/s]
 *
 * Parameters p:
 * p[0]: I1 = 1.0 [kg*m^2]
 * p[1]: I2 = 2.0 [kg*m^2]
 * p[2]: I3 = 3.0 [kg*m^2]
 *
 * Outputs:
 * out[0] = L_squared [kg^2*m^4/s^2]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 6 +-, 11 *, 4 /, 4 calls
 * velocities: 3 +-, 5 *, 1 /, 4 calls
 * accelerations: 15 +-, 29 *, 4 /, 4 calls
 * state: 3 +-, 6 *, 0 /, 4 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 0 *, 0 /, 1 calls
 * energy: 2 +-, 7 *, 0 /, 0 calls
 * jacobian: 6 +-, 20 *, 4 /, 4 calls
 * outputs: 2 +-, 9 *, 0 /, 1 calls
 *
 * Calls: t is the time; y has FREE_RIGID_BODY_NY entries, p has FREE_RIGID_BODY_NP;
 *     free_rigid_body_parameter_defaults may be passed as p. free_rigid_body_state makes y from coordinates
 *     and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: FREE_RIGID_BODY_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_FREE_RIGID_BODY_H
#define NHC_FREE_RIGID_BODY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    FREE_RIGID_BODY_NQ = 3, /* coordinates */
    FREE_RIGID_BODY_NY = 6, /* state: the coordinates and the velocities that are kept */
    FREE_RIGID_BODY_NP = 3, /* parameters */
    FREE_RIGID_BODY_NC = 0, /* constraints */
    FREE_RIGID_BODY_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    FREE_RIGID_BODY_OK = 0, /* the result is good */
    FREE_RIGID_BODY_SINGULAR_1 = 1, /* the coframe is singular */
    FREE_RIGID_BODY_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    FREE_RIGID_BODY_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const free_rigid_body_coordinate_names[FREE_RIGID_BODY_NQ];
extern const char *const free_rigid_body_state_names[FREE_RIGID_BODY_NY];
extern const char *const free_rigid_body_parameter_names[FREE_RIGID_BODY_NP];
extern const char *const free_rigid_body_constraint_names[1];
extern const char *const free_rigid_body_output_names[FREE_RIGID_BODY_NOUT];
extern const double free_rigid_body_parameter_defaults[FREE_RIGID_BODY_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.14)
 * dydt: 6 entries
 */
int free_rigid_body_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 3 entries
 */
int free_rigid_body_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.14)
 * qddot: 3 entries
 */
int free_rigid_body_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 6 entries
 */
int free_rigid_body_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int free_rigid_body_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int free_rigid_body_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double free_rigid_body_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.14)
 * J: 36 entries, row by row: d rhs_i / d y_j stands at 6*i + j
 */
int free_rigid_body_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int free_rigid_body_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int free_rigid_body_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
