#include "softcat_solve.h"

#include "softcat_check.h"
#include "softcat_places.h"
#include "softcat_section.h"
#include "softcat_start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS_PER_TIME = 100000 };

/* A run in units of the model, and all memory that it needs, in one piece. */
typedef struct run {
    const softcat_structure *s; /* with the fibres of the run */
    softcat_sized sized;
    const softcat_settings *settings;
    softcat_filament filament;
    softcat_options options;
    softcat_directions directions;
    double scale, length;   /* time scale [s], rest length [m] */
    int count, skip;        /* times of the integration; 1 if its first, t = 0, is not asked for */
    size_t size;            /* unknowns */
    double *memory;
    double *params, *X, *places, *state, *spare, *times, *kinks, *absolute, *states, *work;
    double *steps, *shifts, *moves; /* directions */
    double *changes;
} run;

/* Cut the memory into arrays; with memory == NULL only count. */
static size_t cut(run *r, int derivatives, int works)
{
    const softcat_model *m = r->s->model;
    size_t sites = (size_t)r->filament.sites, rows = (size_t)r->count, at = 0;
    size_t by = derivatives ? (size_t)r->settings->by_count : 0;
    size_t kinks = (size_t)(r->settings->kink_count + r->s->motion_rows + r->s->turn_rows);
    struct { double **to; size_t size; } parts[] = {
        {&r->params, (size_t)m->parameters}, {&r->X, sites},
        {&r->places, sites * (size_t)m->places},
        {&r->state, r->size}, {&r->spare, r->size}, {&r->times, rows}, {&r->kinks, kinks},
        {&r->absolute, (size_t)m->slots}, {&r->states, rows * r->size},
        {&r->work, works ? rows * (size_t)m->powers : 0}, {&r->steps, by},
        {&r->shifts, by * (size_t)m->parameters}, {&r->moves, by * r->size},
        {&r->changes, by * rows * r->size},
    };
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        *parts[i].to = r->memory ? r->memory + at : NULL;
        at += parts[i].size;
    }
    return at;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Times at which a support changes pace, and those of the caller: positive, in order, once each. */
static void gather_kinks(run *r)
{
    int count = 0, kept = 0;
    for (int row = 0; row < r->s->motion_rows; row++)
        r->kinks[count++] = r->params[r->s->motion + r->s->motion_width * row] / r->scale;
    for (int row = 0; row < r->s->turn_rows; row++)
        r->kinks[count++] = r->params[r->s->turn + 2 * row] / r->scale;
    for (int i = 0; i < r->settings->kink_count; i++)
        r->kinks[count++] = r->settings->kinks[i] / r->scale;
    if (count) qsort(r->kinks, (size_t)count, sizeof(double), compare);
    for (int i = 0; i < count; i++)
        if (r->kinks[i] > 0.0 && (kept == 0 || r->kinks[i] > r->kinks[kept - 1]))
            r->kinks[kept++] = r->kinks[i];
    r->options.kinks = r->kinks;
    r->options.kink_count = kept;
}

static void set_options(run *r, int n, int works)
{
    const softcat_model *m = r->s->model;
    int speed = m->rate[r->s->y], inertia = speed >= 0 && m->differential[speed];
    const softcat_settings *c = r->settings;
    double of_scene = c->absolute > 0.0 ? c->absolute / r->s->absolute : 1.0;
    for (int k = 0; k < m->slots; k++)
        r->absolute[k] = c->absolutes ? c->absolutes[k] : of_scene * r->s->absolutes[k];
    r->options.relative = c->relative > 0.0 ? c->relative : r->s->relative;
    r->options.absolute = r->absolute;
    if (works && !inertia) /* nothing else limits the steps */
        r->options.work_absolute = r->absolute[r->s->y];
    r->options.largest_step =
        (c->largest_step > 0.0 ? c->largest_step : r->s->largest_step) / r->scale;
    r->options.max_steps = c->max_steps > 0 ? c->max_steps : (long)STEPS_PER_TIME * n;
    r->options.method = c->method ? c->method : r->s->method;
    r->options.stop = c->stop;
    gather_kinks(r);
}

