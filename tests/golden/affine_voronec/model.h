/*
 * affine_voronec.h: affine_voronec, emitted by nhc 0.1.0 (nhc:6cbe3932b0443142)
 * A particle with everything at once; affine constraint, time, T of degrees 2, 1 and 0, drag, a driving
 *     force.
 * Equations of motion: voronec (I.4.9)
 * Why: dependent velocities of the spec; Caplygin's equations do not apply: T contains the dependent
 *     coordinate `z`
 *
 * State y:
 * y[0] = x
 * y[1] = y
 * y[2] = z
 * y[3] = x'
 * y[4] = y'
 *
 * No parameters.
 *
 * Constraints:
 * 0: contact
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 54 +-, 91 *, 2 /, 4 calls
 * velocities: 4 +-, 10 *, 0 /, 3 calls
 * accelerations: 59 +-, 114 *, 2 /, 4 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 5 +-, 10 *, 0 /, 3 calls
 * reactions: 60 +-, 117 *, 2 /, 4 calls
 * energy: 18 +-, 37 *, 0 /, 4 calls
 * jacobian: 223 +-, 435 *, 2 /, 4 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has AFFINE_VORONEC_NY entries, p has AFFINE_VORONEC_NP;
 *     affine_voronec_parameter_defaults may be passed as p. affine_voronec_state makes y from coordinates and
 *     velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Return codes: AFFINE_VORONEC_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_AFFINE_VORONEC_H
#define NHC_AFFINE_VORONEC_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    AFFINE_VORONEC_NQ = 3, /* coordinates */
    AFFINE_VORONEC_NY = 5, /* state: the coordinates and the velocities that are kept */
    AFFINE_VORONEC_NP = 0, /* parameters */
    AFFINE_VORONEC_NC = 1, /* constraints */
    AFFINE_VORONEC_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    AFFINE_VORONEC_OK = 0, /* the result is good */
    AFFINE_VORONEC_SINGULAR_2 = 2, /* the mass matrix is singular */
    AFFINE_VORONEC_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const affine_voronec_coordinate_names[AFFINE_VORONEC_NQ];
extern const char *const affine_voronec_state_names[AFFINE_VORONEC_NY];
extern const char *const affine_voronec_parameter_names[1];
extern const char *const affine_voronec_constraint_names[AFFINE_VORONEC_NC];
extern const char *const affine_voronec_output_names[1];
extern const double affine_voronec_parameter_defaults[1];

/*
 * right-hand side dy/dt = f(t, y; p) (I.4.9)
 * dydt: 5 entries
 */
int affine_voronec_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 3 entries
 */
int affine_voronec_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.4.9)
 * qddot: 3 entries
 */
int affine_voronec_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 5 entries
 */
int affine_voronec_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int affine_voronec_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int affine_voronec_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V
 * infinite or NaN where the model is singular
 */
double affine_voronec_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.4.9)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int affine_voronec_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int affine_voronec_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int affine_voronec_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
