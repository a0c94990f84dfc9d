#include "softcat_solve.h"

#include "softcat_check.h"
#include "softcat_places.h"
#include "softcat_problem.h"
#include "softcat_run.h"

#include <math.h>
#include <string.h>

enum { STEPS_PER_TIME = 100000 };

/* A problem that is solved at given times. */
typedef struct run {
    softcat_problem p;
    softcat_directions directions;
    int count, skip;        /* times of the integration; 1 if its first, t = 0, is not asked for */
    double *times, *states, *work;
    double *steps, *shifts, *moves; /* directions */
    double *changes;
} run;

static int take(run *r, const softcat_structure *s, const double *params, int cells, int n,
                const softcat_settings *settings, softcat_memory *memory)
{
    int code = softcat_problem_take(&r->p, s, params, cells, settings, memory);
    if (code) return code;
    size_t rows = (size_t)n + 1, by = (size_t)r->p.settings.by_count;
    size_t parameters = (size_t)s->model->parameters;
    r->times = softcat_take_doubles(memory, rows);
    r->states = softcat_take_doubles(memory, rows * r->p.size);
    r->work = softcat_take_doubles(memory, rows * (size_t)s->model->powers);
    r->steps = softcat_take_doubles(memory, by);
    r->shifts = softcat_take_doubles(memory, by * parameters);
    r->moves = softcat_take_doubles(memory, by * r->p.size);
    r->changes = softcat_take_doubles(memory, by * rows * r->p.size);
    return softcat_fits(memory) || !memory->base ? SOFTCAT_SOLVED : SOFTCAT_MEMORY;
}

size_t softcat_structure_workspace_size(const softcat_structure *s, int cells, int n,
                                        const softcat_settings *settings)
{
    static const double one = 1.0;
    softcat_memory memory = {NULL, 0, 0};
    run r = {.skip = 0};
    if (!softcat_structure_row(s, cells) || n < 1) return 0;
    if (take(&r, s, NULL, cells, n, settings, &memory)) return 0;
    const softcat_directions by = {
        .count = r.p.settings.by_count, .two_sided = 1, .parameters = &one, .state = &one};
    const softcat_view view = softcat_view_of(s, &r.p.sized);
    softcat_run begun = {.model = r.p.s->model, .options = &r.p.options};
    int code = softcat_run_new(&begun, &r.p.filament, by.count > 0 ? &by : NULL, &view, &memory);
    return code ? 0 : softcat_bytes(&memory);
}

/* Where the directions of the derivatives lead: parameters, and what begins where they say. */
static int point(run *r)
{
    const softcat_settings *c = &r->p.settings;
    size_t parameters = (size_t)r->p.s->model->parameters;
    for (int d = 0; d < c->by_count; d++) {
        int k = c->by[d];
        double *move = r->moves + (size_t)d * r->p.size, value = r->p.params[k];
        double step = c->by_step ? c->by_step[d] : 1e-5 * fabs(value);
        if (!(step > 0.0)) return SOFTCAT_BAD_SETTINGS;
        r->steps[d] = step;
        r->shifts[(size_t)d * parameters + (size_t)k] = 1.0;
        if (c->start) continue;
        r->p.params[k] = value + step;
        softcat_straight(r->p.s, r->p.params, r->p.filament.sites, r->p.X, move);
        r->p.params[k] = value - step;
        softcat_straight(r->p.s, r->p.params, r->p.filament.sites, r->p.X, r->p.spare);
        r->p.params[k] = value;
        for (size_t i = 0; i < r->p.size; i++) {
            int moving = r->p.s->model->differential[i % (size_t)r->p.s->model->slots];
            move[i] = moving ? (move[i] - r->p.spare[i]) / (2.0 * step) : 0.0;
        }
    }
    r->directions = (softcat_directions){
        .count = c->by_count, .two_sided = 1, .size = r->steps, .parameters = r->shifts,
        .state = r->moves, .states = r->changes};
    return SOFTCAT_SOLVED;
}

/* d/dp of positions [m] at one time: those of nodes through the model, of supports directly. */
static void differentiate(run *r, int d, double seconds, const double *state, const double *change,
                          double *to)
{
    int k = r->p.settings.by[d];
    double value = r->p.params[k], step = r->steps[d];
    double grows = k == r->p.s->rest_length ? 1.0 : 0.0; /* d length / dp */
    softcat_supports at = softcat_supports_at(r->p.s, r->p.params, seconds), up, down;
    r->p.params[k] = value + step;
    up = softcat_supports_at(r->p.s, r->p.params, seconds);
    r->p.params[k] = value - step;
    down = softcat_supports_at(r->p.s, r->p.params, seconds);
    r->p.params[k] = value;
    softcat_supports slope = {(up.left_x - down.left_x) / (2.0 * step),
                              (up.right_x - down.right_x) / (2.0 * step),
                              (up.right_y - down.right_y) / (2.0 * step),
                              (up.right_z - down.right_z) / (2.0 * step)};
    int axes = softcat_axes(r->p.s);
    for (int i = 0; i < r->p.filament.sites; i++) {
        double place[3], moved[3];
        softcat_problem_node(&r->p, state, i, at, place);
        softcat_problem_node(&r->p, change, i, slope, moved);
        if (r->p.s->x < 0) /* the place of such a node moves with its support only */
            moved[0] = r->p.s->first == SOFTCAT_SYMMETRY || r->p.s->first == SOFTCAT_FREE ? slope.right_x
                                                                               : slope.left_x;
        for (int axis = 0; axis < axes; axis++)
            to[axes * i + axis] = r->p.length * moved[axis] + grows * place[axis];
    }
}

