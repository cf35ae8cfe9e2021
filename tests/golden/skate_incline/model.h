/*
 * skate_incline.h: skate_incline, emitted by nhc 0.1.0 (nhc:f598a06c2940e908)
 * A skate on an inclined plane with its centre of mass above the edge; it never gets far downhill.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, phi': the dependent velocities that nhc would choose (y') are
 *     singular somewhere
 *
 * State y:
 * y[0] = x [m]: down the slope
 * y[1] = y [m]: across the slope
 * y[2] = phi [rad]: heading, from the fall line
 * y[3] = v [m/s]: x'*cos(phi) + y'*sin(phi)
 * y[4] = phi' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: J = 0.4 [kg*m^2]: moment of inertia about the normal
 * p[2]: g = 9.81 [m/s^2]: acceleration of gravity
 * p[3]: alpha = 0.5235987755982988 [rad]: slope, 30 degrees
 *
 * Constraints, with the units of their reactions:
 * 0: slip [N]
 *
 * Outputs:
 * out[0] = speed [m/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 0 +-, 4 *, 0 /, 3 calls
 * velocities: 0 +-, 2 *, 0 /, 2 calls
 * accelerations: 2 +-, 7 *, 0 /, 3 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 1 +-, 2 *, 0 /, 2 calls
 * reactions: 1 +-, 4 *, 0 /, 2 calls
 * energy: 2 +-, 8 *, 0 /, 1 calls
 * jacobian: 0 +-, 4 *, 0 /, 3 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has SKATE_INCLINE_NY entries, p has SKATE_INCLINE_NP;
 *     skate_incline_parameter_defaults may be passed as p. skate_incline_state makes y from coordinates and
 *     velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: SKATE_INCLINE_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_SKATE_INCLINE_H
#define NHC_SKATE_INCLINE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    SKATE_INCLINE_NQ = 3, /* coordinates */
    SKATE_INCLINE_NY = 5, /* state: the coordinates and the velocities that are kept */
    SKATE_INCLINE_NP = 4, /* parameters */
    SKATE_INCLINE_NC = 1, /* constraints */
    SKATE_INCLINE_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    SKATE_INCLINE_OK = 0, /* the result is good */
    SKATE_INCLINE_SINGULAR_2 = 2, /* the mass matrix is singular */
    SKATE_INCLINE_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const skate_incline_coordinate_names[SKATE_INCLINE_NQ];
extern const char *const skate_incline_state_names[SKATE_INCLINE_NY];
extern const char *const skate_incline_parameter_names[SKATE_INCLINE_NP];
extern const char *const skate_incline_constraint_names[SKATE_INCLINE_NC];
extern const char *const skate_incline_output_names[SKATE_INCLINE_NOUT];
extern const double skate_incline_parameter_defaults[SKATE_INCLINE_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 5 entries
 */
int skate_incline_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 3 entries
 */
int skate_incline_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 3 entries
 */
int skate_incline_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 5 entries
 */
int skate_incline_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int skate_incline_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int skate_incline_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double skate_incline_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int skate_incline_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int skate_incline_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int skate_incline_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
