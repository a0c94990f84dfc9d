#include "softcat_plan.h"

#include "softcat_vectors.h"

#include <stdlib.h>
#include <string.h>

static int *integers(int count)
{
    return calloc((size_t)count + 1, sizeof(int));
}

static double *doubles(size_t count)
{
    return calloc(count + 1, sizeof(double));
}

/* Slots that the plan speaks of, and entries inside the site's unknowns. */
static int contradictory_model(const softcat_model *model, int sites)
{
    if (sites < 1 || model->slots < 1) return 1;
    if (model->sections < 0 || model->sections > model->slots) return 1;
    for (int k = 0; k < model->slots; k++)
        if (model->rate[k] >= model->slots || model->rate[k] == k) return 1;
    int kept = model->slots - model->sections;
    for (int e = 0; e < model->entries; e++) {
        int row = model->row[e], column = model->column[e];
        if (row < 0 || column < 0 || row >= model->slots || column >= model->slots) return 1;
        if (row >= kept && column >= kept && model->offset[e] != 0) return 1;
    }
    return 0;
}

static int allocate(softcat_linear *linear)
{
    const softcat_model *model = linear->model;
    int slots = linear->slots, sections = model->sections, entries = model->entries;
    softcat_links *lists[] = {&linear->direct,  &linear->within, &linear->driven,
                              &linear->dragged, &linear->seen,   &linear->moved};
    int missing = 0;
    for (int l = 0; l < 6; l++) {
        lists[l]->links = calloc((size_t)entries + 1, sizeof(softcat_link));
        missing |= !lists[l]->links;
    }
    linear->free_unknowns = calloc((size_t)linear->sites * (size_t)slots, 1);
    linear->at_rest = calloc((size_t)linear->sites, 1);
    linear->held = integers(linear->sites * slots);
    linear->block = calloc((size_t)sections + 1, sizeof(softcat_block));
    linear->group = calloc((size_t)entries + 1, sizeof(softcat_group));
    linear->eliminated_slot = integers(slots);
    linear->remaining_slot = integers(slots);
    linear->place = integers(slots);
    linear->section_slot = integers(sections);
    linear->diagonal = integers(sections);
    linear->answer_offset = integers(entries);
    linear->answer_slot = integers(entries);
    linear->order = integers(sections);
    linear->gathered = doubles((size_t)linear->padded);
    linear->solved = doubles((size_t)linear->padded);
    linear->known = doubles((size_t)entries);
    return missing || !(linear->free_unknowns && linear->at_rest && linear->block
                        && linear->group && linear->eliminated_slot
                        && linear->remaining_slot && linear->place
                        && linear->section_slot && linear->diagonal && linear->answer_offset
                        && linear->answer_slot && linear->held && linear->order
                        && linear->gathered && linear->solved && linear->known);
}

/* x' = u is eliminated unless u is somebody's rate of change itself. */
static int is_eliminated(const softcat_linear *linear, int slot)
{
    const softcat_model *model = linear->model;
    int rate = model->rate[slot];
    return slot < linear->kept && rate >= 0 && rate < linear->kept && model->rate[rate] < 0
           && model->differential[slot];
}

/* Section states that see each other get the same label: the smallest of their slots. */
static void find_blocks(softcat_linear *linear)
{
    const softcat_model *model = linear->model;
    int *label = linear->place, kept = linear->kept, changed = 1, position = 0;
    for (int k = kept; k < linear->slots; k++) label[k] = k;
    while (changed) {
        changed = 0;
        for (int e = 0; e < model->entries; e++) {
            int a = model->row[e], b = model->column[e];
            if (a < kept || b < kept || label[a] == label[b]) continue;
            if (label[a] < label[b]) label[b] = label[a];
            else label[a] = label[b];
            changed = 1;
        }
    }
    for (int k = kept; k < linear->slots; k++) {
        if (label[k] != k) continue;
        softcat_block *block = linear->block + linear->block_count++;
        block->first = position;
        block->start = linear->block_doubles;
        for (int other = k; other < linear->slots; other++)
            if (label[other] == k) linear->section_slot[position++] = other;
        block->size = position - block->first;
        for (int i = 0; i < block->size; i++)
            linear->diagonal[block->first + i] = block->start + i * block->size + i;
        linear->block_doubles += block->size * block->size;
    }
    for (int s = 0; s < position; s++) label[linear->section_slot[s]] = s;
}

