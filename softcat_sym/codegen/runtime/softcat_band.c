#include "softcat_band.h"

#include "softcat_model.h"
#include "softcat_vectors.h"

#include <math.h>
#include <string.h>

enum { FOUR = 4, SQUARE = FOUR * FOUR };

/* A row takes the place of another whose pivot is smaller by this factor (Duff, Erisman & Reid,
 * Direct Methods for Sparse Matrices, 2nd ed., Oxford 2017, section 5.2). Few are: where all stay,
 * the factors are applied four unknowns at a time. */
static const double threshold = 0.01;

void softcat_band_take(softcat_band *band, softcat_memory *memory, int size, int lower, int upper)
{
    size_t n = (size_t)softcat_fours(size);
    band->size = size;
    band->lower = lower;
    band->upper = upper;
    /* Exchanged rows reach `lower` further; three more keep a rounded-up loop within its row. */
    band->width = softcat_fours(2 * lower + upper + 1 + 3);
    band->below = softcat_fours(lower);
    band->above = softcat_fours(upper);
    size_t below = (size_t)band->below, above = (size_t)band->above;
    band->rows = softcat_take_doubles(memory, (n + FOUR + below) * (size_t)band->width);
    band->forward = softcat_take_doubles(memory, n * (FOUR + below));
    band->backward = softcat_take_doubles(memory, n * (FOUR + above));
    band->inverse = softcat_take_doubles(memory, n);
    band->scale = softcat_take_doubles(memory, n);
    band->padded = softcat_take_doubles(memory, above + n + below + (size_t)band->width);
    band->right = band->padded ? band->padded + above : NULL;
    band->pivot = softcat_take_ints(memory, n);
    band->last = softcat_take_ints(memory, n);
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

/* The row whose pivot in column j is taken: 0, or a SOFTCAT_ code. */
static int choose_pivot(const softcat_band *band, int j, int end, int *chosen)
{
    const double *column = band->rows + (size_t)j * (size_t)band->width + band->lower;
    const double *scale = band->scale;
    double own = fabs(*column) * scale[j], best = own;
    *chosen = j;
    for (int i = j + 1; i <= end; i++) {
        column += band->width - 1;
        double size = fabs(*column) * scale[i];
        best = size > best ? size : best;
    }
    if (!isfinite(best)) return SOFTCAT_NON_FINITE;
    if (best == 0.0) return SOFTCAT_SINGULAR;
    if (own >= threshold * best) return SOFTCAT_SOLVED;
    for (*chosen = end; fabs(*column) * scale[*chosen] != best; --*chosen)
        column -= band->width - 1;
    return SOFTCAT_SOLVED;
}

/* What y of four rows does, L y = b: to themselves (the inverse of their square), and below. */
static void pack_forward(const softcat_band *band, int first, double *panel)
{
    size_t step = (size_t)band->width - 1;
    const double *corner = band->rows + (size_t)first * (size_t)band->width + band->lower;
    const double *one = corner + step, *two = one + step, *three = two + step;
    double l10 = one[0], l20 = two[0], l21 = two[1], l30 = three[0], l31 = three[1];
    double l32 = three[2], i20 = l21 * l10 - l20, i31 = l32 * l21 - l31;
    double i30 = -l30 - l31 * -l10 - l32 * i20;
    const double square[SQUARE] = {1.0, -l10, i20, i30, 0.0, 1.0, -l21, i31,
                                   0.0, 0.0,  1.0, -l32, 0.0, 0.0, 0.0, 1.0};
    memcpy(panel, square, sizeof square);
    const double *left = three + step;
    for (int r = 0; r < band->below; r++, left += step) {
        /* Beyond the band stand numbers of other columns. */
        int from = r + FOUR - band->lower;
        double a = from <= 0 ? left[0] : 0.0, b = from <= 1 ? left[1] : 0.0;
        double c = from <= 2 ? left[2] : 0.0, d = from <= 3 ? left[3] : 0.0;
        double *to = panel + SQUARE * (1 + r / FOUR) + r % FOUR;
        to[0] = -a + b * l10 - c * i20 - d * i30;
        to[FOUR] = -b + c * l21 - d * i31;
        to[2 * FOUR] = -c + d * l32;
        to[3 * FOUR] = -d;
    }
}

/* What x of four rows does, U x = y: to themselves, and above, the nearest first. */
static void pack_backward(const softcat_band *band, int first, double *panel)
{
    size_t step = (size_t)band->width - 1;
    const double *zero = band->rows + (size_t)first * (size_t)band->width + band->lower;
    const double *one = zero + step, *two = one + step;
    const double *over = band->inverse + first;
    double i00 = over[0], i11 = over[1], i22 = over[2], i33 = over[3];
    double i01 = -zero[1] * i11 * i00, i12 = -one[2] * i22 * i11, i23 = -two[3] * i33 * i22;
    double i02 = -(zero[1] * i12 + zero[2] * i22) * i00;
    double i13 = -(one[2] * i23 + one[3] * i33) * i11;
    double i03 = -(zero[1] * i13 + zero[2] * i23 + zero[3] * i33) * i00;
    const double square[SQUARE] = {i00, 0.0, 0.0, 0.0, i01, i11, 0.0, 0.0,
                                   i02, i12, i22, 0.0, i03, i13, i23, i33};
    memcpy(panel, square, sizeof square);
    for (int r = 1; r <= band->above && r <= first; r++) {
        const double *right = zero - (size_t)r * step;
        double a = r <= band->upper ? right[0] : 0.0, b = r + 1 <= band->upper ? right[1] : 0.0;
        double c = r + 2 <= band->upper ? right[2] : 0.0, d = r + 3 <= band->upper ? right[3] : 0.0;
        double *to = panel + SQUARE * (1 + (r - 1) / FOUR) + (FOUR - 1) - (r - 1) % FOUR;
        to[0] = -a * i00;
        to[FOUR] = -a * i01 - b * i11;
        to[2 * FOUR] = -a * i02 - b * i12 - c * i22;
        to[3 * FOUR] = -a * i03 - b * i13 - c * i23 - d * i33;
    }
}

int softcat_band_factorise(softcat_band *band)
{
    int n = band->size, lower = band->lower, upper = band->upper, reach = 0;
    size_t width = (size_t)band->width;
    int code = scale_rows(band);
    band->exchanged = 0;
    for (int j = 0; j < n && !code; j++) {
        int end = j + lower < n - 1 ? j + lower : n - 1, p = j;
        code = choose_pivot(band, j, end, &p);
        if (code) return code;
        if (p + upper > reach) reach = p + upper < n - 1 ? p + upper : n - 1;
        double *pivot = band->rows + (size_t)j * width + (size_t)lower;
        if (p != j) {
            double *other = band->rows + (size_t)p * width + (size_t)(j - p + lower);
            exchange(pivot, other, reach - j + 1);
            band->scale[p] = band->scale[j];
            band->exchanged = 1;
        }
        band->pivot[j] = p;
        band->last[j] = reach;
        double inverse = 1.0 / pivot[0], *row = pivot;
        band->inverse[j] = inverse;
        for (int i = j + 1; i <= end; i++) {
            row += width - 1;
            if (row[0] == 0.0) continue;
            row[0] *= inverse;
            softcat_add(row + 1, pivot + 1, -row[0], reach - j);
        }
    }
    for (int j = 0; j < n && !code && !band->exchanged; j += FOUR) {
        pack_forward(band, j, band->forward + j * (FOUR + band->below));
        pack_backward(band, j, band->backward + j * (FOUR + band->above));
    }
    return code;
}

/* to = or += panel * x of as many fours, each a square column by column. */
static inline void apply(double *restrict to, const double *restrict panel, const double *x, int add)
{
    double sum[FOUR];
    for (int l = 0; l < FOUR; l++)
        sum[l] = (panel[l] * x[0] + panel[FOUR + l] * x[1])
                 + (panel[2 * FOUR + l] * x[2] + panel[3 * FOUR + l] * x[3]);
    for (int l = 0; l < FOUR; l++) to[l] = add ? to[l] + sum[l] : sum[l];
}

static void solve_by_fours(const softcat_band *band)
{
    double *b = band->right, *end = b + softcat_fours(band->size), x[FOUR];
    const double *panel = band->forward;
    for (; b < end; b += FOUR) {
        memcpy(x, b, sizeof x);
        apply(b, panel, x, 0);
        panel += SQUARE;
        for (int r = FOUR; r <= band->below; r += FOUR, panel += SQUARE) apply(b + r, panel, x, 1);
    }
    panel = band->backward + softcat_fours(band->size) * (FOUR + band->above);
    for (b = end - FOUR; b >= band->right; b -= FOUR) {
        memcpy(x, b, sizeof x);
        panel -= FOUR * (FOUR + band->above);
        apply(b, panel, x, 0);
        for (int r = FOUR; r <= band->above; r += FOUR) apply(b - r, panel + FOUR * r, x, 1);
    }
}

/* The same row by row, with rows that were exchanged. */
static void solve_by_rows(const softcat_band *band)
{
    int n = band->size;
    double *b = band->right;
    for (int j = 0; j < n; j++) {
        int p = band->pivot[j], end = j + band->lower < n - 1 ? j + band->lower : n - 1;
        const double *times = band->rows + (size_t)j * (size_t)band->width + band->lower;
        double value = b[p];
        b[p] = b[j];
        b[j] = value;
        for (int i = j + 1; i <= end; i++) {
            times += band->width - 1;
            b[i] -= *times * value;
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        const double *row = band->rows + (size_t)i * (size_t)band->width + band->lower + 1;
        b[i] = (b[i] - softcat_dot(row, b + i + 1, band->last[i] - i)) * band->inverse[i];
    }
}

void softcat_band_solve(const softcat_band *band)
{
    /* What was not finite in the last solve must not linger in the padding. */
    memset(band->padded, 0, (size_t)band->above * sizeof(double));
    memset(band->right + band->size, 0, (size_t)(band->below + band->width) * sizeof(double));
    if (band->exchanged) solve_by_rows(band);
    else solve_by_fours(band);
}
