#include "softcat_run.h"

#include <stdlib.h>
#include <string.h>

/* to = from + shift * direction, where there is a direction; `from` itself otherwise. */
static const double *moved(double **memory, const double *from, const double *direction,
                           double shift, size_t size)
{
    if (!direction) return from;
    double *to = *memory;
    *memory += size;
    for (size_t i = 0; i < size; i++) to[i] = from[i] + shift * direction[i];
    return to;
}

static void place_copies(softcat_run *r, const softcat_filament *filament, const double *state,
                         const softcat_directions *directions)
{
    size_t size = r->step.size, powers = (size_t)r->model->powers;
    size_t parameters = (size_t)r->model->parameters;
    size_t places = (size_t)filament->sites * (size_t)r->model->places;
    double *memory = r->memory;
    for (int c = 0; c < r->copy_count; c++) {
        softcat_copy *copy = r->copies + c;
        copy->filament = *filament;
        copy->direction = -1;
        copy->state = memory;
        copy->work = memory + size;
        memory += size + powers;
        memcpy(copy->state, state, size * sizeof(double));
        if (c == 0) continue;
        int d = directions->two_sided ? (c - 1) / 2 : c - 1;
        double shift = directions->two_sided && c % 2 ? -directions->size[d] : directions->size[d];
        copy->direction = d;
        copy->share = (directions->two_sided ? 0.5 : 1.0) / shift;
        size_t n = (size_t)d;
        const double *by = directions->parameters, *at = directions->places;
        copy->filament.parameters = moved(&memory, filament->parameters,
                                          by ? by + n * parameters : NULL, shift, parameters);
        copy->filament.places =
            moved(&memory, filament->places, at ? at + n * places : NULL, shift, places);
        for (size_t i = 0; i < size && directions->state; i++)
            copy->state[i] += shift * directions->state[n * size + i];
    }
    r->outputs.powers = memory;
}

int softcat_copies_new(softcat_run *r, const softcat_filament *filament, const double *state,
                   const softcat_directions *directions)
{
    int code = softcat_step_new(&r->step, r->model, softcat_method_of(r->options->method),
                                filament->sites);
    if (code) return code;
    /* Work that nobody reads is not integrated. */
    if (!r->outputs.work && !(directions && directions->work)) r->step.powers = 0;
    r->copy_count = 1;
    if (directions) r->copy_count += directions->count * (directions->two_sided ? 2 : 1);
    size_t each = r->step.size + (size_t)(r->model->powers + r->model->parameters)
                  + (size_t)filament->sites * (size_t)r->model->places;
    size_t copies = (size_t)r->copy_count;
    r->copies = calloc(copies, sizeof(softcat_copy));
    r->memory = calloc(copies * each + (size_t)r->model->powers + 1, sizeof(double));
    if (!r->copies || !r->memory) return SOFTCAT_MEMORY;
    place_copies(r, filament, state, directions);
    return SOFTCAT_SOLVED;
}

void softcat_copies_free(softcat_run *r)
{
    softcat_step_free(&r->step);
    free(r->copies);
    free(r->memory);
}

/* Algebraic unknowns of the moved copies: two corrections from those of the run leave nothing. */
int softcat_copies_correct(softcat_run *r, double start)
{
    for (int c = 1; c < r->copy_count && r->step.algebraic; c++)
        for (int pass = 0; pass < 2; pass++) {
            softcat_copy *copy = r->copies + c;
            double h = 1e-3 * (r->last - r->t);
            int code = softcat_step_begin(&r->step, &copy->filament, start, h, copy->state);
            if (!code) code = softcat_step_correction(&r->step, 1);
            if (code) return code;
            for (size_t i = 0; i < r->step.size; i++) copy->state[i] += r->step.stages[0][i];
        }
    return SOFTCAT_SOLVED;
}

/* The moved copies take the step that the run has taken, whatever their own error. */
int softcat_copies_follow(softcat_run *r, double h, double start, double inner_end, double end)
{
    for (int c = 1; c < r->copy_count; c++) {
        softcat_copy *copy = r->copies + c;
        int code = softcat_step_begin(&r->step, &copy->filament, start, h, copy->state);
        if (!code)
            code = softcat_step_take(&r->step, &copy->filament, start, h, inner_end, copy->state);
        if (code) return code;
        softcat_outputs_step(&r->outputs, &r->step, copy, r->t, end);
        memcpy(copy->state, r->step.next, r->step.size * sizeof(double));
    }
    return SOFTCAT_SOLVED;
}
