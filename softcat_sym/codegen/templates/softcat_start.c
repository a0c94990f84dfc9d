#include "softcat_start.h"

#include "softcat_places.h"

#include <math.h>
#include <string.h>

static double parameter(const double *params, int number, double otherwise)
{
    return number >= 0 ? params[number] : otherwise;
}

/* Displacement of the right support [m], added to `moved`: straight pieces from nowhere at t = 0,
 * held at the end. */
static void displacement(const softcat_structure *s, const double *params, double seconds,
                         double *moved)
{
    const double *before = NULL;
    for (int row = 0; row < s->motion_rows; row++) {
        const double *point = params + s->motion + s->motion_width * row;
        double begin = before ? before[0] : 0.0;
        double share = (seconds - begin) / fmax(point[0] - begin, 1e-300);
        share = fmin(fmax(share, 0.0), 1.0);
        for (int k = 1; k < s->motion_width; k++)
            moved[k - 1] += (point[k] - (before ? before[k] : 0.0)) * share;
        before = point;
    }
}

softcat_supports softcat_supports_at(const softcat_structure *s, const double *params,
                                     double seconds)
{
    double length = params[s->rest_length], moved[3] = {0.0, 0.0, 0.0};
    double half = 0.5 * parameter(params, s->span, length) / length;
    displacement(s, params, seconds, moved);
    softcat_supports at = {-half, half + moved[0] / length,
                           (moved[1] - parameter(params, s->drop, 0.0)) / length,
                           moved[2] / length};
    return at;
}

/* A line y(X), x(X) in rest lengths, and its angle. */
typedef struct line {
    double x, y, run, fall, angle;
} line;

static line straight_line(const softcat_structure *s, const double *params)
{
    double length = params[s->rest_length], grown = s->stretch;
    double span = parameter(params, s->span, length), drop = parameter(params, s->drop, 0.0);
    line l = {0.0, -0.5 * drop / length, span / length, drop / length, atan2(-drop, span)};
    if (s->first != SOFTCAT_FREE && s->last != SOFTCAT_FREE) return l;
    int held = s->last == SOFTCAT_FREE ? s->left_angle : s->right_angle;
    softcat_end holds = s->last == SOFTCAT_FREE ? s->first : s->last;
    l.angle = holds == SOFTCAT_CLAMPED ? parameter(params, held, 0.0) : 0.0;
    l.run = grown * cos(l.angle);
    l.fall = -grown * sin(l.angle);
    if (s->last == SOFTCAT_FREE) {
        l.x = -0.5 * span / length + 0.5 * l.run;
        l.y = -0.5 * l.fall;
    } else {
        l.x = 0.5 * span / length - 0.5 * l.run;
        l.y = -drop / length + 0.5 * l.fall;
    }
    return l;
}

static int same_angle(double a, double b)
{
    return fabs(a - b) <= fmax(1e-9 * fmax(fabs(a), fabs(b)), 1e-12);
}

static int varies(const double *values, int count)
{
    for (int i = 1; i < count; i++)
        if (values[i] != values[0]) return 1;
    return 0;
}

int softcat_is_straight(const softcat_structure *s, const double *params, int profiled)
{
    double length = params[s->rest_length], span = parameter(params, s->span, length);
    double drop = parameter(params, s->drop, 0.0), distance = hypot(span, drop);
    int held = s->first != SOFTCAT_FREE && s->last != SOFTCAT_FREE;
    if (parameter(params, s->curvature, 0.0) != 0.0) return 0;
    if (parameter(params, s->twist, 0.0) != 0.0 || s->natural_count) return 0;
    if (s->z >= 0 && !s->model->differential[s->y]) return 0;
    for (int i = 0; i < s->initial_bending_count; i++)
        if (s->initial_bending[i] != 0.0) return 0;
    if (varies(s->initial_mean, s->initial_mean_count)) return 0;
    if (!held) return 1;
    double along = atan2(-drop, span);
    if (s->first == SOFTCAT_CLAMPED
        && !same_angle(parameter(params, s->left_angle, 0.0), along)) return 0;
    if (s->last == SOFTCAT_CLAMPED
        && !same_angle(parameter(params, s->right_angle, 0.0), along)) return 0;
    if (length * s->stretch > distance * (1.0 + 1e-12)) return 0;
    return !(profiled && fabs(length - distance) > 1e-12 * fmax(length, distance));
}

/* Where a slot is in site i. */
static double place_of(const softcat_structure *s, int slot, int sites, const double *X, int i)
{
    return s->on_cells[slot] && i + 1 < sites ? 0.5 * (X[i] + X[i + 1]) : X[i];
}

void softcat_straight(const softcat_structure *s, const double *params, int sites, const double *X,
                      double *state)
{
    int slots = s->model->slots;
    line l = straight_line(s, params);
    memset(state, 0, (size_t)sites * (size_t)slots * sizeof(double));
    for (int i = 0; i < sites; i++) {
        double *site = state + (size_t)i * (size_t)slots;
        for (int k = 0; k < slots; k++) {
            double at = place_of(s, k, sites, X, i);
            if (k == s->x) site[k] = l.x + l.run * at;
            else if (k == s->y) site[k] = l.y - l.fall * at;
            else if (k == s->psi) site[k] = l.angle;
            else if (s->q >= 0 && k == s->q) site[k] = cos(0.5 * l.angle);
            else if (s->q >= 0 && k == s->q + 3) site[k] = sin(0.5 * l.angle);
            else if (s->mean[k] != 0.0 || s->bending[k] != 0.0)
                site[k] = s->mean[k]
                              * (softcat_along(s->initial_mean, s->initial_mean_count, at)
                                 + log(s->stretch))
                          + s->bending[k]
                                * softcat_along(s->initial_bending, s->initial_bending_count, at);
        }
    }
}

