#include "softcat_check.h"

#include "softcat_places.h"

#include <math.h>

enum { MOST_CELLS = 1000000 };

int softcat_structure_row(const softcat_structure *s, int cells)
{
    if (cells < s->least_cells || cells > MOST_CELLS) return 0;
    return softcat_axes(s) * softcat_sites(s, cells);
}

static int within(double value, softcat_range range)
{
    if (!isfinite(value)) return 0;
    if (range == SOFTCAT_POSITIVE) return value > 0.0;
    if (range == SOFTCAT_NOT_NEGATIVE) return value >= 0.0;
    return range != SOFTCAT_POISSON || (value > -1.0 && value < 0.5);
}

/* Whether a parameter is the time of a row that begins with one. */
static int is_time(int parameter, int first, int rows, int width)
{
    int at = first >= 0 ? parameter - first : -1;
    return at >= 0 && at < width * rows && at % width == 0;
}

static int check_settings(const softcat_structure *s, const softcat_settings *c)
{
    const double numbers[] = {c->grading, c->relative, c->absolute, c->largest_step};
    for (int i = 0; i < 4; i++)
        if (!within(numbers[i], SOFTCAT_NOT_NEGATIVE)) return SOFTCAT_BAD_SETTINGS;
    int slots = softcat_structure_slots(s, c->fibres);
    if (!slots) return SOFTCAT_BAD_FIBRES;
    for (int k = 0; c->absolutes && k < slots; k++)
        if (!within(c->absolutes[k], SOFTCAT_POSITIVE)) return SOFTCAT_BAD_SETTINGS;
    if (c->relative >= 1.0 || c->max_steps < 0 || c->by_count < 0 || c->kink_count < 0)
        return SOFTCAT_BAD_SETTINGS;
    if (c->method < 0 || c->method > SOFTCAT_RODAS3P) return SOFTCAT_BAD_SETTINGS;
    if (c->thickness && (!s->profiled || c->thickness_count < 1)) return SOFTCAT_BAD_SETTINGS;
    for (int i = 0; c->thickness && i < c->thickness_count; i++)
        if (!within(c->thickness[i], SOFTCAT_POSITIVE)) return SOFTCAT_BAD_SETTINGS;
    if ((c->kink_count && !c->kinks) || (c->by_count && !c->by)) return SOFTCAT_BAD_SETTINGS;
    for (int i = 0; i < c->kink_count; i++)
        if (!isfinite(c->kinks[i])) return SOFTCAT_BAD_SETTINGS;
    for (int d = 0; d < c->by_count; d++) {
        int k = c->by[d];
        if (k < 0 || k >= s->model->parameters || k == s->time_scale) return SOFTCAT_BAD_SETTINGS;
        if (is_time(k, s->motion, s->motion_rows, s->motion_width)) return SOFTCAT_BAD_SETTINGS;
        if (is_time(k, s->turn, s->turn_rows, 2)) return SOFTCAT_BAD_SETTINGS;
        if (c->by_step && !within(c->by_step[d], SOFTCAT_POSITIVE)) return SOFTCAT_BAD_SETTINGS;
    }
    return SOFTCAT_SOLVED;
}

int softcat_check(const softcat_structure *s, const double *params, int cells,
                  const double *times, int n, const softcat_settings *settings, int *which)
{
    if (!params) return SOFTCAT_ARGUMENT;
    for (int k = 0; k < s->model->parameters; k++) {
        softcat_range range = s->parameter_ranges[k];
        *which = k;
        if (!within(params[k], range)) return SOFTCAT_BAD_PARAMETER;
    }
    *which = s->time_scale;
    if (params[s->time_scale] == 0.0 && !(s->gravity >= 0 && params[s->gravity] > 0.0))
        return SOFTCAT_BAD_PARAMETER;
    *which = -1;
    if (!softcat_structure_row(s, cells)) return SOFTCAT_BAD_CELLS;
    if (n < 1 || !times) return SOFTCAT_BAD_TIMES;
    for (int i = 0; i < n; i++)
        if (!isfinite(times[i]) || times[i] < 0.0 || (i > 0 && !(times[i] > times[i - 1])))
            return SOFTCAT_BAD_TIMES;
    return settings ? check_settings(s, settings) : SOFTCAT_SOLVED;
}

const char *softcat_explain(int code)
{
    switch (code) {
    case SOFTCAT_BAD_PARAMETER: return "a parameter is not finite or out of range";
    case SOFTCAT_BAD_CELLS: return "the number of cells per half span is too small or too large";
    case SOFTCAT_BAD_TIMES: return "times must be finite, increasing, not negative, at least one";
    case SOFTCAT_BAD_SETTINGS: return "a setting is out of range, or not one of this structure";
    case SOFTCAT_BAD_START:
        return "the starting shape is no table of this structure, or does not meet the supports";
    case SOFTCAT_NOT_STRAIGHT:
        return "the filament does not begin straight with these parameters: give a starting shape";
    case SOFTCAT_BAD_FIBRES: return "the number of fibres is not 2 to 1000, or there are none";
    default: return softcat_message(code);
    }
}
