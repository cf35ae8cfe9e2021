/*
 * n_snake3.h: n_snake3, emitted by nhc 0.1.0 (nhc:0d1e8f8da0a5322a)
 * Three links with a wheeled axle under the middle of each, hinged in a row with springs in the hinges.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: middle of the first link
 * y[1] = y [m]: middle of the first link
 * y[2] = theta1 [rad]: first link
 * y[3] = theta2 [rad]: second link
 * y[4] = theta3 [rad]: third link
 * y[5] = v [m/s]
 * y[6] = w [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: each link
 * p[1]: J = 0.1 [kg*m^2]: each link
 * p[2]: a = 0.5 [m]: half the length of a link
 * p[3]: k = 0.5 [N*m]: stiffness of the hinges
 *
 * Constraints, with the units of their reactions:
 * 0: wheel1 [N]
 * 1: wheel2 [N]
 * 2: wheel3 [N]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 42 +-, 78 *, 3 /, 6 calls
 * velocities: 5 +-, 11 *, 1 /, 6 calls
 * accelerations: 53 +-, 97 *, 3 /, 6 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 11 +-, 15 *, 0 /, 6 calls
 * reactions: 66 +-, 115 *, 3 /, 4 calls
 * energy: 13 +-, 23 *, 1 /, 4 calls
 * jacobian: 190 +-, 301 *, 3 /, 6 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has N_SNAKE3_NY entries, p has N_SNAKE3_NP; n_snake3_parameter_defaults may be
 *     passed as p. n_snake3_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: N_SNAKE3_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_N_SNAKE3_H
#define NHC_N_SNAKE3_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    N_SNAKE3_NQ = 5, /* coordinates */
    N_SNAKE3_NY = 7, /* state: the coordinates and the velocities that are kept */
    N_SNAKE3_NP = 4, /* parameters */
    N_SNAKE3_NC = 3, /* constraints */
    N_SNAKE3_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    N_SNAKE3_OK = 0, /* the result is good */
    N_SNAKE3_SINGULAR_1 = 1, /* the coframe is singular */
    N_SNAKE3_SINGULAR_2 = 2, /* the mass matrix is singular */
    N_SNAKE3_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const n_snake3_coordinate_names[N_SNAKE3_NQ];
extern const char *const n_snake3_state_names[N_SNAKE3_NY];
extern const char *const n_snake3_parameter_names[N_SNAKE3_NP];
extern const char *const n_snake3_constraint_names[N_SNAKE3_NC];
extern const char *const n_snake3_output_names[1];
extern const double n_snake3_parameter_defaults[N_SNAKE3_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 7 entries
 */
int n_snake3_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 5 entries
 */
int n_snake3_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 5 entries
 */
int n_snake3_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 7 entries
 */
int n_snake3_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 3 entries
 */
int n_snake3_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 3 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int n_snake3_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double n_snake3_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 49 entries, row by row: d rhs_i / d y_j stands at 7*i + j
 */
int n_snake3_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int n_snake3_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int n_snake3_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
