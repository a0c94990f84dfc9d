/* What a run writes at its output times: unknowns, work, and their derivatives. */
#ifndef SOFTCAT_OUTPUTS_H
#define SOFTCAT_OUTPUTS_H

#include "softcat_rosenbrock.h"
#include "softcat_step.h"

/* One of the copies of a run that go in lock-step: the first is the run itself, the others are
 * moved along a direction. */
typedef struct softcat_copy {
    softcat_filament filament;
    double *state;       /* [size] */
    double *work;        /* [powers] integrals so far */
    double *parameters, *places; /* of a moved one, where these move */
    int direction;       /* moved along this direction, -1: along none */
    double share;        /* of this copy in the derivative */
} softcat_copy;

typedef struct softcat_outputs {
    const double *times;
    int count, next;     /* next: the first time not written yet */
    double *states, *work;
    const softcat_directions *directions; /* or NULL */
    double *powers;      /* [powers] */
} softcat_outputs;

/* Write what a copy is at the first output time. */
void softcat_outputs_first(softcat_outputs *, const softcat_step *, const softcat_copy *);

/* Write what lies in the step that a copy has just taken from t to `end`, and add the work done in
 * it. All copies write the same rows. */
void softcat_outputs_step(softcat_outputs *, softcat_step *, softcat_copy *, double t, double end);

#endif
