#include "softcat_plan.h"

#include "softcat_vectors.h"

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

/* Sort the entries by what their row and their column are. */
static void classify(softcat_linear *linear, const softcat_view *view)
{
    const softcat_model *model = linear->model;
    softcat_links *to[2];
    for (int e = 0; e < model->entries; e++)
        for (int l = 0, lists = softcat_plan_lists(linear, view, e, to); l < lists; l++) {
            softcat_link *link = to[l]->links + to[l]->count++;
            link->entry = e;
            link->row = model->row[e];
            link->offset = model->offset[e];
            link->column = model->column[e];
            link->via =
                softcat_is_eliminated(linear, link->column) ? model->rate[link->column] : -1;
            link->distance = link->offset * linear->slots + link->column;
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

/* Those with a rate last, then row by row: nearly in order as they come. */
static int comes_later(const softcat_link *a, const softcat_link *b)
{
    if ((a->via >= 0) != (b->via >= 0)) return a->via >= 0;
    return a->row > b->row;
}

static void sort(softcat_links *links)
{
    for (int i = 1; i < links->count; i++) {
        softcat_link link = links->links[i];
        int j = i;
        for (; j > 0 && comes_later(links->links + j - 1, &link); j--)
            links->links[j] = links->links[j - 1];
        links->links[j] = link;
    }
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

/* Tables of the pattern, as they were counted. */
static void take_tables(softcat_linear *linear, softcat_memory *memory)
{
    const softcat_model *model = linear->model;
    size_t slots = (size_t)linear->slots, sections = (size_t)model->sections;
    size_t columns = (size_t)linear->answer_columns, groups = (size_t)linear->group_count;
    softcat_links *lists[] = {&linear->direct,  &linear->within, &linear->driven,
                              &linear->dragged, &linear->seen,   &linear->moved};
    softcat_link *links = softcat_take(memory, (size_t)linear->link_count, sizeof(softcat_link));
    for (int l = 0; l < 6; l++) {
        lists[l]->links = links;
        if (links) links += lists[l]->count;
    }
    linear->free_unknowns = softcat_take(memory, (size_t)linear->sites * slots, 1);
    linear->at_rest = softcat_take(memory, (size_t)linear->sites, 1);
    linear->held = softcat_take_ints(memory, (size_t)linear->sites * slots);
    linear->block = softcat_take(memory, (size_t)linear->block_count, sizeof(softcat_block));
    linear->group = softcat_take(memory, groups, sizeof(softcat_group));
    linear->eliminated_slot = softcat_take_ints(memory, (size_t)linear->eliminated);
    linear->remaining_slot = softcat_take_ints(memory, (size_t)linear->remaining);
    linear->place = softcat_take_ints(memory, slots);
    linear->section_slot = softcat_take_ints(memory, sections);
    linear->diagonal = softcat_take_ints(memory, sections);
    linear->pivots = softcat_take_ints(memory, sections);
    linear->answer_offset = softcat_take_ints(memory, columns);
    linear->answer_slot = softcat_take_ints(memory, columns);
    linear->group_target = softcat_take_ints(memory, groups * columns);
    linear->gathered = softcat_take_doubles(memory, (size_t)linear->padded);
    linear->solved = softcat_take_doubles(memory, (size_t)linear->padded);
    linear->known = softcat_take_doubles(memory, columns);
}

/* What the numbers of all sites need. */
static void take_stores(softcat_linear *linear, softcat_memory *memory)
{
    size_t sites = (size_t)linear->sites, padded = (size_t)linear->padded;
    size_t answers = (size_t)linear->answer_columns * padded, columns = (size_t)linear->x_columns;
    linear->coupling = softcat_take_doubles(memory, answers);
    linear->blocks = softcat_take_doubles(memory, sites * (size_t)linear->block_doubles);
    linear->answers = softcat_take_doubles(memory, sites * answers);
    linear->x = softcat_take_doubles(memory, sites * (size_t)linear->eliminated + columns);
    linear->drags = softcat_take_doubles(memory, sites * columns * padded);
    linear->weights = softcat_take_doubles(memory, sites * (size_t)linear->group_count * padded);
    linear->moves = softcat_take_doubles(memory, sites * columns * (size_t)linear->lanes);
    softcat_band_take(&linear->band, memory, linear->sites * linear->remaining, linear->band.lower,
                      linear->band.upper);
}

static void forget_counts(softcat_linear *linear)
{
    linear->direct.count = linear->within.count = linear->driven.count = 0;
    linear->dragged.count = linear->seen.count = linear->moved.count = 0;
    linear->block_count = linear->block_doubles = 0;
    linear->answer_columns = linear->group_count = 0;
    linear->eliminated = linear->remaining = 0;
}

/* Fill what was taken: all is found again as it was counted, and written down this time. */
static void fill(softcat_linear *linear, const softcat_view *view)
{
    forget_counts(linear);
    for (int k = 0; k < linear->kept; k++) {
        if (softcat_is_eliminated(linear, k)) linear->eliminated_slot[linear->eliminated++] = k;
        else linear->remaining_slot[linear->remaining++] = k;
    }
    if (linear->remaining <= SOFTCAT_FEW) {
        int natural[SOFTCAT_FEW];
        for (int k = 0; k < linear->remaining; k++) natural[k] = linear->remaining_slot[k];
        for (int k = 0; k < linear->remaining; k++)
            linear->remaining_slot[k] = natural[linear->order[k]];
    }
    for (int k = 0; k < linear->eliminated; k++) linear->place[linear->eliminated_slot[k]] = k;
    for (int k = 0; k < linear->remaining; k++) linear->place[linear->remaining_slot[k]] = k;
    find_blocks(linear);
    classify(linear, view);
    place_sections(linear);
    find_groups(linear);
    place_band(linear);
    sort(&linear->direct);
    sort(&linear->within);
    sort(&linear->driven);
    sort(&linear->dragged);
    sort(&linear->seen);
    sort(&linear->moved);
}

int softcat_plan_make(softcat_linear *linear, const softcat_view *view, softcat_memory *memory)
{
    int code = softcat_plan_count(linear, view);
    if (code) return code;
    linear->padded = softcat_fours(linear->model->sections);
    linear->lanes = softcat_fours(linear->remaining);
    linear->x_columns = (linear->back + linear->ahead + 1) * linear->eliminated;
    take_tables(linear, memory);
    take_stores(linear, memory);
    if (!memory->base) return SOFTCAT_SOLVED;
    if (!softcat_fits(memory)) return SOFTCAT_MEMORY;
    fill(linear, view);
    return SOFTCAT_SOLVED;
}
