#include "softcat_lanes_step.h"

#include <stdlib.h>
#include <string.h>

int lanes_step_new(lanes_step *step, const softcat_lanes_model *model, const softcat_method *method,
                   int sites, int works)
{
    const softcat_model *one = model->one;
    memset(step, 0, sizeof *step);
    int code = lanes_linear_new(&step->linear, one, sites);
    if (code) return code;
    size_t n = (size_t)sites, powers = works && model->work ? (size_t)one->powers : 0;
    size_t size = n * (size_t)one->slots;
    step->model = model;
    step->method = method;
    step->size = size;
    step->powers = (int)powers;
    real **store[] = {&step->parameters, &step->places,       &step->y,          &step->rates,
                      &step->slope,      &step->next,         &step->looked,     &step->point,
                      &step->entries,    &step->scratch,      &step->work,       &step->power,
                      &step->power_time, &step->power_looked, &step->power_next, &step->power_slope,
                      &step->power_stages};
    size_t sizes[] = {(size_t)one->parameters, n * (size_t)one->places, size, size, size, size, size,
                      size, n * (size_t)one->entries, n * (size_t)one->scratch, powers, powers,
                      powers, powers, powers, powers * size, powers * SOFTCAT_MOST_STAGES};
    size_t all = SOFTCAT_MOST_STAGES * size;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) all += sizes[i];
    real *place = lanes_new(all, &step->memory);
    step->mass = calloc(size + 1, sizeof(double));
    if (!place || !step->mass) return SOFTCAT_MEMORY;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; place += sizes[i++]) *store[i] = place;
    for (int i = 0; i < SOFTCAT_MOST_STAGES; i++, place += size) step->stages[i] = place;
    step->filament.sites = sites;
    step->filament.parameters = step->parameters;
    step->filament.places = step->places;
    const unsigned char *is_free = softcat_linear_free_unknowns(step->linear.plan);
    for (size_t i = 0; i < size; i++)
        step->mass[i] = is_free[i] && one->differential[i % (size_t)one->slots] ? 1.0 : 0.0;
    return SOFTCAT_SOLVED;
}

void lanes_step_free(lanes_step *step)
{
    lanes_linear_free(&step->linear);
    free(step->memory);
    free(step->mass);
}

static void add(real *restrict to, const real *restrict what, real times, size_t size)
{
    for (size_t i = 0; i < size; i++) to[i] += times * what[i];
}

static void rates(lanes_step *step, real t, const real *y, real *out)
{
    step->model->rates(&step->filament, t, y, out, step->scratch);
}

static void powers(lanes_step *step, real t, const real *y, real *out)
{
    if (step->powers) step->model->work(&step->filament, t, y, out, step->scratch);
}

static void slope_in_time(lanes_step *step, real t, real h)
{
    real ahead = t + 1e-4 * h, d = ahead - t;
    lanes_mask moves = (lanes_mask)(d > 0.0);
    d = lanes_choose(moves, d, REAL(1.0));
    real over = lanes_choose(moves, 1.0 / (2.0 * d), REAL(0.0));
    rates(step, t + d, step->y, step->slope);
    powers(step, t + d, step->y, step->power_time);
    rates(step, t + 2.0 * d, step->y, step->point);
    powers(step, t + 2.0 * d, step->y, step->power_looked);
    for (int p = 0; p < step->powers; p++)
        step->power_time[p] =
            (4.0 * step->power_time[p] - step->power_looked[p] - 3.0 * step->power[p]) * over;
    for (size_t i = 0; i < step->size; i++)
        step->slope[i] = (4.0 * step->slope[i] - step->point[i] - 3.0 * step->rates[i]) * over;
}

void lanes_step_begin(lanes_step *step, real t, real h)
{
    rates(step, t, step->y, step->rates);
    powers(step, t, step->y, step->power);
    if (step->model->one->moves_in_time) slope_in_time(step, t, h);
    step->model->jacobian(&step->filament, t, step->y, step->entries, step->scratch);
    if (step->powers)
        step->model->work_slope(&step->filament, t, step->y, step->power_slope, step->scratch);
}

