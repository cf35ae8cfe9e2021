/*
 * cvt.h: cvt, emitted by nhc 0.1.0 (nhc:2418eb800692e8f8)
 * A continuously variable transmission; a plane oscillator whose free direction is set by a symmetric driver.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 * Note: hypothesis of I.3 that fails (the generalized equations are used): a force acts on the dependent
 *     coordinate `y`
 *
 * State y:
 * y[0] = x
 * y[1] = y
 * y[2] = xi
 * y[3] = x'
 * y[4] = xi'
 *
 * No parameters.
 *
 * Constraints:
 * 0: belt
 *
 * Outputs:
 * out[0] = E_xi
 * out[1] = E_xy
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 3 +-, 5 *, 1 /, 2 calls
 * velocities: 0 +-, 1 *, 0 /, 1 calls
 * accelerations: 4 +-, 5 *, 1 /, 2 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 1 +-, 1 *, 0 /, 1 calls
 * reactions: 3 +-, 4 *, 1 /, 2 calls
 * energy: 5 +-, 8 *, 0 /, 2 calls
 * jacobian: 5 +-, 15 *, 1 /, 2 calls
 * outputs: 4 +-, 8 *, 0 /, 2 calls
 *
 * Calls: t is the time; y has CVT_NY entries, p has CVT_NP; cvt_parameter_defaults may be passed as p.
 *     cvt_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Return codes: CVT_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CVT_H
#define NHC_CVT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CVT_NQ = 3, /* coordinates */
    CVT_NY = 5, /* state: the coordinates and the velocities that are kept */
    CVT_NP = 0, /* parameters */
    CVT_NC = 1, /* constraints */
    CVT_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    CVT_OK = 0, /* the result is good */
    CVT_SINGULAR_2 = 2, /* the mass matrix is singular */
    CVT_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const cvt_coordinate_names[CVT_NQ];
extern const char *const cvt_state_names[CVT_NY];
extern const char *const cvt_parameter_names[1];
extern const char *const cvt_constraint_names[CVT_NC];
extern const char *const cvt_output_names[CVT_NOUT];
extern const double cvt_parameter_defaults[1];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 5 entries
 */
int cvt_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 3 entries
 */
int cvt_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 3 entries
 */
int cvt_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 5 entries
 */
int cvt_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int cvt_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int cvt_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V
 * infinite or NaN where the model is singular
 */
double cvt_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int cvt_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int cvt_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int cvt_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
