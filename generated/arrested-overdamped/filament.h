/*
 * Yields, flows slowly and stops
 *
 * Generated, do not edit; written by: softcat generate --bundled -o generated
 * softcat_sym 0.1.0, casadi 3.8.2, sympy 1.14.0
 * Effects: inertia, bending, extensibility, finite-stretch, thinning, large-rotation,
 *     viscous-flow, yielding, gravity-ramp, shear, fibres, necking-gradient
 * Digest of the structure: a920ebcfddf630b0f0356432d36beb7d2f50be09f8016929771c9379a2959e6b
 */

#ifndef SOFTCAT_FILAMENT_H
#define SOFTCAT_FILAMENT_H

#include "softcat_solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers of the parameters; all are in SI units. Values are those of the scene. */
enum {
    SOFTCAT_P_REST_LENGTH,    /* [m] 0.2: length of the undeformed filament */
    SOFTCAT_P_THICKNESS,      /* [m] 0.006: of the section; the diameter of a circle */
    SOFTCAT_P_DENSITY,        /* [kg/m^3] 1900 */
    SOFTCAT_P_GRAVITY,        /* [m/s^2] 9.81: acceleration */
    SOFTCAT_P_RAMP,           /* [s] 0.043589: time within which gravity comes on, 0 at once */
    SOFTCAT_P_YOUNGS_MODULUS, /* [Pa] 4e+06 */
    SOFTCAT_P_VISCOSITY,      /* [Pa*s] 13839.1: extensional */
    SOFTCAT_P_YIELD_STRESS,   /* [Pa] 9319.5: in tension */
    SOFTCAT_P_POISSON,        /* [1] 0.45: used by shear only */
    SOFTCAT_P_ASPECT,         /* [1] 1: width over thickness */
    SOFTCAT_P_TIME_SCALE,     /* [s] 0.142784: unit of time in which the computation works; 0: sqrt(rest_length / gravity) */
    SOFTCAT_PARAMETERS
};

/* Numbers of the unknowns of a site, with the scene's fibres: a node, or the cell to its right. */
enum {
    SOFTCAT_SLOT_X,       /* node, differential */
    SOFTCAT_SLOT_Y,       /* node, differential */
    SOFTCAT_SLOT_U,       /* node, differential */
    SOFTCAT_SLOT_V,       /* node, differential */
    SOFTCAT_SLOT_PSI,     /* node, algebraic */
    SOFTCAT_SLOT_AXIAL_0, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_1, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_2, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_3, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_4, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_5, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_6, /* cell, differential */
    SOFTCAT_SLOT_AXIAL_7, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_0, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_1, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_2, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_3, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_4, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_5, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_6, /* cell, differential */
    SOFTCAT_SLOT_SHEAR_7, /* cell, differential */
    SOFTCAT_SLOTS
};

/* How the scene is run: cells a half span, fibres (0: none), longest over shortest cell,
 * tolerances, [s], times. */
#define SOFTCAT_SCENE_CELLS 40
#define SOFTCAT_SCENE_FIBRES 8
#define SOFTCAT_SCENE_GRADING 19.597537758558094
#define SOFTCAT_SCENE_RELATIVE 0.001
#define SOFTCAT_SCENE_ABSOLUTE 4.6597500000000004e-08
#define SOFTCAT_SCENE_DURATION 2.00509351402871
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
