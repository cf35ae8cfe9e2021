/*
 * charged_sleigh.h: charged_sleigh, emitted by nhc 0.1.0 (nhc:6eb9153c5c878a0a)
 * Caplygin's sleigh with a charge at its centre of mass in a magnetic field; T depends on x and y.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: point of the edge
 * y[1] = y [m]: point of the edge
 * y[2] = theta [rad]: heading
 * y[3] = v [m/s]
 * y[4] = w [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: J = 0.5 [kg*m^2]: moment of inertia about the centre of mass
 * p[2]: a = 0.7 [m]: from the edge to the centre of mass
 * p[3]: B = 0.9 [kg/s]: charge times field
 *
 * Constraints, with the units of their reactions:
 * 0: slip [N]
 *
 * Outputs:
 * out[0] = speed [m/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 2 +-, 10 *, 2 /, 2 calls
 * velocities: 0 +-, 2 *, 0 /, 2 calls
 * accelerations: 4 +-, 13 *, 2 /, 2 calls
 * state: 1 +-, 2 *, 0 /, 2 calls
 * residuals: 1 +-, 2 *, 0 /, 2 calls
 * reactions: 2 +-, 5 *, 1 /, 0 calls
 * energy: 7 +-, 15 *, 0 /, 2 calls
 * jacobian: 3 +-, 12 *, 2 /, 2 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has CHARGED_SLEIGH_NY entries, p has CHARGED_SLEIGH_NP;
 *     charged_sleigh_parameter_defaults may be passed as p. charged_sleigh_state makes y from coordinates and
 *     velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: CHARGED_SLEIGH_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CHARGED_SLEIGH_H
#define NHC_CHARGED_SLEIGH_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CHARGED_SLEIGH_NQ = 3, /* coordinates */
    CHARGED_SLEIGH_NY = 5, /* state: the coordinates and the velocities that are kept */
    CHARGED_SLEIGH_NP = 4, /* parameters */
    CHARGED_SLEIGH_NC = 1, /* constraints */
    CHARGED_SLEIGH_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    CHARGED_SLEIGH_OK = 0, /* the result is good */
    CHARGED_SLEIGH_SINGULAR_2 = 2, /* the mass matrix is singular */
    CHARGED_SLEIGH_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const charged_sleigh_coordinate_names[CHARGED_SLEIGH_NQ];
extern const char *const charged_sleigh_state_names[CHARGED_SLEIGH_NY];
extern const char *const charged_sleigh_parameter_names[CHARGED_SLEIGH_NP];
extern const char *const charged_sleigh_constraint_names[CHARGED_SLEIGH_NC];
extern const char *const charged_sleigh_output_names[CHARGED_SLEIGH_NOUT];
extern const double charged_sleigh_parameter_defaults[CHARGED_SLEIGH_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 5 entries
 */
int charged_sleigh_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 3 entries
 */
int charged_sleigh_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 3 entries
 */
int charged_sleigh_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 5 entries
 */
int charged_sleigh_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int charged_sleigh_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int charged_sleigh_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double charged_sleigh_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int charged_sleigh_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int charged_sleigh_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int charged_sleigh_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
