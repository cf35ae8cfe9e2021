/*
 * diff_drive.h: diff_drive, emitted by nhc 0.1.0 (nhc:c1ea6d183d986468)
 * A cart with two driven wheels and a caster; three velocity constraints, one of which is holonomic in
 *     disguise.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: midpoint of the axle
 * y[1] = y [m]: midpoint of the axle
 * y[2] = theta [rad]: heading
 * y[3] = p_R [rad]: right wheel
 * y[4] = p_L [rad]: left wheel
 * y[5] = v [m/s]
 * y[6] = w [rad/s]
 *
 * Parameters p:
 * p[0]: m = 10.0 [kg]: mass
 * p[1]: I = 0.6 [kg*m^2]: of the whole about the vertical through the centre of mass
 * p[2]: J_w = 0.02 [kg*m^2]: of a wheel about its axle
 * p[3]: r = 0.1 [m]: radius of the wheels
 * p[4]: b = 0.25 [m]: half the track
 * p[5]: d = 0.1 [m]: from the axle to the centre of mass
 * p[6]: tau_R = 0.3 [N*m]: torque on the right wheel
 * p[7]: tau_L = 0.2 [N*m]: torque on the left wheel
 *
 * Constraints, with the units of their reactions:
 * 0: slip [N]
 * 1: roll_R [N]
 * 2: roll_L [N]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 9 +-, 22 *, 3 /, 2 calls
 * velocities: 2 +-, 5 *, 1 /, 2 calls
 * accelerations: 11 +-, 24 *, 3 /, 2 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 6 +-, 7 *, 0 /, 2 calls
 * reactions: 12 +-, 24 *, 3 /, 0 calls
 * energy: 4 +-, 13 *, 1 /, 0 calls
 * jacobian: 3 +-, 17 *, 3 /, 2 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has DIFF_DRIVE_NY entries, p has DIFF_DRIVE_NP; diff_drive_parameter_defaults may
 *     be passed as p. diff_drive_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: DIFF_DRIVE_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_DIFF_DRIVE_H
#define NHC_DIFF_DRIVE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    DIFF_DRIVE_NQ = 5, /* coordinates */
    DIFF_DRIVE_NY = 7, /* state: the coordinates and the velocities that are kept */
    DIFF_DRIVE_NP = 8, /* parameters */
    DIFF_DRIVE_NC = 3, /* constraints */
    DIFF_DRIVE_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    DIFF_DRIVE_OK = 0, /* the result is good */
    DIFF_DRIVE_SINGULAR_1 = 1, /* the coframe is singular */
    DIFF_DRIVE_SINGULAR_2 = 2, /* the mass matrix is singular */
    DIFF_DRIVE_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const diff_drive_coordinate_names[DIFF_DRIVE_NQ];
extern const char *const diff_drive_state_names[DIFF_DRIVE_NY];
extern const char *const diff_drive_parameter_names[DIFF_DRIVE_NP];
extern const char *const diff_drive_constraint_names[DIFF_DRIVE_NC];
extern const char *const diff_drive_output_names[1];
extern const double diff_drive_parameter_defaults[DIFF_DRIVE_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 7 entries
 */
int diff_drive_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 5 entries
 */
int diff_drive_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 5 entries
 */
int diff_drive_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 7 entries
 */
int diff_drive_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 3 entries
 */
int diff_drive_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 3 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int diff_drive_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double diff_drive_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 49 entries, row by row: d rhs_i / d y_j stands at 7*i + j
 */
int diff_drive_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int diff_drive_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int diff_drive_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
