#include "softcat_lanes_model.h"
#include "softcat_lanes_step.h"
#include "softcat_turns.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* Control of the steps of each lane is that of softcat_rosenbrock.c. All lanes try a step at once:
 * one whose step is rejected tries a shorter one beside the next steps of the others, and one that
 * is done, or has failed, takes the next member. */
static const double safety = 0.9, most_growth = 6.0, most_shrinking = 0.2;

/* The run of one lane. */
typedef struct lane {
    softcat_member *member; /* NULL: it idles */
    double t, last;
    double wanted, h, end;  /* length of the next step, and of the one that is tried; its end */
    double start, inner_end;
    double error, length;   /* of the last accepted step; error 0: there is none to go by */
    int kink, after_kink, rejected, next; /* next: the first output time not written yet */
} lane;

typedef struct lanes_run {
    lanes_step step;
    lane lanes[LANES];
    real relative, work_absolute, *absolute;
    softcat_member *waiting, *beyond;
    void *memory;
} lanes_run;

static int at_kink(const lane *r, double end)
{
    const softcat_options *options = &r->member->options;
    return r->kink < options->kink_count && end >= options->kinks[r->kink];
}

static double inner_start(const lane *r)
{
    return r->after_kink ? nextafter(r->t, INFINITY) : r->t;
}

static double smallest(const lane *r)
{
    double rounding = 10.0 * DBL_EPSILON * fabs(r->t);
    return fmax(fmax(r->member->options.smallest_step, rounding), DBL_MIN);
}

/* Shorten a step to what is wanted, to the next kink and to the end. */
static void shorten(lane *r, double h)
{
    const softcat_options *options = &r->member->options;
    double target = r->last, most = options->largest_step;
    if (r->kink < options->kink_count && options->kinks[r->kink] < target)
        target = options->kinks[r->kink];
    if (most > 0.0 && h > most) h = most;
    double left = target - r->t;
    if (left <= h * (1.0 + 1e-6)) {
        r->end = target;
        r->h = left;
        return;
    }
    r->h = left < 1.999 * h ? 0.5 * left : h;
    r->end = r->t + r->h;
}

static double growth(lane *r, const softcat_method *method, double error, int accepted)
{
    double power = 1.0 / (double)method->error_order;
    double factor = error > 0.0 ? safety * pow(error, -power) : most_growth;
    if (accepted && r->error > 0.0) {
        double predicted =
            safety * r->h / r->length * pow(fmax(r->error, 1e-2) / (error * error), power);
        factor = fmin(factor, predicted);
    }
    factor = fmin(most_growth, fmax(most_shrinking, factor));
    if (!accepted) return r->rejected ? 0.1 : fmin(factor, safety);
    r->error = r->after_kink ? 0.0 : fmax(error, 1e-2);
    r->length = r->h;
    return r->rejected ? fmin(factor, 1.0) : factor;
}

static int has_algebraic(const softcat_model *model)
{
    int found = 0;
    for (int k = 0; k < model->slots; k++) found |= !model->differential[k];
    return found;
}

static void finish(lane *r, int code)
{
    r->member->status.code = code;
    r->member = NULL;
}

static void write_row(const lanes_run *run, int l, int row, const real *states, const real *work)
{
    const softcat_member *member = run->lanes[l].member;
    size_t size = run->step.size, powers = (size_t)run->step.powers;
    double *to = member->states + (size_t)row * size;
    for (size_t i = 0; i < size; i++) to[i] = states[i][l];
    for (size_t p = 0; p < powers; p++) member->work[(size_t)row * powers + p] = work[p][l];
}