static void blank(double *row, size_t count)
{
    for (size_t i = 0; row && i < count; i++) row[i] = NAN;
}

/* Write time j of n, which is row j + skip of the integration. */
static void write_row(run *r, const softcat_results *to, int j, int n, double seconds, int middle)
{
    const softcat_model *m = r->p.s->model;
    int axes = softcat_axes(r->p.s);
    size_t row = (size_t)(j + r->skip), width = (size_t)(axes * r->p.filament.sites);
    const double *state = r->states + row * r->p.size;
    softcat_supports at = softcat_supports_at(r->p.s, r->p.params, seconds);
    double place[3];
    for (int i = 0; i < r->p.filament.sites && to->positions; i++) {
        double *position = to->positions + (size_t)j * width + (size_t)(axes * i);
        softcat_problem_node(&r->p, state, i, at, place);
        for (int k = 0; k < axes; k++) position[k] = r->p.length * place[k];
    }
    softcat_problem_node(&r->p, state, middle, at, place);
    if (to->midpoint) to->midpoint[j] = r->p.length * place[1];
    if (to->states) memcpy(to->states + (size_t)j * r->p.size, state, r->p.size * sizeof(double));
    if (to->work && m->powers) {
        double unit = softcat_problem_work(&r->p);
        for (int k = 0; k < m->powers; k++)
            to->work[j * m->powers + k] = unit * r->work[(int)row * m->powers + k];
    }
    for (int d = 0; d < r->p.settings.by_count && to->derivatives; d++) {
        const double *change = r->changes + ((size_t)d * (size_t)r->count + row) * r->p.size;
        double *derivative = to->derivatives + ((size_t)d * (size_t)n + (size_t)j) * width;
        differentiate(r, d, seconds, state, change, derivative);
    }
}

static void write_all(run *r, const softcat_results *to, const double *times, int n, int reached,
                      int middle)
{
    size_t width = (size_t)(softcat_axes(r->p.s) * r->p.filament.sites);
    size_t powers = (size_t)r->p.s->model->powers;
    for (int j = 0; j < n; j++) {
        if (j + r->skip < reached) {
            write_row(r, to, j, n, times[j], middle);
            continue;
        }
        blank(to->positions ? to->positions + (size_t)j * width : NULL, width);
        blank(to->midpoint ? to->midpoint + j : NULL, 1);
        blank(to->states ? to->states + (size_t)j * r->p.size : NULL, r->p.size);
        blank(to->work ? to->work + (size_t)j * powers : NULL, powers);
        for (int d = 0; d < r->p.settings.by_count && to->derivatives; d++)
            blank(to->derivatives + ((size_t)d * (size_t)n + (size_t)j) * width, width);
    }
}

/* From units of the model to s and m. */
static void scale_turns(const run *r, softcat_turns *turns)
{
    const double units[] = {r->p.scale, r->p.length, r->p.scale * r->p.length};
    for (int i = 0; i < 3 * (turns->count + 1); i++) turns->rows[i] *= units[i % 3];
}

/* Integrate what was checked and has its memory; *reached: rows that were. */
static int integrate(run *r, const double *params, const double *times, int n,
                     const softcat_results *to, softcat_workspace room, softcat_status *status,
                     int *reached)
{
    softcat_problem *p = &r->p;
    r->skip = times[0] > 0.0;
    r->count = n + r->skip;
    int code = softcat_problem_begin(p, params, room, status);
    int derived = to->derivatives && p->settings.by_count;
    if (!code && derived) code = point(r);
    if (code) return code;
    if (!p->options.max_steps) p->options.max_steps = (long)STEPS_PER_TIME * n;
    for (int j = 0; j < n; j++) r->times[j + r->skip] = times[j] / p->scale;
    int works = to->work || p->options.work_absolute > 0.0;
    p->options.turns = to->turns;
    if (to->turns) {
        to->turns->site = softcat_middle(p->s, p->cells);
        to->turns->slot = p->s->y;
    }
    code = softcat_sensitivities(p->s->model, &p->filament, &p->options, p->state, r->times,
                                 r->count, r->states, works ? r->work : NULL,
                                 derived ? &r->directions : NULL, room, status);
    if (to->turns) scale_turns(r, to->turns);
    /* What fails before the first step may have left no row at all. */
    if (code && status->steps == 0) return code;
    while (*reached < r->count && r->times[*reached] <= status->reached) ++*reached;
    return code;
}

int softcat_structure_solve(const softcat_structure *s, const double *params, int cells,
                            const double *times, int n, const softcat_settings *settings,
                            const softcat_results *results, softcat_workspace workspace,
                            softcat_status *status)
{
    softcat_status unasked;
    softcat_memory memory = softcat_memory_of(workspace);
    run r;
    int reached = 0, which = -1;
    if (!status) status = &unasked;
    memset(status, 0, sizeof *status);
    status->worst_site = -1;
    status->code = softcat_check(s, params, cells, times, n, settings, &which);
    if (!status->code && !results) status->code = SOFTCAT_ARGUMENT;
    status->worst_slot = which;
    if (!status->code && !memory.base) status->code = SOFTCAT_MEMORY;
    if (!status->code) status->code = take(&r, s, params, cells, n, settings, &memory);
    if (status->code) return status->code;
    const softcat_workspace room = {memory.base + memory.used, memory.size - memory.used};
    status->code = integrate(&r, params, times, n, results, room, status, &reached);
    status->reached *= r.p.scale;
    status->worst_slot = softcat_slot_of_scene(s, &r.p.sized, status->worst_slot);
    write_all(&r, results, times, n, reached, softcat_middle(s, cells));
    return status->code;
}
