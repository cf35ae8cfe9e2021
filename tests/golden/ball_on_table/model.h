/*
 * ball_on_table.h: ball_on_table, emitted by nhc 0.1.0 (nhc:1f32d4015d560841)
 * A homogeneous ball that rolls on a turning table; its centre runs on a circle, though nothing holds it
 *     there.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the affine part b_alpha of the
 *     constraints contains the dependent coordinates `x`, `y`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the constraints are not
 *     homogeneous (b_alpha is not zero)
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the time t occurs in T, U or the
 *     constraints
 *
 * State y:
 * y[0] = x [m]: centre
 * y[1] = y [m]: centre
 * y[2] = phi [rad]: precession
 * y[3] = theta [rad]: nutation
 * y[4] = psi [rad]: spin
 * y[5] = phi' [rad/s]
 * y[6] = theta' [rad/s]
 * y[7] = psi' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: a = 0.3 [m]: radius
 * p[2]: k = 0.4: moment of inertia over m a^2; 2/5 for a homogeneous ball
 * p[3]: Omega0 = 1.4 [rad/s]: mean rate of the table
 * p[4]: Omega1 = 0.0 [rad/s]: amplitude of its modulation
 * p[5]: nu = 2.0 [rad/s]: frequency of its modulation
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x [N]
 * 1: roll_y [N]
 *
 * Outputs:
 * out[0] = spin [rad/s]
 * out[1] = moving_energy [J]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 17 +-, 40 *, 3 /, 6 calls
 * velocities: 5 +-, 11 *, 0 /, 4 calls
 * accelerations: 20 +-, 47 *, 3 /, 6 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 7 +-, 11 *, 0 /, 4 calls
 * reactions: 9 +-, 26 *, 1 /, 5 calls
 * energy: 10 +-, 23 *, 0 /, 5 calls
 * jacobian: 18 +-, 64 *, 3 /, 6 calls
 * outputs: 11 +-, 23 *, 0 /, 3 calls
 *
 * Calls: t is the time; y has BALL_ON_TABLE_NY entries, p has BALL_ON_TABLE_NP;
 *     ball_on_table_parameter_defaults may be passed as p. ball_on_table_state makes y from coordinates and
 *     velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: BALL_ON_TABLE_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_BALL_ON_TABLE_H
#define NHC_BALL_ON_TABLE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    BALL_ON_TABLE_NQ = 5, /* coordinates */
    BALL_ON_TABLE_NY = 8, /* state: the coordinates and the velocities that are kept */
    BALL_ON_TABLE_NP = 6, /* parameters */
    BALL_ON_TABLE_NC = 2, /* constraints */
    BALL_ON_TABLE_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    BALL_ON_TABLE_OK = 0, /* the result is good */
    BALL_ON_TABLE_SINGULAR_2 = 2, /* the mass matrix is singular */
    BALL_ON_TABLE_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const ball_on_table_coordinate_names[BALL_ON_TABLE_NQ];
extern const char *const ball_on_table_state_names[BALL_ON_TABLE_NY];
extern const char *const ball_on_table_parameter_names[BALL_ON_TABLE_NP];
extern const char *const ball_on_table_constraint_names[BALL_ON_TABLE_NC];
extern const char *const ball_on_table_output_names[BALL_ON_TABLE_NOUT];
extern const double ball_on_table_parameter_defaults[BALL_ON_TABLE_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 8 entries
 */
int ball_on_table_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 5 entries
 */
int ball_on_table_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 5 entries
 */
int ball_on_table_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 8 entries
 */
int ball_on_table_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 2 entries
 */
int ball_on_table_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 2 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int ball_on_table_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double ball_on_table_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 64 entries, row by row: d rhs_i / d y_j stands at 8*i + j
 */
int ball_on_table_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int ball_on_table_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int ball_on_table_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
