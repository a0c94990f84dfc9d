#include "softcat_run.h"

#include <string.h>

/* to = from + shift * direction, where there is a direction; `from` itself otherwise. */
static const double *moved(double *to, const double *from, const double *direction, double shift,
                           size_t size)
{
    if (!direction) return from;
    for (size_t i = 0; i < size; i++) to[i] = from[i] + shift * direction[i];
    return to;
}

static size_t number_of_places(const softcat_run *r, const softcat_filament *filament)
{
    return (size_t)filament->sites * (size_t)r->model->places;
}

void softcat_copies_place(softcat_run *r, const softcat_filament *filament, const double *state,
                          const softcat_directions *directions)
{
    size_t size = r->step.size, places = number_of_places(r, filament);
    size_t parameters = (size_t)r->model->parameters;
    for (int c = 0; c < r->copy_count; c++) {
        softcat_copy *copy = r->copies + c;
        copy->filament = *filament;
        copy->direction = -1;
        memcpy(copy->state, state, size * sizeof(double));
        memset(copy->work, 0, (size_t)r->model->powers * sizeof(double));
        if (c == 0) continue;
        int d = directions->two_sided ? (c - 1) / 2 : c - 1;
        double shift = directions->two_sided && c % 2 ? -directions->size[d] : directions->size[d];
        copy->direction = d;
        copy->share = (directions->two_sided ? 0.5 : 1.0) / shift;
        size_t n = (size_t)d;
        const double *by = directions->parameters, *at = directions->places;
        copy->filament.parameters = moved(copy->parameters, filament->parameters,
                                          by ? by + n * parameters : NULL, shift, parameters);
        copy->filament.places =
            moved(copy->places, filament->places, at ? at + n * places : NULL, shift, places);
        for (size_t i = 0; i < size && directions->state; i++)
            copy->state[i] += shift * directions->state[n * size + i];
    }
}

int softcat_run_new(softcat_run *r, const softcat_filament *filament,
                    const softcat_directions *directions, const softcat_view *view,
                    softcat_memory *memory)
{
    int count = 1;
    int code = softcat_step_new(&r->step, r->model, view, softcat_method_of(r->options->method),
                                filament->sites, memory);
    if (code) return code;
    if (directions) count += directions->count * (directions->two_sided ? 2 : 1);
    r->copy_count = count;
    r->copies = softcat_take(memory, (size_t)count, sizeof(softcat_copy));
    r->outputs.powers = softcat_take_doubles(memory, (size_t)r->model->powers);
    for (int c = 0; c < count; c++) {
        softcat_copy copy = {.state = softcat_take_doubles(memory, r->step.size)};
        copy.work = softcat_take_doubles(memory, (size_t)r->model->powers);
        if (c && directions->parameters)
            copy.parameters = softcat_take_doubles(memory, (size_t)r->model->parameters);
        if (c && directions->places)
            copy.places = softcat_take_doubles(memory, number_of_places(r, filament));
        if (r->copies) r->copies[c] = copy;
    }
    return softcat_fits(memory) || !memory->base ? SOFTCAT_SOLVED : SOFTCAT_MEMORY;
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
