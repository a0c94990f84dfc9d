/* Where the fibres of a section are, and a structure for any number of them. */
#ifndef SOFTCAT_SECTION_H
#define SOFTCAT_SECTION_H

#include "softcat_linear.h"
#include "softcat_solve.h"

/* A structure with the number of fibres of one run. */
typedef struct softcat_sized {
    softcat_structure structure; /* its tables are as long as the model below says */
    softcat_model model;         /* what structure.model is to point to, where this one stays */
    double *points;              /* [tables * structure.points] of a softcat_filament; or NULL */
} softcat_sized;

/* Size a structure in this memory, which stays in use; fibres 0: as the scene. With a memory that
 * only counts, its numbers alone: its tables are then read through softcat_view_of. 0 or a code. */
int softcat_size(const softcat_structure *, const double *params, int fibres, softcat_memory *,
                 softcat_sized *);
softcat_view softcat_view_of(const softcat_structure *, const softcat_sized *);

/* The slot that is called so with the scene's fibres; of other fibres the first of its kind. */
int softcat_slot_of_scene(const softcat_structure *, const softcat_sized *, int slot);

/* Points of a section that is asked for so many fibres; 0 if there cannot be so many. */
int softcat_points(const softcat_structure *, int fibres);

/* Doubles of a point: coordinate from -1 to 1 through the thickness and share of the section; or
 * two coordinates, what a twist shears there along either, and the share. */
int softcat_tables(const softcat_structure *);

/* The points: all of one table, then all of the next. `width`: over thickness. `room` has
 * softcat_rule_room doubles. */
void softcat_rule(softcat_section, int fibres, int points, double width, double *tables,
                  double *room);
size_t softcat_rule_room(softcat_section, int points);

#endif
