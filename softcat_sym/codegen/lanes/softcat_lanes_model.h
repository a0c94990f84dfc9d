/* A softcat_model whose functions work on as many filaments at once as a vector has lanes, and the
 * integration of many: a lane that is done takes the next. */
#ifndef SOFTCAT_LANES_MODEL_H
#define SOFTCAT_LANES_MODEL_H

#include "softcat_lanes.h"
#include "softcat_rosenbrock.h"

/* As a softcat_filament, the lane innermost. */
typedef struct softcat_lanes_filament {
    int sites;
    const real *parameters, *places;
} softcat_lanes_filament;

/* The functions of a softcat_model, on all lanes. */
typedef struct softcat_lanes_model {
    const softcat_model *one; /* sizes and patterns; its functions are not called */
    int lanes;                /* LANES where it was compiled */
    int (*rates)(const softcat_lanes_filament *, real t, const real *y, real *f, real *scratch);
    int (*jacobian)(const softcat_lanes_filament *, real t, const real *y, real *entries,
                    real *scratch);
    int (*work)(const softcat_lanes_filament *, real t, const real *y, real *powers, real *scratch);
    int (*work_slope)(const softcat_lanes_filament *, real t, const real *y, real *slope,
                      real *scratch);
} softcat_lanes_model;

/* One of many runs: the arguments of softcat_integrate, whose `state` is only read here. */
typedef struct softcat_member {
    softcat_filament filament;
    softcat_options options;
    const double *state, *times;
    int count;
    double *states, *work; /* work: of all members, or of none (NULL) */
    softcat_status status; /* worst_site, worst_slot, evaluations and factorisations are not told */
} softcat_member;

/* Integrate all, each with steps of its own as softcat_integrate takes them, whatever its neighbours
 * are; each has its own status.code. Members have the same sites and method. What fails here is to
 * be tried by softcat_integrate: one with algebraic unknowns and kinks within its time always does.
 * Returns SOFTCAT_SOLVED, or why none was begun. */
int softcat_lanes_integrate(const softcat_lanes_model *, softcat_member *members, int count);

#endif
