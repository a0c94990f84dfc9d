/* Every wrong argument has its code, and nothing is written or read where nothing should be. */
#include "filament.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int wrong;
static softcat_workspace room; /* large enough for all that follows */

static void expect(const char *what, int code, int wanted)
{
    if (code == wanted && softcat_explain(code)[0]) return;
    printf("%s: code %d (%s), wanted %d\n", what, code, softcat_explain(code), wanted);
    wrong = 1;
}

/* What the header says of single parameters, cells and times. */
static void plain(double *p, double *times, double *out)
{
    softcat_status status;
    const double kept = p[SOFTCAT_P_YOUNGS_MODULUS], bad[] = {NAN, INFINITY, 0.0, -1.0};
    for (int k = 0; k < 4; k++) {
        p[SOFTCAT_P_YOUNGS_MODULUS] = bad[k];
        expect("modulus", softcat_solve(p, 8, times, 2, out, room, &status), SOFTCAT_BAD_PARAMETER);
        if (status.worst_slot != SOFTCAT_P_YOUNGS_MODULUS) wrong = 1;
    }
    p[SOFTCAT_P_YOUNGS_MODULUS] = kept;
    p[SOFTCAT_P_POISSON] = 0.5;
    expect("poisson", softcat_solve(p, 8, times, 2, out, room, NULL), SOFTCAT_BAD_PARAMETER);
    softcat_defaults(p);
    expect("no params", softcat_solve(NULL, 8, times, 2, out, room, NULL), SOFTCAT_ARGUMENT);
    expect("cells", softcat_solve(p, 3, times, 2, out, room, NULL), SOFTCAT_BAD_CELLS);
    expect("cells", softcat_solve(p, -8, times, 2, out, room, NULL), SOFTCAT_BAD_CELLS);
    expect("cells", softcat_solve(p, 2000000000, times, 2, out, room, NULL), SOFTCAT_BAD_CELLS);
    expect("n", softcat_solve(p, 8, times, 0, out, room, NULL), SOFTCAT_BAD_TIMES);
    expect("no times", softcat_solve(p, 8, NULL, 2, out, room, NULL), SOFTCAT_BAD_TIMES);
    const double late[] = {0.0, 0.0}, before[] = {-1.0, 0.0}, endless[] = {0.0, INFINITY};
    expect("equal times", softcat_solve(p, 8, late, 2, out, room, NULL), SOFTCAT_BAD_TIMES);
    expect("negative time", softcat_solve(p, 8, before, 2, out, room, NULL), SOFTCAT_BAD_TIMES);
    expect("endless", softcat_solve(p, 8, endless, 2, out, room, NULL), SOFTCAT_BAD_TIMES);
    expect("good", softcat_solve(p, 8, times, 2, out, room, NULL), SOFTCAT_SOLVED);
    if (softcat_row(3) != 0 || softcat_row(8) != 18) wrong = 1;
}

static void settings(const double *p, const double *times, double *out)
{
    const softcat_results results = {.positions = out};
    const double kink[] = {NAN}, step[] = {0.0};
    const int scale[] = {SOFTCAT_P_TIME_SCALE}, beyond[] = {SOFTCAT_PARAMETERS};
    const volatile int stop = 1;
    const struct {
        const char *what;
        softcat_settings with;
        int code;
    } tries[] = {
        {"relative", {.relative = 1.0}, SOFTCAT_BAD_SETTINGS},
        {"negative", {.relative = -1e-3}, SOFTCAT_BAD_SETTINGS},
        {"absolute", {.absolute = NAN}, SOFTCAT_BAD_SETTINGS},
        {"grading", {.grading = 1e300}, SOFTCAT_BAD_SETTINGS},
        {"method", {.method = 17}, SOFTCAT_BAD_SETTINGS},
        {"steps", {.max_steps = -1}, SOFTCAT_BAD_SETTINGS},
        {"kink", {.kinks = kink, .kink_count = 1}, SOFTCAT_BAD_SETTINGS},
        {"no kinks", {.kink_count = 1}, SOFTCAT_BAD_SETTINGS},
        {"thickness", {.thickness = p, .thickness_count = 2}, SOFTCAT_BAD_SETTINGS},
        {"by scale", {.by = scale, .by_count = 1}, SOFTCAT_BAD_SETTINGS},
        {"by beyond", {.by = beyond, .by_count = 1}, SOFTCAT_BAD_SETTINGS},
        {"by step", {.by = scale, .by_count = 1, .by_step = step}, SOFTCAT_BAD_SETTINGS},
        {"stopped", {.stop = &stop}, SOFTCAT_STOPPED},
        {"one step", {.max_steps = 1}, SOFTCAT_STEP_LIMIT},
    };
    for (size_t k = 0; k < sizeof tries / sizeof *tries; k++) {
        out[0] = 7.0;
        expect(tries[k].what,
               softcat_solve_with(p, 8, times, 2, &tries[k].with, &results, room, NULL), tries[k].code);
        /* Refused: untouched. Failed: the last row says that it is not known. */
        int refused = tries[k].code == SOFTCAT_BAD_SETTINGS && k != 3;
        if (refused ? out[0] != 7.0 : !isnan(out[18])) {
            printf("%s: %g %g\n", tries[k].what, out[0], out[18]);
            wrong = 1;
        }
    }
    expect("no results", softcat_solve_with(p, 8, times, 2, NULL, NULL, room, NULL), SOFTCAT_ARGUMENT);
}

