#include "softcat_rosenbrock.h"
#include "softcat_run.h"

#include <math.h>
#include <string.h>

enum { MOST_CORRECTIONS = 50, MOST_HALVINGS = 20 };

/* Largest part of the correction after which the next one, with the same matrix, is smaller by
 * what a damped step promises (natural monotonicity test: Deuflhard, Newton Methods for Nonlinear
 * Problems, Springer 2004, section 3.3). `full` is the correction, of length `length`. */
static int damp(softcat_step *step, const softcat_filament *filament,
                const softcat_options *options, double t, double *state, double length)
{
    double *full = step->stages[1], part = 1.0;
    size_t worst = 0;
    memcpy(full, step->stages[0], step->size * sizeof(double));
    for (int halving = 0; halving < MOST_HALVINGS; halving++, part *= 0.5) {
        for (size_t i = 0; i < step->size; i++) step->next[i] = state[i] + part * full[i];
        step->evaluations++;
        int code = step->model->rates(filament, t, step->next, step->rates, step->scratch);
        if (code && code != SOFTCAT_NON_FINITE) return code;
        if (code || softcat_step_correction(step, 0)) continue;
        double then = softcat_step_norm(step, step->stages[0], state, step->next, options->relative,
                                        options->absolute, 1, &worst);
        if (!(then <= (1.0 - 0.25 * part) * length)) continue;
        memcpy(state, step->next, step->size * sizeof(double));
        return SOFTCAT_SOLVED;
    }
    return SOFTCAT_NO_CONVERGENCE;
}

int softcat_newton(softcat_step *step, const softcat_filament *filament,
                   const softcat_options *options, double t, double *state, softcat_status *status)
{
    const double enough = 1e-2;
    for (int pass = 0; pass < MOST_CORRECTIONS; pass++) {
        step->evaluations++;
        size_t worst = 0;
        int code = step->model->rates(filament, t, state, step->rates, step->scratch);
        if (!code)
            code = step->model->jacobian(filament, t, state, step->entries, step->scratch);
        if (!code) code = softcat_step_correction(step, 1);
        if (code) return code;
        double length = softcat_step_norm(step, step->stages[0], state, state, options->relative,
                                          options->absolute, 1, &worst);
        status->worst_site = (int)(worst / (size_t)step->model->slots);
        status->worst_slot = (int)(worst % (size_t)step->model->slots);
        if (!isfinite(length)) return SOFTCAT_NON_FINITE;
        if (length <= enough) {
            for (size_t i = 0; i < step->size; i++) state[i] += step->stages[0][i];
            return SOFTCAT_SOLVED;
        }
        code = damp(step, filament, options, t, state, length);
        if (code) return code;
        status->steps++;
    }
    return SOFTCAT_NO_CONVERGENCE;
}

int softcat_consistent(const softcat_model *model, const softcat_filament *filament,
                       const softcat_options *options, double t, double *state,
                       softcat_workspace workspace, softcat_status *status)
{
    softcat_step step;
    softcat_memory memory = softcat_memory_of(workspace);
    memset(status, 0, sizeof *status);
    status->reached = t;
    status->worst_site = status->worst_slot = -1;
    const softcat_method *method = softcat_method_of(options->method);
    if (!method || !(options->relative > 0.0)) return status->code = SOFTCAT_ARGUMENT;
    if (!memory.base) return status->code = SOFTCAT_MEMORY;
    status->code = softcat_step_new(&step, model, NULL, method, filament->sites, &memory);
    if (status->code) return status->code;
    if (step.algebraic) status->code = softcat_newton(&step, filament, options, t, state, status);
    status->evaluations = step.evaluations;
    status->factorisations = step.factorisations;
    return status->code;
}

const char *softcat_message(int code)
{
    switch (code) {
    case SOFTCAT_SOLVED: return "solved";
    case SOFTCAT_STEP_LIMIT: return "the last time was not reached within the allowed steps";
    case SOFTCAT_STEP_TOO_SMALL: return "the tolerance asks for steps below the smallest one";
    case SOFTCAT_NON_FINITE: return "rates, Jacobian or unknowns are not finite";
    case SOFTCAT_SINGULAR: return "the matrix of the step or of the algebraic rows is singular";
    case SOFTCAT_MEMORY: return "the workspace is too small";
    case SOFTCAT_ARGUMENT: return "an argument contradicts the documentation of the call";
    case SOFTCAT_STOPPED: return "stopped from outside";
    case SOFTCAT_NO_CONVERGENCE: return "no consistent algebraic unknowns were found";
    case SOFTCAT_BEYOND: return "a node or a cell is beyond its bounds";
    default: return "unknown code";
    }
}
