/* What a session shows: the numbers that a co-simulation, a controller or a Python program reads. */
#ifndef SOFTCAT_DISPLAY_H
#define SOFTCAT_DISPLAY_H

#include "softcat_session.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    SOFTCAT_OUT_MIDPOINT,      /* height of the node at X = 0 [m], negative down */
    SOFTCAT_OUT_SAG,           /* of the lowest node below the left support [m] */
    SOFTCAT_OUT_TENSION_LEFT,  /* in the first cell at the left support [N] */
    SOFTCAT_OUT_TENSION_RIGHT, /* in the last cell at the right support [N] */
    SOFTCAT_OUT_STRESS,        /* largest of |tension| / area + |moment| / section modulus [Pa] */
    SOFTCAT_OUT_KINETIC,       /* energies of the whole filament [J] */
    SOFTCAT_OUT_ELASTIC,
    SOFTCAT_OUT_POTENTIAL,
    SOFTCAT_OUT_DISSIPATED,    /* plastic work since t = 0 [J] */
    SOFTCAT_OUTPUTS
};

/* What a generated filament_instance.c describes. Rows are those of `observe`, -1: none. */
typedef struct softcat_display {
    const softcat_structure *structure;
    int (*observe)(const softcat_filament *, int count, const double *times, const double *states,
                   double *out, double *scratch);
    int rows, rows_each;       /* fields of all sites, and those of each point of a section */
    int scratch, scratch_each; /* doubles of a site likewise */
    int tension, moment, relative_thickness, kinetic, elastic, potential;
    int plastic;               /* number of the power, -1: none */
    int thickness;             /* parameter, or -1: as the scene */
    double area, height;       /* of the undeformed section of the scene [m^2], [m] */
    double modulus;            /* section modulus over area and height */
} softcat_display;

/* Doubles that softcat_display_all needs as scratch. */
size_t softcat_display_scratch(const softcat_display *, const softcat_session *);

/* out [SOFTCAT_OUTPUTS] */
void softcat_display_all(const softcat_display *, const softcat_session *, double *out,
                         double *scratch);

#ifdef __cplusplus
}
#endif
#endif
