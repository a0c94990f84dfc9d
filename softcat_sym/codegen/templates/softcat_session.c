#include "softcat_session.h"

#include "softcat_check.h"
#include "softcat_places.h"
#include "softcat_problem.h"
#include "softcat_run.h"

#include <math.h>
#include <string.h>

enum { STEPS_A_CALL = 100000, SCALARS = 9 };

/* Of a saved session, so that nothing else is taken for one. */
static const double mark = 65.03;

struct softcat_session {
    softcat_problem p;
    softcat_run run;
    softcat_status status;
    double next;       /* length of the next step */
    double before;     /* where the last step began */
    double now;        /* where the session is, before <= now <= run.t */
    int restart;       /* whether algebraic unknowns are to be made consistent before the next step */
    double *from, *from_work; /* unknowns and work at `before` */
    double *seen, *seen_work; /* those at `now` */
};

static int take(softcat_session *session, const softcat_structure *s, const double *params,
                int cells, const softcat_settings *settings, softcat_view *view,
                softcat_memory *memory)
{
    int code = softcat_problem_take(&session->p, s, params, cells, settings, memory);
    if (code) return code;
    softcat_problem *p = &session->p;
    softcat_run *r = &session->run;
    size_t powers = (size_t)s->model->powers;
    r->model = p->s->model;
    r->options = &p->options;
    r->status = &session->status;
    p->options.method = p->settings.method ? p->settings.method : s->method;
    *view = softcat_view_of(s, &p->sized);
    session->from = softcat_take_doubles(memory, p->size);
    session->from_work = softcat_take_doubles(memory, powers);
    session->seen = softcat_take_doubles(memory, p->size);
    session->seen_work = softcat_take_doubles(memory, powers);
    return softcat_fits(memory) || !memory->base ? SOFTCAT_SOLVED : SOFTCAT_MEMORY;
}

size_t softcat_session_size(const softcat_structure *s, int cells, const softcat_settings *settings)
{
    softcat_memory memory = {NULL, 0, 0};
    softcat_session session = {.now = 0.0};
    softcat_view view;
    softcat_take(&memory, 1, sizeof session);
    if (!softcat_structure_row(s, cells)) return 0;
    if (take(&session, s, NULL, cells, settings, &view, &memory)) return 0;
    int code = softcat_run_new(&session.run, &session.p.filament, NULL, &view, &memory);
    return code ? 0 : softcat_bytes(&memory);
}

/* The state where the session is. */
static void look(softcat_session *session)
{
    const softcat_run *r = &session->run;
    const softcat_step *step = &r->step;
    if (session->now < r->t) {
        double x = (session->now - session->before) / (r->t - session->before);
        softcat_step_between(step, session->from, x, session->seen);
        softcat_step_work(step, session->from_work, x, session->seen_work);
    } else {
        memcpy(session->seen, r->copies->state, step->size * sizeof(double));
        memcpy(session->seen_work, r->copies->work, (size_t)step->powers * sizeof(double));
    }
}

softcat_session *softcat_session_begin(const softcat_structure *s, const double *params, int cells,
                                       const softcat_settings *settings, double last,
                                       softcat_workspace workspace, softcat_status *status)
{
    softcat_memory memory = softcat_memory_of(workspace);
    const double end = last > 0.0 ? last : s->duration;
    int which = -1;
    memset(status, 0, sizeof *status);
    status->worst_site = -1;
    status->code = softcat_check(s, params, cells, &end, 1, settings, &which);
    status->worst_slot = which;
    if (!status->code && !memory.base) status->code = SOFTCAT_MEMORY;
    if (status->code) return NULL;
    softcat_session *session = softcat_take(&memory, 1, sizeof *session);
    softcat_view view;
    status->code =
        session ? take(session, s, params, cells, settings, &view, &memory) : SOFTCAT_MEMORY;
    if (status->code) return NULL;
    softcat_problem *p = &session->p;
    softcat_run *r = &session->run;
    const softcat_workspace rest = {memory.base + memory.used, memory.size - memory.used};
    status->code = softcat_problem_begin(p, params, rest, status);
    if (!status->code) status->code = softcat_run_new(r, &p->filament, NULL, NULL, &memory);
    if (status->code) return NULL;
    softcat_copies_place(r, &p->filament, p->state, NULL);
    r->last = end / p->scale;
    status->code = softcat_run_begin(r, &session->next);
    look(session);
    return status->code ? NULL : session;
}

