/* The grid of a filament, and the geometry of its sites that softcat_model asks for. */
#ifndef SOFTCAT_PLACES_H
#define SOFTCAT_PLACES_H

#include "softcat_solve.h"

/* Numbers of a node's position: 2, or 3 in three dimensions. */
int softcat_axes(const softcat_structure *);

/* Number of nodes, and of the node at X = 0. */
int softcat_sites(const softcat_structure *, int cells);
int softcat_middle(const softcat_structure *, int cells);

/* X [sites] in rest lengths: cell lengths in geometric progression towards the supports. */
void softcat_nodes(const softcat_structure *, int cells, double grading, double *X);

/* places [sites * model->places] of a grid; thickness [count] relative, or NULL. */
void softcat_places(const softcat_structure *, int cells, const double *X, const double *thickness,
                    int count, double *places);

/* Values given at equal distances from X = -1/2 to 1/2, linear between, at X. */
double softcat_along(const double *values, int count, double X);

#endif
