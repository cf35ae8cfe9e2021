/*
 * disk_chain2.h: disk_chain2, emitted by nhc 0.1.0 (nhc:b31778948e7b79f5)
 * Two upright rolling disks joined by a spring; the first link of a chain that may be made as long as one
 *     likes.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinates `x1`, `y1`, `x2`, `y2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `x1` contains the
 *     dependent coordinate `x2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `y1` contains the
 *     dependent coordinate `y2`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `x2` contains the
 *     dependent coordinate `x1`
 * Note: hypothesis of I.3 that fails (the generalized equations are used): the force on `y2` contains the
 *     dependent coordinate `y1`
 *
 * State y:
 * y[0] = x1 [m]: first disk
 * y[1] = y1 [m]: first disk
 * y[2] = phi1 [rad]: heading
 * y[3] = theta1 [rad]: angle rolled
 * y[4] = x2 [m]: second disk
 * y[5] = y2 [m]: second disk
 * y[6] = phi2 [rad]: heading
 * y[7] = theta2 [rad]: angle rolled
 * y[8] = phi1' [rad/s]
 * y[9] = theta1' [rad/s]
 * y[10] = phi2' [rad/s]
 * y[11] = theta2' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass of each
 * p[1]: R = 0.5 [m]: radius
 * p[2]: I = 0.125 [kg*m^2]: about the axle
 * p[3]: J = 0.0625 [kg*m^2]: about the vertical
 * p[4]: k = 1.0 [N/m]: stiffness of the spring
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x1 [N]
 * 1: roll_y1 [N]
 * 2: roll_x2 [N]
 * 3: roll_y2 [N]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 5 +-, 15 *, 1 /, 4 calls
 * velocities: 0 +-, 6 *, 0 /, 4 calls
 * accelerations: 9 +-, 23 *, 1 /, 4 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 4 +-, 6 *, 0 /, 4 calls
 * reactions: 13 +-, 25 *, 1 /, 4 calls
 * energy: 9 +-, 18 *, 0 /, 0 calls
 * jacobian: 5 +-, 21 *, 1 /, 4 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has DISK_CHAIN2_NY entries, p has DISK_CHAIN2_NP; disk_chain2_parameter_defaults
 *     may be passed as p. disk_chain2_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: DISK_CHAIN2_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_DISK_CHAIN2_H
#define NHC_DISK_CHAIN2_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    DISK_CHAIN2_NQ = 8, /* coordinates */
    DISK_CHAIN2_NY = 12, /* state: the coordinates and the velocities that are kept */
    DISK_CHAIN2_NP = 5, /* parameters */
    DISK_CHAIN2_NC = 4, /* constraints */
    DISK_CHAIN2_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    DISK_CHAIN2_OK = 0, /* the result is good */
    DISK_CHAIN2_SINGULAR_2 = 2, /* the mass matrix is singular */
    DISK_CHAIN2_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const disk_chain2_coordinate_names[DISK_CHAIN2_NQ];
extern const char *const disk_chain2_state_names[DISK_CHAIN2_NY];
extern const char *const disk_chain2_parameter_names[DISK_CHAIN2_NP];
extern const char *const disk_chain2_constraint_names[DISK_CHAIN2_NC];
extern const char *const disk_chain2_output_names[1];
extern const double disk_chain2_parameter_defaults[DISK_CHAIN2_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 12 entries
 */
int disk_chain2_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 8 entries
 */
int disk_chain2_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 8 entries
 */
int disk_chain2_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 12 entries
 */
int disk_chain2_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 4 entries
 */
int disk_chain2_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 4 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int disk_chain2_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double disk_chain2_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 144 entries, row by row: d rhs_i / d y_j stands at 12*i + j
 */
int disk_chain2_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int disk_chain2_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int disk_chain2_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