static int begin(run *r, int cells, softcat_status *status)
{
    const softcat_settings *c = r->settings;
    const double *thickness = c->thickness ? c->thickness : r->s->thickness;
    int count = c->thickness ? c->thickness_count : r->s->thickness_count, code;
    double grading = c->grading > 0.0 ? c->grading : r->s->grading;
    softcat_nodes(r->s, cells, grading, r->X);
    for (int i = 1; i < r->filament.sites; i++)
        if (!(r->X[i] > r->X[i - 1])) return SOFTCAT_BAD_SETTINGS; /* the grading is too steep */
    softcat_places(r->s, cells, r->X, thickness, count, r->places);
    r->filament.parameters = r->params;
    r->filament.places = r->places;
    r->filament.fibres = r->s->points;
    r->filament.points = r->sized.points;
    if (c->start) {
        softcat_straight(r->s, r->params, r->filament.sites, r->X, r->state);
        code = softcat_from_table(r->s, r->params, c->start, r->filament.sites, r->X, r->state);
        if (code) return code;
    } else {
        if (!softcat_is_straight(r->s, r->params, r->s->profiled)) return SOFTCAT_NOT_STRAIGHT;
        softcat_straight(r->s, r->params, r->filament.sites, r->X, r->state);
    }
    return softcat_settle(r->s, &r->filament, &r->options, r->X, r->state, r->spare, status);
}

/* Where the directions of the derivatives lead: parameters, and what begins where they say. */
static int point(run *r)
{
    const softcat_settings *c = r->settings;
    size_t parameters = (size_t)r->s->model->parameters;
    for (int d = 0; d < c->by_count; d++) {
        int k = c->by[d];
        double *move = r->moves + (size_t)d * r->size, value = r->params[k];
        double step = c->by_step ? c->by_step[d] : 1e-5 * fabs(value);
        if (!(step > 0.0)) return SOFTCAT_BAD_SETTINGS;
        r->steps[d] = step;
        r->shifts[(size_t)d * parameters + (size_t)k] = 1.0;
        if (c->start) continue;
        r->params[k] = value + step;
        softcat_straight(r->s, r->params, r->filament.sites, r->X, move);
        r->params[k] = value - step;
        softcat_straight(r->s, r->params, r->filament.sites, r->X, r->spare);
        r->params[k] = value;
        for (size_t i = 0; i < r->size; i++) {
            int moving = r->s->model->differential[i % (size_t)r->s->model->slots];
            move[i] = moving ? (move[i] - r->spare[i]) / (2.0 * step) : 0.0;
        }
    }
    r->directions = (softcat_directions){
        .count = c->by_count, .two_sided = 1, .size = r->steps, .parameters = r->shifts,
        .state = r->moves, .states = r->changes};
    return SOFTCAT_SOLVED;
}

/* Position [rest lengths] of a node; of one that is held, where its support is. */
static void node(const run *r, const double *state, int i, softcat_supports at, double *place)
{
    const softcat_structure *s = r->s;
    int slots = s->model->slots, last = r->filament.sites - 1;
    const double *site = state + (size_t)i * (size_t)slots;
    int left = i == 0, right = i == last;
    int held_y = (left && s->model->held_first[s->y]) || (right && s->model->held_last[s->y]);
    int held_x = s->x >= 0
                 && ((left && s->model->held_first[s->x]) || (right && s->model->held_last[s->x]));
    place[1] = held_y ? (right ? at.right_y : 0.0) : site[s->y];
    if (s->z >= 0) place[2] = held_y ? (right ? at.right_z : 0.0) : site[s->z];
    if (s->x < 0) {
        int from_left = s->first == SOFTCAT_CLAMPED || s->first == SOFTCAT_PINNED;
        place[0] = r->X[i] + (from_left ? at.left_x + 0.5 : at.right_x - 0.5);
    } else if (held_x) {
        place[0] = right ? at.right_x : s->first == SOFTCAT_SYMMETRY ? 0.0 : at.left_x;
    } else {
        place[0] = site[s->x];
    }
}

