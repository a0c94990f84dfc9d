#include "softcat_plan.h"

#include <string.h>

/* What a model may have at most, so that its pattern is counted without memory: kept unknowns of a
 * site, sites that an entry reaches to, section states that see each other. */
enum { MOST_KEPT = 48, MOST_OFFSET = 4, OFFSETS = 2 * MOST_OFFSET + 1, MOST_BLOCK = 64 };

/* Slots that the plan speaks of, and entries inside the site's unknowns. */
static int contradictory_model(const softcat_model *model, int sites)
{
    if (sites < 1 || model->slots < 1) return 1;
    if (model->sections < 0 || model->sections > model->slots) return 1;
    for (int k = 0; k < model->slots; k++)
        if (model->rate[k] >= model->slots || model->rate[k] == k) return 1;
    int kept = model->slots - model->sections;
    if (kept > MOST_KEPT) return 1;
    for (int e = 0; e < model->entries; e++) {
        int row = model->row[e], column = model->column[e], offset = model->offset[e];
        if (row < 0 || column < 0 || row >= model->slots || column >= model->slots) return 1;
        if (row >= kept && column >= kept && offset != 0) return 1;
        if (offset < -MOST_OFFSET || offset > MOST_OFFSET) return 1;
    }
    return 0;
}

int softcat_is_eliminated(const softcat_linear *linear, int slot)
{
    const softcat_model *model = linear->model;
    if (slot >= linear->kept) return 0;
    int rate = model->rate[slot];
    return rate >= 0 && rate < linear->kept && model->rate[rate] < 0 && model->differential[slot];
}

/* Row, offset and column of an entry. */
static void look_up(const softcat_view *view, int entry, int *row, int *offset, int *column)
{
    const softcat_model *tables = view->tables;
    int e = softcat_source(entry, view->plain_entries, view->from, view->to);
    int point = entry < view->plain_entries ? 0 : (entry - view->plain_entries) % view->to;
    *row = softcat_target(tables->row[e], view->plain_slots, view->from, view->to, point);
    *offset = tables->offset[e];
    *column = softcat_target(tables->column[e], view->plain_slots, view->from, view->to, point);
}

int softcat_plan_lists(softcat_linear *linear, const softcat_view *view, int entry,
                       softcat_links *to[2])
{
    int row, offset, column, count = 0;
    look_up(view, entry, &row, &offset, &column);
    if (softcat_is_eliminated(linear, row)) return 0;
    int by_rate = softcat_is_eliminated(linear, column), kept = column < linear->kept;
    if (row < linear->kept) {
        to[count++] = kept ? &linear->direct : &linear->seen;
        if (by_rate) to[count++] = &linear->moved;
    } else {
        to[count++] = kept ? &linear->driven : &linear->within;
        if (by_rate) to[count++] = &linear->dragged;
    }
    return count;
}

/* Which kept rows see section states of which site, and which kept unknowns move these. */
typedef struct sight {
    unsigned char group[MOST_KEPT][OFFSETS], answer[MOST_KEPT][OFFSETS];
    int place[MOST_KEPT]; /* of a slot among the remaining ones */
} sight;

static void reach_to(softcat_reach *reach, int row, int column, int offset)
{
    signed char *least = &reach->least[row][column], *most = &reach->most[row][column];
    if (offset < *least) *least = (signed char)offset;
    if (offset > *most) *most = (signed char)offset;
}

