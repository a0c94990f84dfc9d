#include "softcat_plan.h"

#include <string.h>

/* Distances below and above the diagonal, for the positions now in `place`. */
static void measure(const softcat_linear *linear, int *lower, int *upper)
{
    int least = 0, most = 0;
    for (int l = 0; l < linear->direct.count; l++) {
        const softcat_link *link = linear->direct.links + l;
        int slot = link->via >= 0 ? link->via : link->column;
        int distance =
            link->offset * linear->remaining + linear->place[slot] - linear->place[link->row];
        least = distance < least ? distance : least;
        most = distance > most ? distance : most;
    }
    for (int g = 0; g < linear->group_count; g++)
        for (int c = 0; c < linear->answer_columns; c++) {
            int sites = linear->group[g].offset + linear->answer_offset[c];
            int distance = sites * linear->remaining + linear->place[linear->answer_slot[c]]
                           - linear->place[linear->group[g].row];
            least = distance < least ? distance : least;
            most = distance > most ? distance : most;
        }
    *lower = -least;
    *upper = most;
}

static int next_permutation(int *list, int count)
{
    int i = count - 2, j = count - 1;
    while (i >= 0 && list[i] >= list[i + 1]) i--;
    if (i < 0) return 0;
    while (list[j] <= list[i]) j--;
    int kept = list[i];
    list[i] = list[j];
    list[j] = kept;
    for (int a = i + 1, b = count - 1; a < b; a++, b--) {
        kept = list[a];
        list[a] = list[b];
        list[b] = kept;
    }
    return 1;
}

/* Order the remaining slots within the site so that the band is narrow: all orders are tried if
 * they are few (the work of a step grows with lower * upper, once, and lower + upper, a stage). */
void softcat_plan_order(softcat_linear *linear, int *lower, int *upper)
{
    enum { FEW = 5 };
    int best[FEW], best_cost = -1, count = linear->remaining;
    measure(linear, lower, upper);
    if (count > FEW) return;
    do {
        for (int i = 0; i < count; i++) linear->place[linear->remaining_slot[i]] = i;
        measure(linear, lower, upper);
        int cost = *lower * *upper + 8 * *lower + 4 * *upper;
        if (best_cost < 0 || cost < best_cost) {
            best_cost = cost;
            memcpy(best, linear->remaining_slot, (size_t)count * sizeof(int));
        }
    } while (next_permutation(linear->remaining_slot, count));
    memcpy(linear->remaining_slot, best, (size_t)count * sizeof(int));
    for (int i = 0; i < count; i++) linear->place[linear->remaining_slot[i]] = i;
    measure(linear, lower, upper);
}
