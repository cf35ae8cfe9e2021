/*
 * point_mass.h: point_mass, emitted by nhc 0.1.0 (nhc:4957cb10ce637607)
 * A point mass thrown in a uniform field of gravity, with linear drag.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 *
 * State y:
 * y[0] = x [m]: horizontal
 * y[1] = y [m]: horizontal
 * y[2] = z [m]: height
 * y[3] = x' [m/s]
 * y[4] = y' [m/s]
 * y[5] = z' [m/s]
 *
 * Parameters p:
 * p[0]: m = 2.0 [kg]: mass
 * p[1]: g = 9.81 [m/s^2]: acceleration of gravity
 * p[2]: c = 0.5 [kg/s]: drag coefficient
 *
 * Outputs:
 * out[0] = speed [m/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 1 +-, 3 *, 1 /, 0 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 1 +-, 3 *, 1 /, 0 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 0 *, 0 /, 0 calls
 * energy: 3 +-, 7 *, 0 /, 0 calls
 * jacobian: 0 +-, 0 *, 1 /, 0 calls
 * outputs: 2 +-, 3 *, 0 /, 1 calls
 *
 * Calls: t is the time; y has POINT_MASS_NY entries, p has POINT_MASS_NP; point_mass_parameter_defaults may
 *     be passed as p. point_mass_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: POINT_MASS_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_POINT_MASS_H
#define NHC_POINT_MASS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    POINT_MASS_NQ = 3, /* coordinates */
    POINT_MASS_NY = 6, /* state: the coordinates and the velocities that are kept */
    POINT_MASS_NP = 3, /* parameters */
    POINT_MASS_NC = 0, /* constraints */
    POINT_MASS_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    POINT_MASS_OK = 0, /* the result is good */
    POINT_MASS_SINGULAR_2 = 2, /* the mass matrix is singular */
    POINT_MASS_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const point_mass_coordinate_names[POINT_MASS_NQ];
extern const char *const point_mass_state_names[POINT_MASS_NY];
extern const char *const point_mass_parameter_names[POINT_MASS_NP];
extern const char *const point_mass_constraint_names[1];
extern const char *const point_mass_output_names[POINT_MASS_NOUT];
extern const double point_mass_parameter_defaults[POINT_MASS_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 6 entries
 */
int point_mass_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state
 * qdot: 3 entries
 */
int point_mass_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 3 entries
 */
int point_mass_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 6 entries
 */
int point_mass_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int point_mass_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int point_mass_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double point_mass_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (II.3)
 * J: 36 entries, row by row: d rhs_i / d y_j stands at 6*i + j
 */
int point_mass_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int point_mass_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int point_mass_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
