/*
 * cvt_eps.h: cvt_eps, emitted by nhc 0.1.0 (nhc:cf2f4c3e0b698726)
 * The transmission with a driver that breaks the symmetry; most integrators for nonholonomic systems drift on
 *     it.
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
 * Parameters p:
 * p[0]: eps = 0.3: what breaks the symmetry of the driver
 *
 * Constraints:
 * 0: belt
 *
 * Outputs:
 * out[0] = E_xi
 * out[1] = E_xy
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 5 +-, 7 *, 1 /, 2 calls
 * velocities: 0 +-, 1 *, 0 /, 1 calls
 * accelerations: 6 +-, 7 *, 1 /, 2 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 1 +-, 1 *, 0 /, 1 calls
 * reactions: 3 +-, 4 *, 1 /, 2 calls
 * energy: 6 +-, 11 *, 0 /, 2 calls
 * jacobian: 6 +-, 17 *, 1 /, 2 calls
 * outputs: 5 +-, 11 *, 0 /, 2 calls
 *
 * Calls: t is the time; y has CVT_EPS_NY entries, p has CVT_EPS_NP; cvt_eps_parameter_defaults may be passed
 *     as p. cvt_eps_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Return codes: CVT_EPS_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CVT_EPS_H
#define NHC_CVT_EPS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CVT_EPS_NQ = 3, /* coordinates */
    CVT_EPS_NY = 5, /* state: the coordinates and the velocities that are kept */
    CVT_EPS_NP = 1, /* parameters */
    CVT_EPS_NC = 1, /* constraints */
    CVT_EPS_NOUT = 2 /* outputs */
};

/* return codes */
enum {
    CVT_EPS_OK = 0, /* the result is good */
    CVT_EPS_SINGULAR_2 = 2, /* the mass matrix is singular */
    CVT_EPS_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const cvt_eps_coordinate_names[CVT_EPS_NQ];
extern const char *const cvt_eps_state_names[CVT_EPS_NY];
extern const char *const cvt_eps_parameter_names[CVT_EPS_NP];
extern const char *const cvt_eps_constraint_names[CVT_EPS_NC];
extern const char *const cvt_eps_output_names[CVT_EPS_NOUT];
extern const double cvt_eps_parameter_defaults[CVT_EPS_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 5 entries
 */
int cvt_eps_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 3 entries
 */
int cvt_eps_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 3 entries
 */
int cvt_eps_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 5 entries
 */
int cvt_eps_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int cvt_eps_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int cvt_eps_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V
 * infinite or NaN where the model is singular
 */
double cvt_eps_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int cvt_eps_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 2 entries
 */
int cvt_eps_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int cvt_eps_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
