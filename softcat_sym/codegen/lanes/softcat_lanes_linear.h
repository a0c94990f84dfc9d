/* softcat_linear.h for all lanes at once: one elimination plan, a pivot of its own for each lane. What
 * depends on how softcat_linear.c keeps its numbers is only where the plan puts them. */
#ifndef SOFTCAT_LANES_LINEAR_H
#define SOFTCAT_LANES_LINEAR_H

#include "softcat_lanes.h"
#include "softcat_plan.h"

#include <stddef.h>

typedef struct lanes_linear {
    softcat_linear *plan;  /* its order and patterns; none of its numbers */
    real *rows, *multipliers, *inverse, *scale, *right; /* as those of softcat_band */
    lanes_mask *pivot;     /* [size] row exchanged with each, of each lane */
    int *common;           /* [size] the same if all lanes have the same, else -1 */
    int *last;             /* [size] last column of each row of U */
    real *blocks, *answers, *weights, *coupling, *gathered, *solved; /* as those of the plan */
    const real *entries;
    real inverse_shift;
    void *memory, *integers, *planned;
} lanes_linear;

/* Zeroed memory for so many vectors, where vectors may lie, in what is to be freed. */
real *lanes_new(size_t count, void **to_free);

int lanes_linear_new(lanes_linear *, const softcat_model *, int sites);
void lanes_linear_free(lanes_linear *);

/* Factorise; the lanes whose matrix is singular or not finite. */
lanes_mask lanes_linear_factorise(lanes_linear *, const real *entries, real shift);

/* k [sites * slots]: in r, out k. */
void lanes_linear_solve(const lanes_linear *, real *k);

/* to += J_x k_x of a site, for the x that are already eliminated; `to` is numbered by `place`, or as
 * the slots are if that is NULL. */
void lanes_carry_over(const lanes_linear *, const softcat_links *, int site, const real *k, real *to,
                      const int *place);

/* What softcat_lanes_sections.c does of it. */
lanes_mask lanes_sections_eliminate(lanes_linear *, int site, const real *entries, real shift);
void lanes_sections_answer(const lanes_linear *, int site, real *rows);
void lanes_sections_first(const lanes_linear *, real *k);
void lanes_sections_last(const lanes_linear *, real *k);
void lanes_scatter(const lanes_linear *, const softcat_links *, int site, const real *entries,
                   real *store);

#endif
