/*
 * voronec_particle.h: voronec_particle, emitted by nhc 0.1.0 (nhc:f1419e60d0470744)
 * A particle whose T, U and constraint depend on the dependent coordinate, so that Caplygin's hypotheses
 *     fail.
 * Equations of motion: voronec (I.4.9)
 * Why: dependent velocities of the spec; Caplygin's equations do not apply: T contains the dependent
 *     coordinate `z`
 *
 * State y:
 * y[0] = x
 * y[1] = y
 * y[2] = z
 * y[3] = x'
 * y[4] = y'
 *
 * No parameters.
 *
 * Constraints:
 * 0: contact
 *
 * Operations of one call (+-: sums and differences; calls: sin, cos, ...):
 * rhs: 31 +-, 60 *, 2 /, 2 calls
 * velocities: 1 +-, 5 *, 0 /, 1 calls
 * accelerations: 34 +-, 78 *, 2 /, 2 calls
 * state: 0 +-, 0 *, 0 /, 0 calls
 * residuals: 2 +-, 5 *, 0 /, 1 calls
 * reactions: 37 +-, 82 *, 2 /, 2 calls
 * energy: 10 +-, 20 *, 0 /, 2 calls
 * jacobian: 125 +-, 254 *, 2 /, 2 calls
 * outputs: 0 +-, 0 *, 0 /, 0 calls
 *
 * Calls: t is the time; y has VORONEC_PARTICLE_NY entries, p has VORONEC_PARTICLE_NP;
 *     voronec_particle_parameter_defaults may be passed as p. voronec_particle_state makes y from coordinates
 *     and velocities.
 * All arrays are the caller's; an output must not overlap an input.
 * Return codes: VORONEC_PARTICLE_OK (0) if the result is good; after any other code the output must not be
 *     used.
 * Compile without -ffast-math: it removes the tests for infinities and NaN.
 * Threads: nothing is kept between calls and only the output is written, so threads may call at the same
 *     time.
 * Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non
 *     holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.
 */
#ifndef NHC_VORONEC_PARTICLE_H
#define NHC_VORONEC_PARTICLE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* sizes */
enum {
    VORONEC_PARTICLE_NQ = 3, /* coordinates */
    VORONEC_PARTICLE_NY = 5, /* state: the coordinates and the velocities that are kept */
    VORONEC_PARTICLE_NP = 0, /* parameters */
    VORONEC_PARTICLE_NC = 1, /* constraints */
    VORONEC_PARTICLE_NOUT = 0 /* outputs */
};

/* return codes */
enum {
    VORONEC_PARTICLE_OK = 0, /* the result is good */
    VORONEC_PARTICLE_SINGULAR_2 = 2, /* the mass matrix is singular */
    VORONEC_PARTICLE_NOT_FINITE = 3 /* a result is infinite or not a number */
};

extern const char *const voronec_particle_coordinate_names[VORONEC_PARTICLE_NQ];
extern const char *const voronec_particle_state_names[VORONEC_PARTICLE_NY];
extern const char *const voronec_particle_parameter_names[1];
extern const char *const voronec_particle_constraint_names[VORONEC_PARTICLE_NC];
extern const char *const voronec_particle_output_names[1];
extern const double voronec_particle_parameter_defaults[1];

/*
 * right-hand side dy/dt = f(t, y; p) (I.4.9)
 * dydt: 5 entries
 */
int voronec_particle_rhs(double t, const double *y, const double *p, double *dydt);

/*
 * all velocities q' from the state (I.1.2)
 * qdot: 3 entries
 */
int voronec_particle_velocities(double t, const double *y, const double *p, double *qdot);

/*
 * all accelerations q'' on the motion (I.4.9)
 * qddot: 3 entries
 */
int voronec_particle_accelerations(double t, const double *y, const double *p, double *qddot);

/*
 * the state y from coordinates and velocities
 * y: 5 entries
 */
int voronec_particle_state(double t, const double *q, const double *qdot, const double *p, double *y);

/*
 * left minus right side of each constraint, zero on every motion (I.1.1)
 * r: 1 entry
 */
int voronec_particle_residuals(double t, const double *q, const double *qdot, const double *p, double *r);

/*
 * reactions lambda of the constraints (I.4.1)
 * lambda: 1 entry
 * Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a
 */
int voronec_particle_reactions(double t, const double *y, const double *p, double *lambda);

/*
 * energy T + V
 * infinite or NaN where the model is singular
 */
double voronec_particle_energy(double t, const double *y, const double *p);

/*
 * Jacobian matrix of rhs, d rhs_i / d y_j (I.4.9)
 * J: 25 entries, row by row: d rhs_i / d y_j stands at 5*i + j
 */
int voronec_particle_jacobian(double t, const double *y, const double *p, double *J);

/*
 * the spec's outputs
 * out: 0 entries
 */
int voronec_particle_outputs(double t, const double *y, const double *p, double *out);

/*
 * rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];
 * the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.
 */
int voronec_particle_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);

#ifdef __cplusplus
}
#endif

#endif
