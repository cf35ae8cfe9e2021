/*
 * roller_racer.h: roller_racer, emitted by nhc 0.1.0 (nhc:90294a85a744f5f7)
 * Two wheeled bodies with a hinge; it is driven by moving the hinge to and fro.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, theta': the dependent velocities that nhc would choose (x', y') are
 *     singular somewhere
 *
 * State y:
 * y[0] = x [m]: axle of the main body
 * y[1] = y [m]: axle of the main body
 * y[2] = theta [rad]: heading of the main body
 * y[3] = phi [rad]: second body, relative to the first
 * y[4] = v [m/s]: x'*cos(theta) + y'*sin(theta)
 * y[5] = theta' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass of the main body
 * p[1]: I1 = 0.2 [kg*m^2]
 * p[2]: I2 = 0.05 [kg*m^2]
 * p[3]: d1 = 0.6 [m]: from the hinge to the first axle
 * p[4]: d2 = 0.25 [m]: from the hinge to the second axle
 *
 * Constraints, with the units of their reactions:
 * 0: rear [N]
 * 1: front [N]
 *
 * Outputs:
 * out[0] = speed [m/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 8 +-, 28 *, 3 /, 4 calls
 * velocities: 2 +-, 6 *, 1 /, 4 calls
 * accelerations: 13 +-, 34 *, 3 /, 4 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 7 +-, 11 *, 0 /, 4 calls
 * reactions: 12 +-, 34 *, 3 /, 2 calls
 * energy: 5 +-, 11 *, 1 /, 2 calls
 * jacobian: 36 +-, 92 *, 3 /, 4 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has ROLLER_RACER_NY entries, p has ROLLER_RACER_NP; roller_racer_parameter_defaults
 *     may be passed as p. roller_racer_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: ROLLER_RACER_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_ROLLER_RACER_H
#define NHC_ROLLER_RACER_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    ROLLER_RACER_NQ = 4, /* coordinates */
    ROLLER_RACER_NY = 6, /* state: the coordinates and the velocities that are kept */
    ROLLER_RACER_NP = 5, /* parameters */
    ROLLER_RACER_NC = 2, /* constraints */
    ROLLER_RACER_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    ROLLER_RACER_OK = 0, /* the result is good */
    ROLLER_RACER_SINGULAR_1 = 1, /* the coframe is singular */
    ROLLER_RACER_SINGULAR_2 = 2, /* the mass matrix is singular */
    ROLLER_RACER_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const roller_racer_coordinate_names[ROLLER_RACER_NQ];
extern const char *const roller_racer_state_names[ROLLER_RACER_NY];
extern const char *const roller_racer_parameter_names[ROLLER_RACER_NP];
extern const char *const roller_racer_constraint_names[ROLLER_RACER_NC];
extern const char *const roller_racer_output_names[ROLLER_RACER_NOUT];
extern const double roller_racer_parameter_defaults[ROLLER_RACER_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 6 entries
 */
int roller_racer_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 4 entries
 */
int roller_racer_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 4 entries
 */
int roller_racer_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 6 entries
 */
int roller_racer_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 2 entries
 */
int roller_racer_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 2 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int roller_racer_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double roller_racer_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 36 entries, row by row: d rhs_i / d y_j stands at 6*i + j
 */
int roller_racer_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int roller_racer_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int roller_racer_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
