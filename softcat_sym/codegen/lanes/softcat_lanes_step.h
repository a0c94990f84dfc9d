/* softcat_step.h for all lanes at once: each lane has its own time, its own step and its own filament. */
#ifndef SOFTCAT_LANES_STEP_H
#define SOFTCAT_LANES_STEP_H

#include "softcat_lanes_linear.h"
#include "softcat_lanes_model.h"
#include "softcat_methods.h"

typedef struct lanes_step {
    const softcat_lanes_model *model;
    const softcat_method *method;
    lanes_linear linear;
    softcat_lanes_filament filament;
    real *parameters, *places;
    size_t size;           /* unknowns of a lane */
    real *y, *work;        /* unknowns and integrals of the powers where the step begins */
    real *stages[SOFTCAT_MOST_STAGES];
    real *rates, *slope, *entries, *next, *looked, *point, *scratch; /* as those of softcat_step */
    double *mass;          /* 1 where y' = f and not held */
    int powers;            /* that are integrated; none if nobody asks */
    real *power, *power_slope, *power_time, *power_looked, *power_stages, *power_next;
    void *memory;
} lanes_step;

int lanes_step_new(lanes_step *, const softcat_lanes_model *, const softcat_method *, int sites,
                   int works);
void lanes_step_free(lanes_step *);

/* Rates, their slope in time and the Jacobian at (t, y). */
void lanes_step_begin(lanes_step *, real t, real h);

/* All stages; `next` is the end. `end` is the time of stages at the end of the step. The lanes
 * whose step failed. */
lanes_mask lanes_step_take(lanes_step *, real t, real h, real end);

/* Estimate of the error of the step just taken; overwrites `point`. */
const real *lanes_step_error(lanes_step *);

/* Largest error of what the powers have done in the step. */
real lanes_step_work_error(const lanes_step *, real relative, real absolute);

/* point = unknowns and power_looked = work at t + x h of the step just taken. */
void lanes_step_between(lanes_step *, real x);

/* Root mean square of the free unknowns of `error`, as softcat_step_norm. */
real lanes_step_norm(const lanes_step *, const real *error, const real *y, const real *z,
                     real relative, const real *absolute);

#endif
