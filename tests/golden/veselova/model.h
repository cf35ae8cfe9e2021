/*
 * veselova.h: veselova, emitted by nhc 0.1.0 (nhc:9654cc8bde34bf57)
 * A rigid body with a fixed point that must not turn about the vertical.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = phi [rad]: precession
 * y[1] = theta [rad]: nutation
 * y[2] = psi [rad]: spin
 * y[3] = w_x [rad/s]
 * y[4] = w_y [rad/s]
 *
 * Parameters p:
 * p[0]: I1 = 1.0 [kg*m^2]
 * p[1]: I2 = 1.7 [kg*m^2]
 * p[2]: I3 = 2.3 [kg*m^2]
 *
 * Constraints, with the units of their reactions:
 * 0: no_turn [N*m]
 *
 * Outputs:
 * out[0] = L_x [kg*m^2/s]
 * out[1] = L_y [kg*m^2/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 22 +-, 41 *, 3 /, 6 calls
 * velocities: 2 +-, 5 *, 1 /, 4 calls
 * accelerations: 30 +-, 59 *, 3 /, 6 calls
 * state: 2 +-, 5 *, 0 /, 3 calls
 * residuals: 1 +-, 1 *, 0 /, 1 calls
 * reactions: 35 +-, 71 *, 3 /, 6 calls
 * energy: 7 +-, 18 *, 1 /, 6 calls
 * jacobian: 95 +-, 196 *, 3 /, 6 calls
 * outputs: 10 +-, 24 *, 1 /, 6 calls
 *
 * Calls: t is the time; y has VESELOVA_NY entries, p has VESELOVA_NP; veselova_parameter_defaults may be
 *     passed as p. veselova_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: VESELOVA_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_VESELOVA_H
#define NHC_VESELOVA_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    VESELOVA_NQ = 3, /* coordinates */
    VESELOVA_NY = 5, /* state: the coordinates and the velocities that are kept */
    VESELOVA_NP = 3, /* parameters */
    VESELOVA_NC = 1, /* constraints */
    VESELOVA_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    VESELOVA_OK = 0, /* the result is good */
    VESELOVA_SINGULAR_1 = 1, /* the coframe is singular */
    VESELOVA_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    VESELOVA_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const veselova_coordinate_names[VESELOVA_NQ];
extern const char *const veselova_state_names[VESELOVA_NY];
extern const char *const veselova_parameter_names[VESELOVA_NP];
extern const char *const veselova_constraint_names[VESELOVA_NC];
extern const char *const veselova_output_names[VESELOVA_NOUT];
extern const double veselova_parameter_defaults[VESELOVA_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 5 entries
 */
int veselova_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 3 entries
 */
int veselova_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 3 entries
 */
int veselova_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 5 entries
 */
int veselova_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int veselova_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int veselova_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double veselova_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int veselova_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int veselova_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int veselova_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
