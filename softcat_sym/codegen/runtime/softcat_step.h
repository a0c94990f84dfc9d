/* One step of a Rosenbrock method, and the workspace that all steps of a run share. */
#ifndef SOFTCAT_STEP_H
#define SOFTCAT_STEP_H

#include "softcat_linear.h"
#include "softcat_methods.h"

#include <stddef.h>

typedef struct softcat_step {
    const softcat_model *model;
    const softcat_method *method;
    softcat_linear *linear;
    size_t size;              /* unknowns, sites * slots */
    int algebraic;            /* whether there are rows 0 = f */
    double *stages[SOFTCAT_MOST_STAGES];
    double *rates, *slope;    /* f and df/dt where the step begins */
    double *entries;          /* Jacobian there */
    double *next;             /* unknowns where it ends */
    double *looked;           /* rates of a stage, if the next one looks at the same point */
    double *point;            /* unknowns of a stage, later of a time between */
    double *mass;             /* 1 where y' = f and not held */
    double *scratch;
    int powers;               /* that are integrated beside the unknowns; none if nobody asks */
    double *power, *power_slope, *power_time; /* g(t, y), dg/dy and dg/dt where the step begins */
    double *power_looked;     /* g of the stage in hand */
    double *power_stages;     /* [stages * powers] */
    double *power_next;       /* [powers] integral over the step */
    long evaluations, factorisations;
} softcat_step;

/* In this memory, which stays in use, or only counted: 0 or a code. `view`: see softcat_linear_new. */
int softcat_step_new(softcat_step *, const softcat_model *, const softcat_view *view,
                     const softcat_method *, int sites, softcat_memory *);

/* Rates, their slope in time (looked for ahead, within the step) and the Jacobian at (t, y). */
int softcat_step_begin(softcat_step *, const softcat_filament *, double t, double h,
                       const double *y);

/* All stages; `next` is the end. `end` is the time of stages at the end
 * of the step, a rounding before t + h if f jumps there. SOFTCAT_NON_FINITE or SOFTCAT_SINGULAR:
 * a shorter step may succeed. */
int softcat_step_take(softcat_step *, const softcat_filament *, double t, double h, double end,
                      const double *y);

/* Estimate of the error of the step just taken; overwrites `point`. */
const double *softcat_step_error(softcat_step *);

/* The largest error of what the powers have done in the step just taken, `before` of it by then, in
 * units of relative * |work| + absolute. */
double softcat_step_work_error(const softcat_step *, const double *before, double relative,
                               double absolute);

/* out = y(t + x h), 0 <= x <= 1, of the step just taken from y. */
void softcat_step_between(const softcat_step *, const double *y, double x, double *out);

/* work = what the powers have done by t + x h of the step just taken, `before` of it by t. */
void softcat_step_work(const softcat_step *, const double *before, double x, double *work);

/* Root mean square of the free unknowns of `error`, each in units of relative * the larger of
 * |y|, |z| + absolute; with `algebraic_only` of those alone. Not finite if any of them is not. */
double softcat_step_norm(const softcat_step *, const double *error, const double *y,
                         const double *z, double relative, const double *absolute,
                         int algebraic_only, size_t *worst);

/* Newton's correction of the algebraic unknowns, in stages[0], from rates and entries. */
int softcat_step_correction(softcat_step *, int factorise);

#endif
