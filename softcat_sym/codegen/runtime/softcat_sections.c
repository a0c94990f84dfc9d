#include "softcat_plan.h"

#include "softcat_vectors.h"

#include <math.h>
#include <string.h>

/* Gauss-Jordan elimination with partial pivoting. */
static int invert_any(double *block, int size, int *order)
{
    for (int j = 0; j < size; j++) {
        int p = j;
        for (int i = j + 1; i < size; i++)
            if (fabs(block[i * size + j]) > fabs(block[p * size + j])) p = i;
        double pivot = block[p * size + j];
        if (!isfinite(pivot)) return SOFTCAT_NON_FINITE;
        if (pivot == 0.0) return SOFTCAT_SINGULAR;
        order[j] = p;
        for (int c = 0; c < size; c++) {
            double moved = block[p * size + c];
            block[p * size + c] = block[j * size + c];
            block[j * size + c] = c == j ? 1.0 / pivot : moved / pivot;
        }
        for (int i = 0; i < size; i++) {
            if (i == j) continue;
            double times = block[i * size + j];
            block[i * size + j] = 0.0;
            if (times == 0.0) continue;
            for (int c = 0; c < size; c++) block[i * size + c] -= times * block[j * size + c];
        }
    }
    for (int j = size - 1; j >= 0; j--)
        for (int i = 0; order[j] != j && i < size; i++) {
            double moved = block[i * size + j];
            block[i * size + j] = block[i * size + order[j]];
            block[i * size + order[j]] = moved;
        }
    return SOFTCAT_SOLVED;
}

/* Turn a block into its inverse: it is applied many times, and is mostly 1 x 1 or 2 x 2. */
static int invert(double *block, int size, int *order)
{
    if (size > 2) return invert_any(block, size, order);
    double a = block[0], b = size > 1 ? block[1] : 0.0, c = size > 1 ? block[2] : 0.0;
    double d = size > 1 ? block[3] : 1.0, determinant = a * d - b * c;
    if (!isfinite(determinant)) return SOFTCAT_NON_FINITE;
    if (determinant == 0.0) return SOFTCAT_SINGULAR;
    block[0] = d / determinant;
    if (size == 1) return SOFTCAT_SOLVED;
    block[1] = -b / determinant;
    block[2] = -c / determinant;
    block[3] = a / determinant;
    return SOFTCAT_SOLVED;
}

/* out = (W_ss)^-1 in, for one vector of section states. */
static void apply_blocks(const softcat_linear *linear, const double *inverse, const double *in,
                         double *out)
{
    for (int b = 0; b < linear->block_count; b++) {
        int first = linear->block[b].first, size = linear->block[b].size;
        if (size == 2) {
            out[first] = inverse[0] * in[first] + inverse[1] * in[first + 1];
            out[first + 1] = inverse[2] * in[first] + inverse[3] * in[first + 1];
            inverse += 4;
            continue;
        }
        for (int i = 0; i < size; i++) {
            double sum = 0.0;
            for (int j = 0; j < size; j++) sum += *inverse++ * in[first + j];
            out[first + i] = sum;
        }
    }
}

/* -J of a list of entries, scattered into an empty store. */
static void gather_links(const softcat_linear *linear, const softcat_links *links, int site,
                         const double *entries, double *store, int columns)
{
    memset(store, 0, (size_t)columns * (size_t)linear->padded * sizeof(double));
    softcat_linear_scatter(linear, links, site, entries, store);
}

static int all_zero(const softcat_links *links, const double *entries)
{
    for (int l = 0; l < links->count; l++)
        if (entries[links->links[l].entry] != 0.0) return 0;
    return 1;
}

