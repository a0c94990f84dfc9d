/* Positions and midpoint of a filament over time, from parameters in SI units.
 *
 * A generated filament.c describes one structure (law, section, ends, effects) by a
 * softcat_structure; filament.h calls what is declared here with it. Lengths are in metres, times
 * in seconds, positions x to the right and y upwards from the left support, with x = 0 halfway
 * between the supports, and in three dimensions z towards the viewer. Everything is re-entrant:
 * there is no global state, and any number of threads may solve at once. Nothing is allocated: a
 * solve works in memory of the caller's, of which softcat_structure_workspace_size says how much it
 * needs. */
#ifndef SOFTCAT_SOLVE_H
#define SOFTCAT_SOLVE_H

#include "softcat_rosenbrock.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Codes beyond those of softcat_model.h; softcat_explain has a sentence for every one. */
enum {
    SOFTCAT_BAD_PARAMETER = 100, /* not finite or out of range; its number is status->worst_slot */
    SOFTCAT_BAD_CELLS,           /* below softcat_structure.least_cells or above a million */
    SOFTCAT_BAD_TIMES,           /* n < 1, not finite, not increasing, or before 0 */
    SOFTCAT_BAD_SETTINGS,        /* a number in softcat_settings is out of range */
    SOFTCAT_BAD_START,           /* the starting shape is no table, or does not meet the supports */
    SOFTCAT_NOT_STRAIGHT,        /* the filament does not begin straight: give a starting shape */
    SOFTCAT_BAD_FIBRES           /* not 2 to 1000, or the structure has none */
};

typedef enum softcat_end {
    SOFTCAT_SYMMETRY, SOFTCAT_CLAMPED, SOFTCAT_PINNED, SOFTCAT_FREE
} softcat_end;

typedef enum softcat_range {
    SOFTCAT_ANY, SOFTCAT_NOT_NEGATIVE, SOFTCAT_POSITIVE, SOFTCAT_POISSON /* -1 < nu < 1/2 */
} softcat_range;

/* How the fibres of a section are placed: through the thickness by Gauss's rule for its width, or
 * by one in either half; in three dimensions on rings, or on a grid of what warps. */
typedef enum softcat_section {
    SOFTCAT_RECTANGLE, SOFTCAT_RECTANGLE_IN_HALVES, SOFTCAT_CIRCLE, SOFTCAT_CIRCLE_IN_HALVES,
    SOFTCAT_RINGS, SOFTCAT_WARPING
} softcat_section;

/* Geometry of a site: lengths in rest lengths that its cell has and its node answers for, the mass
 * of the node over that of the filament, their inverses, thickness and share of a point mass. */
typedef enum softcat_place {
    SOFTCAT_PLACE_X, SOFTCAT_PLACE_CELL, SOFTCAT_PLACE_NODE, SOFTCAT_PLACE_MASS,
    SOFTCAT_PLACE_PER_CELL, SOFTCAT_PLACE_PER_NODE, SOFTCAT_PLACE_PER_MASS,
    SOFTCAT_PLACE_H_NODE, SOFTCAT_PLACE_H_CELL, SOFTCAT_PLACE_HUNG,
    SOFTCAT_PLACE_K0_1, SOFTCAT_PLACE_K0_2, SOFTCAT_PLACE_K0_3, /* natural twist, curvatures */
    SOFTCAT_PLACE_COUNT
} softcat_place;

/* What a filament.c describes; numbers of parameters and slots are -1 where there is none. Tables
 * of slots are those of the scene's number of fibres. */
typedef struct softcat_structure {
    const softcat_model *model;
    const char *title;
    const char *const *parameter_names, *const *parameter_units; /* [model->parameters] */
    const softcat_range *parameter_ranges;                       /* [model->parameters] */
    const double *parameter_values;       /* [model->parameters] those of the scene */
    const char *const *slot_names;        /* [model->slots] */
    const int *on_cells;                  /* [model->slots] whether it belongs to the cell */
    const double *mean, *bending;         /* [model->slots] what a slot is of a plastic strain
                                             that is linear through the thickness; of a fibre what
                                             its coordinate is multiplied by */
    softcat_end first, last;              /* what holds the first and the last node */
    int least_cells;                      /* per half span */
    int area_power;                       /* the area goes with this power of the thickness */
    int profiled;                         /* whether the thickness varies */
    const softcat_place *places;          /* [model->places] */
    int x, y, z, psi, q;                  /* slots; q: the first of four of a quaternion */
    int rest_length, time_scale, gravity, density; /* parameters */
    int span, drop, left_angle, right_angle, curvature, twist;
    int aspect;                           /* width over thickness */
    int motion, motion_rows;              /* first of the numbers of a row: time, dx, dy (, dz) */
    int motion_width;
    int turn, turn_rows;                  /* first of 2 numbers a row: time, angle */
    double stretch;                       /* stress-free initial stretch */
    const double *initial_mean, *initial_bending, *thickness; /* equally spaced from left to right*/
    int initial_mean_count, initial_bending_count, thickness_count;
    const double *natural;                /* [4 * natural_count] of a shape: X, twist and curvatures
                                             [1/m] of cells from left to right */
    int natural_count;
    double grading, relative, absolute;   /* of the scene */
    const double *absolutes;              /* [model->slots] those that go with `absolute` */
    double largest_step;                  /* [s] of the scene; 0: none */
    int method;                           /* of the scene */
    int towards_middle;                   /* whether cells are short at midspan, too */
    double duration;                      /* of the scene [s] */
    int cells, frames;                    /* of the scene */
    softcat_section section;
    double width;                         /* over thickness, where no parameter is */
    int fibres, points;                   /* of the scene, and of its section; 0: not resolved */
    const double *nodes;                  /* of the scene's grid, in rest lengths, and where its fibres */
    const double *section_points;         /* are: as it has them to the last digit; or NULL */
    int plain_slots, plain_entries, plain_scratch; /* of a site without its fibres, which come last:
                                                      kind by kind, in each fibre by fibre */
} softcat_structure;

