#include "softcat_lanes_linear.h"

#include <stdlib.h>
#include <string.h>

/* A row takes the place of another whose pivot is smaller by this factor, as in softcat_band.c: few
 * are, so that rows reach less far. */
static const double threshold = 0.01;

real *lanes_new(size_t count, void **to_free)
{
    size_t each = sizeof(real);
    char *memory = calloc(count + 1, each);
    *to_free = memory;
    return memory ? (real *)(memory + (each - (size_t)memory % each) % each) : NULL;
}

int lanes_linear_new(lanes_linear *linear, const softcat_model *model, int sites)
{
    int code;
    memset(linear, 0, sizeof *linear);
    softcat_memory counted = {NULL, 0, 0};
    softcat_linear_new(model, NULL, sites, &counted, &code);
    if (code) return code;
    counted.size = counted.used;
    counted.base = linear->planned = calloc(counted.used, 1);
    counted.used = 0;
    if (!counted.base) return SOFTCAT_MEMORY;
    softcat_linear *plan = linear->plan = softcat_linear_new(model, NULL, sites, &counted, &code);
    if (code) return code;
    const softcat_band *band = &plan->band;
    size_t n = (size_t)band->size, site = (size_t)sites, padded = (size_t)plan->padded;
    size_t answers = (size_t)plan->answer_columns * padded;
    real **store[] = {&linear->rows,   &linear->multipliers, &linear->inverse, &linear->scale,
                      &linear->right,  &linear->blocks,      &linear->answers, &linear->weights,
                      &linear->coupling, &linear->gathered,  &linear->solved};
    size_t size[] = {n * (size_t)band->width,
                     n * (size_t)band->lower,
                     n,
                     n,
                     n + (size_t)band->width,
                     site * (size_t)plan->block_doubles,
                     site * answers,
                     site * (size_t)plan->group_count * padded,
                     answers,
                     padded,
                     padded};
    size_t all = n;
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) all += size[i];
    real *place = lanes_new(all, &linear->memory);
    linear->common = linear->integers = calloc(2 * n + 1, sizeof(int));
    if (!place || !linear->integers) return SOFTCAT_MEMORY;
    linear->last = linear->common + n;
    linear->pivot = (lanes_mask *)place;
    place += n;
    for (size_t i = 0; i < sizeof size / sizeof *size; place += size[i++]) *store[i] = place;
    return SOFTCAT_SOLVED;
}

void lanes_linear_free(lanes_linear *linear)
{
    free(linear->planned);
    free(linear->memory);
    free(linear->integers);
}

static int plain(const softcat_linear *plan, int site)
{
    return site >= plan->first_plain && site <= plan->last_plain;
}

/* Whether row and column of an entry exist and are free. */
static int counts(const softcat_linear *plan, int site, const softcat_link *link)
{
    int other = site + link->offset;
    if (other < 0 || other >= plan->sites) return 0;
    const unsigned char *free_row = plan->free_unknowns + (ptrdiff_t)site * plan->slots;
    const unsigned char *free_column = plan->free_unknowns + (ptrdiff_t)other * plan->slots;
    if (link->via >= 0 && !free_column[link->via]) return 0;
    return free_row[link->row] && free_column[link->column];
}

void lanes_scatter(const lanes_linear *linear, const softcat_links *links, int site,
                   const real *entries, real *store)
{
    const softcat_link *link = links->links, *first_via = link + links->first_via;
    const softcat_link *end = link + links->count;
    int all = plain(linear->plan, site);
    for (; link < first_via; link++)
        if (all || counts(linear->plan, site, link)) store[link->target] -= entries[link->entry];
    for (; link < end; link++)
        if (all || counts(linear->plan, site, link))
            store[link->target] -= entries[link->entry] * linear->inverse_shift;
}

/* Lanes with a number that is not finite, or a row of zeros. */
static lanes_mask scale_rows(lanes_linear *linear)
{
    const softcat_band *band = &linear->plan->band;
    lanes_mask bad = {0};
    int filled = band->lower + band->upper + 1;
    for (int i = 0; i < band->size; i++) {
        const real *row = linear->rows + (size_t)i * (size_t)band->width;
        real largest = REAL(0.0), sum = REAL(0.0);
        for (int c = 0; c < filled; c++) {
            real size = lanes_fabs(row[c]);
            largest = lanes_larger(size, largest);
            sum += size;
        }
        bad |= ~lanes_finite(sum) | (lanes_mask)(largest == 0.0);
        linear->scale[i] = 1.0 / largest;
    }
    return bad;
}