/* d/dp of positions [m] at one time: those of nodes through the model, of supports directly. */
static void differentiate(run *r, int d, double seconds, const double *state, const double *change,
                          double *to)
{
    int k = r->settings->by[d];
    double value = r->params[k], step = r->steps[d];
    double grows = k == r->s->rest_length ? 1.0 : 0.0; /* d length / dp */
    softcat_supports at = softcat_supports_at(r->s, r->params, seconds), up, down;
    r->params[k] = value + step;
    up = softcat_supports_at(r->s, r->params, seconds);
    r->params[k] = value - step;
    down = softcat_supports_at(r->s, r->params, seconds);
    r->params[k] = value;
    softcat_supports slope = {(up.left_x - down.left_x) / (2.0 * step),
                              (up.right_x - down.right_x) / (2.0 * step),
                              (up.right_y - down.right_y) / (2.0 * step),
                              (up.right_z - down.right_z) / (2.0 * step)};
    int axes = softcat_axes(r->s);
    for (int i = 0; i < r->filament.sites; i++) {
        double place[3], moved[3];
        node(r, state, i, at, place);
        node(r, change, i, slope, moved);
        if (r->s->x < 0) /* the place of such a node moves with its support only */
            moved[0] = r->s->first == SOFTCAT_SYMMETRY || r->s->first == SOFTCAT_FREE ? slope.right_x
                                                                               : slope.left_x;
        for (int k = 0; k < axes; k++)
            to[axes * i + k] = r->length * moved[k] + grows * place[k];
    }
}

static void blank(double *row, size_t count)
{
    for (size_t i = 0; row && i < count; i++) row[i] = NAN;
}

/* Write time j of n, which is row j + skip of the integration. */
static void write_row(run *r, const softcat_results *to, int j, int n, double seconds, int middle)
{
    const softcat_model *m = r->s->model;
    int axes = softcat_axes(r->s);
    size_t row = (size_t)(j + r->skip), width = (size_t)(axes * r->filament.sites);
    const double *state = r->states + row * r->size;
    softcat_supports at = softcat_supports_at(r->s, r->params, seconds);
    double unit = 0.0, place[3];
    for (int i = 0; i < r->filament.sites && to->positions; i++) {
        double *position = to->positions + (size_t)j * width + (size_t)(axes * i);
        node(r, state, i, at, place);
        for (int k = 0; k < axes; k++) position[k] = r->length * place[k];
    }
    node(r, state, middle, at, place);
    if (to->midpoint) to->midpoint[j] = r->length * place[1];
    if (to->states) memcpy(to->states + (size_t)j * r->size, state, r->size * sizeof(double));
    if (to->work && m->powers) {
        if (r->s->density >= 0) unit = r->params[r->s->density];
        unit *= r->length * pow(r->length / r->scale, 2.0);
        for (int k = 0; k < m->powers; k++)
            to->work[j * m->powers + k] = unit * r->work[(int)row * m->powers + k];
    }
    for (int d = 0; d < r->settings->by_count && to->derivatives; d++) {
        const double *change = r->changes + ((size_t)d * (size_t)r->count + row) * r->size;
        double *derivative = to->derivatives + ((size_t)d * (size_t)n + (size_t)j) * width;
        differentiate(r, d, seconds, state, change, derivative);
    }
}

