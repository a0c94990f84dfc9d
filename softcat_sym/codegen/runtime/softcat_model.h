/* What an integrator of softcat_sym is given: one filament, and the functions of its physics.
 *
 * A filament is a row of sites; site i is node i together with the cell to its right. Each site
 * has the same unknowns: that of slot k at site i is y[i * slots + k]. Generated code fills a
 * softcat_model; softcat_rosenbrock.h integrates any such model, also one of a single site. */
#ifndef SOFTCAT_MODEL_H
#define SOFTCAT_MODEL_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a call returns. Each has a sentence: softcat_message. */
enum {
    SOFTCAT_SOLVED = 0,
    SOFTCAT_STEP_LIMIT,     /* max_steps steps did not reach the last time */
    SOFTCAT_STEP_TOO_SMALL, /* the tolerance asks for steps below the smallest one */
    SOFTCAT_NON_FINITE,     /* rates, Jacobian or unknowns are not finite */
    SOFTCAT_SINGULAR,       /* the matrix of the step, or of the algebraic rows, is singular */
    SOFTCAT_MEMORY,         /* the workspace is smaller than its function of sizes says */
    SOFTCAT_ARGUMENT,       /* an argument contradicts what the header asks for */
    SOFTCAT_STOPPED,        /* stopped from outside through softcat_options.stop */
    SOFTCAT_NO_CONVERGENCE, /* Newton's method found no consistent algebraic unknowns */
    SOFTCAT_BEYOND          /* a node or a cell is beyond softcat_options.bounds */
};

/* Memory of the caller, of any alignment, for one call: nothing is allocated. */
typedef struct softcat_workspace {
    void *memory;
    size_t bytes;
} softcat_workspace;

/* What a run is given. */
typedef struct softcat_filament {
    int sites;
    const double *parameters; /* [model->parameters] */
    const double *places;     /* [sites * model->places] geometry of each site */
    /* Looked at only by code that serves any number of fibres: how many points a section has, and
     * [tables * fibres] where they are. */
    int fibres;
    const double *points;
} softcat_filament;

/* The physics, M y' = f(t, y) with M diagonal, ones and zeros. Every function returns
 * SOFTCAT_SOLVED or a code of its own; SOFTCAT_NON_FINITE makes the integrator take a shorter
 * step, any other ends the run. None may keep a state of its own between calls.
 *
 * Held unknowns (held_first, held_last) stay what they are whatever `rates` says of them. Entries
 * of the Jacobian that reach beyond the first or last site, or stand in the row or column of a
 * held unknown, are not looked at. */
typedef struct softcat_model {
    int slots;      /* unknowns of a site: first the kept ones, then `sections` section states */
    int sections;   /* last slots of a site, whose rows see section states of their own site only */
    int parameters; /* numbers that a run is given as a whole */
    int places;     /* and those of each site */
    int scratch;    /* doubles per site that the functions below need */
    int entries;    /* entries of the Jacobian per site */
    int powers;     /* powers that are integrated beside the unknowns (work), for all sites */
    int moves_in_time;                 /* whether f depends on t explicitly */
    const int *rate;                   /* [slots] slot that is this one's rate (x' = u), or -1 */
    const int *differential;           /* [slots] 1: y' = f; 0: 0 = f, index 1 */
    const int *held_first, *held_last; /* [slots] 1: the first, last site has no such unknown */
    const int *row, *offset, *column;  /* [entries] d f[site][row] / d y[site + offset][column] */
    int (*rates)(const softcat_filament *, double t, const double *y, double *f, double *scratch);
    int (*jacobian)(const softcat_filament *, double t, const double *y, double *entries,
                    double *scratch); /* entries[site * model->entries + e] */
    /* powers[model->powers], and their derivatives slope[power * unknowns + unknown]; NULL if there
     * are none. Called right after `rates`, right after `jacobian` at the same t and y, and find
     * in scratch what these have left. */
    int (*work)(const softcat_filament *, double t, const double *y, double *powers,
                double *scratch);
    int (*work_slope)(const softcat_filament *, double t, const double *y, double *slope,
                      double *scratch);
    /* df/dt and d powers/dt at constant y. Called right after `rates`, right after `work` at the
     * same t and y. NULL where f does not depend on t, or where differences shall do. */
    int (*rates_in_time)(const softcat_filament *, double t, const double *y, double *slope,
                         double *scratch);
    int (*work_in_time)(const softcat_filament *, double t, const double *y, double *slope,
                        double *scratch);
} softcat_model;

#ifdef __cplusplus
}
#endif
#endif
