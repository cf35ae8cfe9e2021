/*
 * contact_oscillator.h: contact_oscillator, emitted by nhc 0.1.0 (nhc:b2615e8b60348bf1)
 * Three equal oscillators with one contact constraint; reversible and integrable.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x`
 *
 * State y:
 * y[0] = x
 * y[1] = y
 * y[2] = z
 * y[3] = y'
 * y[4] = z'
 *
 * No parameters.
 *
 * Constraints:
 * 0: contact
 *
 * Outputs:
 * out[0] = H_y
 * out[1] = R
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 3 +-, 4 *, 1 /, 0 calls
 * velocities: 0 +-, 1 *, 0 /, 0 calls
 * accelerations: 4 +-, 4 *, 1 /, 0 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 1 +-, 1 *, 0 /, 0 calls
 * reactions: 3 +-, 3 *, 1 /, 0 calls
 * energy: 5 +-, 7 *, 0 /, 0 calls
 * jacobian: 4 +-, 9 *, 1 /, 0 calls
 * outputs: 4 +-, 8 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has CONTACT_OSCILLATOR_NY entries, p has CONTACT_OSCILLATOR_NP;
 *     contact_oscillator_parameter_defaults may be passed as p. contact_oscillator_state makes y from
 *     coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Return codes: CONTACT_OSCILLATOR_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CONTACT_OSCILLATOR_H
#define NHC_CONTACT_OSCILLATOR_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CONTACT_OSCILLATOR_NQ = 3, /* coordinates */
    CONTACT_OSCILLATOR_NY = 5, /* state: the coordinates and the velocities that are kept */
    CONTACT_OSCILLATOR_NP = 0, /* parameters */
    CONTACT_OSCILLATOR_NC = 1, /* constraints */
    CONTACT_OSCILLATOR_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    CONTACT_OSCILLATOR_OK = 0, /* the result is good */
    CONTACT_OSCILLATOR_SINGULAR_2 = 2, /* the mass matrix is singular */
    CONTACT_OSCILLATOR_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const contact_oscillator_coordinate_names[CONTACT_OSCILLATOR_NQ];
extern const char *const contact_oscillator_state_names[CONTACT_OSCILLATOR_NY];
extern const char *const contact_oscillator_parameter_names[1];
extern const char *const contact_oscillator_constraint_names[CONTACT_OSCILLATOR_NC];
extern const char *const contact_oscillator_output_names[CONTACT_OSCILLATOR_NOUT];
extern const double contact_oscillator_parameter_defaults[1];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 5 entries
 */
int contact_oscillator_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 3 entries
 */
int contact_oscillator_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 3 entries
 */
int contact_oscillator_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 5 entries
 */
int contact_oscillator_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int contact_oscillator_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int contact_oscillator_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V
 * infinite or NaN where the model is singular
 */
double contact_oscillator_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int contact_oscillator_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int contact_oscillator_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int contact_oscillator_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *dydt);

#ifdef __cplusplus
}
#endif

#endif