/* Let a lane take a member, at its first time. */
static void load(lanes_run *run, int l, softcat_member *member)
{
    lanes_step *step = &run->step;
    const softcat_model *one = step->model->one;
    const softcat_options *options = &member->options;
    lane *r = run->lanes + l;
    size_t places = (size_t)member->filament.sites * (size_t)one->places;
    memset(r, 0, sizeof *r);
    memset(&member->status, 0, sizeof member->status);
    member->status.worst_site = member->status.worst_slot = -1;
    r->member = member;
    r->t = member->status.reached = member->times[0];
    r->last = member->times[member->count - 1];
    r->next = 1;
    r->wanted = options->first_step;
    while (r->kink < options->kink_count && options->kinks[r->kink] <= r->t) {
        r->after_kink = options->kinks[r->kink] == r->t;
        r->kink++;
    }
    int jumps = r->kink < options->kink_count && options->kinks[r->kink] < r->last;
    for (int p = 0; p < one->parameters; p++)
        step->parameters[p][l] = member->filament.parameters[p];
    for (size_t i = 0; i < places; i++) step->places[i][l] = member->filament.places[i];
    for (size_t i = 0; i < step->size; i++) step->y[i][l] = member->state[i];
    for (int p = 0; p < step->powers; p++) step->work[p][l] = 0.0;
    for (int k = 0; k < one->slots; k++) run->absolute[k][l] = options->absolute[k];
    run->relative[l] = options->relative;
    run->work_absolute[l] = options->work_absolute;
    write_row(run, l, 0, step->y, step->work);
    softcat_turns *turns = options->turns;
    if (turns)
        softcat_turns_begin(turns, r->t, member->state[turns->site * one->slots + turns->slot]);
    if (!(r->t < r->last)) finish(r, SOFTCAT_SOLVED);
    /* Newton's method, which algebraic unknowns need there, goes one filament at a time. */
    else if (jumps && has_algebraic(one)) finish(r, SOFTCAT_NO_CONVERGENCE);
}

/* A first step after Hairer, Norsett & Wanner (1993), section II.4, for the lanes without one. */
static void choose_first(lanes_run *run)
{
    lanes_step *step = &run->step;
    real *change = step->stages[0], t = REAL(0.0), h = REAL(1.0), at = t;
    double y0[LANES], y1[LANES];
    for (int l = 0; l < LANES; l++) {
        const lane *r = run->lanes + l;
        if (!r->member) continue;
        t[l] = inner_start(r);
        at[l] = r->t;
        h[l] = 1e-3 * (r->last - r->t);
    }
    step->model->rates(&step->filament, t, step->y, step->rates, step->scratch);
    for (size_t i = 0; i < step->size; i++) change[i] = step->mass[i] * step->rates[i];
    real of_y = lanes_step_norm(step, step->y, step->y, step->y, run->relative, run->absolute);
    real of_rates = lanes_step_norm(step, change, step->y, step->y, run->relative, run->absolute);
    for (int l = 0; l < LANES; l++) {
        y0[l] = of_y[l];
        y1[l] = of_rates[l];
        if (y0[l] > 1e-5 && y1[l] > 1e-5 && 0.01 * y0[l] / y1[l] < h[l])
            h[l] = 0.01 * y0[l] / y1[l];
    }
    for (size_t i = 0; i < step->size; i++) step->point[i] = step->y[i] + h * change[i];
    step->model->rates(&step->filament, at + h, step->point, step->next, step->scratch);
    for (size_t i = 0; i < step->size; i++) change[i] = step->mass[i] * step->next[i] - change[i];
    real of_change = lanes_step_norm(step, change, step->y, step->y, run->relative, run->absolute);
    for (int l = 0; l < LANES; l++) {
        lane *r = run->lanes + l;
        if (!r->member || r->wanted > 0.0) continue;
        double y2 = of_change[l] / h[l], most = y1[l] > y2 ? y1[l] : y2;
        double order = (double)step->method->error_order;
        if (!isfinite(y0[l]) || !isfinite(y1[l])) finish(r, SOFTCAT_NON_FINITE);
        else if (!isfinite(y2)) r->wanted = 1e-3 * h[l];
        else if (most <= 1e-15) r->wanted = 1e-3 * (r->last - r->t);
        else r->wanted = fmin(100.0 * h[l], pow(0.01 / most, 1.0 / order));
    }
}