/* A step of the integrator. */
static int advance(softcat_session *session)
{
    softcat_run *r = &session->run;
    int code = session->restart ? softcat_run_restart(r) : SOFTCAT_SOLVED;
    if (code) return code;
    session->restart = 0;
    double before = r->t;
    memcpy(session->from, r->copies->state, r->step.size * sizeof(double));
    memcpy(session->from_work, r->copies->work, (size_t)r->step.powers * sizeof(double));
    code = softcat_run_advance(r, &session->next);
    if (r->t > before) session->before = before;
    session->restart = r->after_kink;
    return code;
}

int softcat_session_step(softcat_session *session, double time, softcat_status *status)
{
    softcat_run *r = &session->run;
    softcat_status unasked;
    double target = time / session->p.scale;
    int code = SOFTCAT_SOLVED;
    if (!status) status = &unasked;
    memset(&session->status, 0, sizeof session->status);
    session->status.worst_site = session->status.worst_slot = -1;
    long most = session->p.settings.max_steps;
    session->p.options.max_steps = most > 0 ? most : STEPS_A_CALL;
    const double rounding = 1e-12 * session->now; /* of a time in seconds */
    if (!isfinite(time) || target < session->now - rounding) code = SOFTCAT_BAD_TIMES;
    else if (target < session->now) target = session->now;
    if (!code && target > r->last) r->last = 2.0 * target;
    while (!code && r->t < target) code = advance(session);
    if (code != SOFTCAT_BAD_TIMES) {
        session->now = target < r->t ? target : r->t;
        look(session);
    }
    *status = session->status;
    status->code = code;
    status->reached = softcat_session_time(session);
    return code;
}

/* Whether a parameter is a unit of the unknowns, or says when a support changes pace. */
static int is_fixed(const softcat_structure *s, int k)
{
    if (k == s->rest_length || k == s->time_scale) return 1;
    int motion = s->motion >= 0 ? k - s->motion : -1, turn = s->turn >= 0 ? k - s->turn : -1;
    if (motion >= 0 && motion < s->motion_rows * s->motion_width) return motion % s->motion_width == 0;
    return turn >= 0 && turn < 2 * s->turn_rows && turn % 2 == 0;
}

int softcat_session_change(softcat_session *session, const double *params, int *which,
                           softcat_status *status)
{
    softcat_problem *p = &session->p;
    softcat_run *r = &session->run;
    int unasked, changed = 0;
    const double time = softcat_session_time(session);
    if (!which) which = &unasked;
    int code = softcat_check(p->s, params, p->cells, &time, 1, NULL, which);
    if (code) return code;
    for (int k = 0; k < p->s->model->parameters; k++) {
        int same = params[k] == p->params[k] || (k == p->s->time_scale && params[k] == 0.0);
        changed |= !same;
        *which = k;
        if (!same && is_fixed(p->s, k)) return SOFTCAT_BAD_PARAMETER;
    }
    *which = -1;
    if (!changed) return SOFTCAT_SOLVED;
    memcpy(p->params, params, (size_t)p->s->model->parameters * sizeof(double));
    p->params[p->s->time_scale] = p->scale;
    memcpy(r->copies->state, session->seen, p->size * sizeof(double));
    memcpy(r->copies->work, session->seen_work, (size_t)r->step.powers * sizeof(double));
    while (r->kink > 0 && p->options.kinks[r->kink - 1] > session->now) r->kink--;
    r->t = session->before = session->now;
    r->error = 0.0;
    r->after_kink = r->kink > 0 && p->options.kinks[r->kink - 1] == r->t;
    session->restart = 0;
    code = softcat_run_restart(r);
    look(session);
    if (status) *status = session->status;
    return code;
}

double softcat_session_time(const softcat_session *session)
{
    return session->now * session->p.scale;
}

const double *softcat_session_parameters(const softcat_session *session)
{
    return session->p.params;
}

double softcat_session_midpoint(const softcat_session *session)
{
    const softcat_problem *p = &session->p;
    double place[3];
    softcat_supports at = softcat_supports_at(p->s, p->params, softcat_session_time(session));
    softcat_problem_node(p, session->seen, softcat_middle(p->s, p->cells), at, place);
    return p->length * place[1];
}

