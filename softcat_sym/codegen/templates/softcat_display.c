#include "softcat_display.h"

#include "softcat_places.h"

#include <math.h>
#include <string.h>

static size_t rows_of(const softcat_display *d, const softcat_filament *filament)
{
    return (size_t)(d->rows + d->rows_each * filament->fibres) * (size_t)filament->sites;
}

size_t softcat_display_scratch(const softcat_display *d, const softcat_session *session)
{
    softcat_filament filament;
    double time;
    softcat_session_state(session, &filament, &time);
    size_t axes = (size_t)softcat_axes(d->structure), sites = (size_t)filament.sites;
    return rows_of(d, &filament) + axes * sites
           + (size_t)(d->scratch + d->scratch_each * filament.fibres) * sites;
}

static double sum_of(const double *rows, int row, int sites)
{
    double sum = 0.0;
    for (int i = 0; row >= 0 && i < sites; i++) sum += rows[row * sites + i];
    return sum;
}

void softcat_display_all(const softcat_display *d, const softcat_session *session, double *out,
                         double *scratch)
{
    const softcat_structure *s = d->structure;
    softcat_filament filament;
    double time, lowest = 0.0, largest = 0.0, work[64];
    const double *state = softcat_session_state(session, &filament, &time);
    int sites = filament.sites, axes = softcat_axes(s), half = s->first == SOFTCAT_SYMMETRY;
    double *rows = scratch, *positions = rows + rows_of(d, &filament);
    softcat_session_positions(session, positions);
    for (int i = 0; i < sites; i++) lowest = fmin(lowest, positions[axes * i + 1]);
    memset(rows, 0, rows_of(d, &filament) * sizeof(double)); /* sums are added to */
    d->observe(&filament, 1, &time, state, rows, positions + axes * sites);
    double scale = d->thickness >= 0 ? filament.parameters[d->thickness] / d->height : 1.0;
    double area = d->area * scale * scale, of_whole = half ? 2.0 * area : area;
    for (int i = 0; i + 1 < sites && d->tension >= 0 && d->moment >= 0; i++) {
        double h = d->relative_thickness >= 0 ? rows[d->relative_thickness * sites + i] : 1.0;
        double height = d->height * scale * h, grown = pow(h, s->area_power);
        double stress = fabs(rows[d->tension * sites + i])
                        + fabs(rows[d->moment * sites + i]) / (d->modulus * height);
        largest = fmax(largest, stress / grown);
    }
    const double *tension = rows + (d->tension >= 0 ? d->tension * sites : 0);
    out[SOFTCAT_OUT_MIDPOINT] = softcat_session_midpoint(session);
    out[SOFTCAT_OUT_SAG] = -lowest;
    out[SOFTCAT_OUT_TENSION_RIGHT] = area * tension[sites - 2];
    out[SOFTCAT_OUT_TENSION_LEFT] = area * tension[half ? sites - 2 : 0];
    out[SOFTCAT_OUT_STRESS] = largest;
    out[SOFTCAT_OUT_KINETIC] = of_whole * sum_of(rows, d->kinetic, sites);
    out[SOFTCAT_OUT_ELASTIC] = of_whole * sum_of(rows, d->elastic, sites);
    out[SOFTCAT_OUT_POTENTIAL] = of_whole * sum_of(rows, d->potential, sites);
    out[SOFTCAT_OUT_DISSIPATED] = 0.0;
    if (d->plastic < 0 || s->model->powers > (int)(sizeof work / sizeof *work)) return;
    softcat_session_work(session, work);
    out[SOFTCAT_OUT_DISSIPATED] = of_whole * work[d->plastic];
}
