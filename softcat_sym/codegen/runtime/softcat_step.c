#include "softcat_step.h"

#include <math.h>
#include <string.h>

int softcat_step_new(softcat_step *step, const softcat_model *model, const softcat_view *view,
                     const softcat_method *method, int sites, softcat_memory *memory)
{
    int code;
    memset(step, 0, sizeof *step);
    step->linear = softcat_linear_new(model, view, sites, memory, &code);
    if (code) return code;
    step->model = model;
    step->method = method;
    step->size = (size_t)sites * (size_t)model->slots;
    size_t powers = model->work ? (size_t)model->powers : 0;
    step->powers = (int)powers;
    for (int i = 0; i < SOFTCAT_MOST_STAGES; i++)
        step->stages[i] = softcat_take_doubles(memory, step->size);
    double **vector[] = {&step->rates, &step->slope, &step->next, &step->point, &step->mass,
                         &step->looked};
    for (int i = 0; i < 6; i++) *vector[i] = softcat_take_doubles(memory, step->size);
    step->entries = softcat_take_doubles(memory, (size_t)sites * (size_t)model->entries);
    step->scratch = softcat_take_doubles(memory, (size_t)sites * (size_t)model->scratch);
    double **few[] = {&step->power, &step->power_time, &step->power_looked, &step->power_next};
    for (int i = 0; i < 4; i++) *few[i] = softcat_take_doubles(memory, powers);
    step->power_stages = softcat_take_doubles(memory, powers * SOFTCAT_MOST_STAGES);
    step->power_slope = softcat_take_doubles(memory, powers * step->size);
    if (!memory->base) return SOFTCAT_SOLVED;
    if (!softcat_fits(memory)) return SOFTCAT_MEMORY;
    const unsigned char *is_free = softcat_linear_free_unknowns(step->linear);
    for (int k = 0; k < model->slots; k++) step->algebraic |= !model->differential[k];
    for (size_t i = 0; i < step->size; i++)
        step->mass[i] = is_free[i] && model->differential[i % (size_t)model->slots] ? 1.0 : 0.0;
    return SOFTCAT_SOLVED;
}

static int rates(softcat_step *step, const softcat_filament *filament, double t, const double *y,
                 double *out)
{
    step->evaluations++;
    return step->model->rates(filament, t, y, out, step->scratch);
}

/* The powers where `rates` was asked just now. */
static int powers(softcat_step *step, const softcat_filament *filament, double t, const double *y,
                  double *out)
{
    return step->powers ? step->model->work(filament, t, y, out, step->scratch) : SOFTCAT_SOLVED;
}

static void add(double *restrict to, const double *restrict what, double times, size_t size)
{
    for (size_t i = 0; i < size; i++) to[i] += times * what[i];
}

/* to += the sum of the first `count` stages, each times its weight and over h. Four at a time, so
 * that the vector is loaded and stored less often. */
static void add_stages(const softcat_step *step, double *restrict to, const double *weight,
                       double h, int count)
{
    const double *stage[SOFTCAT_MOST_STAGES];
    double times[SOFTCAT_MOST_STAGES];
    int used = 0, j = 0;
    for (int i = 0; i < count; i++)
        if (weight[i] != 0.0) {
            stage[used] = step->stages[i];
            times[used++] = weight[i] / h;
        }
    for (; j + 4 <= used; j += 4) {
        const double *a = stage[j], *b = stage[j + 1], *c = stage[j + 2], *d = stage[j + 3];
        double ta = times[j], tb = times[j + 1], tc = times[j + 2], td = times[j + 3];
        for (size_t n = 0; n < step->size; n++)
            to[n] += (ta * a[n] + tb * b[n]) + (tc * c[n] + td * d[n]);
    }
    for (; j + 2 <= used; j += 2) {
        const double *a = stage[j], *b = stage[j + 1];
        double ta = times[j], tb = times[j + 1];
        for (size_t n = 0; n < step->size; n++) to[n] += ta * a[n] + tb * b[n];
    }
    if (j < used) add(to, stage[j], times[j], step->size);
}

