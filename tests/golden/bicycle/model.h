/*
 * bicycle.h: bicycle, emitted by nhc 0.1.0 (nhc:02cab8a25254e0fd)
 * Whipple's bicycle, nonlinear; two wheels, rear frame with rider, front frame; x ahead, y right, z down.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with roll', steer', thF': the dependent velocities of the spec (x', y', z',
 *     yaw', pitch', thF') are singular somewhere
 *
 * State y:
 * y[0] = x [m]: centre of the rear wheel
 * y[1] = y [m]: centre of the rear wheel
 * y[2] = z [m]: centre of the rear wheel, downwards
 * y[3] = yaw [rad]: first turn of the rear frame, about z
 * y[4] = roll [rad]: second turn, about x
 * y[5] = pitch [rad]: third turn, about y
 * y[6] = steer [rad]: front frame against rear frame
 * y[7] = thR [rad]: rear wheel against rear frame
 * y[8] = thF [rad]: front wheel against front frame
 * y[9] = roll' [rad/s]
 * y[10] = steer' [rad/s]
 * y[11] = thF' [rad/s]
 *
 * Parameters p:
 * p[0]: w = 1.02 [m]: wheelbase
 * p[1]: c = 0.08 [m]: trail
 * p[2]: lam = 0.3141592653589793 [rad]: tilt of the steering axis, 18 degrees
 * p[3]: g = 9.81 [m/s^2]: acceleration of gravity
 * p[4]: r_R = 0.3 [m]: radius of the rear wheel
 * p[5]: m_R = 2.0 [kg]: mass of the rear wheel
 * p[6]: R_xx = 0.0603 [kg*m^2]: rear wheel, across the axle
 * p[7]: R_yy = 0.12 [kg*m^2]: rear wheel, about the axle
 * p[8]: x_B = 0.3 [m]: rear frame and rider, ahead of the rear contact
 * p[9]: z_B = -0.9 [m]
 * p[10]: m_B = 85.0 [kg]
 * p[11]: B_xx = 9.2 [kg*m^2]
 * p[12]: B_xz = 2.4 [kg*m^2]
 * p[13]: B_yy = 11.0 [kg*m^2]
 * p[14]: B_zz = 2.8 [kg*m^2]
 * p[15]: x_H = 0.9 [m]: front frame, ahead of the rear contact
 * p[16]: z_H = -0.7 [m]
 * p[17]: m_H = 4.0 [kg]
 * p[18]: H_xx = 0.05892 [kg*m^2]
 * p[19]: H_xz = -0.00756 [kg*m^2]
 * p[20]: H_yy = 0.06 [kg*m^2]
 * p[21]: H_zz = 0.00708 [kg*m^2]
 * p[22]: r_F = 0.35 [m]: radius of the front wheel
 * p[23]: m_F = 3.0 [kg]: mass of the front wheel
 * p[24]: F_xx = 0.1405 [kg*m^2]: front wheel, across the axle
 * p[25]: F_yy = 0.28 [kg*m^2]: front wheel, about the axle
 *
 * Constraints, with the units of their reactions:
 * 0: rear_x [N]
 * 1: rear_y [N]
 * 2: rear_z [N]
 * 3: front_x [N]
 * 4: front_y [N]
 * 5: front_z [N]
 *
 * Outputs:
 * out[0] = speed [m/s]
 * out[1] = rear_height [m]
 * out[2] = front_height [m]
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 450 +-, 699 *, 6 /, 17 calls
 * velocities: 55 +-, 99 *, 3 /, 17 calls
 * accelerations: 153 +-, 264 *, 3 /, 12 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 108 +-, 183 *, 2 /, 12 calls
 * reactions: 367 +-, 549 *, 3 /, 12 calls
 * energy: 125 +-, 198 *, 3 /, 15 calls
 * jacobian: 3683 +-, 5097 *, 7 /, 17 calls
 * outputs: 56 +-, 101 *, 3 /, 15 calls
 *
 * Calls: t is the time; y has BICYCLE_NY entries, p has BICYCLE_NP; bicycle_parameter_defaults may be passed
 *     as p. bicycle_state makes y from coordinates and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Units are in brackets, and nothing is converted.
 * Return codes: BICYCLE_OK (0) if the result is good; after any other code the output must not be used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_BICYCLE_H
#define NHC_BICYCLE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    BICYCLE_NQ = 9, /* coordinates */
    BICYCLE_NY = 12, /* state: the coordinates and the velocities that are kept */
    BICYCLE_NP = 26, /* parameters */
    BICYCLE_NC = 6, /* constraints */
    BICYCLE_NOUT = 3 /* outputs */
};

/* return codes */
enum {
    BICYCLE_OK = 0, /* the result is good */
    BICYCLE_SINGULAR_1 = 1, /* the coframe is singular */
    BICYCLE_SINGULAR_2 = 2, /* the mass matrix is singular, or the velocities that are kept do not suffice */
    BICYCLE_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const bicycle_coordinate_names[BICYCLE_NQ];
extern const char *const bicycle_state_names[BICYCLE_NY];
extern const char *const bicycle_parameter_names[BICYCLE_NP];
extern const char *const bicycle_constraint_names[BICYCLE_NC];
extern const char *const bicycle_output_names[BICYCLE_NOUT];
extern const double bicycle_parameter_defaults[BICYCLE_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (I.2.15)
 * dydt: 12 entries
 */
int bicycle_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.2.4)
 * qdot: 9 entries
 */
int bicycle_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.2.15)
 * qddot: 9 entries
 */
int bicycle_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities (I.2.1)
 * y: 12 entries
 */
int bicycle_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 6 entries
 */
int bicycle_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 6 entries
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int bicycle_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V [J]
 * infinite or NaN where the model is singular
 */
double bicycle_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)
 * J: 144 entries, row by row: d rhs_i / d y_j stands at 12*i + j
 */
int bicycle_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 3 entries
 */
int bicycle_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int bicycle_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
