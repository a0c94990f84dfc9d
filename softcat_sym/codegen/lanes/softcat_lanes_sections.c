#include "softcat_lanes_linear.h"

#include <string.h>

/* Gauss-Jordan elimination; the pivot of each lane is its own. */
static lanes_mask invert_any(real *block, int size, lanes_mask *order)
{
    lanes_mask bad = {0};
    for (int j = 0; j < size; j++) {
        real best = lanes_fabs(block[j * size + j]);
        lanes_mask found = (lanes_mask){0} + j;
        for (int i = j + 1; i < size; i++) {
            real other = lanes_fabs(block[i * size + j]);
            lanes_mask larger = (lanes_mask)(other > best);
            best = lanes_choose(larger, other, best);
            found = lanes_choose_integer(larger, (lanes_mask){0} + i, found);
        }
        order[j] = found;
        bad |= ~lanes_finite(best) | (lanes_mask)(best == 0.0);
        for (int p = j + 1; p < size; p++) {
            lanes_mask m = (lanes_mask)(found == (lanes_mask){0} + p);
            for (int c = 0; c < size && lanes_any(m); c++) {
                real kept = block[p * size + c];
                block[p * size + c] = lanes_choose(m, block[j * size + c], kept);
                block[j * size + c] = lanes_choose(m, kept, block[j * size + c]);
            }
        }
        real inverse = 1.0 / block[j * size + j];
        block[j * size + j] = REAL(1.0);
        for (int c = 0; c < size; c++) block[j * size + c] *= inverse;
        for (int i = 0; i < size; i++) {
            if (i == j) continue;
            real times = block[i * size + j];
            block[i * size + j] = REAL(0.0);
            if (!lanes_any((lanes_mask)(times != 0.0))) continue;
            for (int c = 0; c < size; c++) block[i * size + c] -= times * block[j * size + c];
        }
    }
    for (int j = size - 1; j >= 0; j--)
        for (int p = j + 1; p < size; p++) {
            lanes_mask m = (lanes_mask)(order[j] == (lanes_mask){0} + p);
            for (int i = 0; i < size && lanes_any(m); i++) {
                real kept = block[i * size + j];
                block[i * size + j] = lanes_choose(m, block[i * size + p], kept);
                block[i * size + p] = lanes_choose(m, kept, block[i * size + p]);
            }
        }
    return bad;
}

static lanes_mask invert(real *block, int size, lanes_mask *order)
{
    if (size > 2) return invert_any(block, size, order);
    if (size == 1) {
        real whole = block[0];
        block[0] = 1.0 / whole;
        return ~lanes_finite(whole) | (lanes_mask)(whole == 0.0);
    }
    real a = block[0], b = block[1], c = block[2], d = block[3], determinant = a * d - b * c;
    real inverse = 1.0 / determinant;
    block[0] = d * inverse;
    block[1] = -b * inverse;
    block[2] = -c * inverse;
    block[3] = a * inverse;
    return ~lanes_finite(determinant) | (lanes_mask)(determinant == 0.0);
}

/* out = (W_ss)^-1 in, for one vector of section states. */
static void apply(const softcat_linear *plan, const real *restrict inverse,
                  const real *restrict in, real *restrict out)
{
    for (int b = 0; b < plan->block_count; b++) {
        int first = plan->block[b].first, size = plan->block[b].size;
        for (int i = 0; i < size; i++) {
            real sum = REAL(0.0);
            for (int j = 0; j < size; j++) sum += *inverse++ * in[first + j];
            out[first + i] = sum;
        }
    }
}

