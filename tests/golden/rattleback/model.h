/*
 * rattleback.h: rattleback, emitted by nhc 0.1.0 (nhc:3557d0763e9d95fc)
 * A loaded ellipsoid that rolls on a plane and prefers one sense of spin (celt, wobblestone).
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [cm]: centre of mass
 * y[1] = y [cm]: centre of mass
 * y[2] = z [cm]: centre of mass, downwards
 * y[3] = alpha [rad]: roll about the long axis
 * y[4] = beta [rad]: pitch
 * y[5] = gamma [rad]: heading
 * y[6] = w1 [rad/s]
 * y[7] = w2 [rad/s]
 * y[8] = w3 [rad/s]
 *
 * Parameters p:
 * p[0]: a = 20.0 [cm]: half axis 1 of the ellipsoid
 * p[1]: b = 3.0 [cm]: half axis 2
 * p[2]: c = 2.0 [cm]: half axis 3
 * p[3]: h = 1.0 [cm]: from the centre of the ellipsoid down to the centre of mass
 * p[4]: I_a = 2.0 [cm^2]
 * p[5]: I_b = 16.0 [cm^2]
 * p[6]: I_c = 17.0 [cm^2]
 * p[7]: I_d = -0.2 [cm^2]: product of inertia, what makes it a rattleback
 * p[8]: g = 981.0 [cm/s^2]: acceleration of gravity
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x [cm/s^2]
 * 1: roll_y [cm/s^2]
 * 2: roll_z [cm/s^2]
 *
 * Outputs:
 * out[0] = spin [rad/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 61 +-, 112 *, 5 /, 7 calls
 * velocities: 15 +-, 40 *, 2 /, 7 calls
 * accelerations: 94 +-, 161 *, 5 /, 7 calls
 * state: 3 +-, 6 *, 0 /, 4 calls
 * residuals: 18 +-, 40 *, 1 /, 7 calls
 * reactions: 86 +-, 154 *, 5 /, 7 calls
 * energy: 13 +-, 36 *, 1 /, 5 calls
 * jacobian: 439 +-, 662 *, 5 /, 7 calls
 * outputs: 0 +-, 0 *, 0 /, 1 calls
 *
 * Calls: t is the time; y has RATTLEBACK_NY entries, p has RATTLEBACK_NP; rattleback_parameter_defaults may
 *     be passed as p. rattleback_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: RATTLEBACK_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_RATTLEBACK_H
#define NHC_RATTLEBACK_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    RATTLEBACK_NQ = 6, /* coordinates */
    RATTLEBACK_NY = 9, /* state: the coordinates and the velocities that are kept */
    RATTLEBACK_NP = 9, /* parameters */
    RATTLEBACK_NC = 3, /* constraints */
    RATTLEBACK_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    RATTLEBACK_OK = 0, /* the result is good */
    RATTLEBACK_SINGULAR_1 = 1, /* the coframe is singular */
    RATTLEBACK_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    RATTLEBACK_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const rattleback_coordinate_names[RATTLEBACK_NQ];
extern const char *const rattleback_state_names[RATTLEBACK_NY];
extern const char *const rattleback_parameter_names[RATTLEBACK_NP];
extern const char *const rattleback_constraint_names[RATTLEBACK_NC];
extern const char *const rattleback_output_names[RATTLEBACK_NOUT];
extern const double rattleback_parameter_defaults[RATTLEBACK_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 9 entries
 */
int rattleback_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 6 entries
 */
int rattleback_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 6 entries
 */
int rattleback_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 9 entries
 */
int rattleback_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 3 entries
 */
int rattleback_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 3 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int rattleback_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [cm^2/s^2]
 * infinite or NaN where the model is singular
 */
double rattleback_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 81 entries, row by row: d rhs_i / d y_j stands at 9*i + j
 */
int rattleback_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int rattleback_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int rattleback_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
