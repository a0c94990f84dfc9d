/* Turning points of one unknown, in the dense output of each accepted step. */
#ifndef SOFTCAT_TURNS_H
#define SOFTCAT_TURNS_H

#include "softcat_methods.h"
#include "softcat_rosenbrock.h"

/* Whether site, slot and rows cannot be. */
int softcat_turns_are_wrong(const softcat_turns *, int sites, int slots);

/* Begin at time t with this value. */
void softcat_turns_begin(softcat_turns *, double t, double value);

/* Go on by a step from `before` at t to `after` at `end`, to which the stages of the unknown
 * belong. */
void softcat_turns_step(softcat_turns *, const softcat_method *, double t, double end,
                        double before, double after, const double *stages);

#endif
