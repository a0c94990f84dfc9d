/* A run under way: what softcat_rosenbrock.c keeps between steps, and its copies in lock-step. */
#ifndef SOFTCAT_RUN_H
#define SOFTCAT_RUN_H

#include "softcat_outputs.h"
#include "softcat_rosenbrock.h"
#include "softcat_step.h"

typedef struct softcat_run {
    const softcat_model *model;
    const softcat_options *options;
    softcat_status *status;
    softcat_step step;
    softcat_outputs outputs;
    softcat_copy *copies; /* the run itself, then the moved ones */
    int copy_count;
    double t, last;
    int kink;             /* next of options->kinks */
    int after_kink;       /* whether the step begins where f changes its form */
    double error, length; /* of the last accepted step; error 0: there is none to go by */
} softcat_run;

/* Take the memory of the run and its copies, which step() fills; with a memory that only counts,
 * count. `view`: see softcat_linear_new. 0 or a code. */
int softcat_run_new(softcat_run *, const softcat_filament *, const softcat_directions *,
                    const softcat_view *view, softcat_memory *);

/* Begin in this state: the run, and its copies, moved by their directions. */
void softcat_copies_place(softcat_run *, const softcat_filament *, const double *state,
                          const softcat_directions *);

/* Begin to step at r->t: kinks that are over, and the first step, of a length chosen if 0. */
int softcat_run_begin(softcat_run *, double *next);

/* Try steps of length *next and shorter until one is accepted; then the length of the next. */
int softcat_run_advance(softcat_run *, double *next);

/* Go on from a kink, where algebraic unknowns may have jumped. */
int softcat_run_restart(softcat_run *);

/* Damped Newton's method for the algebraic unknowns at t; counts its passes as steps. */
int softcat_newton(softcat_step *, const softcat_filament *, const softcat_options *, double t,
                   double *state, softcat_status *);

/* Make the algebraic unknowns of the moved copies consistent; f is asked at `start`. */
int softcat_copies_correct(softcat_run *, double start);

/* Let the moved copies take the step that the run has taken. */
int softcat_copies_follow(softcat_run *, double h, double start, double inner_end, double end);

#endif