static double dot(const double *restrict a, const double *restrict b, size_t size)
{
    double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
    size_t n = 0;
    for (; n + 4 <= size; n += 4) {
        s0 += a[n] * b[n];
        s1 += a[n + 1] * b[n + 1];
        s2 += a[n + 2] * b[n + 2];
        s3 += a[n + 3] * b[n + 3];
    }
    for (; n < size; n++) s0 += a[n] * b[n];
    return (s0 + s1) + (s2 + s3);
}

/* df/dt of second order from two points ahead: a support that changes pace where the step begins
 * is not looked at from the wrong side, and the step ends before the next change. */
static int difference_in_time(softcat_step *step, const softcat_filament *filament, double t, double h,
                         const double *y)
{
    volatile double ahead = t + 1e-4 * h; /* rounded as a time is */
    double d = ahead - t;
    if (!(d > 0.0)) return SOFTCAT_SOLVED;
    int code = rates(step, filament, t + d, y, step->slope);
    if (!code) code = powers(step, filament, t + d, y, step->power_time);
    if (!code) code = rates(step, filament, t + 2.0 * d, y, step->point);
    if (!code) code = powers(step, filament, t + 2.0 * d, y, step->power_looked);
    for (int p = 0; p < step->powers && !code; p++)
        step->power_time[p] =
            (4.0 * step->power_time[p] - step->power_looked[p] - 3.0 * step->power[p]) / (2.0 * d);
    for (size_t i = 0; i < step->size && !code; i++)
        step->slope[i] = (4.0 * step->slope[i] - step->point[i] - 3.0 * step->rates[i]) / (2.0 * d);
    return code;
}

static int slope_in_time(softcat_step *step, const softcat_filament *filament, double t, double h,
                         const double *y)
{
    const softcat_model *model = step->model;
    if (!model->rates_in_time) return difference_in_time(step, filament, t, h, y);
    int code = model->rates_in_time(filament, t, y, step->slope, step->scratch);
    if (!code && step->powers)
        code = model->work_in_time(filament, t, y, step->power_time, step->scratch);
    return code;
}

int softcat_step_begin(softcat_step *step, const softcat_filament *filament, double t, double h,
                       const double *y)
{
    int code = rates(step, filament, t, y, step->rates);
    if (!code) code = powers(step, filament, t, y, step->power);
    if (!code && step->model->moves_in_time) code = slope_in_time(step, filament, t, h, y);
    if (!code) code = step->model->jacobian(filament, t, y, step->entries, step->scratch);
    if (!code && step->powers)
        code = step->model->work_slope(filament, t, y, step->power_slope, step->scratch);
    return code;
}

static int same_point(const softcat_method *method, int i)
{
    return i > 0 && method->time[i] == method->time[i - 1]
           && !memcmp(method->a[i], method->a[i - 1], sizeof method->a[i]);
}

/* Where stage i looks; it may go on from the stage before, and has its own sum in `point`. */
static void stage_point(softcat_step *step, const double *y, int i)
{
    const double *a = step->method->a[i];
    int goes_on = i > 1 && a[i - 1] == 1.0;
    for (int j = 0; j < i - 1 && goes_on; j++) goes_on = a[j] == step->method->a[i - 1][j];
    if (goes_on) {
        add(step->point, step->stages[i - 1], 1.0, step->size);
        return;
    }
    memcpy(step->point, y, step->size * sizeof(double));
    add_stages(step, step->point, a, 1.0, i);
}

/* M sum_j (c_ij / h) k_j + h slope_i df/dt; `next` is free until the last stage. Without algebraic
 * unknowns M only leaves out those that are held, and these are not looked at. */
