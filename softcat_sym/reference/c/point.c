/* The scalar solve and the order of the links; the formulas are generated (see point.h). */
#include <float.h>
#include <math.h>

#include "point.h"

/* Of the generated text only softcat_point calls anything. Hidden, its functions can be inlined in a shared library. */
#pragma GCC visibility push(hidden)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "point_law.h"
#pragma GCC diagnostic pop
#pragma GCC visibility pop

#define SOFTCAT_POINT_ITERATIONS 80

/* Once a Newton correction is this small the next one is its square, below rounding. */
#define SOFTCAT_POINT_CLOSE 1e-8

/* Find sig_eq in [0, trial]: Newton from above, and bisection where it leaves the bracket. Not positive if not found. */
static inline double softcat_point_solve(double trial, const double strains[2], double step, const double stiffness[2],
                                         const double *material) {
    double low = 0.0, high = trial, sigma = trial, residual, slope, next;
    const double *in[5];
    double *out[2];
    int i;
    in[0] = &sigma, in[1] = strains, in[2] = &step, in[3] = stiffness, in[4] = material;
    out[0] = &residual, out[1] = &slope;
    for (i = 0; i < SOFTCAT_POINT_ITERATIONS; i++) {
        softcat_residual(in, out, 0, 0, 0);
        if (residual > 0.0)
            high = sigma;
        else
            low = sigma;
        next = sigma - residual / slope;
        if (next >= low && next <= high && next > 0.0) {
            if (fabs(next - sigma) <= SOFTCAT_POINT_CLOSE * sigma) return next;
        } else {
            next = 0.5 * (low + high);
            if (next == low || next == high) return next;
        }
        sigma = next;
    }
    return -1.0;
}

SOFTCAT_POINT_API int softcat_point(const double F[4], double state[SOFTCAT_POINT_STATE], double step,
                                    const double *material, double P[4], double record[SOFTCAT_POINT_RECORD]) {
    double jacobian, inverse, axes[4], stiffness[2], trial[2], relaxed[2], *strains = trial, sigma, rate, work = 0.0;
    const double *in[7];
    double *out[6];

    in[0] = F, in[1] = state, in[2] = material;
    out[0] = &jacobian, out[1] = &inverse, out[2] = axes, out[3] = stiffness, out[4] = trial, out[5] = &sigma;
    softcat_trial(in, out, 0, 0, 0);
    /* Anything that is not finite ends in sigma. */
    if (!(jacobian > 0.0) || !(sigma <= DBL_MAX)) return SOFTCAT_POINT_INVERTED;

    in[0] = &sigma, in[1] = material;
    out[0] = &rate;
    softcat_rate(in, out, 0, 0, 0);
    if (rate > 0.0 && step > 0.0) {
        sigma = softcat_point_solve(sigma, trial, step, stiffness, material);
        if (!(sigma > 0.0)) return SOFTCAT_POINT_UNSOLVED;
        strains = relaxed;
        in[0] = &sigma, in[1] = trial, in[2] = &step, in[3] = stiffness, in[4] = material;
        out[0] = relaxed, out[1] = &rate, out[2] = &work;
        softcat_relaxed(in, out, 0, 0, 0);
        in[0] = F, in[1] = &inverse, in[2] = axes, in[3] = strains;
        out[0] = state;
        softcat_state(in, out, 0, 0, 0);
    }

    in[0] = F, in[1] = &inverse, in[2] = axes, in[3] = strains, in[4] = stiffness, in[5] = state, in[6] = material;
    out[0] = P, out[1] = &record[SOFTCAT_POINT_ENERGY], out[2] = &record[SOFTCAT_POINT_WIDTH];
    softcat_stress(in, out, 0, 0, 0);
    record[SOFTCAT_POINT_WORK] = work;
    record[SOFTCAT_POINT_RATE] = rate;
    return SOFTCAT_POINT_DONE;
}
