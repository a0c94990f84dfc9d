/* Derivatives of the shape at the end by every parameter, beside differences of whole runs:
 * parameter, error of the derivative over the largest difference, or over a hundredth of the shape
 * over the parameter: what hardly matters is hardly known from differences. */
#include "filament.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 6, MOST = 3 * (2 * CELLS + 1) };

static const softcat_settings tight = {.relative = 1e-9, .absolute = 1e-13};

static softcat_workspace room;

static int shape(const double *params, double *out)
{
    const double time[] = {SOFTCAT_SCENE_DURATION};
    const softcat_results results = {.positions = out};
    return softcat_solve_with(params, CELLS, time, 1, &tight, &results, room, NULL);
}

int main(void)
{
    const softcat_structure *s = &softcat_filament_structure;
    const double time[] = {SOFTCAT_SCENE_DURATION};
    double params[SOFTCAT_PARAMETERS], up[MOST], down[MOST], slope[MOST];
    int row = softcat_row(CELLS);
    const softcat_settings one = {.by_count = 1};
    room.bytes = softcat_workspace_size(CELLS, 1, &one);
    room.memory = malloc(room.bytes);
    printf("parameter,error\n");
    for (int k = 0; k < s->model->parameters; k++) {
        size_t length = strlen(s->parameter_names[k]);
        softcat_settings with = tight;
        const softcat_results results = {.derivatives = slope};
        softcat_defaults(params);
        double value = params[k], step = value != 0.0 ? 1e-4 * fabs(value) : 1e-5, error = 0.0;
        with.by = &k;
        with.by_count = 1;
        with.by_step = value != 0.0 ? NULL : &step;
        if (k == s->time_scale) continue;
        if (length > 5 && strcmp(s->parameter_names[k] + length - 5, "_time") == 0) continue;
        /* An end that is elsewhere, or turned, at the release would jump there: that has no derivative. */
        if (strncmp(s->parameter_names[k], "motion_0_", 9) == 0) continue;
        if (strcmp(s->parameter_names[k], "turn_0_angle") == 0) continue;
        if (softcat_solve_with(params, CELLS, time, 1, &with, &results, room, NULL)) exit(1);
        params[k] = value + step;
        if (shape(params, up)) exit(1);
        params[k] = value - step;
        if (shape(params, down)) exit(1);
        double largest = 1e-300, weight = value != 0.0 ? 0.01 / fabs(value) : 0.0;
        for (int i = 0; i < row; i++) {
            double difference = (up[i] - down[i]) / (2.0 * step);
            largest = fmax(largest, fmax(fabs(difference), weight * fabs(up[i])));
            error = fmax(error, fabs(difference - slope[i]));
        }
        printf("%d,%g\n", k, error / largest);
    }
    free(room.memory);
    return 0;
}
