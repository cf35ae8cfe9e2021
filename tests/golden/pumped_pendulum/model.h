/*
 * pumped_pendulum.h: pumped_pendulum, emitted by nhc 0.1.0 (nhc:f56c678dbc0be68f)
 * A pendulum whose pivot is moved to and fro; T depends on time and is not homogeneous in the velocities.
 * Source: pumped_pendulum.yaml
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
 * p[3]: a = 0.3 [m]: amplitude of the pivot
 * p[4]: nu = 3.0 [rad/s]: frequency of the pivot
 *
 * Operations:
 * rhs: 1 +-, 9 *, 1 /, 3 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 1 +-, 9 *, 1 /, 3 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 2 *, 0 /, 0 calls
 * energy: 3 +-, 13 *, 0 /, 3 calls
 * jacobian: 1 +-, 9 *, 1 /, 3 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Every array is the caller's; an output must not overlap an input. Nothing is kept between calls.
 */
#ifndef NHC_PUMPED_PENDULUM_H
#define NHC_PUMPED_PENDULUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    PUMPED_PENDULUM_NQ = 1, /* coordinates */
    PUMPED_PENDULUM_NY = 2, /* state: the coordinates and the velocities that are kept */
    PUMPED_PENDULUM_NP = 5, /* parameters */
    PUMPED_PENDULUM_NC = 0, /* constraints */
    PUMPED_PENDULUM_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    PUMPED_PENDULUM_OK = 0, /* the result is good */
    PUMPED_PENDULUM_SINGULAR_2 = 2, /* the mass matrix is singular */
    PUMPED_PENDULUM_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const pumped_pendulum_coordinate_names[];
extern const char *const pumped_pendulum_state_names[];
extern const char *const pumped_pendulum_parameter_names[];
extern const double pumped_pendulum_parameter_defaults[];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 2 entries
 */
int pumped_pendulum_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 1 entries
 */
int pumped_pendulum_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 1 entries
 */
int pumped_pendulum_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 2 entries
 */
int pumped_pendulum_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left sides of the constraints, zero on every motion (I.1.1)
 * r: 0 entries
 */
int pumped_pendulum_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda: Q_i gains lambda_a a_ai (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a
 */
int pumped_pendulum_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * T + V
 * not finite where the model is singular
 */
double pumped_pendulum_energy(double t, const double *y, const double *p);

/*
 * d rhs_i / d y_j, row-major (II.3)
 * J: 4 entries, row by row: d rhs_i / d y_j stands at 2*i + j
 */
int pumped_pendulum_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int pumped_pendulum_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int pumped_pendulum_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