static void add_history(softcat_step *step, double h, int i)
{
    const softcat_method *method = step->method;
    double *k = step->stages[i], *sum = step->next;
    if (!step->algebraic) {
        add_stages(step, k, method->c[i], h, i);
    } else if (i > 0) {
        memset(sum, 0, step->size * sizeof(double));
        add_stages(step, sum, method->c[i], h, i);
        for (size_t n = 0; n < step->size; n++) k[n] += step->mass[n] * sum[n];
    }
    if (step->model->moves_in_time && method->slope[i] != 0.0)
        add(k, step->slope, h * method->slope[i], step->size);
}

/* Rates of stage i in stages[i]; points that were looked at before are not asked for again. */
static int look(softcat_step *step, const softcat_filament *filament, double t, double h,
                double end, const double *y, int i)
{
    const softcat_method *method = step->method;
    const double *a = method->a[i];
    double when = method->time[i] < 1.0 ? t + method->time[i] * h : end, *k = step->stages[i];
    int at_start = method->time[i] == 0.0;
    for (int j = 0; j < i && at_start; j++) at_start = a[j] == 0.0;
    if (at_start) {
        memcpy(k, step->rates, step->size * sizeof(double));
        memcpy(step->power_looked, step->power, (size_t)step->powers * sizeof(double));
    } else if (same_point(method, i)) {
        memcpy(k, step->looked, step->size * sizeof(double));
    } else {
        stage_point(step, y, i);
        int code = rates(step, filament, when, step->point, k);
        if (!code) code = powers(step, filament, when, step->point, step->power_looked);
        if (code) return code;
        if (i + 1 < method->stages && same_point(method, i + 1))
            memcpy(step->looked, k, step->size * sizeof(double));
    }
    return SOFTCAT_SOLVED;
}

/* What the powers do is one more unknown each, q' = g(t, y), on which nothing depends:
 * k_i = h gamma (g + sum_j (c_ij / h) k_j + h slope_i dg/dt + dg/dy k_i). */
static void work_stage(softcat_step *step, double h, int i)
{
    const softcat_method *method = step->method;
    size_t count = (size_t)step->powers;
    double *k = step->power_stages + (size_t)i * count;
    for (size_t p = 0; p < count; p++) {
        const double *slope = step->power_slope + p * step->size;
        double sum = step->power_looked[p];
        if (step->model->moves_in_time) sum += h * method->slope[i] * step->power_time[p];
        for (int j = 0; j < i; j++)
            sum += method->c[i][j] / h * step->power_stages[(size_t)j * count + p];
        k[p] = h * method->gamma * (sum + dot(slope, step->stages[i], step->size));
    }
}

/* What the powers do in the step: the last stage goes on from the point where it looks. */
static void work_of_step(softcat_step *step)
{
    const softcat_method *method = step->method;
    size_t count = (size_t)step->powers;
    int last = method->stages - 1;
    for (size_t p = 0; p < count; p++) {
        double sum = step->power_stages[(size_t)last * count + p];
        for (int j = 0; j < last; j++)
            sum += method->a[last][j] * step->power_stages[(size_t)j * count + p];
        step->power_next[p] = sum;
    }
}

int softcat_step_take(softcat_step *step, const softcat_filament *filament, double t, double h,
                      double end, const double *y)
{
    const softcat_method *method = step->method;
    step->factorisations++;
    int code = softcat_linear_factorise(step->linear, step->entries, 1.0 / (h * method->gamma));
    if (code) return code;
    for (int i = 0; i < method->stages; i++) {
        code = look(step, filament, t, h, end, y, i);
        if (code) return code;
        double *k = step->stages[i];
        add_history(step, h, i);
        softcat_linear_solve(step->linear, k);
        work_stage(step, h, i);
    }
    work_of_step(step);
    const double *last = step->stages[method->stages - 1];
    double sum = 0.0;
    for (size_t n = 0; n < step->size; n++) {
        step->next[n] = step->point[n] + last[n];
        sum += fabs(step->next[n]) * 1e-10; /* not to overflow itself */
    }
    return isfinite(sum) ? SOFTCAT_SOLVED : SOFTCAT_NON_FINITE;
}

