/* Adaptive linearly implicit Rosenbrock methods for M y' = f(t, y) of a softcat_model.
 *
 * L-stable, stiffly accurate, with an embedded error estimate and dense output, for stiff
 * differential equations and index-1 differential-algebraic ones. Re-entrant, needs only libm and
 * memory of the caller's: nothing is allocated, the stack stays below 4096 bytes a function.
 *
 * Bounds on time: a run tries max_steps steps at most. Each factorises once and asks for rates eight
 * times at most (three more where f depends on time without its slope being given); a Newton's
 * method makes 50 corrections of 20 halvings at most. */
#ifndef SOFTCAT_ROSENBROCK_H
#define SOFTCAT_ROSENBROCK_H

#include "softcat_model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Methods; coefficients and sources in softcat_methods.c. */
enum {
    SOFTCAT_RODAS5P = 1, /* order 5, 8 stages, dense output of order 4 */
    SOFTCAT_RODAS4,      /* order 4, 6 stages, dense output of order 3 */
    SOFTCAT_RODAS3P      /* order 3, 5 stages, dense output of order 3 */
};

/* Where a run ends before its last time. */
typedef struct softcat_bounds {
    int slots[3];              /* of the positions of a node, -1: none */
    double farthest;           /* largest coordinate of a node */
    const double *longest;     /* [sites - 1] length of a cell */
    double held[2][3];         /* where the first and the last node are held; NAN: nowhere */
} softcat_bounds;

/* Whether a state, whose numbers stand `stride` apart, is beyond its bounds. */
int softcat_beyond(const softcat_bounds *, const double *state, int slots, int sites, int stride);

/* Turning points of one unknown: where it stops to rise or to fall, on the dense output of the steps
 * themselves, whatever the output times are. When there is room for no more, the smallest swings
 * but for the last are left out. */
typedef struct softcat_turns {
    int site, slot;            /* the unknown */
    int capacity;              /* rows that there is room for, 8 or more */
    int count, direction;      /* out: rows before the last; 1 where it rises at last, -1: it falls */
    double *rows;              /* [3 * capacity] out: time, value and integral of the value until
                                  then: at first, at each turning point, and at last */
} softcat_turns;

/* Set all to zero first ({0}), then what is wanted. */
typedef struct softcat_options {
    double relative;           /* relative error a step may make, > 0 */
    const double *absolute;    /* [slots] absolute error, in units of each slot, >= 0 */
    double work_absolute;      /* absolute error of the work, whose error is controlled too; 0: not.
                                  Without inertia little else may limit the steps. */
    double first_step;         /* 0: chosen */
    double smallest_step;      /* 0: ten roundings of the time */
    double largest_step;       /* 0: the whole span */
    long max_steps;            /* accepted and rejected ones; 0: 100000 */
    int method;                /* SOFTCAT_RODAS5P ...; 0: that one */
    const double *kinks;       /* [kink_count] increasing times at which f is not smooth: */
    int kink_count;            /*              no step runs over one of them */
    const volatile int *stop;  /* or NULL: set non-zero from outside (a signal, a thread) to stop */
    const softcat_bounds *bounds; /* or NULL; looked at after every step */
    softcat_turns *turns;      /* or NULL: of no unknown */
} softcat_options;

/* What a run did, also if it failed. */
typedef struct softcat_status {
    int code;
    long steps, rejected;      /* steps accepted, rejected */
    long evaluations;          /* of f, those for df/dt included */
    long factorisations;
    double reached;            /* time up to which the unknowns are known */
    int worst_site, worst_slot; /* unknown with the largest weighted error in the last step that was
                                   tried, or that was not finite; -1 if there was none */
} softcat_status;

/* Derivatives with respect to numbers q that move parameters, places and initial state:
 * parameters + q * direction. A perturbed copy of the run takes the same steps, with a Jacobian and
 * a factorisation of its own (internal differentiation, Bock 1983): steps, hence the noise of step
 * control, do not enter. The difference errs by about size (one-sided) or size^2 (two-sided),
 * relative to the scale on which the solution bends in q, plus rounding: 1e-16 / size times the
 * condition of a step. With size a 1e-7th of that scale a one-sided difference is good to about
 * 1e-6, with a 1e-5th a two-sided one to about 1e-9. */
typedef struct softcat_directions {
    int count;
    int two_sided;             /* 0: one copy a direction; 1: two, a step to either side */
    const double *size;        /* [count] step in q, > 0 */
    const double *parameters;  /* [count * model->parameters] d parameters / dq, or NULL: none */
    const double *places;      /* [count * sites * model->places], or NULL */
    const double *state;       /* [count * sites * slots] d initial state / dq, or NULL */
    double *states;            /* out [count * times * sites * slots] dy/dq, or NULL */
    double *work;              /* out [count * times * powers], or NULL */
} softcat_directions;

/* Bytes of the workspace that any of the functions below needs; directions may be NULL. 0 if the
 * model contradicts itself, or is so large that there cannot be so many. */
size_t softcat_integrate_size(const softcat_model *, int sites, const softcat_directions *);

/* Integrate from times[0] to times[count - 1].
 *
 * state   [sites * slots] in: unknowns at times[0], algebraic ones consistent (see below);
 *         out: those at status->reached
 * times   [count] strictly increasing, count >= 1
 * states  [count * sites * slots] unknowns at the times, or NULL
 * work    [count * powers] integrals of the powers from times[0], or NULL
 * Rows of states and work at times beyond status->reached are not written. Returns status->code. */
int softcat_integrate(const softcat_model *, const softcat_filament *, const softcat_options *,
                      double *state, const double *times, int count, double *states, double *work,
                      softcat_workspace, softcat_status *);

/* The same, with derivatives of states and work; directions may be NULL. */
int softcat_sensitivities(const softcat_model *, const softcat_filament *, const softcat_options *,
                          double *state, const double *times, int count, double *states,
                          double *work, const softcat_directions *, softcat_workspace,
                          softcat_status *);

/* Solve the algebraic rows 0 = f(t, y) for the algebraic unknowns; the others stay as they are.
 * Damped Newton's method, to a hundredth of the tolerances. */
int softcat_consistent(const softcat_model *, const softcat_filament *, const softcat_options *,
                       double t, double *state, softcat_workspace, softcat_status *);

/* One English sentence on a code; never NULL. */
const char *softcat_message(int code);

#ifdef __cplusplus
}
#endif
#endif
