/*
 * smooth_tippe_top.h: smooth_tippe_top, emitted by nhc 0.1.0 (nhc:2e1ddc1536d8bc45)
 * The ball of routh_sphere on a plane without any friction.
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 *
 * State y:
 * y[0] = x [m]: geometric centre
 * y[1] = y [m]: geometric centre
 * y[2] = phi [rad]: precession
 * y[3] = theta [rad]: nutation
 * y[4] = psi [rad]: spin
 * y[5] = x' [m/s]
 * y[6] = y' [m/s]
 * y[7] = phi' [rad/s]
 * y[8] = theta' [rad/s]
 * y[9] = psi' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: R = 1.0 [m]: radius
 * p[2]: e = -0.2 [m]: centre of mass along the axis of symmetry
 * p[3]: I1 = 0.38 [kg*m^2]: across the axis, at the centre of mass
 * p[4]: I3 = 0.42 [kg*m^2]: about the axis
 * p[5]: g = 9.81 [m/s^2]: acceleration of gravity
 *
 * Outputs:
 * out[0] = jellett [kg*m^3/s]
 * out[1] = spin [rad/s]
 * out[2] = p_x [kg*m/s]
 * out[3] = p_y [kg*m/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 12 +-, 33 *, 3 /, 4 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 12 +-, 34 *, 3 /, 4 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 2 +-, 6 *, 0 /, 1 calls
 * energy: 11 +-, 25 *, 0 /, 4 calls
 * jacobian: 38 +-, 116 *, 3 /, 4 calls
 * outputs: 7 +-, 18 *, 0 /, 4 calls
 *
 * Calls: t is the time; y has SMOOTH_TIPPE_TOP_NY entries, p has SMOOTH_TIPPE_TOP_NP;
 *     smooth_tippe_top_parameter_defaults may be passed as p. smooth_tippe_top_state makes y from coordinates
 *     and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: SMOOTH_TIPPE_TOP_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_SMOOTH_TIPPE_TOP_H
#define NHC_SMOOTH_TIPPE_TOP_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    SMOOTH_TIPPE_TOP_NQ = 5, /* coordinates */
    SMOOTH_TIPPE_TOP_NY = 10, /* state: the coordinates and the velocities that are kept */
    SMOOTH_TIPPE_TOP_NP = 6, /* parameters */
    SMOOTH_TIPPE_TOP_NC = 0, /* constraints */
    SMOOTH_TIPPE_TOP_NOUT = 4 /* outputs */
};

/* return codes */
enum {
    SMOOTH_TIPPE_TOP_OK = 0, /* the result is good */
    SMOOTH_TIPPE_TOP_SINGULAR_2 = 2, /* the mass matrix is singular */
    SMOOTH_TIPPE_TOP_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const smooth_tippe_top_coordinate_names[SMOOTH_TIPPE_TOP_NQ];
extern const char *const smooth_tippe_top_state_names[SMOOTH_TIPPE_TOP_NY];
extern const char *const smooth_tippe_top_parameter_names[SMOOTH_TIPPE_TOP_NP];
extern const char *const smooth_tippe_top_constraint_names[1];
extern const char *const smooth_tippe_top_output_names[SMOOTH_TIPPE_TOP_NOUT];
extern const double smooth_tippe_top_parameter_defaults[SMOOTH_TIPPE_TOP_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 10 entries
 */
int smooth_tippe_top_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state
 * qdot: 5 entries
 */
int smooth_tippe_top_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 5 entries
 */
int smooth_tippe_top_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 10 entries
 */
int smooth_tippe_top_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int smooth_tippe_top_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int smooth_tippe_top_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double smooth_tippe_top_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (II.3)
 * J: 100 entries, row by row: d rhs_i / d y_j stands at 10*i + j
 */
int smooth_tippe_top_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 4 entries
 */
int smooth_tippe_top_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int smooth_tippe_top_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
