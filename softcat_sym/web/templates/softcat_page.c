/* What a page in a browser calls: one filament at a time, solved and seen as `softcat run` does.
 *
 * Compiled with the C file of its structure, the runtime and the text of the observables into one
 * WebAssembly module; page_rows.h says how many fields that text has. It has state, unlike all else
 * here: buffers stay valid until the next page_solve. */
#include "filament.h"
#include "page_rows.h"
#include "softcat_places.h"
#include "softcat_section.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef __wasm__
#define EXPORTED(name) __attribute__((export_name(#name))) name
#else
#define EXPORTED(name) name
#endif

enum { PARAMETERS = SOFTCAT_PARAMETERS, STATUS = 8 };

/* The text of the observables: rows of sites for each of `count` times in units of the scale. */
int softcat_filament_observe(const softcat_filament *, int count, const double *times,
                             const double *states, double *out, double *scratch);

static const softcat_structure *const structure = &softcat_filament_structure;
static double parameters[PARAMETERS], known[STATUS];
static double *absolute, *start, *memory, *fields, *midpoint;
static int start_rows;
static softcat_workspace workspace;

double *EXPORTED(page_parameters)(void)
{
    return parameters;
}

/* Room for the tolerances of so many unknowns of a site. */
double *EXPORTED(page_absolute)(int slots)
{
    free(absolute);
    return absolute = malloc((size_t)slots * sizeof(double));
}

/* Room for X of the nodes, then for the unknowns with the scene's fibres; NULL without memory, and
 * for no rows. */
double *EXPORTED(page_start)(int rows)
{
    free(start);
    start = rows > 0 ? calloc((size_t)rows * (1 + (size_t)SOFTCAT_SLOTS), sizeof(double)) : NULL;
    start_rows = start ? rows : 0;
    return start;
}

double *EXPORTED(page_fields)(void)
{
    return fields;
}

double *EXPORTED(page_midpoint)(void)
{
    return midpoint;
}

double *EXPORTED(page_status)(void)
{
    return known;
}

const char *EXPORTED(page_explain)(int code)
{
    return softcat_explain(code);
}

/* Fields of the first `count` frames; `places` has room for X, places and scratch of the sites. */
static void observe(const softcat_sized *sized, int cells, int sites, double grading, int count,
                    double *times, const double *states, double *places)
{
    double given[PARAMETERS], *X = places + (size_t)sites * (size_t)structure->model->places;
    softcat_filament filament = {sites, given, places, sized->structure.points, sized->points};
    memcpy(given, parameters, sizeof given);
    double *scale = &given[structure->time_scale];
    if (*scale == 0.0) *scale = sqrt(given[structure->rest_length] / given[structure->gravity]);
    for (int j = 0; j < count; j++) times[j] /= *scale;
    softcat_nodes(structure, cells, grading, X);
    softcat_places(structure, cells, X, structure->thickness, structure->thickness_count, places);
    softcat_filament_observe(&filament, count, times, states, fields, X + sites);
}

/* The structure with so many fibres, in memory of its own, which is to be freed: 0 or a code. */
static int size(int fibres, softcat_sized *sized, void **tables)
{
    softcat_memory counted = {NULL, 0, 0};
    *tables = NULL;
    int code = softcat_size(structure, parameters, fibres, &counted, sized);
    if (code) return code;
    counted.size = counted.used;
    counted.base = *tables = malloc(counted.used + 1);
    counted.used = 0;
    if (!counted.base) return SOFTCAT_MEMORY;
    return softcat_size(structure, parameters, fibres, &counted, sized);
}

/* All that a run fills and works in, in one piece; 0 if there is no such memory. */
static int make_room(const softcat_sized *sized, size_t frames, size_t sites, size_t bytes,
                     double **times, double **states, double **places)
{
    const softcat_model *m = &sized->model;
    size_t points = (size_t)sized->structure.points;
    size_t each = (size_t)m->places + 1 + PAGE_SCRATCH(points);
    size_t sizes[] = {frames, frames * sites * PAGE_ROWS(points), frames,
                      frames * sites * (size_t)m->slots, sites * each};
    double **parts[] = {&midpoint, &fields, times, states, places};
    size_t sum = 0;
    for (int k = 0; k < 5; k++) sum += sizes[k];
    free(memory);
    memory = calloc(sum + bytes / sizeof(double) + 1, sizeof(double));
    workspace = (softcat_workspace){memory ? memory + sum : NULL, bytes};
    double *at = memory;
    for (int k = 0; k < 5; at += memory ? sizes[k] : 0, k++) *parts[k] = at;
    return memory != NULL;
}

static int finish(const softcat_status *status, int reached, int sites)
{
    const double numbers[STATUS] = {
        status->code, status->reached, (double)status->steps, (double)status->rejected,
        status->worst_site, status->worst_slot, reached, sites};
    memcpy(known, numbers, sizeof known);
    return status->code;
}

/* Solve at `frames` even times from 0 to `duration`; fibres 0: as the scene; largest_step and
 * max_steps 0: no limit. */
int EXPORTED(page_solve)(int cells, int fibres, int frames, double duration, double grading,
                         double relative, double largest_step, int method, int max_steps)
{
    softcat_sized sized;
    softcat_status status = {.worst_site = -1, .worst_slot = -1};
    int reached = 0, sites = softcat_structure_row(structure, cells) / softcat_axes(structure);
    double *times, *states, *places;
    void *tables;
    const softcat_table table = {start_rows, start, start + start_rows};
    const softcat_settings settings = {
        .fibres = fibres, .grading = grading, .relative = relative, .absolutes = absolute,
        .method = method,
        .largest_step = largest_step > 0.0 ? largest_step : duration, .max_steps = max_steps,
        .start = start ? &table : NULL};
    size_t bytes = softcat_structure_workspace_size(structure, cells, frames, &settings);
    status.code = size(fibres, &sized, &tables);
    if (frames < 2) status.code = SOFTCAT_BAD_TIMES;
    else if (sites == 0) status.code = SOFTCAT_BAD_CELLS;
    else if (!status.code
             && !make_room(&sized, (size_t)frames, (size_t)sites, bytes, &times, &states, &places))
        status.code = SOFTCAT_MEMORY;
    if (status.code) {
        free(tables);
        return finish(&status, 0, 0);
    }
    for (int j = 0; j < frames; j++) {
        times[j] = duration * j / (frames - 1);
        midpoint[j] = NAN;
    }
    const softcat_results results = {.midpoint = midpoint, .states = states};
    softcat_structure_solve(structure, parameters, cells, times, frames, &settings, &results,
                            workspace, &status);
    while (reached < frames && isfinite(midpoint[reached])) reached++;
    if (reached) observe(&sized, cells, sites, grading, reached, times, states, places);
    free(tables);
    return finish(&status, reached, sites);
}
