/*
 * chaplygin_ball.h: chaplygin_ball, emitted by nhc 0.1.0 (nhc:e13fa185b467dc63)
 * A ball with three different moments of inertia and its centre of mass at its centre rolls on a horizontal
 *     plane.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: centre
 * y[1] = y [m]: centre
 * y[2] = phi [rad]: precession
 * y[3] = theta [rad]: nutation
 * y[4] = psi [rad]: spin
 * y[5] = w1 [rad/s]
 * y[6] = w2 [rad/s]
 * y[7] = w3 [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: a = 1.0 [m]: radius
 * p[2]: I1 = 0.4 [kg*m^2]
 * p[3]: I2 = 0.5 [kg*m^2]
 * p[4]: I3 = 0.7 [kg*m^2]
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x [N]
 * 1: roll_y [N]
 *
 * Outputs:
 * out[0] = K1 [kg*m^2/s]
 * out[1] = K2 [kg*m^2/s]
 * out[2] = K3 [kg*m^2/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 21 +-, 40 *, 5 /, 6 calls
 * velocities: 5 +-, 12 *, 1 /, 6 calls
 * accelerations: 35 +-, 69 *, 5 /, 6 calls
 * state: 3 +-, 6 *, 0 /, 4 calls
 * residuals: 4 +-, 7 *, 0 /, 3 calls
 * reactions: 24 +-, 49 *, 4 /, 6 calls
 * energy: 11 +-, 22 *, 0 /, 4 calls
 * jacobian: 65 +-, 174 *, 5 /, 6 calls
 * outputs: 8 +-, 18 *, 0 /, 4 calls
 *
 * Calls: t is the time; y has CHAPLYGIN_BALL_NY entries, p has CHAPLYGIN_BALL_NP;
 *     chaplygin_ball_parameter_defaults may be passed as p. chaplygin_ball_state makes y from coordinates and
 *     velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: CHAPLYGIN_BALL_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CHAPLYGIN_BALL_H
#define NHC_CHAPLYGIN_BALL_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CHAPLYGIN_BALL_NQ = 5, /* coordinates */
    CHAPLYGIN_BALL_NY = 8, /* state: the coordinates and the velocities that are kept */
    CHAPLYGIN_BALL_NP = 5, /* parameters */
    CHAPLYGIN_BALL_NC = 2, /* constraints */
    CHAPLYGIN_BALL_NOUT = 3 /* outputs */
};

/* return codes */
enum {
    CHAPLYGIN_BALL_OK = 0, /* the result is good */
    CHAPLYGIN_BALL_SINGULAR_1 = 1, /* the coframe is singular */
    CHAPLYGIN_BALL_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    CHAPLYGIN_BALL_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const chaplygin_ball_coordinate_names[CHAPLYGIN_BALL_NQ];
extern const char *const chaplygin_ball_state_names[CHAPLYGIN_BALL_NY];
extern const char *const chaplygin_ball_parameter_names[CHAPLYGIN_BALL_NP];
extern const char *const chaplygin_ball_constraint_names[CHAPLYGIN_BALL_NC];
extern const char *const chaplygin_ball_output_names[CHAPLYGIN_BALL_NOUT];
extern const double chaplygin_ball_parameter_defaults[CHAPLYGIN_BALL_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 8 entries
 */
int chaplygin_ball_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 5 entries
 */
int chaplygin_ball_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 5 entries
 */
int chaplygin_ball_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 8 entries
 */
int chaplygin_ball_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 2 entries
 */
int chaplygin_ball_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 2 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int chaplygin_ball_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double chaplygin_ball_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 64 entries, row by row: d rhs_i / d y_j stands at 8*i + j
 */
int chaplygin_ball_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 3 entries
 */
int chaplygin_ball_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int chaplygin_ball_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