static void exchange(real *restrict a, real *restrict b, lanes_mask m, int count)
{
    for (int c = 0; c < count; c++) {
        real kept = a[c];
        a[c] = lanes_choose(m, b[c], a[c]);
        b[c] = lanes_choose(m, kept, b[c]);
    }
}

/* Exchange row `j`, lane by lane, with the one below it that has the largest number in its column,
 * unless its own will do. Lanes for which none will. */
static lanes_mask take_pivot(lanes_linear *linear, int j, int end, int *reach)
{
    const softcat_band *band = &linear->plan->band;
    size_t width = (size_t)band->width;
    int lower = band->lower, n = band->size, bound = j + band->upper;
    real best = lanes_fabs(linear->rows[(size_t)j * width + (size_t)lower]) * linear->scale[j];
    lanes_mask here = (lanes_mask){0} + j, found = here;
    for (int i = j + 1; i <= end; i++) {
        real entry = linear->rows[(size_t)i * width + (size_t)(j - i + lower)];
        real size = lanes_fabs(entry) * linear->scale[i];
        lanes_mask larger = (lanes_mask)(size > best);
        best = lanes_choose(larger, size, best);
        found = lanes_choose_integer(larger, (lanes_mask){0} + i, found);
    }
    real own = lanes_fabs(linear->rows[(size_t)j * width + (size_t)lower]) * linear->scale[j];
    found = lanes_choose_integer((lanes_mask)(own >= threshold * best), here, found);
    linear->pivot[j] = found;
    linear->common[j] = lanes_any((lanes_mask)(found != found[0])) ? -1 : (int)found[0];
    lanes_mask moved = (lanes_mask)(found != here);
    for (int p = end; p > j && lanes_any(moved); p--) {
        lanes_mask m = (lanes_mask)(found == (lanes_mask){0} + p);
        if (!lanes_any(m)) continue;
        if (p + band->upper > bound) bound = p + band->upper;
        if (bound > *reach) *reach = bound < n - 1 ? bound : n - 1;
        exchange(linear->rows + (size_t)j * width + (size_t)lower,
                 linear->rows + (size_t)p * width + (size_t)(j - p + lower), m, *reach - j + 1);
        linear->scale[p] = lanes_choose(m, linear->scale[j], linear->scale[p]);
    }
    if (bound > *reach) *reach = bound < n - 1 ? bound : n - 1;
    return (lanes_mask)(best == 0.0) | ~lanes_finite(best);
}

static lanes_mask factorise_band(lanes_linear *linear)
{
    const softcat_band *band = &linear->plan->band;
    size_t width = (size_t)band->width;
    int n = band->size, lower = band->lower, reach = 0;
    lanes_mask bad = scale_rows(linear);
    for (int j = 0; j < n; j++) {
        int end = j + lower < n - 1 ? j + lower : n - 1;
        bad |= take_pivot(linear, j, end, &reach);
        linear->last[j] = reach;
        const real *restrict pivot = linear->rows + (size_t)j * width + (size_t)lower;
        real *multipliers = linear->multipliers + (size_t)j * (size_t)band->lower;
        real inverse = linear->inverse[j] = 1.0 / pivot[0];
        for (int i = j + 1; i <= end; i++) {
            real *restrict row = linear->rows + (size_t)i * width + (size_t)(j - i + lower);
            real times = row[0] * inverse;
            multipliers[i - j - 1] = times;
            if (lanes_any((lanes_mask)(times != 0.0)))
                for (int c = 1; c <= reach - j; c++) row[c] -= times * pivot[c];
        }
    }
    return bad;
}

lanes_mask lanes_linear_factorise(lanes_linear *linear, const real *entries, real shift)
{
    const softcat_linear *plan = linear->plan;
    const softcat_model *model = plan->model;
    const softcat_band *band = &plan->band;
    lanes_mask bad = {0};
    size_t each = (size_t)model->entries;
    linear->entries = entries;
    linear->inverse_shift = 1.0 / shift;
    for (int site = 0; site < plan->sites && model->sections > 0; site++)
        bad |= lanes_sections_eliminate(linear, site, entries + (size_t)site * each, shift);
    memset(linear->rows, 0, (size_t)band->size * (size_t)band->width * sizeof(real));
    for (int site = 0; site < plan->sites; site++) {
        real *rows = linear->rows + (size_t)site * (size_t)plan->remaining * (size_t)band->width;
        const unsigned char *is_free = plan->free_unknowns + (size_t)site * (size_t)plan->slots;
        for (int i = 0; i < plan->remaining; i++) {
            int slot = plan->remaining_slot[i];
            real mass = model->differential[slot] ? shift : REAL(0.0);
            rows[i * band->width + band->lower] = is_free[slot] ? mass : REAL(1.0);
        }
        lanes_scatter(linear, &plan->direct, site, entries + (size_t)site * each, rows);
        if (model->sections > 0) lanes_sections_answer(linear, site, rows);
    }
    return bad | factorise_band(linear);
}

