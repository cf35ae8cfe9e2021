/*
 * bead_on_rod.h: bead_on_rod, emitted by nhc 0.1.0 (nhc:85b27d4f1a74e76a)
 * A bead on a straight horizontal rod that turns at a constant rate; T has a part without velocities.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 *
 * State y:
 * y[0] = r [m]: distance from the axis
 * y[1] = r' [m/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass of the bead
 * p[1]: Omega = 2.0 [rad/s]: rate of the rod
 *
 * Outputs:
 * out[0] = jacobi [kg*m^2/s^2]
 * out[1] = torque [kg*m^2/s^2]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 0 +-, 2 *, 0 /, 0 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 0 +-, 2 *, 0 /, 0 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 0 *, 0 /, 0 calls
 * energy: 1 +-, 6 *, 0 /, 0 calls
 * jacobian: 0 +-, 1 *, 0 /, 0 calls
 * outputs: 1 +-, 10 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has BEAD_ON_ROD_NY entries, p has BEAD_ON_ROD_NP; bead_on_rod_parameter_defaults
 *     may be passed as p. bead_on_rod_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: BEAD_ON_ROD_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_BEAD_ON_ROD_H
#define NHC_BEAD_ON_ROD_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    BEAD_ON_ROD_NQ = 1, /* coordinates */
    BEAD_ON_ROD_NY = 2, /* state: the coordinates and the velocities that are kept */
    BEAD_ON_ROD_NP = 2, /* parameters */
    BEAD_ON_ROD_NC = 0, /* constraints */
    BEAD_ON_ROD_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    BEAD_ON_ROD_OK = 0, /* the result is good */
    BEAD_ON_ROD_SINGULAR_2 = 2, /* the mass matrix is singular */
    BEAD_ON_ROD_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const bead_on_rod_coordinate_names[BEAD_ON_ROD_NQ];
extern const char *const bead_on_rod_state_names[BEAD_ON_ROD_NY];
extern const char *const bead_on_rod_parameter_names[BEAD_ON_ROD_NP];
extern const char *const bead_on_rod_constraint_names[1];
extern const char *const bead_on_rod_output_names[BEAD_ON_ROD_NOUT];
extern const double bead_on_rod_parameter_defaults[BEAD_ON_ROD_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 2 entries
 */
int bead_on_rod_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state
 * qdot: 1 entry
 */
int bead_on_rod_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 1 entry
 */
int bead_on_rod_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 2 entries
 */
int bead_on_rod_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int bead_on_rod_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int bead_on_rod_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double bead_on_rod_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (II.3)
 * J: 4 entries, row by row: d rhs_i / d y_j stands at 2*i + j
 */
int bead_on_rod_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int bead_on_rod_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int bead_on_rod_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
