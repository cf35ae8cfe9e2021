/*
 * nh_particle_pot.h: nh_particle_pot, emitted by nhc 0.1.0 (nhc:a53c2aa6efaa3634)
 * The nonholonomic particle with springs in x and y.
 * Equations of motion: chaplygin (III.3)
 * Why: dependent velocities of the spec
 *
 * State y:
 * y[0] = x
 * y[1] = y
 * y[2] = z
 * y[3] = x'
 * y[4] = y'
 *
 * Parameters p:
 * p[0]: m = 1.0
 * p[1]: k = 1.0
 *
 * Constraints:
 * 0: contact
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 2 +-, 7 *, 2 /, 0 calls
 * velocities: 0 +-, 1 *, 0 /, 0 calls
 * accelerations: 3 +-, 8 *, 2 /, 0 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 1 +-, 1 *, 0 /, 0 calls
 * reactions: 3 +-, 8 *, 1 /, 0 calls
 * energy: 4 +-, 8 *, 0 /, 0 calls
 * jacobian: 3 +-, 16 *, 2 /, 0 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has NH_PARTICLE_POT_NY entries, p has NH_PARTICLE_POT_NP;
 *     nh_particle_pot_parameter_defaults may be passed as p. nh_particle_pot_state makes y from coordinates
 *     and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Return codes: NH_PARTICLE_POT_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_NH_PARTICLE_POT_H
#define NHC_NH_PARTICLE_POT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    NH_PARTICLE_POT_NQ = 3, /* coordinates */
    NH_PARTICLE_POT_NY = 5, /* state: the coordinates and the velocities that are kept */
    NH_PARTICLE_POT_NP = 2, /* parameters */
    NH_PARTICLE_POT_NC = 1, /* constraints */
    NH_PARTICLE_POT_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    NH_PARTICLE_POT_OK = 0, /* the result is good */
    NH_PARTICLE_POT_SINGULAR_2 = 2, /* the mass matrix is singular */
    NH_PARTICLE_POT_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const nh_particle_pot_coordinate_names[NH_PARTICLE_POT_NQ];
extern const char *const nh_particle_pot_state_names[NH_PARTICLE_POT_NY];
extern const char *const nh_particle_pot_parameter_names[NH_PARTICLE_POT_NP];
extern const char *const nh_particle_pot_constraint_names[NH_PARTICLE_POT_NC];
extern const char *const nh_particle_pot_output_names[1];
extern const double nh_particle_pot_parameter_defaults[NH_PARTICLE_POT_NP];

/*
 * right-hand side dy/dt = f(t, y; p) (III.3)
 * dydt: 5 entries
 */
int nh_particle_pot_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 3 entries
 */
int nh_particle_pot_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (III.3)
 * qddot: 3 entries
 */
int nh_particle_pot_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 5 entries
 */
int nh_particle_pot_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int nh_particle_pot_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int nh_particle_pot_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V
 * infinite or NaN where the model is singular
 */
double nh_particle_pot_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (III.3)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int nh_particle_pot_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int nh_particle_pot_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int nh_particle_pot_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
