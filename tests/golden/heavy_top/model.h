/*
 * heavy_top.h: heavy_top, emitted by nhc 0.1.0 (nhc:945a14844d04cd89)
 * The symmetric top with a fixed point (Lagrange's top).
 * Equations of motion: lagrange (II.3)
 * Why: no constraints
 *
 * State y:
 * y[0] = phi [rad]: precession
 * y[1] = theta [rad]: nutation
 * y[2] = psi [rad]: spin
 * y[3] = phi' [rad/s]
 * y[4] = theta' [rad/s]
 * y[5] = psi' [rad/s]
 *
 * Parameters p:
 * p[0]: I1 = 1.0 [kg*m^2]: across the axis, at the fixed point
 * p[1]: I3 = 1.5 [kg*m^2]: about the axis
 * p[2]: mgl = 2.0 [N*m]: weight times the distance of the centre of mass
 *
 * Outputs:
 * out[0] = p_phi [kg*m^2/s]
 * out[1] = p_psi [kg*m^2/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 5 +-, 13 *, 2 /, 2 calls
 * velocities: 0 +-, 0 *, 0 /, 0 calls
 * accelerations: 5 +-, 13 *, 2 /, 2 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 0 +-, 0 *, 0 /, 0 calls
 * reactions: 0 +-, 2 *, 0 /, 1 calls
 * energy: 4 +-, 10 *, 0 /, 2 calls
 * jacobian: 14 +-, 33 *, 2 /, 2 calls
 * outputs: 2 +-, 6 *, 0 /, 2 calls
 *
 * Calls: t is the time; y has HEAVY_TOP_NY entries, p has HEAVY_TOP_NP; heavy_top_parameter_defaults may be
 *     passed as p. heavy_top_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: HEAVY_TOP_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_HEAVY_TOP_H
#define NHC_HEAVY_TOP_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    HEAVY_TOP_NQ = 3, /* coordinates */
    HEAVY_TOP_NY = 6, /* state: the coordinates and the velocities that are kept */
    HEAVY_TOP_NP = 3, /* parameters */
    HEAVY_TOP_NC = 0, /* constraints */
    HEAVY_TOP_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    HEAVY_TOP_OK = 0, /* the result is good */
    HEAVY_TOP_SINGULAR_2 = 2, /* the mass matrix is singular */
    HEAVY_TOP_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const heavy_top_coordinate_names[HEAVY_TOP_NQ];
extern const char *const heavy_top_state_names[HEAVY_TOP_NY];
extern const char *const heavy_top_parameter_names[HEAVY_TOP_NP];
extern const char *const heavy_top_constraint_names[1];
extern const char *const heavy_top_output_names[HEAVY_TOP_NOUT];
extern const double heavy_top_parameter_defaults[HEAVY_TOP_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (II.3)
 * dydt: 6 entries
 */
int heavy_top_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state
 * qdot: 3 entries
 */
int heavy_top_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (II.3)
 * qddot: 3 entries
 */
int heavy_top_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 6 entries
 */
int heavy_top_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 0 entries
 */
int heavy_top_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 0 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int heavy_top_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double heavy_top_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (II.3)
 * J: 36 entries, row by row: d rhs_i / d y_j stands at 6*i + j
 */
int heavy_top_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int heavy_top_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int heavy_top_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