static int same_point(const softcat_method *method, int i)
{
    return i > 0 && method->time[i] == method->time[i - 1]
           && !memcmp(method->a[i], method->a[i - 1], sizeof method->a[i]);
}

/* Where stage i looks; it may go on from the stage before, and has its own sum in `point`. */
static void stage_point(lanes_step *step, int i)
{
    const double *a = step->method->a[i];
    int goes_on = i > 1 && a[i - 1] == 1.0;
    for (int j = 0; j < i - 1 && goes_on; j++) goes_on = a[j] == step->method->a[i - 1][j];
    if (goes_on) {
        add(step->point, step->stages[i - 1], REAL(1.0), step->size);
        return;
    }
    for (size_t n = 0; n < step->size; n++) {
        real sum = step->y[n];
        for (int j = 0; j < i; j++) sum += a[j] * step->stages[j][n];
        step->point[n] = sum;
    }
}

/* M sum_j (c_ij / h) k_j + h slope_i df/dt. */
static void add_history(lanes_step *step, real h, real inverse, int i)
{
    const softcat_method *method = step->method;
    real *k = step->stages[i], times = h * method->slope[i];
    int moves = step->model->one->moves_in_time && method->slope[i] != 0.0;
    for (size_t n = 0; n < step->size; n++) {
        real sum = REAL(0.0);
        for (int j = 0; j < i; j++) sum += method->c[i][j] * step->stages[j][n];
        k[n] += step->mass[n] * inverse * sum;
        if (moves) k[n] += times * step->slope[n];
    }
}

/* Rates of stage i in stages[i]; points that were looked at before are not asked for again. */
static void look(lanes_step *step, real t, real h, real end, int i)
{
    const softcat_method *method = step->method;
    const double *a = method->a[i];
    real when = method->time[i] < 1.0 ? t + method->time[i] * h : end, *k = step->stages[i];
    int at_start = method->time[i] == 0.0;
    for (int j = 0; j < i && at_start; j++) at_start = a[j] == 0.0;
    if (at_start) {
        memcpy(k, step->rates, step->size * sizeof(real));
        memcpy(step->power_looked, step->power, (size_t)step->powers * sizeof(real));
    } else if (same_point(method, i)) {
        memcpy(k, step->looked, step->size * sizeof(real));
    } else {
        stage_point(step, i);
        rates(step, when, step->point, k);
        powers(step, when, step->point, step->power_looked);
        if (i + 1 < method->stages && same_point(method, i + 1))
            memcpy(step->looked, k, step->size * sizeof(real));
    }
}

static void work_stage(lanes_step *step, real h, real inverse, int i)
{
    const softcat_method *method = step->method;
    size_t count = (size_t)step->powers;
    real *k = step->power_stages + (size_t)i * count;
    for (size_t p = 0; p < count; p++) {
        const real *slope = step->power_slope + p * step->size, *stage = step->stages[i];
        real sum = step->power_looked[p], odd = REAL(0.0);
        if (step->model->one->moves_in_time) sum += h * method->slope[i] * step->power_time[p];
        for (int j = 0; j < i; j++)
            sum += method->c[i][j] * inverse * step->power_stages[(size_t)j * count + p];
        size_t n = 0;
        for (; n + 1 < step->size; n += 2) {
            sum += slope[n] * stage[n];
            odd += slope[n + 1] * stage[n + 1];
        }
        if (n < step->size) sum += slope[n] * stage[n];
        k[p] = h * method->gamma * (sum + odd);
    }
}

static void work_of_step(lanes_step *step)
{
    const softcat_method *method = step->method;
    size_t count = (size_t)step->powers;
    int last = method->stages - 1;
    for (size_t p = 0; p < count; p++) {
        real sum = step->power_stages[(size_t)last * count + p];
        for (int j = 0; j < last; j++)
            sum += method->a[last][j] * step->power_stages[(size_t)j * count + p];
        step->power_next[p] = sum;
    }
}