const double *softcat_step_error(softcat_step *step)
{
    const softcat_method *method = step->method;
    const double *last = step->stages[method->stages - 1];
    if (method->embedded < 0) return last;
    memcpy(step->point, last, step->size * sizeof(double));
    add(step->point, step->stages[method->embedded], -1.0, step->size);
    return step->point;
}

double softcat_step_work_error(const softcat_step *step, const double *before, double relative,
                               double absolute)
{
    const softcat_method *method = step->method;
    size_t count = (size_t)step->powers;
    const double *last = step->power_stages + (size_t)(method->stages - 1) * count;
    double largest = 0.0;
    for (size_t p = 0; p < count; p++) {
        double error = last[p];
        if (method->embedded >= 0) error -= step->power_stages[(size_t)method->embedded * count + p];
        error = fabs(error) / (absolute + relative * fabs(before[p] + step->power_next[p]));
        if (!(error <= largest)) largest = error;
    }
    return largest;
}

/* What each stage adds to the line between both ends of the step. */
static void dense_weights(const softcat_method *method, double x, double *weight)
{
    double power = x * (1.0 - x);
    memset(weight, 0, SOFTCAT_MOST_STAGES * sizeof(double));
    for (int m = 0; m < method->dense_rows; m++, power *= x)
        for (int j = 0; j < method->stages; j++) weight[j] += power * method->dense[m][j];
}

void softcat_step_work(const softcat_step *step, const double *before, double x, double *work)
{
    double weight[SOFTCAT_MOST_STAGES];
    size_t count = (size_t)step->powers;
    dense_weights(step->method, x, weight);
    for (size_t p = 0; p < count; p++) {
        work[p] = before[p] + x * step->power_next[p];
        for (int j = 0; j < step->method->stages; j++)
            work[p] += weight[j] * step->power_stages[(size_t)j * count + p];
    }
}

void softcat_step_between(const softcat_step *step, const double *y, double x, double *out)
{
    const softcat_method *method = step->method;
    double weight[SOFTCAT_MOST_STAGES];
    dense_weights(method, x, weight);
    for (size_t n = 0; n < step->size; n++) out[n] = (1.0 - x) * y[n] + x * step->next[n];
    add_stages(step, out, weight, 1.0, method->stages);
}

double softcat_step_norm(const softcat_step *step, const double *error, const double *y,
                         const double *z, double relative, const double *absolute,
                         int algebraic_only, size_t *worst)
{
    const unsigned char *is_free = softcat_linear_free_unknowns(step->linear);
    size_t slots = (size_t)step->model->slots, count = 0, site = 0;
    double sum = 0.0, largest = -1.0;
    for (; site < step->size; site += slots)
        for (size_t k = 0; k < slots; k++) {
            size_t i = site + k;
            if (!is_free[i] || (algebraic_only && step->model->differential[k])) continue;
            double a = fabs(y[i]), b = fabs(z[i]);
            double weight = absolute[k] + relative * (a > b ? a : b);
            double value = error[i] == 0.0 ? 0.0 : error[i] / weight;
            sum += value * value;
            count++;
            if (!(value * value <= largest)) {
                largest = isnan(value) ? INFINITY : value * value;
                *worst = i;
            }
        }
    return count ? sqrt(sum / (double)count) : 0.0;
}

int softcat_step_correction(softcat_step *step, int factorise)
{
    int code = SOFTCAT_SOLVED;
    softcat_linear_hold(step->linear, 1);
    if (factorise) {
        step->factorisations++;
        code = softcat_linear_factorise(step->linear, step->entries, 0.0);
    }
    if (!code) {
        memcpy(step->stages[0], step->rates, step->size * sizeof(double));
        softcat_linear_solve(step->linear, step->stages[0]);
    }
    softcat_linear_hold(step->linear, 0);
    return code;
}