static softcat_link *append(softcat_links *links, const softcat_linear *linear, int entry)
{
    const softcat_model *model = linear->model;
    softcat_link *link = links->links + links->count++;
    link->entry = entry;
    link->row = model->row[entry];
    link->offset = model->offset[entry];
    link->column = model->column[entry];
    link->via = is_eliminated(linear, link->column) ? model->rate[link->column] : -1;
    link->distance = link->offset * linear->slots + link->column;
    return link;
}

/* Sort the entries by what their row and their column are. */
static void classify(softcat_linear *linear)
{
    const softcat_model *model = linear->model;
    for (int e = 0; e < model->entries; e++) {
        int row = model->row[e], column = model->column[e];
        if (is_eliminated(linear, row)) continue;
        if (model->offset[e] < -linear->back) linear->back = -model->offset[e];
        if (model->offset[e] > linear->ahead) linear->ahead = model->offset[e];
        int by_rate = is_eliminated(linear, column), kept = column < linear->kept;
        if (row < linear->kept) {
            append(kept ? &linear->direct : &linear->seen, linear, e);
            if (by_rate) append(&linear->moved, linear, e);
        } else {
            append(kept ? &linear->driven : &linear->within, linear, e);
            if (by_rate) append(&linear->dragged, linear, e);
        }
    }
}

/* Position of (offset, slot) in a list of such pairs. */
static int find_or_add(int *count, int *offsets, int *slots, int offset, int slot)
{
    int c = 0;
    while (c < *count && (slots[c] != slot || offsets[c] != offset)) c++;
    if (c == *count) ++*count;
    slots[c] = slot;
    offsets[c] = offset;
    return c;
}

/* Where the column of an eliminated x stands in a panel of so many rows. */
static void place_by_x(const softcat_linear *linear, softcat_links *links, int rows)
{
    for (int l = 0; l < links->count; l++) {
        softcat_link *link = links->links + l;
        int c = (link->offset + linear->back) * linear->eliminated + linear->place[link->column];
        link->target = c * rows + linear->place[link->row];
        link->via = -1; /* x itself is meant */
    }
}

/* Where the numbers of a section row go, and which kept unknowns such rows see. */
static void place_sections(softcat_linear *linear)
{
    for (int l = 0; l < linear->within.count; l++) {
        softcat_link *link = linear->within.links + l;
        int s = linear->place[link->row];
        const softcat_block *block = linear->block;
        while (s >= block->first + block->size) block++;
        link->target = linear->diagonal[s] + linear->place[link->column] - s;
    }
    for (int l = 0; l < linear->driven.count; l++) {
        softcat_link *link = linear->driven.links + l;
        int slot = link->via >= 0 ? link->via : link->column;
        int c = find_or_add(&linear->answer_columns, linear->answer_offset, linear->answer_slot,
                            link->offset, slot);
        link->target = c * linear->padded + linear->place[link->row];
    }
    place_by_x(linear, &linear->dragged, linear->padded);
}

/* Those with a rate last, then row by row. */
static int by_rate_and_row(const void *left, const void *right)
{
    const softcat_link *a = left, *b = right;
    if ((a->via >= 0) != (b->via >= 0)) return a->via >= 0 ? 1 : -1;
    if (a->row != b->row) return a->row < b->row ? -1 : 1;
    return a->entry < b->entry ? -1 : a->entry > b->entry;
}

static void sort(softcat_links *links)
{
    qsort(links->links, (size_t)links->count, sizeof(softcat_link), by_rate_and_row);
    while (links->first_via < links->count && links->links[links->first_via].via < 0)
        links->first_via++;
}

static void find_groups(softcat_linear *linear)
{
    for (int l = 0; l < linear->seen.count; l++) {
        softcat_link *link = linear->seen.links + l;
        softcat_group *group = linear->group;
        while (group < linear->group + linear->group_count
               && (group->row != link->row || group->offset != link->offset))
            group++;
        if (group == linear->group + linear->group_count) linear->group_count++;
        group->row = link->row;
        group->offset = link->offset;
        link->target = (int)(group - linear->group) * linear->padded + linear->place[link->column];
    }
}

