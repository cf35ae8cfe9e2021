/*
 * pendulum.h: pendulum, emitted by nhc 0.1.0 (nhc:61a991f1e696aab1)
 * The plane pendulum, large swings.
 * Source: pendulum.yaml
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 *
 * State y:
 * y[0] = theta [rad]: angle from the downward vertical
 * y[1] = theta' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass of the bob
 * p[1]: l = 1.0 [m]: length of the rod
 * p[2]: g = 9.81 [m/s^2]: acceleration of gravity
 *
 * Outputs:
 * out[0] = rate [rad/s]
 *
 * Operations:
 * rhs: 0 +-, 3 *, 1 /, 1 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 0 +-, 3 *, 1 /, 1 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 2 *, 0 /, 0 calls
 * energy: 1 +-, 6 *, 0 /, 1 calls
 * jacobian: 0 +-, 3 *, 1 /, 1 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Every array is the caller's; an output must not overlap an input. Nothing is kept between calls.
 */
#ifndef NHC_PENDULUM_H
#define NHC_PENDULUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    PENDULUM_NQ = 1, /* coordinates */
    PENDULUM_NY = 2, /* state: the coordinates and the velocities that are kept */
    PENDULUM_NP = 3, /* parameters */
    PENDULUM_NC = 0, /* constraints */
    PENDULUM_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    PENDULUM_OK = 0, /* the result is good */
    PENDULUM_SINGULAR_2 = 2, /* the mass matrix is singular */
    PENDULUM_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const pendulum_coordinate_names[];
extern const char *const pendulum_state_names[];
extern const char *const pendulum_parameter_names[];
extern const double pendulum_parameter_defaults[];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 2 entries
 */
int pendulum_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 1 entries
 */
int pendulum_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 1 entries
 */
int pendulum_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 2 entries
 */
int pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left sides of the constraints, zero on every motion (I.1.1)
 * r: 0 entries
 */
int pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda: Q_i gains lambda_a a_ai (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a
 */
int pendulum_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * T + V
 * not finite where the model is singular
 */
double pendulum_energy(double t, const double *y, const double *p);

/*
 * d rhs_i / d y_j, row-major (II.3)
 * J: 4 entries, row by row: d rhs_i / d y_j stands at 2*i + j
 */
int pendulum_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entries
 */
int pendulum_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
