/*
 * chaotic.h: chaotic, emitted by nhc 0.1.0 (nhc:55cba38180e3c9e3)
 * Seven coupled oscillators with one contact constraint; reversible and chaotic.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `x`
 *
 * State y:
 * y[0] = x
 * y[1] = y1
 * y[2] = y2
 * y[3] = y3
 * y[4] = z1
 * y[5] = z2
 * y[6] = z3
 * y[7] = y1'
 * y[8] = y2'
 * y[9] = y3'
 * y[10] = z1'
 * y[11] = z2'
 * y[12] = z3'
 *
 * No parameters.
 *
 * Constraints:
 * 0: contact
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 20 +-, 24 *, 1 /, 0 calls
 * velocities: 2 +-, 3 *, 0 /, 0 calls
 * accelerations: 21 +-, 24 *, 1 /, 0 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 3 +-, 3 *, 0 /, 0 calls
 * reactions: 13 +-, 14 *, 1 /, 0 calls
 * energy: 19 +-, 22 *, 0 /, 0 calls
 * jacobian: 53 +-, 102 *, 1 /, 0 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has CHAOTIC_NY entries, p has CHAOTIC_NP; chaotic_parameter_defaults may be passed
 *     as p. chaotic_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Return codes: CHAOTIC_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CHAOTIC_H
#define NHC_CHAOTIC_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CHAOTIC_NQ = 7, /* coordinates */
    CHAOTIC_NY = 13, /* state: the coordinates and the velocities that are kept */
    CHAOTIC_NP = 0, /* parameters */
    CHAOTIC_NC = 1, /* constraints */
    CHAOTIC_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    CHAOTIC_OK = 0, /* the result is good */
    CHAOTIC_SINGULAR_2 = 2, /* the mass matrix is singular */
    CHAOTIC_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const chaotic_coordinate_names[CHAOTIC_NQ];
extern const char *const chaotic_state_names[CHAOTIC_NY];
extern const char *const chaotic_parameter_names[1];
extern const char *const chaotic_constraint_names[CHAOTIC_NC];
extern const char *const chaotic_output_names[1];
extern const double chaotic_parameter_defaults[1];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 13 entries
 */
int chaotic_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 7 entries
 */
int chaotic_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 7 entries
 */
int chaotic_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 13 entries
 */
int chaotic_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int chaotic_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int chaotic_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V
 * infinite or NaN where the model is singular
 */
double chaotic_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 169 entries, row by row: d rhs_i / d y_j stands at 13*i + j
 */
int chaotic_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int chaotic_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int chaotic_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
