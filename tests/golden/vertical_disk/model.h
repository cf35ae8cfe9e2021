/*
 * vertical_disk.h: vertical_disk, emitted by nhc 0.1.0 (nhc:b73ecedab1dc7c24)
 * A disk that stays upright and rolls without slipping.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 *
 * State y:
 * y[0] = x [m]: point of contact
 * y[1] = y [m]: point of contact
 * y[2] = phi [rad]: heading
 * y[3] = theta [rad]: angle rolled
 * y[4] = phi' [rad/s]
 * y[5] = theta' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: R = 0.5 [m]: radius
 * p[2]: I = 0.125 [kg*m^2]: moment of inertia about the axle
 * p[3]: J = 0.0625 [kg*m^2]: moment of inertia about the vertical
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x [N]
 * 1: roll_y [N]
 *
 * Outputs:
 * out[0] = speed [m/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 1 +-, 5 *, 0 /, 2 calls
 * velocities: 0 +-, 3 *, 0 /, 2 calls
 * accelerations: 1 +-, 6 *, 0 /, 2 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 2 +-, 3 *, 0 /, 2 calls
 * reactions: 1 +-, 6 *, 0 /, 2 calls
 * energy: 2 +-, 7 *, 0 /, 0 calls
 * jacobian: 1 +-, 6 *, 0 /, 2 calls
 * outputs: 0 +-, 1 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has VERTICAL_DISK_NY entries, p has VERTICAL_DISK_NP;
 *     vertical_disk_parameter_defaults may be passed as p. vertical_disk_state makes y from coordinates and
 *     velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: VERTICAL_DISK_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_VERTICAL_DISK_H
#define NHC_VERTICAL_DISK_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    VERTICAL_DISK_NQ = 4, /* coordinates */
    VERTICAL_DISK_NY = 6, /* state: the coordinates and the velocities that are kept */
    VERTICAL_DISK_NP = 4, /* parameters */
    VERTICAL_DISK_NC = 2, /* constraints */
    VERTICAL_DISK_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    VERTICAL_DISK_OK = 0, /* the result is good */
    VERTICAL_DISK_SINGULAR_2 = 2, /* the mass matrix is singular */
    VERTICAL_DISK_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const vertical_disk_coordinate_names[VERTICAL_DISK_NQ];
extern const char *const vertical_disk_state_names[VERTICAL_DISK_NY];
extern const char *const vertical_disk_parameter_names[VERTICAL_DISK_NP];
extern const char *const vertical_disk_constraint_names[VERTICAL_DISK_NC];
extern const char *const vertical_disk_output_names[VERTICAL_DISK_NOUT];
extern const double vertical_disk_parameter_defaults[VERTICAL_DISK_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 6 entries
 */
int vertical_disk_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 4 entries
 */
int vertical_disk_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 4 entries
 */
int vertical_disk_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 6 entries
 */
int vertical_disk_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 2 entries
 */
int vertical_disk_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 2 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int vertical_disk_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double vertical_disk_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 36 entries, row by row: d rhs_i / d y_j stands at 6*i + j
 */
int vertical_disk_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int vertical_disk_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int vertical_disk_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
