/*
 * Ink strand that shrank as it dried
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres
 * Digest of the structure: 3b96fb7cb3f859ad79e60c6974c712c276e742180b0f090a86b79e7d65fd119d
 */

#ifndef SOFTCAT_FILAMENT_H
#define SOFTCAT_FILAMENT_H

#include "softcat_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of the parameters; all are in SI units. Values are those of the scene. */
enum {
    SOFTCAT_P_REST_LENGTH,    /* [m] 0.01: length of the undeformed filament */
    SOFTCAT_P_THICKNESS,      /* [m] 0.0005: of the section; the diameter of a circle */
    SOFTCAT_P_DENSITY,        /* [kg/m^3] 2200 */
    SOFTCAT_P_GRAVITY,        /* [m/s^2] 9.81: acceleration */
    SOFTCAT_P_RAMP,           /* [s] 0.02: time within which gravity comes on, 0 at once */
    SOFTCAT_P_YOUNGS_MODULUS, /* [Pa] 1e+06 */
    SOFTCAT_P_VISCOSITY,      /* [Pa*s] 300: extensional */
    SOFTCAT_P_YIELD_STRESS,   /* [Pa] 3464.1: in tension */
    SOFTCAT_P_POISSON,        /* [1] 0.45: used by shear only */
    SOFTCAT_P_TIME_SCALE,     /* [s] 0.0319275: unit of time in which the computation works; 0: sqrt(rest_length / gravity) */
    SOFTCAT_PARAMETERS
};

/* Numbers of the unknowns of a site, with the scene's fibres: a node, or the cell to its right. */
enum {
    SOFTCAT_SLOT_X,        /* node, differential */
    SOFTCAT_SLOT_Y,        /* node, differential */
    SOFTCAT_SLOT_U,        /* node, differential */
    SOFTCAT_SLOT_V,        /* node, differential */
    SOFTCAT_SLOT_PSI,      /* node, algebraic */
    SOFTCAT_SLOT_AXIAL_0,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_1,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_2,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_3,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_4,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_5,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_6,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_7,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_8,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_9,  /* cell, differential */
    SOFTCAT_SLOT_AXIAL_10, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_11, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_12, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_13, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_14, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_15, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_0,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_1,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_2,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_3,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_4,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_5,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_6,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_7,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_8,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_9,  /* cell, differential */
    SOFTCAT_SLOT_SHEAR_10, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_11, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_12, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_13, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_14, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_15, /* cell, differential */
    SOFTCAT_SLOTS
};

/* How the scene is run: cells a half span, fibres (0: none), longest over shortest cell,
 * tolerances, [s], times. */
#define SOFTCAT_SCENE_CELLS 40
#define SOFTCAT_SCENE_FIBRES 16
#define SOFTCAT_SCENE_GRADING 9.404868286995688
#define SOFTCAT_SCENE_RELATIVE 0.0002
#define SOFTCAT_SCENE_ABSOLUTE 1.0097667724851204e-07
#define SOFTCAT_SCENE_DURATION 0.5
#define SOFTCAT_SCENE_FRAMES 201

extern const softcat_structure softcat_filament_structure;

/* Doubles that one time takes in `out`, 2 for each node; 0 if cells < 4. Solved is
 * half the filament, from its plane of symmetry (x = 0) to the right support: cells + 1 nodes. */
int softcat_row(int cells);

/* Fill params [SOFTCAT_PARAMETERS] with the scene's. */
void softcat_defaults(double *params);

/* Bytes of the workspace that a solve of n times needs; settings, or NULL: as they are given to the
 * solve, of which only fibres, by_count and kink_count matter. 0 if it cannot be. */
size_t softcat_workspace_size(int cells, int n, const softcat_settings *settings);

/* Positions [m] of all nodes at n times, with the scene's grading, fibres and tolerances.
 *
 * params  [SOFTCAT_PARAMETERS] SI
 * cells   per half span, 4 or more
 * times   [n] increasing, from 0 on [s]; the filament is at rest at t = 0
 * out     [n * softcat_row(cells)] x_0 y_0 x_1 y_1 ... of each time; NaN at times not reached
 * workspace memory of the caller's, softcat_workspace_size bytes or more; none is allocated
 * status  or NULL
 * Returns SOFTCAT_SOLVED or a code; softcat_explain says what it means. */
int softcat_solve(const double *params, int cells, const double *times, int n, double *out,
                   softcat_workspace workspace, softcat_status *status);

/* The same for the height [m] of the node at X = 0 only: out [n]. */
int softcat_midpoint(const double *params, int cells, const double *times, int n, double *out,
                      softcat_workspace workspace, softcat_status *status);

/* Positions, and their derivatives by parameters number by[0] ... by[by_count - 1] in the same
 * pass: derivatives [by_count * n * softcat_row(cells)] in m per SI unit. */
int softcat_solve_sensitivities(const double *params, int cells, const double *times, int n,
                                 const int *by, int by_count, double *out, double *derivatives,
                                 softcat_workspace workspace, softcat_status *status);

/* All that softcat_solve.h offers: fibres, grading, tolerances, a starting shape, stopping, the thickness
 * along the filament, all unknowns, work. */
int softcat_solve_with(const double *params, int cells, const double *times, int n,
                        const softcat_settings *settings, const softcat_results *results,
                        softcat_workspace workspace, softcat_status *status);

#ifdef __cplusplus
}
#endif

#endif
