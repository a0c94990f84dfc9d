/* Coefficients of Rosenbrock methods. */
#ifndef SOFTCAT_METHODS_H
#define SOFTCAT_METHODS_H

enum { SOFTCAT_MOST_STAGES = 8, SOFTCAT_MOST_DENSE = 3 };

/* Stages k_i of a step h from y(t), in the form without products J k (Hairer & Wanner 1996,
 * section IV.7; Kaps, Poon & Bui 1985):
 *   (M / (h gamma) - J) k_i = f(t + time_i h, y + sum_j a_ij k_j)
 *                             + M sum_j (c_ij / h) k_j + h slope_i df/dt,
 * y_1 = y + sum_j a_sj k_j + k_s: the last row of `a` and k_s itself (stiffly accurate). The
 * error is estimated by k_s, or by k_s - k_embedded. Dense output, 0 <= x <= 1 (ibid.):
 *   y(t + x h) = (1 - x) y + x (y_1 + (1 - x) (K_1 + x (K_2 + x K_3))), K_m = sum_j dense_mj k_j */
typedef struct softcat_method {
    const char *name;
    int stages, error_order; /* the estimate is O(h^error_order) */
    int dense_rows;
    int embedded;            /* stage that ends the embedded method in place of the last, or -1 */
    double gamma;
    double a[SOFTCAT_MOST_STAGES][SOFTCAT_MOST_STAGES];
    double c[SOFTCAT_MOST_STAGES][SOFTCAT_MOST_STAGES];
    double time[SOFTCAT_MOST_STAGES], slope[SOFTCAT_MOST_STAGES];
    double dense[SOFTCAT_MOST_DENSE][SOFTCAT_MOST_STAGES];
} softcat_method;

/* The method of a softcat_options, or NULL. */
const softcat_method *softcat_method_of(int method);

#endif
