/* Factors of a band matrix by Gaussian elimination with scaled threshold pivoting. */
#ifndef SOFTCAT_BAND_H
#define SOFTCAT_BAND_H

#include "softcat_memory.h"

typedef struct softcat_band {
    int size, lower, upper; /* order, diagonals below and above the main one */
    int width;              /* stored columns of a row, a multiple of four */
    int below, above;       /* lower and upper, rounded up to fours */
    int exchanged;          /* whether the last factorisation exchanged rows */
    double *rows;           /* [size * width] A(i, j) at rows[i * width + j - i + lower]; then L, U */
    double *forward;        /* what four unknowns of L y = b do to themselves and those below */
    double *backward;       /* what four unknowns of U x = y do to themselves and those above */
    double *inverse;        /* [size] one over the pivots */
    double *scale;          /* [size] one over the largest number of each row */
    double *padded;         /* [above + size + below], zero outside of `right` */
    double *right;          /* [size] right-hand side */
    int *pivot;             /* [size] row exchanged with each */
    int *last;              /* [size] last column of each row of U */
} softcat_band;

/* Take its memory. */
void softcat_band_take(softcat_band *, softcat_memory *, int size, int lower, int upper);

/* Factorise what stands in `rows` (zero where nothing was set): 0, or a SOFTCAT_ code. */
int softcat_band_factorise(softcat_band *);

/* Solve for the right-hand side in `right`, which becomes the solution. */
void softcat_band_solve(const softcat_band *);

#endif