/* Give idle lanes the members that wait, and all a step to try: how many there are. */
static int prepare(lanes_run *run)
{
    int fresh = 0, busy = 0;
    for (int l = 0; l < LANES; l++) {
        lane *r = run->lanes + l;
        while (!r->member && run->waiting < run->beyond) load(run, l, run->waiting++);
        fresh |= r->member && !(r->wanted > 0.0);
    }
    if (fresh) choose_first(run);
    for (int l = 0; l < LANES; l++) {
        lane *r = run->lanes + l;
        if (!r->member) continue;
        const softcat_options *options = &r->member->options;
        const softcat_status *status = &r->member->status;
        long most = options->max_steps > 0 ? options->max_steps : 100000;
        if (options->stop && *options->stop) {
            finish(r, SOFTCAT_STOPPED);
        } else if (status->steps + status->rejected >= most) {
            finish(r, SOFTCAT_STEP_LIMIT);
        } else if (!r->rejected && r->wanted < smallest(r)) {
            finish(r, SOFTCAT_STEP_TOO_SMALL);
        } else {
            shorten(r, r->rejected ? r->h : r->wanted);
            r->start = inner_start(r);
            r->inner_end = at_kink(r, r->end) ? nextafter(r->end, r->start) : r->end;
            busy++;
        }
    }
    return busy;
}

/* Write all that lies in the steps that these lanes have taken. */
static void write_outputs(lanes_run *run, const int *accepted)
{
    for (;;) {
        int rows[LANES], any = 0;
        real x = REAL(1.0);
        for (int l = 0; l < LANES; l++) {
            lane *r = run->lanes + l;
            rows[l] = -1;
            if (!accepted[l] || r->next >= r->member->count) continue;
            double time = r->member->times[r->next];
            if (time > r->end) continue;
            rows[l] = r->next++;
            x[l] = time < r->end ? (time - r->t) / r->h : 1.0;
            any = 1;
        }
        if (!any) return;
        lanes_step_between(&run->step, x);
        for (int l = 0; l < LANES; l++)
            if (rows[l] >= 0) write_row(run, l, rows[l], run->step.point, run->step.power_looked);
    }
}

/* Turning points in the step that a lane has taken. */
static void watch(const lanes_run *run, int l)
{
    const lanes_step *step = &run->step;
    const lane *r = run->lanes + l;
    softcat_turns *turns = r->member->options.turns;
    double stages[SOFTCAT_MOST_STAGES];
    size_t i = (size_t)(turns->site * step->model->one->slots + turns->slot);
    for (int j = 0; j < step->method->stages; j++) stages[j] = step->stages[j][i][l];
    softcat_turns_step(turns, step->method, r->t, r->end, step->y[i][l], step->next[i][l], stages);
}

static void accept(lanes_run *run, int l, double error)
{
    lane *r = run->lanes + l;
    r->member->status.steps++;
    r->after_kink = at_kink(r, r->end);
    while (at_kink(r, r->end)) r->kink++;
    double factor = growth(r, run->step.method, error, 1);
    /* A step cut short by far says little of what the next may be. */
    double wanted = r->rejected ? 0.0 : r->wanted;
    r->wanted = factor < most_growth ? factor * r->h : fmax(factor * r->h, wanted);
    r->rejected = 0;
    r->t = r->member->status.reached = r->end;
    if (!(r->t < r->last)) finish(r, SOFTCAT_SOLVED);
    else if (r->member->options.bounds
             && softcat_beyond(r->member->options.bounds, (const double *)run->step.y + l,
                               run->step.model->one->slots, r->member->filament.sites, LANES))
        finish(r, SOFTCAT_BEYOND);
}

static void reject(lanes_run *run, int l, int bad, double error)
{
    lane *r = run->lanes + l;
    double factor =
        bad || !isfinite(error) ? 0.25 : growth(r, run->step.method, error, 0);
    r->member->status.rejected++;
    r->rejected = 1;
    r->h *= factor;
    if (r->h < smallest(r)) finish(r, bad ? SOFTCAT_NON_FINITE : SOFTCAT_STEP_TOO_SMALL);
}

