/* Factors of a band matrix by Gaussian elimination with scaled partial pivoting. */
#ifndef SOFTCAT_BAND_H
#define SOFTCAT_BAND_H

#include <stddef.h>

typedef struct softcat_band {
    int size, lower, upper; /* order, diagonals below and above the main one */
    int width;              /* stored columns of a row, a multiple of four */
    int below;              /* stored multipliers of a column, a multiple of four */
    double *rows;           /* [size * width] A(i, j) at rows[i * width + j - i + lower] */
    double *multipliers;    /* [size * below] column by column */
    double *inverse;        /* [size] one over the pivots */
    double *scale;          /* [size] one over the largest number of each row */
    double *right;          /* [size + below + width] right-hand side, padded with zeros */
    int *pivot;             /* [size] row exchanged with each */
    int *last;              /* [size] last column of each row of U */
} softcat_band;

/* Allocate; 0, or 1 if there is no memory (softcat_band_free is still to be called). */
int softcat_band_new(softcat_band *, int size, int lower, int upper);
void softcat_band_free(softcat_band *);

/* Factorise what stands in `rows` (zero where nothing was set): 0, or a SOFTCAT_ code. */
int softcat_band_factorise(softcat_band *);

/* Solve for the right-hand side in `right`, which becomes the solution. */
void softcat_band_solve(const softcat_band *);

#endif
