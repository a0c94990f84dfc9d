/* Loops over short vectors whose lengths are rounded up to fours and padded with zeros, so that
 * they have no remainder: the bands and sections of a filament are only some ten numbers wide. */
#ifndef SOFTCAT_VECTORS_H
#define SOFTCAT_VECTORS_H

static inline int softcat_fours(int n)
{
    return (n + 3) / 4 * 4;
}

static inline void softcat_add(double *restrict to, const double *restrict what, double times,
                               int count)
{
    for (int c = 0; c < count; c += 4) {
        to[c] += times * what[c];
        to[c + 1] += times * what[c + 1];
        to[c + 2] += times * what[c + 2];
        to[c + 3] += times * what[c + 3];
    }
}

static inline double softcat_dot(const double *restrict a, const double *restrict b, int count)
{
    double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
    for (int c = 0; c < count; c += 4) {
        s0 += a[c] * b[c];
        s1 += a[c + 1] * b[c + 1];
        s2 += a[c + 2] * b[c + 2];
        s3 += a[c + 3] * b[c + 3];
    }
    return (s0 + s1) + (s2 + s3);
}

/* to -= panel * x, the panel column by column; to stays in registers meanwhile. */
static inline void softcat_subtract(double *restrict to, const double *restrict panel, int rows,
                                    const double *restrict x, int columns)
{
    for (int r = 0; r < rows; r += 4) {
        double s0 = to[r], s1 = to[r + 1], s2 = to[r + 2], s3 = to[r + 3];
        const double *a = panel + r;
        for (int c = 0; c < columns; c++, a += rows) {
            s0 -= a[0] * x[c];
            s1 -= a[1] * x[c];
            s2 -= a[2] * x[c];
            s3 -= a[3] * x[c];
        }
        to[r] = s0;
        to[r + 1] = s1;
        to[r + 2] = s2;
        to[r + 3] = s3;
    }
}

#endif