/* Lagrange's cubic through the four places around `at`, of a slot. */
static double cubic(const softcat_structure *s, const softcat_table *table, int slot, double at)
{
    int slots = softcat_structure_slots(s, 0), count = table->rows - (s->on_cells[slot] ? 1 : 0), first = 0;
    while (first + 4 < count && place_of(s, slot, table->rows, table->X, first + 2) <= at) first++;
    double sum = 0.0;
    for (int i = first; i < first + 4; i++) {
        double part = table->values[(size_t)i * (size_t)slots + (size_t)slot];
        double here = place_of(s, slot, table->rows, table->X, i);
        for (int j = first; j < first + 4; j++) {
            double there = place_of(s, slot, table->rows, table->X, j);
            if (j != i) part *= (at - there) / (here - there);
        }
        sum += part;
    }
    return sum;
}

static int far_apart(double a, double b)
{
    return !(fabs(a - b) <= 1e-9);
}

/* Whether the ends of a table are where the supports are. */
static int meets(const softcat_structure *s, const double *params, const softcat_table *table)
{
    softcat_supports at = softcat_supports_at(s, params, 0.0);
    int slots = softcat_structure_slots(s, 0);
    const double *first = table->values;
    const double *last = first + (size_t)(table->rows - 1) * (size_t)slots;
    const int *left = s->model->held_first, *right = s->model->held_last;
    double left_x = s->first == SOFTCAT_SYMMETRY ? 0.0 : at.left_x;
    if (s->x >= 0 && left[s->x] && far_apart(first[s->x], left_x)) return 0;
    if (s->x >= 0 && right[s->x] && far_apart(last[s->x], at.right_x)) return 0;
    if (s->z >= 0 && left[s->z] && far_apart(first[s->z], 0.0)) return 0;
    if (s->z >= 0 && right[s->z] && far_apart(last[s->z], at.right_z)) return 0;
    if (left[s->y] && far_apart(first[s->y], 0.0)) return 0;
    return !(right[s->y] && far_apart(last[s->y], at.right_y));
}

int softcat_from_table(const softcat_structure *s, const double *params, const softcat_table *table,
                       int sites, const double *X, double *state)
{
    int slots = softcat_structure_slots(s, 0), same = table->rows == sites;
    int kept = slots == s->model->slots ? slots : s->plain_slots;
    double begins = s->first == SOFTCAT_SYMMETRY ? 0.0 : -0.5;
    if (table->rows < 6 || !table->X || !table->values) return SOFTCAT_BAD_START;
    for (int i = 1; i < table->rows; i++)
        if (!(table->X[i] > table->X[i - 1])) return SOFTCAT_BAD_START;
    if (far_apart(table->X[0], begins) || far_apart(table->X[table->rows - 1], 0.5))
        return SOFTCAT_BAD_START;
    for (size_t i = 0; i < (size_t)table->rows * (size_t)slots; i++)
        if (!isfinite(table->values[i])) return SOFTCAT_BAD_START;
    if (!meets(s, params, table)) return SOFTCAT_BAD_START;
    for (int i = 0; i < sites && same; i++) same = fabs(table->X[i] - X[i]) <= 1e-12;
    for (int i = 0; i < sites; i++)
        for (int k = 0; k < kept; k++) {
            size_t n = (size_t)i * (size_t)slots + (size_t)k;
            state[(size_t)i * (size_t)s->model->slots + (size_t)k] =
                same ? table->values[n] : cubic(s, table, k, place_of(s, k, sites, X, i));
        }
    return SOFTCAT_SOLVED;
}

int softcat_settle(const softcat_structure *s, const softcat_filament *filament,
                   const softcat_options *options, const double *X, double *state, double *work,
                   softcat_workspace workspace, softcat_status *status)
{
    /* Without inertia and viscous stress the filament hangs from the beginning: sags to begin
     * Newton's method from, in rest lengths. */
    static const double sags[] = {0.0, 0.003, 0.03, 0.1, 0.3};
    int slots = s->model->slots, code = SOFTCAT_SOLVED;
    int tries = s->model->differential[s->y] ? 1 : (int)(sizeof sags / sizeof *sags);
    size_t size = (size_t)filament->sites * (size_t)slots;
    for (int tight = 1; tight >= 0; tight--)
        for (int n = 0; n < tries; n++) {
            softcat_options how = *options;
            if (tight && how.relative > 1e-8) how.relative = 1e-8;
            memcpy(work, state, size * sizeof(double));
            for (int i = 0; i < filament->sites && sags[n] > 0.0; i++)
                work[(size_t)i * (size_t)slots + (size_t)s->y] -=
                    sags[n] * (1.0 - 4.0 * X[i] * X[i]);
            code = softcat_consistent(s->model, filament, &how, 0.0, work, workspace, status);
            if (code == SOFTCAT_MEMORY || code == SOFTCAT_ARGUMENT) return code;
            if (code) continue;
            memcpy(state, work, size * sizeof(double));
            return SOFTCAT_SOLVED;
        }
    return code;
}
