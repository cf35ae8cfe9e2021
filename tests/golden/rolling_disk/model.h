/*
 * rolling_disk.h: rolling_disk, emitted by nhc 0.1.0 (nhc:f2bd9edb26f1a2c1)
 * A thin disk that rolls on a horizontal plane and may lean and fall (Euler's disk).
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: centre
 * y[1] = y [m]: centre
 * y[2] = phi [rad]: yaw, direction of the horizontal diameter
 * y[3] = theta [rad]: tilt of the plane of the disk, pi/2 upright
 * y[4] = psi [rad]: spin
 * y[5] = w_t [rad/s]
 * y[6] = w_u [rad/s]
 * y[7] = w_n [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: R = 0.5 [m]: radius
 * p[2]: A = 0.0625 [kg*m^2]: moment of inertia about a diameter
 * p[3]: C = 0.125 [kg*m^2]: moment of inertia about the axis
 * p[4]: g = 9.81 [m/s^2]: acceleration of gravity
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x [N]
 * 1: roll_y [N]
 *
 * Outputs:
 * out[0] = height [m]
 * out[1] = contact_x [m]
 * out[2] = contact_y [m]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 8 +-, 21 *, 4 /, 4 calls
 * velocities: 3 +-, 8 *, 1 /, 4 calls
 * accelerations: 15 +-, 41 *, 4 /, 4 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 5 +-, 8 *, 0 /, 4 calls
 * reactions: 9 +-, 22 *, 3 /, 4 calls
 * energy: 5 +-, 11 *, 0 /, 1 calls
 * jacobian: 8 +-, 44 *, 4 /, 4 calls
 * outputs: 2 +-, 4 *, 0 /, 4 calls
 *
 * Calls: t is the time; y has ROLLING_DISK_NY entries, p has ROLLING_DISK_NP; rolling_disk_parameter_defaults
 *     may be passed as p. rolling_disk_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: ROLLING_DISK_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_ROLLING_DISK_H
#define NHC_ROLLING_DISK_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    ROLLING_DISK_NQ = 5, /* coordinates */
    ROLLING_DISK_NY = 8, /* state: the coordinates and the velocities that are kept */
    ROLLING_DISK_NP = 5, /* parameters */
    ROLLING_DISK_NC = 2, /* constraints */
    ROLLING_DISK_NOUT = 3 /* outputs */
};

/* return codes */
enum {
    ROLLING_DISK_OK = 0, /* the result is good */
    ROLLING_DISK_SINGULAR_1 = 1, /* the coframe is singular */
    ROLLING_DISK_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    ROLLING_DISK_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const rolling_disk_coordinate_names[ROLLING_DISK_NQ];
extern const char *const rolling_disk_state_names[ROLLING_DISK_NY];
extern const char *const rolling_disk_parameter_names[ROLLING_DISK_NP];
extern const char *const rolling_disk_constraint_names[ROLLING_DISK_NC];
extern const char *const rolling_disk_output_names[ROLLING_DISK_NOUT];
extern const double rolling_disk_parameter_defaults[ROLLING_DISK_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 8 entries
 */
int rolling_disk_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 5 entries
 */
int rolling_disk_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 5 entries
 */
int rolling_disk_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 8 entries
 */
int rolling_disk_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 2 entries
 */
int rolling_disk_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 2 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int rolling_disk_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double rolling_disk_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 64 entries, row by row: d rhs_i / d y_j stands at 8*i + j
 */
int rolling_disk_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 3 entries
 */
int rolling_disk_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int rolling_disk_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
