/*
 * chaplygin_sleigh.h: chaplygin_sleigh, emitted by nhc 0.1.0 (nhc:fc895b2194997b38)
 * A rigid body on a knife edge; the centre of mass is a distance a ahead of the edge.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: point of the edge
 * y[1] = y [m]: point of the edge
 * y[2] = theta [rad]: heading
 * y[3] = v [m/s]
 * y[4] = w [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: J = 0.5 [kg*m^2]: moment of inertia about the centre of mass
 * p[2]: a = 0.7 [m]: from the edge to the centre of mass
 *
 * Constraints, with the units of their reactions:
 * 0: slip [N]
 *
 * Outputs:
 * out[0] = speed [m/s]
 * out[1] = X [m]
 * out[2] = Y [m]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 1 +-, 8 *, 1 /, 2 calls
 * velocities: 0 +-, 2 *, 0 /, 2 calls
 * accelerations: 3 +-, 10 *, 1 /, 2 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 1 +-, 2 *, 0 /, 2 calls
 * reactions: 1 +-, 5 *, 1 /, 0 calls
 * energy: 2 +-, 7 *, 0 /, 0 calls
 * jacobian: 1 +-, 8 *, 1 /, 2 calls
 * outputs: 2 +-, 2 *, 0 /, 2 calls
 *
 * Calls: t is the time; y has CHAPLYGIN_SLEIGH_NY entries, p has CHAPLYGIN_SLEIGH_NP;
 *     chaplygin_sleigh_parameter_defaults may be passed as p. chaplygin_sleigh_state makes y from coordinates
 *     and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: CHAPLYGIN_SLEIGH_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CHAPLYGIN_SLEIGH_H
#define NHC_CHAPLYGIN_SLEIGH_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CHAPLYGIN_SLEIGH_NQ = 3, /* coordinates */
    CHAPLYGIN_SLEIGH_NY = 5, /* state: the coordinates and the velocities that are kept */
    CHAPLYGIN_SLEIGH_NP = 3, /* parameters */
    CHAPLYGIN_SLEIGH_NC = 1, /* constraints */
    CHAPLYGIN_SLEIGH_NOUT = 3 /* outputs */
};

/* return codes */
enum {
    CHAPLYGIN_SLEIGH_OK = 0, /* the result is good */
    CHAPLYGIN_SLEIGH_SINGULAR_2 = 2, /* the mass matrix is singular */
    CHAPLYGIN_SLEIGH_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const chaplygin_sleigh_coordinate_names[CHAPLYGIN_SLEIGH_NQ];
extern const char *const chaplygin_sleigh_state_names[CHAPLYGIN_SLEIGH_NY];
extern const char *const chaplygin_sleigh_parameter_names[CHAPLYGIN_SLEIGH_NP];
extern const char *const chaplygin_sleigh_constraint_names[CHAPLYGIN_SLEIGH_NC];
extern const char *const chaplygin_sleigh_output_names[CHAPLYGIN_SLEIGH_NOUT];
extern const double chaplygin_sleigh_parameter_defaults[CHAPLYGIN_SLEIGH_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 5 entries
 */
int chaplygin_sleigh_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 3 entries
 */
int chaplygin_sleigh_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 3 entries
 */
int chaplygin_sleigh_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 5 entries
 */
int chaplygin_sleigh_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int chaplygin_sleigh_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int chaplygin_sleigh_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double chaplygin_sleigh_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int chaplygin_sleigh_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 3 entries
 */
int chaplygin_sleigh_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int chaplygin_sleigh_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