static void starts(const double *p, const double *times, double *out)
{
    double X[9], values[9 * SOFTCAT_SLOTS] = {0};
    softcat_table table = {9, X, values};
    const softcat_results results = {.positions = out};
    const softcat_settings with = {.start = &table};
    for (int i = 0; i < 9; i++) {
        X[i] = i / 16.0;
        values[i * SOFTCAT_SLOTS + SOFTCAT_SLOT_X] = X[i];
    }
    expect("start", softcat_solve_with(p, 8, times, 2, &with, &results, room, NULL), SOFTCAT_SOLVED);
    values[8 * SOFTCAT_SLOTS + SOFTCAT_SLOT_X] = 0.4; /* the support is at 0.5 */
    expect("away", softcat_solve_with(p, 8, times, 2, &with, &results, room, NULL), SOFTCAT_BAD_START);
    values[8 * SOFTCAT_SLOTS + SOFTCAT_SLOT_X] = 0.5;
    values[5] = NAN;
    expect("nan", softcat_solve_with(p, 8, times, 2, &with, &results, room, NULL), SOFTCAT_BAD_START);
    values[5] = 0.0;
    X[3] = X[2];
    expect("order", softcat_solve_with(p, 8, times, 2, &with, &results, room, NULL), SOFTCAT_BAD_START);
    table.rows = 2;
    expect("short", softcat_solve_with(p, 8, times, 2, &with, &results, room, NULL), SOFTCAT_BAD_START);
}

/* All results, at times of which the first is not 0; the first of them alone gives the same. */
static void everything(const double *p, const double *times)
{
    const double later[] = {0.5 * times[1], times[1]};
    const softcat_model *model = softcat_filament_structure.model;
    size_t row = (size_t)softcat_row(8), size = row / 2 * SOFTCAT_SLOTS;
    double *memory = calloc(2 * (3 * row + 1 + size + (size_t)model->powers), sizeof(double));
    if (!memory) exit(1);
    const int by[] = {SOFTCAT_P_YOUNGS_MODULUS, SOFTCAT_P_GRAVITY};
    const softcat_settings with = {.by = by, .by_count = 2};
    const softcat_results all = {memory, memory + 2 * row, memory + 2 * row + 2,
                                 memory + 2 * row + 2 + 2 * size,
                                 memory + 2 * row + 2 + 2 * size + 2 * model->powers, NULL};
    double alone[1];
    expect("all", softcat_solve_with(p, 8, later, 2, &with, &all, room, NULL), SOFTCAT_SOLVED);
    expect("alone", softcat_midpoint(p, 8, later + 1, 1, alone, room, NULL), SOFTCAT_SOLVED);
    if (!(fabs(alone[0] - all.midpoint[1]) < 1e-4 * fabs(alone[0])) || alone[0] >= 0.0
        || all.midpoint[1] != all.positions[row + 1]) {
        printf("midpoint: %g %g %g\n", alone[0], all.midpoint[1], all.positions[row + 1]);
        wrong = 1;
    }
    free(memory);
}

/* A workspace that is too small is said to be, whatever its size and wherever it begins. */
static void small(const double *p, const double *times, double *out)
{
    const softcat_settings beyond = {.fibres = 1001}, negative = {.by_count = -1};
    size_t enough = softcat_workspace_size(8, 2, NULL);
    expect("none", softcat_solve(p, 8, times, 2, out, (softcat_workspace){NULL, enough}, NULL),
           SOFTCAT_MEMORY);
    for (size_t bytes = 0; bytes < enough - 16; bytes += bytes < 4000 ? 8 : enough / 50) {
        const softcat_workspace less = {malloc(bytes + 1), bytes};
        expect("less", softcat_solve(p, 8, times, 2, out, less, NULL), SOFTCAT_MEMORY);
        free(less.memory);
    }
    for (size_t off = 0; off < 16; off++) {
        char *block = malloc(enough + off);
        const softcat_workspace odd = {block ? block + off : NULL, enough};
        expect("odd", softcat_solve(p, 8, times, 2, out, odd, NULL), SOFTCAT_SOLVED);
        free(block);
    }
    if (softcat_workspace_size(3, 2, NULL) || softcat_workspace_size(8, 0, NULL)
        || softcat_workspace_size(8, 2, &beyond) || softcat_workspace_size(8, 2, &negative)) {
        printf("a size of what cannot be\n");
        wrong = 1;
    }
}

int main(void)
{
    double params[SOFTCAT_PARAMETERS], out[2 * 18];
    double times[] = {0.0, 0.02 * SOFTCAT_SCENE_DURATION};
    const softcat_settings largest = {.by_count = 2};
    room.bytes = softcat_workspace_size(8, 2, &largest);
    room.memory = malloc(room.bytes);
    if (!room.memory) return 1;
    softcat_defaults(params);
    plain(params, times, out);
    settings(params, times, out);
    starts(params, times, out);
    everything(params, times);
    small(params, times, out);
    free(room.memory);
    if (!wrong) printf("all as it should be\n");
    return wrong;
}
