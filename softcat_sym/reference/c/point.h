/* One material point of the three-dimensional law (3.1)-(3.8) in plane stress: an implicit exponential-map step.
 *
 * To inline it into an element loop, define SOFTCAT_POINT_API as `static` and include "point.c" instead of this file;
 * records that the caller does not read then cost nothing. The law is compiled in: "point_law.h" is generated.
 */
#ifndef SOFTCAT_POINT_H
#define SOFTCAT_POINT_H

#ifndef SOFTCAT_POINT_API
#define SOFTCAT_POINT_API extern
#endif

/* Cp^-1 in the plane: 11, 12, 22. An unstrained point starts as 1, 0, 1. */
#define SOFTCAT_POINT_STATE 3

/* Places in record. Energies are per reference volume. */
#define SOFTCAT_POINT_RECORD 4
#define SOFTCAT_POINT_ENERGY 0 /* stored elastic energy */
#define SOFTCAT_POINT_WORK 1   /* work done on the flow during this step */
#define SOFTCAT_POINT_RATE 2   /* equivalent (tensile) plastic rate phi(sig_eq); the shear rate is sqrt(3) times it */
#define SOFTCAT_POINT_WIDTH 3  /* stretch F33 of the width */

#define SOFTCAT_POINT_DONE 0
#define SOFTCAT_POINT_INVERTED 1 /* det F <= 0, or something is not finite */
#define SOFTCAT_POINT_UNSOLVED 2 /* the scalar equation was not solved */

/* Advance a point to the deformation gradient F.
 *
 * F         11, 12, 21, 22 at the end of the step.
 * state     Cp^-1, advanced in place; left alone where the point does not flow.
 * step      duration of the step, >= 0; 0 gives the elastic response from the present state.
 * material  E, nu, then the constants of the flow rule, in the order that the generator of point_law.h states.
 * P         first Piola stress, force per reference area: 11, 12, 21, 22.
 * record    see above.
 *
 * Returns SOFTCAT_POINT_DONE, or what went wrong; state, P and record are then left alone.
 * Time and stress may be in any units that agree.
 */
SOFTCAT_POINT_API int softcat_point(const double F[4], double state[SOFTCAT_POINT_STATE], double step,
                                    const double *material, double P[4], double record[SOFTCAT_POINT_RECORD]);

#endif
