/*
 * cartesian_pendulum.h: cartesian_pendulum, emitted by nhc 0.1.0 (nhc:a27abe027a65bed6)
 * The plane pendulum in Cartesian coordinates; its constraint is written with velocities, but it is
 *     holonomic.
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
 *
 * Constraints, with the units of their reactions:
 * 0: rod [kg/s^2]
 *
 * Outputs:
 * out[0] = length [m]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 1 +-, 7 *, 1 /, 0 calls
 * velocities: 1 +-, 4 *, 0 /, 0 calls
 * accelerations: 3 +-, 10 *, 1 /, 0 calls
 * state: 2 +-, 4 *, 1 /, 0 calls
 * residuals: 1 +-, 2 *, 0 /, 0 calls
 * reactions: 2 +-, 6 *, 1 /, 0 calls
 * energy: 2 +-, 8 *, 0 /, 0 calls
 * jacobian: 2 +-, 13 *, 1 /, 0 calls
 * outputs: 1 +-, 2 *, 0 /, 1 calls
 *
 * Calls: t is the time; y has CARTESIAN_PENDULUM_NY entries, p has CARTESIAN_PENDULUM_NP;
 *     cartesian_pendulum_parameter_defaults may be passed as p. cartesian_pendulum_state makes y from
 *     coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: CARTESIAN_PENDULUM_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CARTESIAN_PENDULUM_H
#define NHC_CARTESIAN_PENDULUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CARTESIAN_PENDULUM_NQ = 2, /* coordinates */
    CARTESIAN_PENDULUM_NY = 3, /* state: the coordinates and the velocities that are kept */
    CARTESIAN_PENDULUM_NP = 2, /* parameters */
    CARTESIAN_PENDULUM_NC = 1, /* constraints */
    CARTESIAN_PENDULUM_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    CARTESIAN_PENDULUM_OK = 0, /* the result is good */
    CARTESIAN_PENDULUM_SINGULAR_1 = 1, /* the coframe is singular */
    CARTESIAN_PENDULUM_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    CARTESIAN_PENDULUM_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const cartesian_pendulum_coordinate_names[CARTESIAN_PENDULUM_NQ];
extern const char *const cartesian_pendulum_state_names[CARTESIAN_PENDULUM_NY];
extern const char *const cartesian_pendulum_parameter_names[CARTESIAN_PENDULUM_NP];
extern const char *const cartesian_pendulum_constraint_names[CARTESIAN_PENDULUM_NC];
extern const char *const cartesian_pendulum_output_names[CARTESIAN_PENDULUM_NOUT];
extern const double cartesian_pendulum_parameter_defaults[CARTESIAN_PENDULUM_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 3 entries
 */
int cartesian_pendulum_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 2 entries
 */
int cartesian_pendulum_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 2 entries
 */
int cartesian_pendulum_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 3 entries
 */
int cartesian_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int cartesian_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int cartesian_pendulum_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double cartesian_pendulum_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 9 entries, row by row: d rhs_i / d y_j stands at 3*i + j
 */
int cartesian_pendulum_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int cartesian_pendulum_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int cartesian_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *dydt);

#ifdef __cplusplus
}
#endif

#endif
