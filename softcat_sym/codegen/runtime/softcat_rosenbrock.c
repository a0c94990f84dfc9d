#include "softcat_rosenbrock.h"

#include "softcat_run.h"
#include "softcat_turns.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Steps are chosen after Hairer & Wanner (1996), section IV.8, and Gustafsson (1994). */
static const double safety = 0.9, most_growth = 6.0, most_shrinking = 0.2;

static int contradictory_options(const softcat_model *model, const softcat_options *options,
                                 const double *times, int count,
                                 const softcat_directions *directions)
{
    if (!(options->work_absolute >= 0.0)) return 1;
    if (count < 1 || !(options->relative > 0.0) || !softcat_method_of(options->method)) return 1;
    for (int k = 0; k < model->slots; k++)
        if (!(options->absolute[k] >= 0.0)) return 1;
    for (int i = 0; i < count; i++)
        if (!isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1]))) return 1;
    for (int i = 1; i < options->kink_count; i++)
        if (!(options->kinks[i] > options->kinks[i - 1])) return 1;
    for (int d = 0; directions && d < directions->count; d++)
        if (!(directions->size[d] > 0.0)) return 1;
    return 0;
}

/* The time at which f is asked where the step begins, and ends: on the inner side of a kink. */
static double inner_start(const softcat_run *r)
{
    return r->after_kink ? nextafter(r->t, INFINITY) : r->t;
}

static int at_kink(const softcat_run *r, double end)
{
    return r->kink < r->options->kink_count && end >= r->options->kinks[r->kink];
}

static double norm(softcat_run *r, const double *error, const double *y, const double *z)
{
    size_t worst = 0, slots = (size_t)r->model->slots;
    double value = softcat_step_norm(&r->step, error, y, z, r->options->relative,
                                     r->options->absolute, 0, &worst);
    r->status->worst_site = (int)(worst / slots);
    r->status->worst_slot = (int)(worst % slots);
    return value;
}

/* A first step after Hairer, Norsett & Wanner (1993), section II.4, from the differential
 * unknowns alone: an explicit Euler step says nothing of the others. */
static int choose_first(softcat_run *r, double *first)
{
    softcat_step *step = &r->step;
    softcat_copy *copy = r->copies;
    double span = r->last - r->t, h = 1e-3 * span, *change = step->stages[0];
    int code = softcat_step_begin(step, &copy->filament, inner_start(r), h, copy->state);
    if (code) return code;
    for (size_t i = 0; i < step->size; i++) change[i] = step->mass[i] * step->rates[i];
    double y0 = norm(r, copy->state, copy->state, copy->state);
    double y1 = norm(r, change, copy->state, copy->state);
    if (!isfinite(y0) || !isfinite(y1)) return SOFTCAT_NON_FINITE;
    if (y0 > 1e-5 && y1 > 1e-5 && 0.01 * y0 / y1 < h) h = 0.01 * y0 / y1;
    for (size_t i = 0; i < step->size; i++) step->point[i] = copy->state[i] + h * change[i];
    step->evaluations++;
    code = step->model->rates(&copy->filament, r->t + h, step->point, step->next, step->scratch);
    if (code && code != SOFTCAT_NON_FINITE) return code;
    for (size_t i = 0; i < step->size; i++) change[i] = step->mass[i] * step->next[i] - change[i];
    double y2 = code ? INFINITY : norm(r, change, copy->state, copy->state) / h;
    double most = y1 > y2 ? y1 : y2, order = (double)step->method->error_order;
    if (!isfinite(y2)) *first = 1e-3 * h;
    else if (most <= 1e-15) *first = 1e-3 * span;
    else *first = fmin(100.0 * h, pow(0.01 / most, 1.0 / order));
    return SOFTCAT_SOLVED;
}

/* Shorten a step to what is wanted, to the next kink and to the end; the last two steps before
 * one of these share what is left. */
static double shorten(const softcat_run *r, double h, double *end)
{
    double target = r->last, most = r->options->largest_step;
    if (r->kink < r->options->kink_count && r->options->kinks[r->kink] < target)
        target = r->options->kinks[r->kink];
    if (most > 0.0 && h > most) h = most;
    double left = target - r->t;
    if (left <= h * (1.0 + 1e-6)) {
        *end = target;
        return left;
    }
    if (left < 1.999 * h) h = 0.5 * left;
    *end = r->t + h;
    return h;
}

static void watch(const softcat_run *r, double end)
{
    softcat_turns *turns = r->options->turns;
    double stages[SOFTCAT_MOST_STAGES];
    size_t i = (size_t)turns->site * (size_t)r->model->slots + (size_t)turns->slot;
    for (int j = 0; j < r->step.method->stages; j++) stages[j] = r->step.stages[j][i];
    softcat_turns_step(turns, r->step.method, r->t, end, r->copies->state[i], r->step.next[i],
                       stages);
}

