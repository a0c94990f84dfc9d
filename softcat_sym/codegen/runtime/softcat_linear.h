/* Linear systems W k = r of a filament, W = M s - J with a shift s.
 *
 * Elimination follows the filament's structure. Unknowns x whose rate is an unknown u go first
 * (k_x = (r_x + k_u) / s); then the section states of each site, in blocks that do not see each
 * other; what is left is coupled to neighbouring sites only: a band matrix, factorised with
 * scaled threshold pivoting. */
#ifndef SOFTCAT_LINEAR_H
#define SOFTCAT_LINEAR_H

#include "softcat_model.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct softcat_linear softcat_linear;

/* Plan the elimination and allocate all that it needs; NULL: *code says why. */
softcat_linear *softcat_linear_new(const softcat_model *, int sites, int *code);
void softcat_linear_free(softcat_linear *);

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
