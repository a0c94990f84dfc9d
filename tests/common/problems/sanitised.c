/* A program that runs what a sanitiser should see: every method, section states, both ends held,
 * derivatives, each failure, and a workspace that is too small. Prints the codes; 1 if one
 * surprises. */
#include "softcat_linear.h"
#include "softcat_rosenbrock.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const softcat_model smooth, explosion, undetermined, root, algebraic;
int linear_rates(const softcat_filament *, double, const double *, double *, double *);
int linear_jacobian(const softcat_filament *, double, const double *, double *, double *);
int linear_work(const softcat_filament *, double, const double *, double *, double *);
int linear_work_slope(const softcat_filament *, double, const double *, double *, double *);

static size_t kept_back; /* bytes by which a workspace is smaller than it should be */

/* A workspace of its own block, so that a byte beyond it is noticed. */
static softcat_workspace room_for(const softcat_model *model, int sites,
                                  const softcat_directions *directions)
{
    size_t asked = softcat_integrate_size(model, sites, directions);
    softcat_workspace room = {NULL, asked > kept_back ? asked - kept_back : 0};
    if (room.bytes) room.memory = malloc(room.bytes);
    return room;
}

enum { SITES = 7, SLOTS = 6, ENTRIES = 18 };

/* x' = u, two kept unknowns of reach two, a pair of section states and one alone. */
static const int row[ENTRIES] = {0, 1, 1, 1, 2, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 5, 5};
static const int offset[ENTRIES] = {0, 0, 0, -1, 0, -2, 2, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1};
static const int column[ENTRIES] = {1, 1, 3, 3, 2, 2, 2, 0, 5, 3, 4, 0, 1, 4, 3, 2, 5, 2};
static const int rate[SLOTS] = {1, -1, -1, -1, -1, -1}, differential[SLOTS] = {1, 1, 0, 1, 1, 1};
static const int first[SLOTS] = {1, 1, 0, 0, 0, 0}, last[SLOTS] = {0, 0, 0, 1, 1, 1};
static const softcat_model chain = {
    SLOTS, 3, 3 + 3 * ENTRIES, ENTRIES, 0, ENTRIES, 2, 0, rate, differential, first, last, row,
    offset, column, linear_rates, linear_jacobian, linear_work,
    linear_work_slope, NULL, NULL};

static int run_chain(int method)
{
    double parameters[3 + 3 * ENTRIES] = {SLOTS, ENTRIES, 0.0}, places[SITES * ENTRIES];
    double state[SITES * SLOTS], times[] = {0.0, 0.3, 1.0, 2.0}, states[4 * SITES * SLOTS], work[8];
    double absolute[SLOTS], size[2] = {1e-6, 1e-6}, moved[2 * (3 + 3 * ENTRIES)] = {0.0};
    double derivatives[2 * 4 * SITES * SLOTS], work_derivatives[2 * 8];
    for (int e = 0; e < ENTRIES; e++) {
        parameters[3 + e] = row[e];
        parameters[3 + ENTRIES + e] = offset[e];
        parameters[3 + 2 * ENTRIES + e] = column[e];
        for (int site = 0; site < SITES; site++)
            places[site * ENTRIES + e] =
                e == 0 ? 1.0 : (row[e] == column[e] && !offset[e] ? -3.0 : 0.3 * cos(e + site));
    }
    moved[2] = moved[3 + 3 * ENTRIES + 2] = 1.0;
    for (int i = 0; i < SITES * SLOTS; i++) state[i] = sin(i);
    for (int k = 0; k < SLOTS; k++) absolute[k] = 1e-7;
    softcat_filament filament = {.sites = SITES, .parameters = parameters, .places = places};
    softcat_options options = {0};
    options.relative = 1e-6;
    options.absolute = absolute;
    options.method = method;
    softcat_directions directions = {2, method % 2, size, moved, NULL, NULL, derivatives,
                                     work_derivatives};
    softcat_status status;
    softcat_workspace room = room_for(&chain, SITES, &directions);
    int code = softcat_consistent(&chain, &filament, &options, 0.0, state, room, &status);
    if (!code)
        code = softcat_sensitivities(&chain, &filament, &options, state, times, 4, states, work,
                                     &directions, room, &status);
    free(room.memory);
    if (code) return code;
    return memcmp(state, states + 3 * SITES * SLOTS, sizeof state) ? -1 : 0;
}

static int run(const softcat_model *model, double end, long max_steps, int stop)
{
    double state[2] = {1.0, 1.0}, parameters[2] = {1.0, 0.0}, times[2] = {0.0, end};
    double absolute[2] = {1e-8, 1e-8}, states[4], work[2];
    softcat_filament filament = {.sites = 1, .parameters = parameters};
    softcat_options options = {0};
    const volatile int flag = stop;
    options.relative = 1e-8;
    options.absolute = absolute;
    options.max_steps = max_steps;
    options.stop = &flag;
    softcat_status status;
    softcat_workspace room = room_for(model, 1, NULL);
    int code = softcat_integrate(model, &filament, &options, state, times, 2, states, work, room,
                                 &status);
    free(room.memory);
    return code;
}

static int surprises;

static void expect(const char *what, int code, int wanted)
{
    printf("%s: %s\n", what, softcat_message(code));
    surprises += code != wanted;
}

int main(void)
{
    expect("Rodas5P", run_chain(SOFTCAT_RODAS5P), SOFTCAT_SOLVED);
    expect("Rodas4", run_chain(SOFTCAT_RODAS4), SOFTCAT_SOLVED);
    expect("Rodas3P", run_chain(SOFTCAT_RODAS3P), SOFTCAT_SOLVED);
    expect("no method", run_chain(17), SOFTCAT_ARGUMENT);
    expect("smooth", run(&smooth, 2.0, 0, 0), SOFTCAT_SOLVED);
    expect("step limit", run(&smooth, 2.0, 3, 0), SOFTCAT_STEP_LIMIT);
    expect("stopped", run(&smooth, 2.0, 0, 1), SOFTCAT_STOPPED);
    expect("backwards", run(&smooth, -2.0, 0, 0), SOFTCAT_ARGUMENT);
    expect("explosion", run(&explosion, 2.0, 0, 0), SOFTCAT_STEP_TOO_SMALL);
    expect("root", run(&root, 2.0, 0, 0), SOFTCAT_NON_FINITE);
    expect("undetermined", run(&undetermined, 2.0, 0, 0), SOFTCAT_SINGULAR);
    size_t all = softcat_integrate_size(&chain, SITES, NULL);
    for (kept_back = 24; kept_back < all + 5000; kept_back += 8)
        if (run_chain(SOFTCAT_RODAS4) != SOFTCAT_MEMORY) surprises++;
    printf("%d surprises\n", surprises);
    return surprises != 0;
}