static void write_all(run *r, const softcat_results *to, const double *times, int n, int reached,
                      int middle)
{
    size_t width = (size_t)(softcat_axes(r->s) * r->filament.sites);
    size_t powers = (size_t)r->s->model->powers;
    for (int j = 0; j < n; j++) {
        if (j + r->skip < reached) {
            write_row(r, to, j, n, times[j], middle);
            continue;
        }
        blank(to->positions ? to->positions + (size_t)j * width : NULL, width);
        blank(to->midpoint ? to->midpoint + j : NULL, 1);
        blank(to->states ? to->states + (size_t)j * r->size : NULL, r->size);
        blank(to->work ? to->work + (size_t)j * powers : NULL, powers);
        for (int d = 0; d < r->settings->by_count && to->derivatives; d++)
            blank(to->derivatives + ((size_t)d * (size_t)n + (size_t)j) * width, width);
    }
}

/* From units of the model to s and m. */
static void scale_turns(const run *r, softcat_turns *turns)
{
    const double units[] = {r->scale, r->length, r->scale * r->length};
    for (int i = 0; i < 3 * (turns->count + 1); i++) turns->rows[i] *= units[i % 3];
}

/* Integrate what was checked and has its memory; *reached: rows that were. */
static int integrate(run *r, const double *params, int cells, const double *times, int n,
                     const softcat_results *to, softcat_status *status, int *reached)
{
    memcpy(r->params, params, (size_t)r->s->model->parameters * sizeof(double));
    r->params[r->s->time_scale] = r->scale;
    set_options(r, n, to->work != NULL);
    int code = begin(r, cells, status), derived = to->derivatives && r->settings->by_count;
    if (!code && derived) code = point(r);
    if (code) return code;
    for (int j = 0; j < n; j++) r->times[j + r->skip] = times[j] / r->scale;
    r->options.turns = to->turns;
    if (to->turns) {
        to->turns->site = softcat_middle(r->s, cells);
        to->turns->slot = r->s->y;
    }
    code = softcat_sensitivities(r->s->model, &r->filament, &r->options, r->state, r->times,
                                 r->count, r->states, to->work ? r->work : NULL,
                                 derived ? &r->directions : NULL, status);
    if (to->turns) scale_turns(r, to->turns);
    /* What fails before the first step may have left no row at all. */
    if (code && status->steps == 0) return code;
    while (*reached < r->count && r->times[*reached] <= status->reached) ++*reached;
    return code;
}

int softcat_structure_solve(const softcat_structure *s, const double *params, int cells,
                            const double *times, int n, const softcat_settings *settings,
                            const softcat_results *results, softcat_status *status)
{
    static const softcat_settings plain;
    softcat_status unasked;
    run r = {.settings = settings ? settings : &plain};
    int reached = 0, which = -1;
    if (!status) status = &unasked;
    memset(status, 0, sizeof *status);
    status->worst_site = -1;
    status->code = softcat_check(s, params, cells, times, n, r.settings, &which);
    if (!status->code && !results) status->code = SOFTCAT_ARGUMENT;
    status->worst_slot = which;
    if (!status->code) status->code = softcat_size(s, params, r.settings->fibres, &r.sized);
    if (status->code) {
        softcat_unsize(&r.sized);
        return status->code;
    }
    r.s = &r.sized.structure;
    r.length = params[s->rest_length];
    r.scale = params[s->time_scale];
    if (r.scale == 0.0) r.scale = sqrt(r.length / params[s->gravity]);
    r.skip = times[0] > 0.0;
    r.filament.sites = softcat_sites(s, cells);
    r.size = (size_t)r.filament.sites * (size_t)r.s->model->slots;
    r.count = n + r.skip;
    r.memory = calloc(cut(&r, results->derivatives != NULL, results->work != NULL) + 1,
                      sizeof(double));
    if (!r.memory) {
        status->code = SOFTCAT_MEMORY;
    } else {
        cut(&r, results->derivatives != NULL, results->work != NULL);
        status->code = integrate(&r, params, cells, times, n, results, status, &reached);
        status->reached *= r.scale;
        status->worst_slot = softcat_slot_of_scene(s, &r.sized, status->worst_slot);
        write_all(&r, results, times, n, reached, softcat_middle(s, cells));
    }
    free(r.memory);
    softcat_unsize(&r.sized);
    return status->code;
}