void softcat_session_positions(const softcat_session *session, double *out)
{
    const softcat_problem *p = &session->p;
    int axes = softcat_axes(p->s);
    double place[3];
    softcat_supports at = softcat_supports_at(p->s, p->params, softcat_session_time(session));
    for (int i = 0; i < p->filament.sites; i++) {
        softcat_problem_node(p, session->seen, i, at, place);
        for (int axis = 0; axis < axes; axis++) *out++ = p->length * place[axis];
    }
}

const double *softcat_session_state(const softcat_session *session, softcat_filament *filament,
                                    double *model_time)
{
    *filament = session->p.filament;
    *model_time = session->now;
    return session->seen;
}

void softcat_session_work(const softcat_session *session, double *out)
{
    double unit = softcat_problem_work(&session->p);
    for (int k = 0; k < session->run.step.powers; k++) out[k] = unit * session->seen_work[k];
}

/* What is saved: pieces of the memory, and how long they are. */
typedef struct piece {
    double *at;
    size_t count;
} piece;

enum { PIECES = 10 };

static size_t pieces_of(const softcat_session *session, piece *pieces)
{
    const softcat_run *r = &session->run;
    const softcat_step *step = &r->step;
    size_t size = step->size, powers = (size_t)step->powers, sum = SCALARS;
    size_t stages = (size_t)step->method->stages;
    const piece all[PIECES] = {
        {session->p.params, (size_t)r->model->parameters},
        {r->copies->state, size}, {r->copies->work, powers},
        {session->from, size}, {session->from_work, powers},
        {session->seen, size}, {session->seen_work, powers},
        {step->next, size}, {step->power_stages, stages * powers}, {step->power_next, powers}};
    memcpy(pieces, all, sizeof all);
    for (int k = 0; k < PIECES; k++) sum += all[k].count;
    return sum + stages * size;
}

size_t softcat_session_count(const softcat_session *session)
{
    piece pieces[PIECES];
    return pieces_of(session, pieces);
}

void softcat_session_save(const softcat_session *session, double *to)
{
    piece pieces[PIECES];
    const softcat_run *r = &session->run;
    const double scalars[SCALARS] = {
        mark, (double)pieces_of(session, pieces), r->t, r->error, r->length,
        session->next, session->before, session->now,
        (double)r->kink + 0.25 * r->after_kink + 0.5 * session->restart};
    memcpy(to, scalars, sizeof scalars);
    to += SCALARS;
    for (int k = 0; k < PIECES; to += pieces[k++].count)
        if (pieces[k].count) memcpy(to, pieces[k].at, pieces[k].count * sizeof(double));
    for (int j = 0; j < r->step.method->stages; j++, to += r->step.size)
        memcpy(to, r->step.stages[j], r->step.size * sizeof(double));
}

int softcat_session_load(softcat_session *session, const double *from, size_t count)
{
    piece pieces[PIECES];
    softcat_run *r = &session->run;
    if (count != pieces_of(session, pieces) || from[0] != mark || from[1] != (double)count)
        return SOFTCAT_ARGUMENT;
    for (size_t i = 2; i < count; i++)
        if (!isfinite(from[i])) return SOFTCAT_ARGUMENT;
    if (!(from[6] <= from[7] && from[7] <= from[2])) return SOFTCAT_ARGUMENT;
    if (!(from[8] >= 0.0 && from[8] < session->p.options.kink_count + 1)) return SOFTCAT_ARGUMENT;
    int kinks = (int)from[8], marks = (int)(4.0 * (from[8] - kinks));
    r->t = from[2];
    r->error = from[3];
    r->length = from[4];
    session->next = from[5];
    session->before = from[6];
    session->now = from[7];
    r->kink = kinks;
    r->after_kink = marks & 1;
    session->restart = marks >> 1 & 1;
    if (r->last < r->t) r->last = 2.0 * r->t;
    from += SCALARS;
    for (int k = 0; k < PIECES; from += pieces[k++].count)
        if (pieces[k].count) memcpy(pieces[k].at, from, pieces[k].count * sizeof(double));
    for (int j = 0; j < r->step.method->stages; j++, from += r->step.size)
        memcpy(r->step.stages[j], from, r->step.size * sizeof(double));
    return SOFTCAT_SOLVED;
}