/* Where everything goes in the rows of the band, and beside it. */
static void place_band(softcat_linear *linear)
{
    const softcat_band *band = &linear->band;
    place_by_x(linear, &linear->moved, linear->lanes);
    for (int l = 0; l < linear->direct.count; l++) {
        softcat_link *link = linear->direct.links + l;
        int slot = link->via >= 0 ? link->via : link->column, row = linear->place[link->row];
        int distance = link->offset * linear->remaining + linear->place[slot] - row;
        link->target = row * band->width + band->lower + distance;
    }
    for (int g = 0; g < linear->group_count; g++)
        for (int c = 0; c < linear->answer_columns; c++) {
            int sites = linear->group[g].offset + linear->answer_offset[c];
            int row = linear->place[linear->group[g].row];
            int distance = sites * linear->remaining + linear->place[linear->answer_slot[c]] - row;
            linear->group_target[g * linear->answer_columns + c] =
                row * band->width + band->lower + distance;
        }
}

/* What the numbers of all sites need, once the pattern is known. */
static int allocate_stores(softcat_linear *linear, int lower, int upper)
{
    size_t sites = (size_t)linear->sites, padded = (size_t)linear->padded;
    size_t answers = (size_t)linear->answer_columns * padded;
    linear->group_target = integers(linear->group_count * linear->answer_columns);
    linear->coupling = doubles(answers);
    linear->blocks = doubles(sites * (size_t)linear->block_doubles);
    linear->answers = doubles(sites * answers);
    linear->x_columns = (linear->back + linear->ahead + 1) * linear->eliminated;
    size_t columns = (size_t)linear->x_columns;
    linear->x = doubles(sites * (size_t)linear->eliminated + columns);
    linear->drags = doubles(sites * columns * padded);
    linear->weights = doubles(sites * (size_t)linear->group_count * padded);
    linear->moves = doubles(sites * columns * (size_t)linear->lanes);
    int missing = softcat_band_new(&linear->band, linear->sites * linear->remaining, lower, upper);
    return missing || !(linear->group_target && linear->coupling && linear->blocks
                        && linear->answers && linear->drags && linear->weights && linear->moves
                        && linear->x);
}

int softcat_plan_make(softcat_linear *linear)
{
    const softcat_model *model = linear->model;
    int lower = 0, upper = 0;
    if (contradictory_model(model, linear->sites)) return SOFTCAT_ARGUMENT;
    linear->slots = model->slots;
    linear->kept = model->slots - model->sections;
    linear->padded = softcat_fours(model->sections);
    if (allocate(linear)) return SOFTCAT_MEMORY;
    for (int k = 0; k < linear->kept; k++) {
        if (is_eliminated(linear, k)) linear->eliminated_slot[linear->eliminated++] = k;
        else linear->remaining_slot[linear->remaining++] = k;
    }
    linear->lanes = softcat_fours(linear->remaining);
    for (int k = 0; k < linear->eliminated; k++) linear->place[linear->eliminated_slot[k]] = k;
    for (int k = 0; k < linear->remaining; k++) linear->place[linear->remaining_slot[k]] = k;
    find_blocks(linear);
    classify(linear);
    place_sections(linear);
    find_groups(linear);
    softcat_plan_order(linear, &lower, &upper);
    if (allocate_stores(linear, lower, upper)) return SOFTCAT_MEMORY;
    place_band(linear);
    sort(&linear->direct);
    sort(&linear->within);
    sort(&linear->driven);
    sort(&linear->dragged);
    sort(&linear->seen);
    sort(&linear->moved);
    return SOFTCAT_SOLVED;
}

void softcat_plan_free(softcat_linear *linear)
{
    softcat_links *lists[] = {&linear->direct,  &linear->within, &linear->driven,
                              &linear->dragged, &linear->seen,   &linear->moved};
    for (int l = 0; l < 6; l++) free(lists[l]->links);
    int *ints[] = {linear->eliminated_slot, linear->remaining_slot, linear->place,
                   linear->section_slot,    linear->diagonal,       linear->answer_offset,
                   linear->answer_slot,     linear->order,          linear->group_target,
                   linear->held};
    double *numbers[] = {linear->gathered, linear->solved,  linear->coupling, linear->blocks,
                         linear->answers,  linear->drags,   linear->weights,  linear->moves,
                         linear->x,        linear->known};
    for (size_t i = 0; i < sizeof ints / sizeof *ints; i++) free(ints[i]);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) free(numbers[i]);
    free(linear->free_unknowns);
    free(linear->at_rest);
    free(linear->block);
    free(linear->group);
    softcat_band_free(&linear->band);
}