lanes_mask lanes_step_take(lanes_step *step, real t, real h, real end)
{
    const softcat_method *method = step->method;
    real inverse = 1.0 / h;
    lanes_mask bad =
        lanes_linear_factorise(&step->linear, step->entries, inverse * (1.0 / method->gamma));
    for (int i = 0; i < method->stages; i++) {
        look(step, t, h, end, i);
        add_history(step, h, inverse, i);
        lanes_linear_solve(&step->linear, step->stages[i]);
        work_stage(step, h, inverse, i);
    }
    work_of_step(step);
    const real *last = step->stages[method->stages - 1];
    real sum = REAL(0.0);
    for (size_t n = 0; n < step->size; n++) {
        step->next[n] = step->point[n] + last[n];
        sum += lanes_fabs(step->next[n]) * 1e-10; /* not to overflow itself */
    }
    return bad | ~lanes_finite(sum);
}

const real *lanes_step_error(lanes_step *step)
{
    const softcat_method *method = step->method;
    const real *last = step->stages[method->stages - 1];
    if (method->embedded < 0) return last;
    memcpy(step->point, last, step->size * sizeof(real));
    add(step->point, step->stages[method->embedded], REAL(-1.0), step->size);
    return step->point;
}

real lanes_step_work_error(const lanes_step *step, real relative, real absolute)
{
    const softcat_method *method = step->method;
    size_t count = (size_t)step->powers;
    const real *last = step->power_stages + (size_t)(method->stages - 1) * count;
    real largest = REAL(0.0);
    for (size_t p = 0; p < count; p++) {
        real error = last[p];
        if (method->embedded >= 0) error -= step->power_stages[(size_t)method->embedded * count + p];
        error = lanes_fabs(error)
                / (absolute + relative * lanes_fabs(step->work[p] + step->power_next[p]));
        largest = lanes_choose((lanes_mask)(error <= largest), largest, error);
    }
    return largest;
}

void lanes_step_between(lanes_step *step, real x)
{
    const softcat_method *method = step->method;
    real weight[SOFTCAT_MOST_STAGES], power = x * (1.0 - x);
    size_t count = (size_t)step->powers;
    for (int j = 0; j < method->stages; j++) weight[j] = REAL(0.0);
    for (int m = 0; m < method->dense_rows; m++, power *= x)
        for (int j = 0; j < method->stages; j++) weight[j] += power * method->dense[m][j];
    for (size_t n = 0; n < step->size; n++) {
        real sum = (1.0 - x) * step->y[n] + x * step->next[n];
        for (int j = 0; j < method->stages; j++) sum += weight[j] * step->stages[j][n];
        step->point[n] = sum;
    }
    for (size_t p = 0; p < count; p++) {
        real sum = step->work[p] + x * step->power_next[p];
        for (int j = 0; j < method->stages; j++)
            sum += weight[j] * step->power_stages[(size_t)j * count + p];
        step->power_looked[p] = sum;
    }
}

real lanes_step_norm(const lanes_step *step, const real *error, const real *y, const real *z,
                     real relative, const real *absolute)
{
    const unsigned char *is_free = softcat_linear_free_unknowns(step->linear.plan);
    size_t slots = (size_t)step->model->one->slots, count = 0;
    real sum = REAL(0.0);
    for (size_t site = 0; site < step->size; site += slots)
        for (size_t k = 0; k < slots; k++) {
            size_t i = site + k;
            if (!is_free[i]) continue;
            real largest = lanes_larger(lanes_fabs(y[i]), lanes_fabs(z[i]));
            real value = error[i] / (absolute[k] + relative * largest);
            /* 0 / 0 is no error */
            value = lanes_choose((lanes_mask)(error[i] == 0.0), REAL(0.0), value);
            sum += value * value;
            count++;
        }
    return count ? lanes_sqrt(sum / (double)count) : REAL(0.0);
}