/* Lengths of the lists, and what each entry reaches to. */
static void count_links(softcat_linear *linear, const softcat_view *view, sight *seen,
                        softcat_reach *reach)
{
    int row, offset, column, entries = linear->model->entries;
    softcat_links *to[2];
    for (int e = 0; e < entries; e++) {
        int lists = softcat_plan_lists(linear, view, e, to);
        if (!lists) continue;
        look_up(view, e, &row, &offset, &column);
        for (int l = 0; l < lists; l++) to[l]->count++;
        linear->link_count += lists;
        if (offset < -linear->back) linear->back = -offset;
        if (offset > linear->ahead) linear->ahead = offset;
        int slot = softcat_is_eliminated(linear, column) ? linear->model->rate[column] : column;
        if (to[0] == &linear->direct)
            reach_to(reach, seen->place[row], seen->place[slot], offset);
        else if (to[0] == &linear->seen) seen->group[row][offset + MOST_OFFSET] = 1;
        else if (to[0] == &linear->driven) seen->answer[slot][offset + MOST_OFFSET] = 1;
    }
}

/* What rows see through section states, of which site whatever. */
static void reach_through_sections(softcat_linear *linear, const sight *seen, softcat_reach *reach)
{
    for (int i = 0; i < linear->kept * OFFSETS; i++) {
        int row = i / OFFSETS, there = i % OFFSETS;
        linear->answer_columns += seen->answer[row][there];
        if (!seen->group[row][there]) continue;
        linear->group_count++;
        for (int j = 0; j < linear->kept * OFFSETS; j++)
            if (seen->answer[j / OFFSETS][j % OFFSETS])
                reach_to(reach, seen->place[row], seen->place[j / OFFSETS],
                         there + j % OFFSETS - 2 * MOST_OFFSET);
    }
}

/* How many section states see each other with `first`, itself included: 0 if it is not the first of
 * them, -1 if they are too many. Entries that do not lie between two numbers are none of these. */
static int block_of(const softcat_linear *linear, const softcat_view *view, int first,
                    const int between[2])
{
    int member[MOST_BLOCK] = {first}, count = 1, row, offset, column;
    for (int m = 0; m < count; m++)
        for (int e = between[0]; e <= between[1]; e++) {
            look_up(view, e, &row, &offset, &column);
            if (row < linear->kept || column < linear->kept) continue;
            if (row != member[m] && column != member[m]) continue;
            int other = row == member[m] ? column : row, known = 0;
            if (other < first) return 0;
            while (known < count && member[known] != other) known++;
            if (known < count) continue;
            if (count == MOST_BLOCK) return -1;
            member[count++] = other;
        }
    return count;
}

static int count_blocks(softcat_linear *linear, const softcat_view *view)
{
    int between[2] = {0, -1};
    softcat_links *to[2];
    for (int e = 0; e < linear->model->entries; e++) {
        if (!softcat_plan_lists(linear, view, e, to) || to[0] != &linear->within) continue;
        if (between[1] < 0) between[0] = e;
        between[1] = e;
    }
    for (int k = linear->kept; k < linear->slots; k++) {
        int size = block_of(linear, view, k, between);
        if (size < 0) return SOFTCAT_ARGUMENT;
        linear->block_count += size > 0;
        linear->block_doubles += size * size;
    }
    return SOFTCAT_SOLVED;
}

int softcat_plan_count(softcat_linear *linear, const softcat_view *view)
{
    const softcat_model *model = linear->model;
    softcat_reach reach;
    sight seen = {.place = {0}};
    if (contradictory_model(view->tables, linear->sites)) return SOFTCAT_ARGUMENT;
    linear->slots = model->slots;
    linear->kept = model->slots - model->sections;
    for (int k = 0; k < linear->kept; k++) {
        if (softcat_is_eliminated(linear, k)) linear->eliminated++;
        else seen.place[k] = linear->remaining++;
    }
    if (linear->remaining > SOFTCAT_MOST_REMAINING) return SOFTCAT_ARGUMENT;
    memset(reach.least, 2 * MOST_OFFSET + 1, sizeof reach.least);
    memset(reach.most, -2 * MOST_OFFSET - 1, sizeof reach.most);
    count_links(linear, view, &seen, &reach);
    reach_through_sections(linear, &seen, &reach);
    softcat_plan_order(linear, &reach);
    return count_blocks(linear, view);
}
