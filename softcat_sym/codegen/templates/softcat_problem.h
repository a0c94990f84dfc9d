/* A filament in units of its model and in memory of the caller's: what softcat_solve.c and
 * softcat_session.c share. */
#ifndef SOFTCAT_PROBLEM_H
#define SOFTCAT_PROBLEM_H

#include "softcat_section.h"
#include "softcat_start.h"

typedef struct softcat_problem {
    const softcat_structure *s; /* with the fibres of the run */
    softcat_sized sized;
    softcat_settings settings;
    softcat_filament filament;
    softcat_options options;
    double scale, length;       /* time scale [s], rest length [m] */
    int cells;
    size_t size;                /* unknowns */
    double *params, *X, *places, *state, *spare, *kinks, *absolute;
} softcat_problem;

/* Take what a problem needs of the memory; of one that only counts params are not looked at. The
 * problem must stay where it is from now on. 0 or a code. */
int softcat_problem_take(softcat_problem *, const softcat_structure *, const double *params,
                         int cells, const softcat_settings *, softcat_memory *);

/* The state at t = 0, and the options: where these control the error of the work it must be
 * integrated. `spare` is used meanwhile. */
int softcat_problem_begin(softcat_problem *, const double *params, softcat_workspace,
                          softcat_status *);

/* Times at which a support changes pace, and those of the caller: positive, in order, once each. */
void softcat_problem_kinks(softcat_problem *);

/* Position [rest lengths] of a node; of one that is held, where its support is. */
void softcat_problem_node(const softcat_problem *, const double *state, int node,
                          softcat_supports, double *place);

/* Joules per m^2 of the undeformed section that a unit of work is. */
double softcat_problem_work(const softcat_problem *);

#endif
