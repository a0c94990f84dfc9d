#include "softcat_band.h"

#include "softcat_model.h"
#include "softcat_vectors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int softcat_band_new(softcat_band *band, int size, int lower, int upper)
{
    size_t n = (size_t)size;
    band->size = size;
    band->lower = lower;
    band->upper = upper;
    /* Exchanged rows reach `lower` further; three more keep a rounded-up loop within its row. */
    band->width = softcat_fours(2 * lower + upper + 1 + 3);
    band->below = softcat_fours(lower);
    band->rows = calloc(n * (size_t)band->width + 1, sizeof(double));
    band->multipliers = calloc(n * (size_t)band->below + 1, sizeof(double));
    band->inverse = calloc(n + 1, sizeof(double));
    band->scale = calloc(n + 1, sizeof(double));
    band->right = calloc(n + (size_t)band->below + (size_t)band->width + 1, sizeof(double));
    band->pivot = calloc(n + 1, sizeof(int));
    band->last = calloc(n + 1, sizeof(int));
    return !(band->rows && band->multipliers && band->inverse && band->scale && band->right
             && band->pivot && band->last);
}

void softcat_band_free(softcat_band *band)
{
    free(band->rows);
    free(band->multipliers);
    free(band->inverse);
    free(band->scale);
    free(band->right);
    free(band->pivot);
    free(band->last);
}

/* Rows may have any unit (momentum, geometry, a flow rule): pivots are compared in units of the
 * largest number of their row. */
static int scale_rows(softcat_band *band)
{
    int filled = band->lower + band->upper + 1;
    for (int i = 0; i < band->size; i++) {
        const double *row = band->rows + (size_t)i * (size_t)band->width;
        double largest = 0.0, sum = 0.0;
        for (int c = 0; c < filled; c++) {
            double size = fabs(row[c]);
            largest = size > largest ? size : largest;
            sum += size; /* a comparison alone would pass over what is not a number */
        }
        if (!isfinite(sum)) return SOFTCAT_NON_FINITE;
        if (largest == 0.0) return SOFTCAT_SINGULAR;
        band->scale[i] = 1.0 / largest;
    }
    return SOFTCAT_SOLVED;
}

static void exchange(double *restrict a, double *restrict b, int count)
{
    for (int c = 0; c < count; c++) {
        double kept = a[c];
        a[c] = b[c];
        b[c] = kept;
    }
}

int softcat_band_factorise(softcat_band *band)
{
    int n = band->size, lower = band->lower, upper = band->upper, reach = 0;
    size_t width = (size_t)band->width;
    int code = scale_rows(band);
    if (code) return code;
    for (int j = 0; j < n; j++) {
        int end = j + lower < n - 1 ? j + lower : n - 1, p = j;
        double best = -1.0;
        for (int i = j; i <= end; i++) {
            double entry = band->rows[(size_t)i * width + (size_t)(j - i + lower)];
            double size = fabs(entry) * band->scale[i];
            if (size > best) {
                best = size;
                p = i;
            }
        }
        if (best == 0.0) return SOFTCAT_SINGULAR;
        if (!isfinite(best) || best < 0.0) return SOFTCAT_NON_FINITE;
        if (p + upper > reach) reach = p + upper < n - 1 ? p + upper : n - 1;
        double *pivot = band->rows + (size_t)j * width + (size_t)lower;
        if (p != j) {
            double *other = band->rows + (size_t)p * width + (size_t)(j - p + lower);
            exchange(pivot, other, reach - j + 1);
            band->scale[p] = band->scale[j];
        }
        band->pivot[j] = p;
        band->last[j] = reach;
        double *multipliers = band->multipliers + (size_t)j * (size_t)band->below;
        double inverse = 1.0 / pivot[0];
        band->inverse[j] = inverse;
        for (int i = j + 1; i <= end; i++) {
            double *row = band->rows + (size_t)i * width + (size_t)(j - i + lower);
            double times = row[0] * inverse;
            multipliers[i - j - 1] = times;
            if (times != 0.0) softcat_add(row + 1, pivot + 1, -times, reach - j);
        }
    }
    return SOFTCAT_SOLVED;
}

void softcat_band_solve(const softcat_band *band)
{
    int n = band->size;
    double *b = band->right;
    /* What was not finite in the last solve must not linger in the padding. */
    memset(b + n, 0, (size_t)(band->below + band->width) * sizeof(double));
    for (int j = 0; j < n; j++) {
        const double *multipliers = band->multipliers + (size_t)j * (size_t)band->below;
        int p = band->pivot[j];
        double value = b[p];
        b[p] = b[j];
        b[j] = value;
        if (value != 0.0) softcat_add(b + j + 1, multipliers, -value, band->below);
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = band->rows + (size_t)i * (size_t)band->width + band->lower + 1;
        const double *known = b + i + 1;
        b[i] = (b[i] - softcat_dot(row, known, band->last[i] - i)) * band->inverse[i];
    }
}
