/* Linear systems W k = r of a filament, W = M s - J with a shift s.
 *
 * Elimination follows the filament's structure. Unknowns x whose rate is an unknown u go first
 * (k_x = (r_x + k_u) / s); then the section states of each site, in blocks that do not see each
 * other; what is left is coupled to neighbouring sites only: a band matrix, factorised with
 * scaled threshold pivoting. */
#ifndef SOFTCAT_LINEAR_H
#define SOFTCAT_LINEAR_H

#include "softcat_memory.h"
#include "softcat_model.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct softcat_linear softcat_linear;

/* A model with `to` fibres, as tables of one with `from` say it: what each fibre has comes last,
 * kind by kind. */
typedef struct softcat_view {
    const softcat_model *tables;
    int plain_slots, plain_entries, from, to;
} softcat_view;

/* Where entry `at` is in the tables, and the slot that stands there as the model counts it. */
static inline int softcat_source(int at, int plain, int from, int to)
{
    return at < plain ? at : plain + (at - plain) / to * from;
}

static inline int softcat_target(int at, int plain, int from, int to, int point)
{
    return at < plain ? at : plain + (at - plain) / from * to + point;
}

/* Plan the elimination in this memory, which stays in use; NULL: *code says why, or the memory only
 * counts. `view`: how to read the tables while it does; NULL: as they are. */
softcat_linear *softcat_linear_new(const softcat_model *, const softcat_view *view, int sites,
                                   softcat_memory *, int *code);

/* Which unknowns are held: [sites * slots] 1 free, 0 held (k = 0). Held ends from the start; with
 * `algebraic_only` the differential unknowns are held, too. */
void softcat_linear_hold(softcat_linear *, int algebraic_only);
const unsigned char *softcat_linear_free_unknowns(const softcat_linear *);

/* Factorise; entries [sites * model->entries] must stay unchanged until the last solve. Returns
 * SOFTCAT_SOLVED, SOFTCAT_SINGULAR, or SOFTCAT_NON_FINITE. */
int softcat_linear_factorise(softcat_linear *, const double *entries, double shift);

/* k [sites * slots]: in r, out k. */
void softcat_linear_solve(const softcat_linear *, double *k);

#ifdef __cplusplus
}
#endif
#endif
