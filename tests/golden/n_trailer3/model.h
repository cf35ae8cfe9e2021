/*
 * n_trailer3.h: n_trailer3, emitted by nhc 0.1.0 (nhc:0a97164f1c2c97ca)
 * A tractor with three trailers, each hitched to the axle before it; none of the four axles slips sideways.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: axle of the tractor
 * y[1] = y [m]: axle of the tractor
 * y[2] = theta0 [rad]: heading of the tractor
 * y[3] = theta1 [rad]: first trailer
 * y[4] = theta2 [rad]: second trailer
 * y[5] = theta3 [rad]: third trailer
 * y[6] = v [m/s]
 * y[7] = w [rad/s]
 *
 * Parameters p:
 * p[0]: m0 = 1.0 [kg]: tractor
 * p[1]: J0 = 0.1 [kg*m^2]: tractor
 * p[2]: m = 0.5 [kg]: each trailer
 * p[3]: J = 0.05 [kg*m^2]: each trailer
 * p[4]: L = 0.8 [m]: from axle to axle
 *
 * Constraints, with the units of their reactions:
 * 0: axle0 [N]
 * 1: axle1 [N]
 * 2: axle2 [N]
 * 3: axle3 [N]
 *
 * Outputs:
 * out[0] = tail_x [m]
 * out[1] = tail_y [m]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 17 +-, 31 *, 2 /, 8 calls
 * velocities: 3 +-, 8 *, 1 /, 7 calls
 * accelerations: 24 +-, 47 *, 2 /, 8 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 10 +-, 17 *, 0 /, 8 calls
 * reactions: 38 +-, 75 *, 2 /, 6 calls
 * energy: 9 +-, 14 *, 1 /, 3 calls
 * jacobian: 66 +-, 138 *, 2 /, 8 calls
 * outputs: 6 +-, 2 *, 0 /, 6 calls
 *
 * Calls: t is the time; y has N_TRAILER3_NY entries, p has N_TRAILER3_NP; n_trailer3_parameter_defaults may
 *     be passed as p. n_trailer3_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: N_TRAILER3_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_N_TRAILER3_H
#define NHC_N_TRAILER3_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    N_TRAILER3_NQ = 6, /* coordinates */
    N_TRAILER3_NY = 8, /* state: the coordinates and the velocities that are kept */
    N_TRAILER3_NP = 5, /* parameters */
    N_TRAILER3_NC = 4, /* constraints */
    N_TRAILER3_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    N_TRAILER3_OK = 0, /* the result is good */
    N_TRAILER3_SINGULAR_1 = 1, /* the coframe is singular */
    N_TRAILER3_SINGULAR_2 = 2, /* the mass matrix is singular */
    N_TRAILER3_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const n_trailer3_coordinate_names[N_TRAILER3_NQ];
extern const char *const n_trailer3_state_names[N_TRAILER3_NY];
extern const char *const n_trailer3_parameter_names[N_TRAILER3_NP];
extern const char *const n_trailer3_constraint_names[N_TRAILER3_NC];
extern const char *const n_trailer3_output_names[N_TRAILER3_NOUT];
extern const double n_trailer3_parameter_defaults[N_TRAILER3_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 8 entries
 */
int n_trailer3_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 6 entries
 */
int n_trailer3_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 6 entries
 */
int n_trailer3_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 8 entries
 */
int n_trailer3_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 4 entries
 */
int n_trailer3_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 4 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int n_trailer3_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double n_trailer3_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 64 entries, row by row: d rhs_i / d y_j stands at 8*i + j
 */
int n_trailer3_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int n_trailer3_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int n_trailer3_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
