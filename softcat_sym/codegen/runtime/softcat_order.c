#include "softcat_plan.h"

#include <string.h>

/* Distances below and above the diagonal with slot i of the remaining ones at place[i]. */
static void measure(softcat_linear *linear, const softcat_reach *reach, const int *place)
{
    int least = 0, most = 0, count = linear->remaining;
    for (int r = 0; r < count; r++)
        for (int c = 0; c < count; c++) {
            if (reach->most[r][c] < reach->least[r][c]) continue;
            int between = place[c] - place[r];
            int low = reach->least[r][c] * count + between;
            int high = reach->most[r][c] * count + between;
            least = low < least ? low : least;
            most = high > most ? high : most;
        }
    linear->band.lower = -least;
    linear->band.upper = most;
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

/* All orders are tried if they are few (the work of a step grows with lower * upper, once, and
 * lower + upper, a stage). */
void softcat_plan_order(softcat_linear *linear, const softcat_reach *reach)
{
    int order[SOFTCAT_FEW], place[SOFTCAT_MOST_REMAINING], best_cost = -1;
    int count = linear->remaining;
    for (int i = 0; i < count; i++) place[i] = i;
    if (count > SOFTCAT_FEW) {
        measure(linear, reach, place);
        return;
    }
    memcpy(order, place, (size_t)count * sizeof(int));
    do {
        for (int i = 0; i < count; i++) place[order[i]] = i;
        measure(linear, reach, place);
        int lower = linear->band.lower, upper = linear->band.upper;
        int cost = lower * upper + 8 * lower + 4 * upper;
        if (best_cost >= 0 && cost >= best_cost) continue;
        best_cost = cost;
        memcpy(linear->order, order, (size_t)count * sizeof(int));
    } while (next_permutation(order, count));
    for (int i = 0; i < count; i++) place[linear->order[i]] = i;
    measure(linear, reach, place);
}
