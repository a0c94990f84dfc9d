/* f = J y - cubic y^3 for any pattern: parameters = slots, entries, cubic, then rows, offsets and
 * columns; places are the entries of J. The powers are the sum and the sum of squares. */
#include "softcat_model.h"

#include <stddef.h>

int linear_rates(const softcat_filament *filament, double t, const double *y, double *f, double *scratch);
int linear_jacobian(const softcat_filament *filament, double t, const double *y, double *j, double *scratch);
int linear_work(const softcat_filament *filament, double t, const double *y, double *powers, double *scratch);
int linear_work_slope(const softcat_filament *filament, double t, const double *y, double *slope, double *scratch);

int linear_rates(const softcat_filament *filament, double t, const double *y, double *f, double *scratch)
{
    const double *p = filament->parameters;
    int slots = (int)p[0], entries = (int)p[1], sites = filament->sites;
    (void)t, (void)scratch;
    for (int i = 0; i < sites * slots; i++) f[i] = -p[2] * y[i] * y[i] * y[i];
    for (int site = 0; site < sites; site++)
        for (int e = 0; e < entries; e++) {
            int row = (int)p[3 + e], other = site + (int)p[3 + entries + e], column = (int)p[3 + 2 * entries + e];
            if (other < 0 || other >= sites) continue;
            f[site * slots + row] += filament->places[site * entries + e] * y[other * slots + column];
        }
    return 0;
}

int linear_jacobian(const softcat_filament *filament, double t, const double *y, double *j, double *scratch)
{
    const double *p = filament->parameters;
    int slots = (int)p[0], entries = (int)p[1];
    (void)t, (void)scratch;
    for (int site = 0; site < filament->sites; site++)
        for (int e = 0; e < entries; e++) {
            double value = y[site * slots + (int)p[3 + e]];
            int diagonal = p[3 + e] == p[3 + 2 * entries + e] && p[3 + entries + e] == 0.0;
            j[site * entries + e] =
                filament->places[site * entries + e] - (diagonal ? 3.0 * p[2] * value * value : 0.0);
        }
    return 0;
}

int linear_work(const softcat_filament *filament, double t, const double *y, double *powers, double *scratch)
{
    int slots = (int)filament->parameters[0];
    (void)t, (void)scratch;
    powers[0] = powers[1] = 0.0;
    for (int i = 0; i < filament->sites * slots; i++) {
        powers[0] += y[i];
        powers[1] += y[i] * y[i];
    }
    return 0;
}

int linear_work_slope(const softcat_filament *filament, double t, const double *y, double *slope, double *scratch)
{
    int unknowns = filament->sites * (int)filament->parameters[0];
    (void)t, (void)scratch;
    for (int i = 0; i < unknowns; i++) {
        slope[i] = 1.0;
        slope[unknowns + i] = 2.0 * y[i];
    }
    return 0;
}
