#include "softcat_problem.h"

#include "softcat_places.h"

#include <math.h>
#include <string.h>

int softcat_problem_take(softcat_problem *r, const softcat_structure *s, const double *params,
                         int cells, const softcat_settings *settings, softcat_memory *memory)
{
    static const softcat_settings plain;
    *r = (softcat_problem){.settings = settings ? *settings : plain, .cells = cells};
    int code = softcat_size(s, params, r->settings.fibres, memory, &r->sized);
    if (code) return code;
    r->sized.structure.model = &r->sized.model;
    r->s = &r->sized.structure;
    const softcat_model *m = r->s->model;
    size_t sites = (size_t)softcat_sites(s, cells);
    r->filament.sites = (int)sites;
    r->size = sites * (size_t)m->slots;
    r->params = softcat_take_doubles(memory, (size_t)m->parameters);
    r->X = softcat_take_doubles(memory, sites);
    r->places = softcat_take_doubles(memory, sites * (size_t)m->places);
    r->state = softcat_take_doubles(memory, r->size);
    r->spare = softcat_take_doubles(memory, r->size);
    r->kinks = softcat_take_doubles(
        memory, (size_t)(r->settings.kink_count + s->motion_rows + s->turn_rows));
    r->absolute = softcat_take_doubles(memory, (size_t)m->slots);
    return softcat_fits(memory) || !memory->base ? SOFTCAT_SOLVED : SOFTCAT_MEMORY;
}

void softcat_problem_kinks(softcat_problem *r)
{
    int count = 0, kept = 0;
    for (int row = 0; row < r->s->motion_rows; row++)
        r->kinks[count++] = r->params[r->s->motion + r->s->motion_width * row] / r->scale;
    for (int row = 0; row < r->s->turn_rows; row++)
        r->kinks[count++] = r->params[r->s->turn + 2 * row] / r->scale;
    for (int i = 0; i < r->settings.kink_count; i++)
        r->kinks[count++] = r->settings.kinks[i] / r->scale;
    for (int i = 1; i < count; i++) {
        double time = r->kinks[i];
        int j = i;
        for (; j > 0 && r->kinks[j - 1] > time; j--) r->kinks[j] = r->kinks[j - 1];
        r->kinks[j] = time;
    }
    for (int i = 0; i < count; i++)
        if (r->kinks[i] > 0.0 && (kept == 0 || r->kinks[i] > r->kinks[kept - 1]))
            r->kinks[kept++] = r->kinks[i];
    r->options.kinks = r->kinks;
    r->options.kink_count = kept;
}

static void set_options(softcat_problem *r)
{
    const softcat_model *m = r->s->model;
    int speed = m->rate[r->s->y], inertia = speed >= 0 && m->differential[speed];
    const softcat_settings *c = &r->settings;
    double of_scene = c->absolute > 0.0 ? c->absolute / r->s->absolute : 1.0;
    for (int k = 0; k < m->slots; k++)
        r->absolute[k] = c->absolutes ? c->absolutes[k] : of_scene * r->s->absolutes[k];
    r->options.relative = c->relative > 0.0 ? c->relative : r->s->relative;
    r->options.absolute = r->absolute;
    if (m->powers > 0 && !inertia) /* nothing else limits the steps */
        r->options.work_absolute = r->absolute[r->s->y];
    r->options.largest_step =
        (c->largest_step > 0.0 ? c->largest_step : r->s->largest_step) / r->scale;
    r->options.max_steps = c->max_steps;
    r->options.method = c->method ? c->method : r->s->method;
    r->options.stop = c->stop;
    softcat_problem_kinks(r);
}

int softcat_problem_begin(softcat_problem *r, const double *params,
                          softcat_workspace workspace, softcat_status *status)
{
    const softcat_settings *c = &r->settings;
    const double *thickness = c->thickness ? c->thickness : r->s->thickness;
    int count = c->thickness ? c->thickness_count : r->s->thickness_count, code;
    double grading = c->grading > 0.0 ? c->grading : r->s->grading;
    memcpy(r->params, params, (size_t)r->s->model->parameters * sizeof(double));
    r->length = params[r->s->rest_length];
    r->scale = params[r->s->time_scale];
    if (r->scale == 0.0) r->scale = sqrt(r->length / params[r->s->gravity]);
    r->params[r->s->time_scale] = r->scale;
    set_options(r);
    softcat_nodes(r->s, r->cells, grading, r->X);
    for (int i = 1; i < r->filament.sites; i++)
        if (!(r->X[i] > r->X[i - 1])) return SOFTCAT_BAD_SETTINGS; /* the grading is too steep */
    softcat_places(r->s, r->cells, r->X, thickness, count, r->places);
    r->filament.parameters = r->params;
    r->filament.places = r->places;
    r->filament.fibres = r->s->points;
    r->filament.points = r->sized.points;
    if (!c->start && !softcat_is_straight(r->s, r->params, r->s->profiled))
        return SOFTCAT_NOT_STRAIGHT;
    softcat_straight(r->s, r->params, r->filament.sites, r->X, r->state);
    if (c->start) {
        code = softcat_from_table(r->s, r->params, c->start, r->filament.sites, r->X, r->state);
        if (code) return code;
    }
    return softcat_settle(r->s, &r->filament, &r->options, r->X, r->state, r->spare, workspace,
                          status);
}

void softcat_problem_node(const softcat_problem *r, const double *state, int i, softcat_supports at,
                          double *place)
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

double softcat_problem_work(const softcat_problem *r)
{
    double density = r->s->density >= 0 ? r->params[r->s->density] : 0.0;
    return density * r->length * pow(r->length / r->scale, 2.0);
}