static int accept(softcat_run *r, double h, double start, double inner_end, double end)
{
    if (r->options->turns) watch(r, end);
    softcat_outputs_step(&r->outputs, &r->step, r->copies, r->t, end);
    memcpy(r->copies[0].state, r->step.next, r->step.size * sizeof(double));
    int code = softcat_copies_follow(r, h, start, inner_end, end);
    if (code) return code;
    r->status->steps++;
    r->after_kink = at_kink(r, end);
    while (at_kink(r, end)) r->kink++;
    r->t = r->status->reached = end;
    while (r->outputs.next < r->outputs.count && r->outputs.times[r->outputs.next] <= end)
        r->outputs.next++;
    return SOFTCAT_SOLVED;
}

/* Length of the step after one of length h with this error, in units of h. */
static double growth(softcat_run *r, double h, double error, int accepted, int rejected_before)
{
    double power = 1.0 / (double)r->step.method->error_order;
    double factor = error > 0.0 ? safety * pow(error, -power) : most_growth;
    if (accepted && r->error > 0.0) {
        double predicted =
            safety * h / r->length * pow(fmax(r->error, 1e-2) / (error * error), power);
        factor = fmin(factor, predicted);
    }
    factor = fmin(most_growth, fmax(most_shrinking, factor));
    if (!accepted) return rejected_before ? 0.1 : fmin(factor, safety);
    r->error = r->after_kink ? 0.0 : fmax(error, 1e-2);
    r->length = h;
    return rejected_before ? fmin(factor, 1.0) : factor;
}

static void blame_non_finite(softcat_run *r)
{
    size_t slots = (size_t)r->model->slots;
    for (size_t i = 0; i < r->step.size; i++)
        if (!isfinite(r->step.next[i])) {
            r->status->worst_site = (int)(i / slots);
            r->status->worst_slot = (int)(i % slots);
            return;
        }
}

static double smallest(const softcat_run *r)
{
    double rounding = 10.0 * DBL_EPSILON * fabs(r->t);
    return fmax(fmax(r->options->smallest_step, rounding), DBL_MIN);
}

int softcat_run_advance(softcat_run *r, double *next)
{
    softcat_step *step = &r->step;
    const softcat_copy *copy = r->copies;
    int code, rejected = 0;
    double end, start = inner_start(r), wanted = *next, h = shorten(r, wanted, &end);
    if (wanted < smallest(r)) return SOFTCAT_STEP_TOO_SMALL;
    code = softcat_step_begin(step, &copy->filament, start, h, copy->state);
    if (code) return code;
    for (;;) {
        if (r->options->stop && *r->options->stop) return SOFTCAT_STOPPED;
        if (r->status->steps + r->status->rejected
            >= (r->options->max_steps > 0 ? r->options->max_steps : 100000))
            return SOFTCAT_STEP_LIMIT;
        double inner_end = at_kink(r, end) ? nextafter(end, start) : end, factor, error = 0.0;
        code = softcat_step_take(step, &copy->filament, start, h, inner_end, copy->state);
        if (code && code != SOFTCAT_NON_FINITE && code != SOFTCAT_SINGULAR) return code;
        if (!code) {
            error = norm(r, softcat_step_error(step), copy->state, step->next);
            if (r->options->work_absolute > 0.0)
                error = fmax(error, softcat_step_work_error(step, copy->work, r->options->relative,
                                                            r->options->work_absolute));
        } else if (code == SOFTCAT_NON_FINITE) {
            blame_non_finite(r);
        }
        if (!code && error <= 1.0) {
            code = accept(r, h, start, inner_end, end);
            factor = growth(r, h, error, 1, rejected);
            /* A step cut short by far says little of what the next may be. */
            *next = factor < most_growth ? factor * h : fmax(factor * h, rejected ? 0.0 : wanted);
            return code;
        }
        r->status->rejected++;
        factor = code || !isfinite(error) ? 0.25 : growth(r, h, error, 0, rejected);
        rejected = 1;
        h *= factor;
        if (h < smallest(r))
            return code ? code : SOFTCAT_STEP_TOO_SMALL;
        h = shorten(r, h, &end);
    }
}

/* Where f jumps, algebraic unknowns jump with it. */
int softcat_run_restart(softcat_run *r)
{
    softcat_status aside = *r->status;
    if (!r->step.algebraic) return SOFTCAT_SOLVED;
    int code = softcat_newton(&r->step, &r->copies[0].filament, r->options, inner_start(r),
                          r->copies[0].state, &aside);
    return code ? code : softcat_copies_correct(r, inner_start(r));
}

