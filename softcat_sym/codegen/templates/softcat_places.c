#include "softcat_places.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

int softcat_axes(const softcat_structure *s)
{
    return s->z >= 0 ? 3 : 2;
}

int softcat_sites(const softcat_structure *s, int cells)
{
    return s->first == SOFTCAT_SYMMETRY ? cells + 1 : 2 * cells + 1;
}

int softcat_middle(const softcat_structure *s, int cells)
{
    return s->first == SOFTCAT_SYMMETRY ? 0 : cells;
}

/* Neighbours differ by grading^(1 / (cells - 1)): the nodes lie on a smooth map of an equal grid,
 * on which differences keep their second order. Under a heavy weight cells are short at midspan,
 * too. */
static double length_of(const softcat_structure *s, int cells, double grading, int i)
{
    if (cells == 1 || grading == 1.0) return 1.0;
    if (!s->towards_middle) return pow(grading, -(double)i / (cells - 1));
    double share = cos(3.14159265358979323846 * (i + 0.5) / cells);
    return pow(grading, -share * share);
}

void softcat_nodes(const softcat_structure *s, int cells, double grading, double *X)
{
    int middle = softcat_middle(s, cells);
    if (s->nodes && cells == s->cells && grading == s->grading) {
        memcpy(X, s->nodes, (size_t)softcat_sites(s, cells) * sizeof(double));
        return;
    }
    double *half = X + middle, sum = 0.0;
    half[0] = 0.0;
    for (int i = 0; i < cells; i++) {
        sum += length_of(s, cells, grading, i);
        half[i + 1] = sum;
    }
    for (int i = 1; i < cells; i++) half[i] /= 2.0 * sum;
    half[cells] = 0.5;
    for (int i = 1; i <= middle; i++) X[middle - i] = -half[i];
}

double softcat_along(const double *values, int count, double X)
{
    if (count == 0) return 0.0;
    if (count == 1) return values[0];
    double at = fmin(fmax((X + 0.5) * (count - 1), 0.0), count - 1.0);
    int left = (int)at;
    if (left == count - 1) left--;
    return values[left] + (at - left) * (values[left + 1] - values[left]);
}

/* Natural twist and curvatures [1/m] of a cell around X: linear between the cells of the scene. */
static void natural(const softcat_structure *s, double X, double *to)
{
    const double *row = s->natural;
    int left = 0;
    while (left + 2 < s->natural_count && row[4 * (left + 1)] <= X) left++;
    for (int k = 1; k < 4 && s->natural_count; k++) {
        const double *a = row + 4 * left, *b = a + (s->natural_count > 1 ? 4 : 0);
        double share = b > a ? (X - a[0]) / (b[0] - a[0]) : 0.0;
        to[k - 1] = share == 1.0 ? b[k] : a[k] + share * (b[k] - a[k]);
    }
}

static double of_cell(const double *X, int sites, int i)
{
    return i >= 0 && i + 1 < sites ? X[i + 1] - X[i] : 0.0;
}

void softcat_places(const softcat_structure *s, int cells, const double *X, const double *thickness,
                    int count, double *places)
{
    int sites = softcat_sites(s, cells), width = s->model->places;
    double hung = s->first == SOFTCAT_SYMMETRY ? 0.5 : 1.0, area_before = 0.0;
    for (int i = 0; i < sites; i++) {
        double known[SOFTCAT_PLACE_COUNT] = {0.0}, h_cell = 1.0, h_node = 1.0;
        double before = of_cell(X, sites, i - 1);
        int has_cell = i + 1 < sites;
        if (s->profiled) h_node = softcat_along(thickness, count, X[i]);
        if (s->profiled && has_cell)
            h_cell = softcat_along(thickness, count, 0.5 * (X[i] + X[i + 1]));
        double area = pow(h_cell, s->area_power), behind = of_cell(X, sites, i);
        known[SOFTCAT_PLACE_X] = X[i];
        known[SOFTCAT_PLACE_CELL] = has_cell ? behind : 1.0; /* the last site has no cell */
        known[SOFTCAT_PLACE_NODE] = 0.5 * (before + behind);
        known[SOFTCAT_PLACE_MASS] = 0.5 * (before * area_before + behind * area);
        known[SOFTCAT_PLACE_PER_CELL] = 1.0 / known[SOFTCAT_PLACE_CELL];
        known[SOFTCAT_PLACE_PER_NODE] = 1.0 / known[SOFTCAT_PLACE_NODE];
        known[SOFTCAT_PLACE_PER_MASS] = 1.0 / known[SOFTCAT_PLACE_MASS];
        known[SOFTCAT_PLACE_H_NODE] = h_node;
        known[SOFTCAT_PLACE_H_CELL] = h_cell;
        known[SOFTCAT_PLACE_HUNG] = i == softcat_middle(s, cells) ? hung : 0.0;
        natural(s, has_cell ? 0.5 * (X[i] + X[i + 1]) : X[i], known + SOFTCAT_PLACE_K0_1);
        for (int k = 0; k < width; k++)
            places[(size_t)i * (size_t)width + (size_t)k] = known[s->places[k]];
        area_before = area;
    }
}
