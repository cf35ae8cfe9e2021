/*
 * snakeboard.h: snakeboard, emitted by nhc 0.1.0 (nhc:385498e7a32113a3)
 * A board on two steerable axles and a rotor; it moves by turning the rotor and the axles to and fro.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with v, psi', p_b', p_f': the dependent velocities of the spec (x', y') are
 *     singular somewhere
 *
 * State y:
 * y[0] = x [m]: centre of the board
 * y[1] = y [m]: centre of the board
 * y[2] = theta [rad]: heading of the board
 * y[3] = psi [rad]: rotor, relative to the board
 * y[4] = p_b [rad]: back axle, relative to the board
 * y[5] = p_f [rad]: front axle, relative to the board
 * y[6] = v [1/s]: x' = l*(cos(theta + p_b)*cos(p_f) + cos(p_b)*cos(theta + p_f))*v, y' = l*(sin(theta +
 *     p_b)*cos(p_f) + cos(p_b)*sin(theta + p_f))*v, theta' = (cos(p_b)*sin(p_f) - cos(p_f)*sin(p_b))*v
 * y[7] = psi' [rad/s]
 * y[8] = p_b' [rad/s]
 * y[9] = p_f' [rad/s]
 *
 * Parameters p:
 * p[0]: m = 1.0 [kg]: mass of everything
 * p[1]: l = 0.5 [m]: from the centre to an axle
 * p[2]: J = 0.1 [kg*m^2]: board
 * p[3]: J_r = 0.05 [kg*m^2]: rotor
 * p[4]: J_w = 0.02 [kg*m^2]: each axle
 * p[5]: tau = 0.05 [N*m]: amplitude of the torque on the rotor
 * p[6]: sigma = 0.02 [N*m]: amplitude of the torques on the axles
 * p[7]: nu = 1.0 [rad/s]: frequency of the torques
 *
 * Constraints, with the units of their reactions:
 * 0: back [N]
 * 1: front [N]
 *
 * Outputs:
 * out[0] = speed [m/s]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 33 +-, 55 *, 3 /, 9 calls
 * velocities: 11 +-, 22 *, 0 /, 7 calls
 * accelerations: 41 +-, 63 *, 3 /, 9 calls
 * state: 12 +-, 20 *, 2 /, 6 calls
 * residuals: 9 +-, 15 *, 0 /, 6 calls
 * reactions: 48 +-, 84 *, 3 /, 9 calls
 * energy: 16 +-, 27 *, 0 /, 6 calls
 * jacobian: 94 +-, 155 *, 1 /, 9 calls
 * outputs: 10 +-, 25 *, 0 /, 7 calls
 *
 * Calls: t is the time; y has SNAKEBOARD_NY entries, p has SNAKEBOARD_NP; snakeboard_parameter_defaults may
 *     be passed as p. snakeboard_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: SNAKEBOARD_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_SNAKEBOARD_H
#define NHC_SNAKEBOARD_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    SNAKEBOARD_NQ = 6, /* coordinates */
    SNAKEBOARD_NY = 10, /* state: the coordinates and the velocities that are kept */
    SNAKEBOARD_NP = 8, /* parameters */
    SNAKEBOARD_NC = 2, /* constraints */
    SNAKEBOARD_NOUT = 1 /* outputs */
};

/* return codes */
enum {
    SNAKEBOARD_OK = 0, /* the result is good */
    SNAKEBOARD_SINGULAR_1 = 1, /* the coframe is singular */
    SNAKEBOARD_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    SNAKEBOARD_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const snakeboard_coordinate_names[SNAKEBOARD_NQ];
extern const char *const snakeboard_state_names[SNAKEBOARD_NY];
extern const char *const snakeboard_parameter_names[SNAKEBOARD_NP];
extern const char *const snakeboard_constraint_names[SNAKEBOARD_NC];
extern const char *const snakeboard_output_names[SNAKEBOARD_NOUT];
extern const double snakeboard_parameter_defaults[SNAKEBOARD_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 10 entries
 */
int snakeboard_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 6 entries
 */
int snakeboard_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 6 entries
 */
int snakeboard_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 10 entries
 */
int snakeboard_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 2 entries
 */
int snakeboard_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 2 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int snakeboard_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double snakeboard_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 100 entries, row by row: d rhs_i / d y_j stands at 10*i + j
 */
int snakeboard_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 1 entry
 */
int snakeboard_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int snakeboard_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
