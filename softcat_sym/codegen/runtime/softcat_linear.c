#include "softcat_linear.h"

#include "softcat_plan.h"
#include "softcat_vectors.h"

#include <math.h>
#include <string.h>

softcat_linear *softcat_linear_new(const softcat_model *model, const softcat_view *view, int sites,
                                   softcat_memory *memory, int *code)
{
    const softcat_view plain = {model, model->slots, model->entries, 1, 1};
    softcat_linear plan = {.model = model, .sites = sites};
    softcat_linear *linear = softcat_take(memory, 1, sizeof plan);
    *code = softcat_plan_make(&plan, view ? view : &plain, memory);
    if (*code || !linear) return NULL;
    *linear = plan;
    softcat_linear_hold(linear, 0);
    return linear;
}

void softcat_linear_hold(softcat_linear *linear, int algebraic_only)
{
    const softcat_model *model = linear->model;
    int last = linear->sites - 1;
    linear->held_count = 0;
    for (int site = 0; site <= last; site++)
        for (int k = 0; k < linear->slots; k++) {
            int held = (site == 0 && model->held_first[k]) || (site == last && model->held_last[k])
                       || (algebraic_only && model->differential[k]);
            linear->free_unknowns[(size_t)site * (size_t)linear->slots + (size_t)k] = !held;
            if (held) linear->held[linear->held_count++] = site * linear->slots + k;
        }
    linear->first_plain = linear->back + 1;
    linear->last_plain = algebraic_only ? -1 : last - linear->ahead - 1;
}

const unsigned char *softcat_linear_free_unknowns(const softcat_linear *linear)
{
    return linear->free_unknowns;
}

/* A site all of whose entries stand inside the filament and meet no held unknown. */
static int plain(const softcat_linear *linear, int site)
{
    return site >= linear->first_plain && site <= linear->last_plain;
}

/* Whether row and column of an entry exist and are free. */
static int counts(const softcat_linear *linear, int site, const softcat_link *link)
{
    int other = site + link->offset;
    if (other < 0 || other >= linear->sites) return 0;
    const unsigned char *free_row = linear->free_unknowns + (ptrdiff_t)site * linear->slots;
    const unsigned char *free_column = linear->free_unknowns + (ptrdiff_t)other * linear->slots;
    if (link->via >= 0 && !free_column[link->via]) return 0;
    return free_row[link->row] && free_column[link->column];
}

void softcat_linear_scatter(const softcat_linear *linear, const softcat_links *links, int site,
                            const double *entries, double *store)
{
    const softcat_link *link = links->links, *first_via = link + links->first_via;
    const softcat_link *end = link + links->count;
    double inverse = linear->inverse_shift;
    if (plain(linear, site)) {
        for (; link < first_via; link++) store[link->target] -= entries[link->entry];
        for (; link < end; link++) store[link->target] -= entries[link->entry] * inverse;
        return;
    }
    for (; link < end; link++)
        if (counts(linear, site, link))
            store[link->target] -= entries[link->entry] * (link < first_via ? 1.0 : inverse);
}

int softcat_linear_factorise(softcat_linear *linear, const double *entries, double shift)
{
    const softcat_model *model = linear->model;
    softcat_band *band = &linear->band;
    int code = SOFTCAT_SOLVED;
    size_t each = (size_t)model->entries;
    size_t moves_each = (size_t)(linear->x_columns * linear->lanes);
    linear->inverse_shift = shift > 0.0 ? 1.0 / shift : 0.0;
    for (int site = 0; site < linear->sites && model->sections > 0 && !code; site++)
        code = softcat_sections_eliminate(linear, site, entries + (size_t)site * each, shift);
    if (code) return code;
    memset(band->rows, 0, (size_t)band->size * (size_t)band->width * sizeof(double));
    for (int site = 0; site < linear->sites; site++) {
        double *rows = band->rows + (size_t)site * (size_t)linear->remaining * (size_t)band->width;
        const unsigned char *is_free = linear->free_unknowns + (size_t)site * (size_t)linear->slots;
        for (int i = 0; i < linear->remaining; i++) {
            int slot = linear->remaining_slot[i];
            double mass = model->differential[slot] ? shift : 0.0;
            rows[i * band->width + band->lower] = is_free[slot] ? mass : 1.0;
        }
        softcat_linear_scatter(linear, &linear->direct, site, entries + (size_t)site * each, rows);
        double *moves = linear->moves + (size_t)site * moves_each;
        memset(moves, 0, moves_each * sizeof(double));
        softcat_linear_scatter(linear, &linear->moved, site, entries + (size_t)site * each, moves);
        if (model->sections > 0) softcat_sections_answer(linear, site, rows);
    }
    return softcat_band_factorise(band);
}

/* The right-hand side of the band, to which J_rx k_x of the x already eliminated adds; -J stands in
 * the moves. What is written beyond a site is written again by the next. */
static void gather(const softcat_linear *linear, const double *k)
{
    int remaining = linear->remaining, columns = linear->x_columns;
    double *right = linear->band.right;
    const double *panel = linear->moves, *x = linear->x;
    for (int site = 0; site < linear->sites; site++, right += remaining, x += linear->eliminated) {
        for (int i = 0; i < remaining; i++) right[i] = k[linear->remaining_slot[i]];
        softcat_subtract(right, panel, linear->lanes, x, columns);
        panel += columns * linear->lanes;
        k += linear->slots;
    }
}

void softcat_linear_solve(const softcat_linear *linear, double *k)
{
    size_t slots = (size_t)linear->slots;
    double over = linear->inverse_shift;
    for (int i = 0; i < linear->held_count; i++) k[linear->held[i]] = 0.0;
    for (int e = 0; e < linear->eliminated; e++) {
        double *one = k + linear->eliminated_slot[e];
        double *x = linear->x + linear->back * linear->eliminated + e;
        for (int site = 0; site < linear->sites; site++, one += slots, x += linear->eliminated)
            *x = *one *= over;
    }
    gather(linear, k);
    if (linear->model->sections > 0) softcat_sections_first(linear, k);
    softcat_band_solve(&linear->band);
    const double *right = linear->band.right;
    for (int site = 0; site < linear->sites; site++)
        for (int i = 0; i < linear->remaining; i++)
            k[(size_t)site * slots + (size_t)linear->remaining_slot[i]] = *right++;
    if (linear->model->sections > 0) softcat_sections_last(linear, k);
    for (int e = 0; e < linear->eliminated; e++) {
        double *x = k + linear->eliminated_slot[e];
        const double *u = k + linear->model->rate[linear->eliminated_slot[e]];
        for (int site = 0; site < linear->sites; site++)
            x[(size_t)site * slots] += u[(size_t)site * slots] * over;
    }
    for (int i = 0; i < linear->held_count; i++) k[linear->held[i]] = 0.0;
}
