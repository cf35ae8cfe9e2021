/*
 * chaplygin_ball_quaternion.h: chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:87f0c7a014ec8ec4)
 * A ball with three different moments of inertia rolls on a horizontal plane; its orientation is a
 *     quaternion.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: angular velocities and quasi-velocities of the spec
 *
 * State y:
 * y[0] = x [m]: centre
 * y[1] = y [m]: centre
 * y[2] = R_0 [1]: quaternion of R, scalar part
 * y[3] = R_1 [1]: quaternion of R, along x
 * y[4] = R_2 [1]: quaternion of R, along y
 * y[5] = R_3 [1]: quaternion of R, along z
 * y[6] = w1 [rad/s]
 * y[7] = w2 [rad/s]
 * y[8] = w3 [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass
 * p[1]: a = 1.0 [m]: radius
 * p[2]: I1 = 0.4 [kg*m^2]
 * p[3]: I2 = 0.5 [kg*m^2]
 * p[4]: I3 = 0.7 [kg*m^2]
 *
 * Constraints, with the units of their reactions:
 * 0: roll_x [N]
 * 1: roll_y [N]
 * 2: R_norm [N*m]
 *
 * Outputs:
 * out[0] = K_x [kg*m^2/s]
 * out[1] = K_y [kg*m^2/s]
 * out[2] = K_z [kg*m^2/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 46 +-, 76 *, 4 /, 0 calls
 * velocities: 23 +-, 47 *, 1 /, 0 calls
 * accelerations: 78 +-, 158 *, 4 /, 0 calls
 * state: 12 +-, 23 *, 1 /, 0 calls
 * residuals: 29 +-, 50 *, 1 /, 0 calls
 * positions: 4 +-, 4 *, 0 /, 0 calls
 * reactions: 37 +-, 85 *, 4 /, 0 calls
 * energy: 15 +-, 37 *, 1 /, 0 calls
 * jacobian: 153 +-, 350 *, 4 /, 0 calls
 * outputs: 26 +-, 44 *, 1 /, 0 calls
 *
 * Calls: t is the time; y has CHAPLYGIN_BALL_QUATERNION_NY entries, p has CHAPLYGIN_BALL_QUATERNION_NP;
 *     chaplygin_ball_quaternion_parameter_defaults may be passed as p. chaplygin_ball_quaternion_state makes
 *     y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: CHAPLYGIN_BALL_QUATERNION_OK (0) if the result is good; after any other code the output must
 *     not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_CHAPLYGIN_BALL_QUATERNION_H
#define NHC_CHAPLYGIN_BALL_QUATERNION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    CHAPLYGIN_BALL_QUATERNION_NQ = 6, /* coordinates */
    CHAPLYGIN_BALL_QUATERNION_NY = 9, /* state: the coordinates and the velocities that are kept */
    CHAPLYGIN_BALL_QUATERNION_NP = 5, /* parameters */
    CHAPLYGIN_BALL_QUATERNION_NC = 3, /* constraints */
    CHAPLYGIN_BALL_QUATERNION_NOUT = 3 /* outputs */
};

/* return codes */
enum {
    CHAPLYGIN_BALL_QUATERNION_OK = 0, /* the result is good */
    CHAPLYGIN_BALL_QUATERNION_SINGULAR_2 = 2, /* the mass matrix is singular */
    CHAPLYGIN_BALL_QUATERNION_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const chaplygin_ball_quaternion_coordinate_names[CHAPLYGIN_BALL_QUATERNION_NQ];
extern const char *const chaplygin_ball_quaternion_state_names[CHAPLYGIN_BALL_QUATERNION_NY];
extern const char *const chaplygin_ball_quaternion_parameter_names[CHAPLYGIN_BALL_QUATERNION_NP];
extern const char *const chaplygin_ball_quaternion_constraint_names[CHAPLYGIN_BALL_QUATERNION_NC];
extern const char *const chaplygin_ball_quaternion_output_names[CHAPLYGIN_BALL_QUATERNION_NOUT];
extern const double chaplygin_ball_quaternion_parameter_defaults[CHAPLYGIN_BALL_QUATERNION_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 9 entries
 */
int chaplygin_ball_quaternion_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 6 entries
 */
int chaplygin_ball_quaternion_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 6 entries
 */
int chaplygin_ball_quaternion_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 9 entries
 */
int chaplygin_ball_quaternion_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 3 entries
 */
int chaplygin_ball_quaternion_residuals(double t, const double *q, const double *qdot, const double *p,
    double *r);

/*
 * left minus right side of each holonomic constraint, zero on every motion
 * f: 1 entry
 */
int chaplygin_ball_quaternion_positions(double t, const double *q, const double *p, double *f);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 3 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int chaplygin_ball_quaternion_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double chaplygin_ball_quaternion_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 81 entries, row by row: d rhs_i / d y_j stands at 9*i + j
 */
int chaplygin_ball_quaternion_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 3 entries
 */
int chaplygin_ball_quaternion_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int chaplygin_ball_quaternion_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *dydt);

#ifdef __cplusplus
}
#endif

#endif
