/*
 * routh_sphere.h: routh_sphere, emitted by nhc 0.1.0 (nhc:d16799ae532de2a3)
 * A ball with its centre of mass off its centre, dynamically symmetric, rolls on a horizontal plane.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 *
 * State y:
 * y[0] = x [m]: geometric centre
 * y[1] = y [m]: geometric centre
 * y[2] = phi [rad]: precession
 * y[3] = theta [rad]: nutation
 * y[4] = psi [rad]: spin
 * y[5] = phi' [rad/s]
 * y[6] = theta' [rad/s]
 * y[7] = psi' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: R = 1.0 [m]: radius
 * p[2]: e = -0.2 [m]: centre of mass along the axis of symmetry
 * p[3]: I1 = 0.38 [kg*m^2]: across the axis, at the centre of mass
 * p[4]: I3 = 0.42 [kg*m^2]: about the axis
 * p[5]: g = 9.81 [m/s^2]: acceleration of gravity
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x [N]
 * 1: roll_y [N]
 *
 * Outputs:
 * out[0] = jellett [kg*m^3/s]
 * out[1] = routh [kg*m^2/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 24 +-, 47 *, 3 /, 4 calls
 * velocities: 2 +-, 7 *, 0 /, 3 calls
 * accelerations: 29 +-, 59 *, 3 /, 4 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 4 +-, 7 *, 0 /, 3 calls
 * reactions: 34 +-, 73 *, 3 /, 4 calls
 * energy: 9 +-, 22 *, 0 /, 2 calls
 * jacobian: 46 +-, 124 *, 3 /, 4 calls
 * outputs: 5 +-, 17 *, 0 /, 3 calls
 *
 * Calls: t is the time; y has ROUTH_SPHERE_NY entries, p has ROUTH_SPHERE_NP; routh_sphere_parameter_defaults
 *     may be passed as p. routh_sphere_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: ROUTH_SPHERE_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_ROUTH_SPHERE_H
#define NHC_ROUTH_SPHERE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    ROUTH_SPHERE_NQ = 5, /* coordinates */
    ROUTH_SPHERE_NY = 8, /* state: the coordinates and the velocities that are kept */
    ROUTH_SPHERE_NP = 6, /* parameters */
    ROUTH_SPHERE_NC = 2, /* constraints */
    ROUTH_SPHERE_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    ROUTH_SPHERE_OK = 0, /* the result is good */
    ROUTH_SPHERE_SINGULAR_2 = 2, /* the mass matrix is singular */
    ROUTH_SPHERE_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const routh_sphere_coordinate_names[ROUTH_SPHERE_NQ];
extern const char *const routh_sphere_state_names[ROUTH_SPHERE_NY];
extern const char *const routh_sphere_parameter_names[ROUTH_SPHERE_NP];
extern const char *const routh_sphere_constraint_names[ROUTH_SPHERE_NC];
extern const char *const routh_sphere_output_names[ROUTH_SPHERE_NOUT];
extern const double routh_sphere_parameter_defaults[ROUTH_SPHERE_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 8 entries
 */
int routh_sphere_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 5 entries
 */
int routh_sphere_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 5 entries
 */
int routh_sphere_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 8 entries
 */
int routh_sphere_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 2 entries
 */
int routh_sphere_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 2 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int routh_sphere_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double routh_sphere_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 64 entries, row by row: d rhs_i / d y_j stands at 8*i + j
 */
int routh_sphere_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int routh_sphere_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int routh_sphere_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
