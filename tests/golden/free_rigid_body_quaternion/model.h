/*
 * free_rigid_body_quaternion.h: free_rigid_body_quaternion, emitted by nhc 0.1.0 (nhc:a5fa293c6e3ff910)
 * A free rigid body, its orientation a quaternion; Euler's equations, and no orientation that is special.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: angular velocities and quasi-velocities of the spec
 *
 * State y:
 * y[0] = R_0 [1]: quaternion of R, scalar part
 * y[1] = R_1 [1]: quaternion of R, along x
 * y[2] = R_2 [1]: quaternion of R, along y
 * y[3] = R_3 [1]: quaternion of R, along z
 * y[4] = w1 [rad/s]
 * y[5] = w2 [rad/s]
 * y[6] = w3 [rad/s]
 *
 * Parameters p:
 * p[0]: I1 = 1.0 [kg*m^2]
 * p[1]: I2 = 2.0 [kg*m^2]
 * p[2]: I3 = 3.0 [kg*m^2]
 *
 * Constraints, with the units of their reactions:
 * 0: R_norm [N*m]
 *
 * Outputs:
 * out[0] = L_x [kg*m^2/s]
 * out[1] = L_y [kg*m^2/s]
 * out[2] = L_z [kg*m^2/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 11 +-, 22 *, 3 /, 0 calls
 * velocities: 8 +-, 16 *, 0 /, 0 calls
 * accelerations: 17 +-, 39 *, 3 /, 0 calls
 * state: 12 +-, 23 *, 1 /, 0 calls
 * residuals: 3 +-, 5 *, 0 /, 0 calls
 * positions: 4 +-, 4 *, 0 /, 0 calls
 * reactions: 0 +-, 0 *, 0 /, 0 calls
 * energy: 2 +-, 7 *, 0 /, 0 calls
 * jacobian: 3 +-, 13 *, 3 /, 0 calls
 * outputs: 15 +-, 28 *, 1 /, 0 calls
 *
 * Calls: t is the time; y has FREE_RIGID_BODY_QUATERNION_NY entries, p has FREE_RIGID_BODY_QUATERNION_NP;
 *     free_rigid_body_quaternion_parameter_defaults may be passed as p. free_rigid_body_quaternion_state
 *     makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: FREE_RIGID_BODY_QUATERNION_OK (0) if the result is good; after any other code the output must
 *     not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_FREE_RIGID_BODY_QUATERNION_H
#define NHC_FREE_RIGID_BODY_QUATERNION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    FREE_RIGID_BODY_QUATERNION_NQ = 4, /* coordinates */
    FREE_RIGID_BODY_QUATERNION_NY = 7, /* state: the coordinates and the velocities that are kept */
    FREE_RIGID_BODY_QUATERNION_NP = 3, /* parameters */
    FREE_RIGID_BODY_QUATERNION_NC = 1, /* constraints */
    FREE_RIGID_BODY_QUATERNION_NOUT = 3 /* outputs */
};

/* return codes */
enum {
    FREE_RIGID_BODY_QUATERNION_OK = 0, /* the result is good */
    FREE_RIGID_BODY_QUATERNION_SINGULAR_2 = 2, /* the mass matrix is singular */
    FREE_RIGID_BODY_QUATERNION_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const free_rigid_body_quaternion_coordinate_names[FREE_RIGID_BODY_QUATERNION_NQ];
extern const char *const free_rigid_body_quaternion_state_names[FREE_RIGID_BODY_QUATERNION_NY];
extern const char *const free_rigid_body_quaternion_parameter_names[FREE_RIGID_BODY_QUATERNION_NP];
extern const char *const free_rigid_body_quaternion_constraint_names[FREE_RIGID_BODY_QUATERNION_NC];
extern const char *const free_rigid_body_quaternion_output_names[FREE_RIGID_BODY_QUATERNION_NOUT];
extern const double free_rigid_body_quaternion_parameter_defaults[FREE_RIGID_BODY_QUATERNION_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 7 entries
 */
int free_rigid_body_quaternion_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 4 entries
 */
int free_rigid_body_quaternion_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 4 entries
 */
int free_rigid_body_quaternion_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 7 entries
 */
int free_rigid_body_quaternion_state(double t, const double *q, const double *qdot, const double *p,
    double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int free_rigid_body_quaternion_residuals(double t, const double *q, const double *qdot, const double *p,
    double *r);

/*
 * left minus right side of each holonomic constraint, zero on every motion
 * f: 1 entry
 */
int free_rigid_body_quaternion_positions(double t, const double *q, const double *p, double *f);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int free_rigid_body_quaternion_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double free_rigid_body_quaternion_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 49 entries, row by row: d rhs_i / d y_j stands at 7*i + j
 */
int free_rigid_body_quaternion_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 3 entries
 */
int free_rigid_body_quaternion_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int free_rigid_body_quaternion_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *dydt);

#ifdef __cplusplus
}
#endif

#endif
