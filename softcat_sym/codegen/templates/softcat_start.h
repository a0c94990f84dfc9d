/* Where the supports are, and the state in which a filament begins. */
#ifndef SOFTCAT_START_H
#define SOFTCAT_START_H

#include "softcat_solve.h"

/* Positions of the supports in rest lengths; the left one has the height 0. */
typedef struct softcat_supports {
    double left_x, right_x, right_y, right_z;
} softcat_supports;

softcat_supports softcat_supports_at(const softcat_structure *, const double *params,
                                     double seconds);

/* Whether the straight filament without weight is in equilibrium. */
int softcat_is_straight(const softcat_structure *, const double *params, int profiled);

/* state [sites * slots] of the straight filament at rest, and of a table carried over to X, which
 * leaves fibres that it has not as they are; the algebraic unknowns are a guess. Held unknowns are
 * set, too. */
void softcat_straight(const softcat_structure *, const double *params, int sites, const double *X,
                      double *state);
int softcat_from_table(const softcat_structure *, const double *params, const softcat_table *,
                       int sites, const double *X, double *state);

/* Make the algebraic unknowns consistent at t = 0: 0 or a code. `work` [sites * slots]. */
int softcat_settle(const softcat_structure *, const softcat_filament *, const softcat_options *,
                   const double *X, double *state, double *work, softcat_workspace,
                   softcat_status *);

#endif
