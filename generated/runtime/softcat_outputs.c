#include "softcat_outputs.h"

#include <string.h>

/* One row of an output and its derivatives. A derivative is the sum of what the copies are, each
 * times its share: -1/size, 1/size one-sided, -1/(2 size), 1/(2 size) two-sided. */
static void write_row(const softcat_outputs *outputs, const softcat_copy *copy, size_t width,
                      int row, const double *what, double *rows, double *derivatives)
{
    const softcat_directions *directions = outputs->directions;
    if (rows && copy->direction < 0)
        memcpy(rows + (size_t)row * width, what, width * sizeof(double));
    if (!directions || !derivatives) return;
    for (int d = 0; d < directions->count; d++) {
        double *to = derivatives + ((size_t)d * (size_t)outputs->count + (size_t)row) * width;
        double share = copy->share;
        if (copy->direction < 0) {
            memset(to, 0, width * sizeof(double)); /* the run itself comes first */
            share = directions->two_sided ? 0.0 : -1.0 / directions->size[d];
        } else if (copy->direction != d) {
            continue;
        }
        for (size_t i = 0; i < width && share != 0.0; i++) to[i] += share * what[i];
    }
}

static void write_both(const softcat_outputs *outputs, const softcat_step *step,
                       const softcat_copy *copy, int row, const double *state, const double *work)
{
    const softcat_directions *directions = outputs->directions;
    write_row(outputs, copy, step->size, row, state, outputs->states,
              directions ? directions->states : NULL);
    if (step->powers)
        write_row(outputs, copy, (size_t)step->powers, row, work, outputs->work,
                  directions ? directions->work : NULL);
}

void softcat_outputs_first(softcat_outputs *outputs, const softcat_step *step,
                           const softcat_copy *copy)
{
    write_both(outputs, step, copy, 0, copy->state, copy->work);
}

void softcat_outputs_step(softcat_outputs *outputs, softcat_step *step, softcat_copy *copy, double t,
                          double end)
{
    double h = end - t;
    for (int row = outputs->next; row < outputs->count && outputs->times[row] <= end; row++) {
        double x = (outputs->times[row] - t) / h;
        const double *state = step->next;
        if (outputs->times[row] < end) {
            softcat_step_between(step, copy->state, x, step->point);
            state = step->point;
        }
        softcat_step_work(step, copy->work, outputs->times[row] < end ? x : 1.0, outputs->powers);
        write_both(outputs, step, copy, row, state, outputs->powers);
    }
    softcat_step_work(step, copy->work, 1.0, copy->work);
}
