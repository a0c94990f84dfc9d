/* Right-hand side of half a soft filament (Kamrin & Mahadevan 2012), written by hand. */
#ifndef KIRCHHOFF_H
#define KIRCHHOFF_H

#define KIRCHHOFF_SCRATCH 12 /* rows of cells + 2 doubles that kirchhoff_rates needs */

/*
 * Lengths are in rest lengths, stresses in Young's moduli, times in time scales. Node 0 lies on
 * the plane of symmetry, node `cells` in the clamp. Ghost cells stand before the first and after
 * the last: they are level, have no length of any node, and carry no force.
 */
typedef struct kirchhoff {
    int cells;
    double half_thickness;   /* h0/2 */
    double yield_strain;     /* sigma_Y/E */
    double flow;             /* time_scale E/eta */
    double gravity, ramp;    /* g after the ramp, duration of the ramp */
    const double *per_cell;  /* [cells] 1/(length of the cell) */
    const double *per_node;  /* [cells + 1] 1/(length that the node answers for) */
    const double *before;    /* [cells + 1] share of the cell before in that length */
    const double *behind;    /* [cells + 1] share of the cell behind */
    const double *per_mass;  /* [cells + 1] E time_scale^2/(rho L0^2)/(length of the node) */
} kirchhoff;

/*
 * state, rates: x, y, u, v, a_1 on cells + 1 nodes, then a_0 on the cells. What the ends hold (x, u
 * of both ends, y, v of the clamp) has rate zero, and its velocities must be zero.
 * scratch: KIRCHHOFF_SCRATCH * (cells + 2) doubles.
 */
void kirchhoff_rates(const kirchhoff *filament, double t, const double *state, double *rates,
                     double *scratch);

/* The same, `count` times in a row: for timing. */
void kirchhoff_repeat(const kirchhoff *filament, double t, const double *state, double *rates,
                      double *scratch, int count);

#endif