/* All lanes try the step that `prepare` gave them. */
static void attempt(lanes_run *run)
{
    lanes_step *step = &run->step;
    real start = REAL(0.0), h = REAL(1.0), end = REAL(1.0);
    int accepted[LANES];
    lanes_mask taken = {0};
    for (int l = 0; l < LANES; l++) {
        const lane *r = run->lanes + l;
        if (!r->member) continue;
        start[l] = r->start;
        h[l] = r->h;
        end[l] = r->inner_end;
    }
    lanes_step_begin(step, start, h);
    lanes_mask bad = lanes_step_take(step, start, h, end);
    real error = lanes_step_norm(step, lanes_step_error(step), step->y, step->next, run->relative,
                                 run->absolute);
    real of_work = lanes_step_work_error(step, run->relative, run->work_absolute);
    for (int l = 0; l < LANES; l++) {
        if (run->work_absolute[l] > 0.0 && !(of_work[l] <= error[l])) error[l] = of_work[l];
        accepted[l] = run->lanes[l].member && !bad[l] && error[l] <= 1.0;
        taken[l] = accepted[l] ? -1 : 0;
    }
    write_outputs(run, accepted);
    for (int l = 0; l < LANES; l++)
        if (accepted[l] && run->lanes[l].member->options.turns) watch(run, l);
    for (size_t i = 0; i < step->size; i++)
        step->y[i] = lanes_choose(taken, step->next[i], step->y[i]);
    for (int p = 0; p < step->powers; p++)
        step->work[p] = lanes_choose(taken, step->work[p] + step->power_next[p], step->work[p]);
    for (int l = 0; l < LANES; l++) {
        if (accepted[l]) accept(run, l, error[l]);
        else if (run->lanes[l].member) reject(run, l, bad[l] != 0, error[l]);
    }
}

static int contradictory(const softcat_model *model, const softcat_member *members, int count)
{
    for (int m = 0; m < count; m++) {
        const softcat_member *member = members + m;
        const softcat_options *options = &member->options;
        if (member->filament.sites != members->filament.sites || member->count < 1) return 1;
        if (options->method != members->options.method || !member->states) return 1;
        if (!(options->relative > 0.0) || !(options->work_absolute >= 0.0)) return 1;
        if (!member->work != !members->work) return 1;
        if (options->turns
            && softcat_turns_are_wrong(options->turns, member->filament.sites, model->slots))
            return 1;
        for (int k = 0; k < model->slots; k++)
            if (!(options->absolute[k] >= 0.0)) return 1;
        for (int i = 0; i < member->count; i++)
            if (!isfinite(member->times[i]) || (i && !(member->times[i] > member->times[i - 1])))
                return 1;
    }
    return 0;
}

int softcat_lanes_integrate(const softcat_lanes_model *model, softcat_member *members, int count)
{
    if (count < 1) return SOFTCAT_SOLVED;
    const softcat_method *method = softcat_method_of(members->options.method);
    if (model->lanes != LANES || !method || contradictory(model->one, members, count))
        return SOFTCAT_ARGUMENT;
    lanes_run *run;
    void *memory;
    /* Vectors stand in it: it lies where they may lie. */
    run = (lanes_run *)lanes_new(sizeof *run / sizeof(real) + 1, &memory);
    if (!run) return SOFTCAT_MEMORY;
    run->waiting = members;
    run->beyond = members + count;
    int code =
        lanes_step_new(&run->step, model, method, members->filament.sites, members->work != NULL);
    run->absolute = lanes_new((size_t)model->one->slots, &run->memory);
    if (!run->absolute) code = SOFTCAT_MEMORY;
    while (!code) {
        if (prepare(run)) attempt(run);
        else if (run->waiting == run->beyond) break;
    }
    lanes_step_free(&run->step);
    free(run->memory);
    free(memory);
    return code;
}
