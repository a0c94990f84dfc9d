/* Where a soft filament comes to rest, and how much that depends on its yield stress. C99. */
#include "filament.h"

#include <stdio.h>
#include <stdlib.h>

enum { TIMES = 5 };

int main(void)
{
    double params[SOFTCAT_PARAMETERS], times[TIMES];
    const int cells = SOFTCAT_SCENE_CELLS, row = softcat_row(cells);
    const int by[1] = {SOFTCAT_P_YIELD_STRESS};
    softcat_status status;
    softcat_defaults(params);
    params[SOFTCAT_P_YIELD_STRESS] = 8000.0; /* Pa; the scene has 9319.5 */
    for (int j = 0; j < TIMES; j++) times[j] = 0.5 * j;

    const softcat_settings derived = {.by_count = 1};
    size_t bytes = softcat_workspace_size(cells, TIMES, &derived);
    double *shape = malloc(2 * (size_t)TIMES * (size_t)row * sizeof *shape + bytes);
    if (!shape) return EXIT_FAILURE;
    softcat_workspace workspace = {shape + 2 * TIMES * row, bytes};
    double *slope = shape + TIMES * row; /* d shape / d yield stress, in m/Pa */
    int code =
        softcat_solve_sensitivities(params, cells, times, TIMES, by, 1, shape, slope, workspace,
                                    &status);
    if (code) {
        fprintf(stderr, "%s, at t = %g s\n", softcat_explain(code), status.reached);
        free(shape);
        return EXIT_FAILURE;
    }
    printf("time_s,midpoint_m,slope_m_per_Pa\n");
    for (int j = 0; j < TIMES; j++) /* the first node is the one at midspan; y comes after x */
        printf("%g,%.9g,%.6g\n", times[j], shape[j * row + 1], slope[j * row + 1]);
    free(shape);
    return EXIT_SUCCESS;
}