static void solve_band(const lanes_linear *linear)
{
    const softcat_band *band = &linear->plan->band;
    real *restrict b = linear->right;
    int n = band->size;
    real value = b[0]; /* of row j: what is needed at once stays in a register */
    for (int j = 0; j < n; j++) {
        const real *restrict times = linear->multipliers + (size_t)j * (size_t)band->lower;
        int count = j + band->lower < n - 1 ? band->lower : n - 1 - j, p = linear->common[j];
        b[j] = value;
        if (p != j) {
            for (int i = p < 0 ? j + 1 : p; i <= (p < 0 ? j + count : p); i++)
                exchange(b + j, b + i, (lanes_mask)(linear->pivot[j] == (lanes_mask){0} + i), 1);
            value = b[j];
        }
        real next = count > 0 ? b[j + 1] - value * times[0] : value;
        for (int i = 1; i < count; i++) b[j + 1 + i] -= value * times[i];
        value = next;
    }
    value = REAL(0.0);
    for (int i = n - 1; i >= 0; i--) {
        const real *restrict row = linear->rows + (size_t)i * (size_t)band->width + band->lower + 1;
        const real *known = b + i + 1;
        real even = b[i], odd = REAL(0.0);
        /* Where a sum goes must not depend on how far the rows of other lanes reach. */
        int c = linear->last[i] - i - 1;
        if (c > 0 && c % 2 == 0) even -= row[c] * known[c];
        for (c -= 1 - c % 2; c > 1; c -= 2) {
            odd -= row[c] * known[c];
            even -= row[c - 1] * known[c - 1];
        }
        if (c == 1) odd -= row[1] * known[1];
        even += odd;
        if (i < n - 1) even -= row[0] * value;
        b[i] = value = even * linear->inverse[i];
    }
}

void lanes_carry_over(const lanes_linear *linear, const softcat_links *links, int site,
                      const real *k, real *to, const int *place)
{
    const softcat_linear *plan = linear->plan;
    const real *entries = linear->entries + (size_t)site * (size_t)plan->model->entries;
    const unsigned char *is_free = plan->free_unknowns + (ptrdiff_t)site * plan->slots;
    const real *here = k + (ptrdiff_t)site * plan->slots;
    const softcat_link *link = links->links, *end = link + links->count;
    int all = plain(plan, site);
    while (link < end) { /* links of a row stand together */
        int row = link->row;
        real sum = REAL(0.0);
        for (; link < end && link->row == row; link++) {
            int other = site + link->offset;
            if (all || (other >= 0 && other < plan->sites && is_free[row]))
                sum += entries[link->entry] * here[link->distance];
        }
        to[place ? place[row] : row] += sum;
    }
}

void lanes_linear_solve(const lanes_linear *linear, real *k)
{
    const softcat_linear *plan = linear->plan;
    size_t slots = (size_t)plan->slots, all = (size_t)plan->sites * slots;
    for (size_t i = 0; i < all; i++)
        if (!plan->free_unknowns[i]) k[i] = REAL(0.0);
    for (int e = 0; e < plan->eliminated; e++)
        for (int site = 0; site < plan->sites; site++)
            k[(size_t)site * slots + (size_t)plan->eliminated_slot[e]] *= linear->inverse_shift;
    for (int site = 0; site < plan->sites; site++)
        lanes_carry_over(linear, &plan->moved, site, k, k + (size_t)site * slots, NULL);
    if (plan->model->sections > 0) lanes_sections_first(linear, k);
    real *right = linear->right;
    for (int site = 0; site < plan->sites; site++)
        for (int i = 0; i < plan->remaining; i++)
            *right++ = k[(size_t)site * slots + (size_t)plan->remaining_slot[i]];
    solve_band(linear);
    right = linear->right;
    for (int site = 0; site < plan->sites; site++)
        for (int i = 0; i < plan->remaining; i++)
            k[(size_t)site * slots + (size_t)plan->remaining_slot[i]] = *right++;
    if (plan->model->sections > 0) lanes_sections_last(linear, k);
    for (int e = 0; e < plan->eliminated; e++) {
        size_t x = (size_t)plan->eliminated_slot[e], u = (size_t)plan->model->rate[x];
        for (int site = 0; site < plan->sites; site++)
            if (plan->free_unknowns[(size_t)site * slots + x])
                k[(size_t)site * slots + x] +=
                    k[(size_t)site * slots + u] * linear->inverse_shift;
    }
}