int softcat_sections_eliminate(softcat_linear *linear, int site, const double *entries,
                               double shift)
{
    const softcat_model *model = linear->model;
    int padded = linear->padded, columns = linear->answer_columns;
    double *blocks = linear->blocks + (size_t)site * (size_t)linear->block_doubles;
    const unsigned char *is_free = linear->free_unknowns + (ptrdiff_t)site * linear->slots;
    memset(blocks, 0, (size_t)linear->block_doubles * sizeof(double));
    for (int s = 0; s < model->sections; s++) {
        int slot = linear->section_slot[s];
        double mass = model->differential[slot] ? shift : 0.0;
        blocks[linear->diagonal[s]] = is_free[slot] ? mass : 1.0;
    }
    softcat_linear_scatter(linear, &linear->within, site, entries, blocks);
    for (int b = 0; b < linear->block_count; b++) {
        const softcat_block *block = linear->block + b;
        int code = invert(blocks + block->start, block->size, linear->pivots);
        if (code) return code;
    }
    int groups = linear->group_count;
    gather_links(linear, &linear->seen, site, entries,
                 linear->weights + (ptrdiff_t)site * groups * padded, groups);
    linear->at_rest[site] = (unsigned char)all_zero(&linear->driven, entries);
    if (linear->at_rest[site]) return SOFTCAT_SOLVED;
    gather_links(linear, &linear->dragged, site, entries,
                 linear->drags + (ptrdiff_t)site * linear->x_columns * padded, linear->x_columns);
    gather_links(linear, &linear->driven, site, entries, linear->coupling, columns);
    double *answers = linear->answers + (ptrdiff_t)site * columns * padded;
    for (int c = 0; c < columns; c++)
        apply_blocks(linear, blocks, linear->coupling + c * padded, answers + c * padded);
    return SOFTCAT_SOLVED;
}

/* What the kept rows of a site see of kept unknowns through section states: S = W_kk
 * - W_ks (W_ss)^-1 W_sk, where `weights` is W_ks. */
void softcat_sections_answer(const softcat_linear *linear, int site, double *rows)
{
    size_t padded = (size_t)linear->padded, columns = (size_t)linear->answer_columns;
    const double *weight = linear->weights + (size_t)site * (size_t)linear->group_count * padded;
    const int *target = linear->group_target;
    for (int g = 0; g < linear->group_count; g++, weight += padded, target += columns) {
        int other = site + linear->group[g].offset;
        if (other < 0 || other >= linear->sites || linear->at_rest[other]) continue;
        const double *answer = linear->answers + (size_t)other * columns * padded;
        for (size_t c = 0; c < columns; c++)
            rows[target[c]] -= softcat_dot(weight, answer + c * padded, linear->padded);
    }
}

/* Section states of their own right-hand side, which takes in the x; then what the rows in the band
 * see of them. */
void softcat_sections_first(const softcat_linear *linear, double *k)
{
    int sections = linear->model->sections, padded = linear->padded, columns = linear->x_columns;
    const double *drag = linear->drags, *x = linear->x;
    for (int site = 0; site < linear->sites;
         site++, x += linear->eliminated, drag += columns * padded) {
        double *here = k + (ptrdiff_t)site * linear->slots;
        int moves = 0;
        for (int s = 0; s < sections; s++) {
            linear->gathered[s] = here[linear->section_slot[s]];
            moves |= linear->gathered[s] != 0.0;
        }
        if (!linear->at_rest[site])
            softcat_subtract(linear->gathered, drag, padded, x, columns);
        else if (!moves)
            continue;
        apply_blocks(linear, linear->blocks + (size_t)site * (size_t)linear->block_doubles,
                     linear->gathered, linear->solved);
        for (int s = 0; s < sections; s++) here[linear->section_slot[s]] = linear->solved[s];
        for (int g = 0; g < linear->group_count; g++) {
            const softcat_group *group = linear->group + g;
            int seeing = site - group->offset;
            if (seeing < 0 || seeing >= linear->sites) continue;
            size_t place = (size_t)seeing * (size_t)linear->group_count + (size_t)g;
            const double *weight = linear->weights + place * (size_t)padded;
            linear->band.right[seeing * linear->remaining + linear->place[group->row]] -=
                softcat_dot(weight, linear->solved, padded);
        }
    }
}

void softcat_sections_last(const softcat_linear *linear, double *k)
{
    int sections = linear->model->sections, padded = linear->padded;
    int columns = linear->answer_columns;
    const double *answer = linear->answers;
    for (int site = 0; site < linear->sites; site++, answer += columns * padded) {
        if (linear->at_rest[site]) continue;
        double *here = k + (ptrdiff_t)site * linear->slots;
        for (int s = 0; s < sections; s++) linear->gathered[s] = here[linear->section_slot[s]];
        for (int c = 0; c < columns; c++) {
            int other = site + linear->answer_offset[c];
            int known = other >= 0 && other < linear->sites;
            int slot = linear->answer_offset[c] * linear->slots + linear->answer_slot[c];
            linear->known[c] = known ? here[slot] : 0.0;
        }
        softcat_subtract(linear->gathered, answer, padded, linear->known, columns);
        for (int s = 0; s < sections; s++) here[linear->section_slot[s]] = linear->gathered[s];
    }
}
