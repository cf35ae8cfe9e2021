/*
 * suslov.h: suslov, emitted by nhc 0.1.0 (nhc:6b42ca4069420f5a)
 * A rigid body with a fixed point that must not turn about one of its own axes.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = phi [rad]: precession
 * y[1] = theta [rad]: nutation
 * y[2] = psi [rad]: spin
 * y[3] = w1 [rad/s]
 * y[4] = w2 [rad/s]
 *
 * Parameters p:
 * p[0]: I11 = 1.0 [kg*m^2]
 * p[1]: I22 = 1.6 [kg*m^2]
 * p[2]: I33 = 2.0 [kg*m^2]
 * p[3]: I13 = 0.3 [kg*m^2]
 * p[4]: I23 = -0.2 [kg*m^2]
 *
 * Constraints, with the units of their reactions:
 * 0: no_spin [N*m]
 *
 * Outputs:
 * out[0] = M3 [kg*m^2/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 3 +-, 11 *, 3 /, 4 calls
 * velocities: 2 +-, 5 *, 1 /, 4 calls
 * accelerations: 11 +-, 30 *, 3 /, 4 calls
 * state: 2 +-, 5 *, 0 /, 3 calls
 * residuals: 1 +-, 1 *, 0 /, 1 calls
 * reactions: 4 +-, 8 *, 2 /, 1 calls
 * energy: 1 +-, 5 *, 0 /, 0 calls
 * jacobian: 6 +-, 22 *, 3 /, 4 calls
 * outputs: 1 +-, 2 *, 0 /, 1 calls
 *
 * Calls: t is the time; y has SUSLOV_NY entries, p has SUSLOV_NP; suslov_parameter_defaults may be passed as
 *     p. suslov_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: SUSLOV_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_SUSLOV_H
#define NHC_SUSLOV_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    SUSLOV_NQ = 3, /* coordinates */
    SUSLOV_NY = 5, /* state: the coordinates and the velocities that are kept */
    SUSLOV_NP = 5, /* parameters */
    SUSLOV_NC = 1, /* constraints */
    SUSLOV_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    SUSLOV_OK = 0, /* the result is good */
    SUSLOV_SINGULAR_1 = 1, /* the coframe is singular */
    SUSLOV_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    SUSLOV_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const suslov_coordinate_names[SUSLOV_NQ];
extern const char *const suslov_state_names[SUSLOV_NY];
extern const char *const suslov_parameter_names[SUSLOV_NP];
extern const char *const suslov_constraint_names[SUSLOV_NC];
extern const char *const suslov_output_names[SUSLOV_NOUT];
extern const double suslov_parameter_defaults[SUSLOV_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 5 entries
 */
int suslov_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 3 entries
 */
int suslov_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 3 entries
 */
int suslov_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 5 entries
 */
int suslov_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int suslov_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int suslov_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double suslov_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int suslov_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int suslov_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int suslov_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