int softcat_beyond(const softcat_bounds *bounds, const double *state, int slots, int sites,
                   int stride)
{
    double before[3] = {0.0};
    for (int i = 0; i < sites; i++) {
        double length = 0.0;
        for (int axis = 0; axis < 3; axis++) {
            if (bounds->slots[axis] < 0) continue;
            double at = state[(i * slots + bounds->slots[axis]) * stride];
            double held = i == 0 ? bounds->held[0][axis] : i == sites - 1 ? bounds->held[1][axis] : NAN;
            if (!isnan(held)) at = held;
            if (fabs(at) > bounds->farthest) return 1;
            length += (at - before[axis]) * (at - before[axis]);
            before[axis] = at;
        }
        if (i && length > bounds->longest[i - 1] * bounds->longest[i - 1]) return 1;
    }
    return 0;
}

int softcat_run_begin(softcat_run *r, double *next)
{
    while (r->kink < r->options->kink_count && r->options->kinks[r->kink] <= r->t) {
        r->after_kink = r->options->kinks[r->kink] == r->t;
        r->kink++;
    }
    int code = softcat_copies_correct(r, inner_start(r));
    if (!code && r->t < r->last && !(*next > 0.0)) code = choose_first(r, next);
    return code;
}

static int integrate(softcat_run *r)
{
    double next = r->options->first_step;
    softcat_turns *turns = r->options->turns;
    int code = softcat_run_begin(r, &next);
    if (turns)
        softcat_turns_begin(turns, r->t,
                            r->copies->state[turns->site * r->model->slots + turns->slot]);
    for (int c = 0; c < r->copy_count && !code; c++)
        softcat_outputs_first(&r->outputs, &r->step, r->copies + c);
    r->outputs.next = 1;
    r->status->worst_site = r->status->worst_slot = -1;
    while (!code && r->t < r->last) {
        code = softcat_run_advance(r, &next);
        if (!code && r->options->bounds && r->t < r->last
            && softcat_beyond(r->options->bounds, r->copies[0].state, r->model->slots,
                              r->copies[0].filament.sites, 1))
            code = SOFTCAT_BEYOND;
        if (!code && r->after_kink && r->t < r->last) code = softcat_run_restart(r);
    }
    return code;
}

size_t softcat_integrate_size(const softcat_model *model, int sites,
                              const softcat_directions *directions)
{
    const softcat_options plain = {0};
    const softcat_filament filament = {.sites = sites};
    softcat_run r = {.model = model, .options = &plain};
    softcat_memory memory = {NULL, 0, 0};
    return softcat_run_new(&r, &filament, directions, NULL, &memory) ? 0 : softcat_bytes(&memory);
}

int softcat_sensitivities(const softcat_model *model, const softcat_filament *filament,
                          const softcat_options *options, double *state, const double *times,
                          int count, double *states, double *work,
                          const softcat_directions *directions, softcat_workspace workspace,
                          softcat_status *status)
{
    softcat_memory memory = softcat_memory_of(workspace);
    memset(status, 0, sizeof *status);
    status->worst_site = status->worst_slot = -1;
    if (contradictory_options(model, options, times, count, directions)
        || (options->turns
            && softcat_turns_are_wrong(options->turns, filament->sites, model->slots)))
        return status->code = SOFTCAT_ARGUMENT;
    if (!memory.base) return status->code = SOFTCAT_MEMORY;
    softcat_run r = {.model = model, .options = options, .status = status};
    r.outputs.times = times;
    r.outputs.count = count;
    r.outputs.states = states;
    r.outputs.work = work;
    r.outputs.directions = directions;
    r.t = status->reached = times[0];
    r.last = times[count - 1];
    status->code = softcat_run_new(&r, filament, directions, NULL, &memory);
    if (status->code) return status->code;
    /* Work that nobody reads is not integrated. */
    if (!work && !(directions && directions->work)) r.step.powers = 0;
    softcat_copies_place(&r, filament, state, directions);
    status->code = integrate(&r);
    memcpy(state, r.copies[0].state, r.step.size * sizeof(double));
    status->evaluations = r.step.evaluations;
    status->factorisations = r.step.factorisations;
    return status->code;
}

int softcat_integrate(const softcat_model *model, const softcat_filament *filament,
                      const softcat_options *options, double *state, const double *times, int count,
                      double *states, double *work, softcat_workspace workspace,
                      softcat_status *status)
{
    return softcat_sensitivities(model, filament, options, state, times, count, states, work, NULL,
                                 workspace, status);
}