lanes_mask lanes_sections_eliminate(lanes_linear *linear, int site, const real *entries, real shift)
{
    const softcat_linear *plan = linear->plan;
    const softcat_model *model = plan->model;
    size_t padded = (size_t)plan->padded, wide = (size_t)plan->answer_columns * padded;
    size_t weights = (size_t)plan->group_count * padded, at = (size_t)site;
    real *blocks = linear->blocks + at * (size_t)plan->block_doubles;
    real *answers = linear->answers + at * wide;
    const unsigned char *is_free = plan->free_unknowns + (ptrdiff_t)site * plan->slots;
    lanes_mask bad = {0};
    memset(blocks, 0, (size_t)plan->block_doubles * sizeof(real));
    memset(linear->coupling, 0, wide * sizeof(real));
    memset(linear->weights + at * weights, 0, weights * sizeof(real));
    for (int s = 0; s < model->sections; s++) {
        int slot = plan->section_slot[s];
        real mass = model->differential[slot] ? shift : REAL(0.0);
        blocks[plan->diagonal[s]] = is_free[slot] ? mass : REAL(1.0);
    }
    lanes_scatter(linear, &plan->within, site, entries, blocks);
    lanes_scatter(linear, &plan->driven, site, entries, linear->coupling);
    lanes_scatter(linear, &plan->seen, site, entries, linear->weights + at * weights);
    for (int b = 0; b < plan->block_count; b++) {
        const softcat_block *block = plan->block + b;
        bad |= invert(blocks + block->start, block->size, (lanes_mask *)linear->gathered);
    }
    for (size_t c = 0; c < wide; c += padded)
        apply(plan, blocks, linear->coupling + c, answers + c);
    return bad;
}

static real dot(const real *restrict a, const real *restrict b, int count)
{
    real even = REAL(0.0), odd = REAL(0.0);
    for (int c = 0; c < count; c += 2) { /* `count` is a multiple of four */
        even += a[c] * b[c];
        odd += a[c + 1] * b[c + 1];
    }
    return even + odd;
}

void lanes_sections_answer(const lanes_linear *linear, int site, real *rows)
{
    const softcat_linear *plan = linear->plan;
    size_t padded = (size_t)plan->padded, columns = (size_t)plan->answer_columns;
    const real *weight = linear->weights + (size_t)site * (size_t)plan->group_count * padded;
    const int *target = plan->group_target;
    for (int g = 0; g < plan->group_count; g++, weight += padded, target += columns) {
        int other = site + plan->group[g].offset;
        if (other < 0 || other >= plan->sites) continue;
        const real *answer = linear->answers + (size_t)other * columns * padded;
        for (size_t c = 0; c < columns; c++)
            rows[target[c]] -= dot(weight, answer + c * padded, plan->padded);
    }
}

void lanes_sections_first(const lanes_linear *linear, real *k)
{
    const softcat_linear *plan = linear->plan;
    int sections = plan->model->sections, padded = plan->padded, last = plan->sites - 1;
    for (int site = 0; site <= last; site++) {
        real *here = k + (ptrdiff_t)site * plan->slots;
        for (int s = 0; s < sections; s++) linear->gathered[s] = here[plan->section_slot[s]];
        lanes_carry_over(linear, &plan->dragged, site, k, linear->gathered, plan->place);
        apply(plan, linear->blocks + (size_t)site * (size_t)plan->block_doubles, linear->gathered,
              linear->solved);
        for (int s = 0; s < sections; s++) here[plan->section_slot[s]] = linear->solved[s];
        for (int g = 0; g < plan->group_count; g++) {
            const softcat_group *group = plan->group + g;
            int seeing = site - group->offset;
            if (seeing < 0 || seeing > last) continue;
            size_t place = (size_t)seeing * (size_t)plan->group_count + (size_t)g;
            k[(ptrdiff_t)seeing * plan->slots + group->row] -=
                dot(linear->weights + place * (size_t)padded, linear->solved, padded);
        }
    }
}

void lanes_sections_last(const lanes_linear *linear, real *k)
{
    const softcat_linear *plan = linear->plan;
    int sections = plan->model->sections, padded = plan->padded;
    const real *answer = linear->answers;
    for (int site = 0; site < plan->sites; site++) {
        real *here = k + (ptrdiff_t)site * plan->slots;
        for (int s = 0; s < sections; s++) linear->gathered[s] = here[plan->section_slot[s]];
        for (int c = 0; c < plan->answer_columns; c++, answer += padded) {
            int other = site + plan->answer_offset[c];
            if (other < 0 || other >= plan->sites) continue;
            real known = k[(ptrdiff_t)other * plan->slots + plan->answer_slot[c]];
            for (int s = 0; s < sections; s++) linear->gathered[s] -= known * answer[s];
        }
        for (int s = 0; s < sections; s++) here[plan->section_slot[s]] = linear->gathered[s];
    }
}