/* A shape to begin from: unknowns at nodes from left to right, those of cells in the row of the
 * node to their left. Dimensionless, as the model has them: lengths in rest lengths. */
typedef struct softcat_table {
    int rows;
    const double *X;      /* [rows] of the nodes, in rest lengths, 0 halfway; increasing */
    const double *values; /* [rows * model->slots]; with other fibres than the scene's a run begins
                             with those of the straight filament */
} softcat_table;

/* Set all to zero first ({0}); what stays zero is as the scene has it. */
typedef struct softcat_settings {
    int fibres;                /* through the thickness, of the section in three dimensions; 2 to
                                  1000 where the section is resolved */
    double grading;            /* longest cell, at midspan, over the shortest, at the supports */
    double relative, absolute; /* error a step may make; absolute: lengths in rest lengths, other
                                  unknowns in the proportions of the scene */
    const double *absolutes;   /* [slots] or NULL: instead, of each unknown */
    double largest_step;       /* [s] */
    long max_steps;            /* 0: 100000 for each time asked */
    int method;                /* SOFTCAT_RODAS5P ... of softcat_rosenbrock.h */
    const double *thickness;   /* [thickness_count] relative, equally spaced from left to right; */
    int thickness_count;       /*       only of a structure whose scene has a profile */
    const softcat_table *start;
    const double *kinks;       /* [kink_count] increasing times [s] at which anything jumps; those
                                  of a moving support are known */
    int kink_count;
    const volatile int *stop;  /* set non-zero from another thread or a signal to stop */
    const int *by;             /* [by_count] parameters that derivatives are taken by */
    int by_count;
    const double *by_step;     /* [by_count] SI, steps of their differences; NULL: 1e-5 of each */
} softcat_settings;

/* Where results go; NULL: not wanted. n is the number of times, row that of softcat_structure_row.
 * After a failure, rows at times that were not reached are NaN. */
typedef struct softcat_results {
    double *positions;   /* [n * row] x_0 y_0 x_1 y_1 ... of all nodes from left to right [m];
                            x_0 y_0 z_0 ... in three dimensions */
    double *midpoint;    /* [n] height of the node at X = 0 [m] */
    double *states;      /* [n * sites * slots] all unknowns, dimensionless */
    double *work;        /* [n * model->powers] J per m^2 of undeformed section: dissipated by
                            flow, of the changing load, of the necking gradient */
    double *derivatives; /* [by_count * n * row] of positions by parameters [m / SI unit] */
    softcat_turns *turns; /* capacity and rows given: turning points of the height of the node at
                             X = 0, in s, m and m s; none after a failure without a row */
} softcat_results;

/* Doubles that one time takes in `positions`; 0 if `cells` is out of range. A symmetric filament is
 * solved from its plane of symmetry to the right support: cells + 1 nodes; others have
 * 2 * cells + 1. */
int softcat_structure_row(const softcat_structure *, int cells);

/* Unknowns of a site with so many fibres, 0: as the scene; 0 if there cannot be so many. */
int softcat_structure_slots(const softcat_structure *, int fibres);

/* Bytes of the workspace for n times with these settings (or NULL), of which only fibres, by_count
 * and kink_count matter; 0 if cells, n or fibres are out of range. */
size_t softcat_structure_workspace_size(const softcat_structure *, int cells, int n,
                                        const softcat_settings *settings);

/* Solve from rest at t = 0.
 *
 * params   [model->parameters] SI; time_scale 0: sqrt(rest_length / gravity)
 * cells    per half span
 * times    [n] increasing, times[0] >= 0 [s]
 * settings or NULL
 * workspace with as many bytes, or more; it may be used again after the call
 * status   or NULL; `reached` is in seconds, `worst_slot` one of the scene's
 * Returns SOFTCAT_SOLVED or a code.
 *
 * Without settings->start the filament begins straight and without velocity, stretched or bent
 * plastically as the scene says, which must be an equilibrium without weight: neither slack nor
 * curved nor twisted, clamps along the line of the supports; otherwise SOFTCAT_NOT_STRAIGHT. A
 * starting shape
 * is carried over to the grid by cubic interpolation; it is at rest only with the parameters and
 * cells that it was computed for. Algebraic unknowns are made consistent either way.
 *
 * Derivatives: see softcat_directions; those by motion_*_time, turn_*_time and time_scale are
 * refused. */
int softcat_structure_solve(const softcat_structure *, const double *params, int cells,
                            const double *times, int n, const softcat_settings *settings,
                            const softcat_results *, softcat_workspace workspace,
                            softcat_status *status);

/* One English sentence on a code; never NULL. */
const char *softcat_explain(int code);

#ifdef __cplusplus
}
#endif
#endif
