/*
 * holonomic_pendulum.h: holonomic_pendulum, emitted by nhc 0.1.0 (nhc:84980d30f71579db)
 * The plane pendulum in Cartesian coordinates with the rod as a constraint on the positions.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v: the dependent velocities that nhc would choose (x') are singular
 *     somewhere
 *
 * State y:
 * y[0] = x [m]: across
 * y[1] = y [m]: up
 * y[2] = v [1/s]: (y*x' - x*y')/(x^2 + y^2)
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass of the bob
 * p[1]: g = 9.81 [m/s^2]: acceleration of gravity
 * p[2]: l = 1.0 [m]: length of the rod
 *
 * Constraints, with the units of their reactions:
 * 0: rod [kg/s^2]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 1 +-, 7 *, 1 /, 0 calls
 * velocities: 1 +-, 4 *, 0 /, 0 calls
 * accelerations: 3 +-, 10 *, 1 /, 0 calls
 * state: 2 +-, 4 *, 1 /, 0 calls
 * residuals: 1 +-, 2 *, 0 /, 0 calls
 * positions: 2 +-, 4 *, 0 /, 0 calls
 * reactions: 2 +-, 6 *, 1 /, 0 calls
 * energy: 2 +-, 8 *, 0 /, 0 calls
 * jacobian: 2 +-, 13 *, 1 /, 0 calls
 * outputs: 1 +-, 2 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has HOLONOMIC_PENDULUM_NY entries, p has HOLONOMIC_PENDULUM_NP;
 *     holonomic_pendulum_parameter_defaults may be passed as p. holonomic_pendulum_state makes y from
 *     coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: HOLONOMIC_PENDULUM_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_HOLONOMIC_PENDULUM_H
#define NHC_HOLONOMIC_PENDULUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    HOLONOMIC_PENDULUM_NQ = 2, /* coordinates */
    HOLONOMIC_PENDULUM_NY = 3, /* state: the coordinates and the velocities that are kept */
    HOLONOMIC_PENDULUM_NP = 3, /* parameters */
    HOLONOMIC_PENDULUM_NC = 1, /* constraints */
    HOLONOMIC_PENDULUM_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    HOLONOMIC_PENDULUM_OK = 0, /* the result is good */
    HOLONOMIC_PENDULUM_SINGULAR_1 = 1, /* the coframe is singular */
    HOLONOMIC_PENDULUM_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    HOLONOMIC_PENDULUM_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const holonomic_pendulum_coordinate_names[HOLONOMIC_PENDULUM_NQ];
extern const char *const holonomic_pendulum_state_names[HOLONOMIC_PENDULUM_NY];
extern const char *const holonomic_pendulum_parameter_names[HOLONOMIC_PENDULUM_NP];
extern const char *const holonomic_pendulum_constraint_names[HOLONOMIC_PENDULUM_NC];
extern const char *const holonomic_pendulum_output_names[1];
extern const double holonomic_pendulum_parameter_defaults[HOLONOMIC_PENDULUM_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 3 entries
 */
int holonomic_pendulum_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 2 entries
 */
int holonomic_pendulum_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 2 entries
 */
int holonomic_pendulum_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 3 entries
 */
int holonomic_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int holonomic_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * left minus right side of each holonomic constraint, zero on every motion
 * f: 1 entry
 */
int holonomic_pendulum_positions(double t, const double *q, const double *p, double *f);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int holonomic_pendulum_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double holonomic_pendulum_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 9 entries, row by row: d rhs_i / d y_j stands at 3*i + j
 */
int holonomic_pendulum_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int holonomic_pendulum_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int holonomic_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *dydt);

#ifdef __cplusplus
}
#endif

#endif
