/* Solve a filament that a parameter file describes, and write its midpoint over time as CSV.
 *
 *     filament PARAMETERS [-o OUTPUT] [--shape] [--cells N] [--fibres N]
 *
 * Without -o the table goes to standard output; with --shape it has the nodes, too; --cells and
 * --fibres go before what the file says. Exit status: 0 solved, 1 the solver failed (nothing is written),
 * 2 bad input. */
#include "filament.h"
#include "softcat_text.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SOLVED = 0, FAILED = 1, BAD_INPUT = 2 };

static const char usage[] =
    "usage: filament PARAMETERS [-o OUTPUT] [--shape] [--cells N] [--fibres N]\n";

typedef struct arguments {
    const char *parameters, *output;
    int shape, help, cells, fibres;
} arguments;

/* A whole number above 0, or 0. */
static int number_of(const char *word)
{
    char *end;
    long number = strtol(word, &end, 10);
    return *end || number < 1 || number > INT_MAX ? 0 : (int)number;
}

static int understand(int count, char **words, arguments *asked)
{
    for (int k = 1; k < count; k++) {
        if (strcmp(words[k], "--shape") == 0) asked->shape = 1;
        else if (strcmp(words[k], "--help") == 0) asked->help = 1;
        else if (strcmp(words[k], "-o") == 0 && k + 1 < count) asked->output = words[++k];
        else if (strcmp(words[k], "--cells") == 0 && k + 1 < count) {
            if (!(asked->cells = number_of(words[++k]))) return 0;
        } else if (strcmp(words[k], "--fibres") == 0 && k + 1 < count) {
            if (!(asked->fibres = number_of(words[++k]))) return 0;
        }
        else if (words[k][0] == '-' || asked->parameters) return 0;
        else asked->parameters = words[k];
    }
    return asked->help || asked->parameters;
}

/* Nodes in rows of x and y, and z if there are three `axes`. */
static void write_table(FILE *file, const double *times, int frames, const double *midpoint,
                        const double *shape, int row, int axes)
{
    fprintf(file, "time_s,midpoint_m");
    for (int k = 0; k < row && shape; k++) fprintf(file, ",%c_%d_m", "xyz"[k % axes], k / axes);
    fprintf(file, "\n");
    for (int j = 0; j < frames; j++) {
        fprintf(file, "%.15g,%.12g", times[j], midpoint[j]);
        for (int k = 0; k < row && shape; k++)
            fprintf(file, ",%.12g", shape[(size_t)j * (size_t)row + (size_t)k]);
        fprintf(file, "\n");
    }
}

static int write_file(const arguments *asked, const double *times, int frames,
                      const double *midpoint, const double *shape, int row, int axes)
{
    FILE *file = asked->output ? fopen(asked->output, "w") : stdout;
    int failed = !file;
    if (file) {
        write_table(file, times, frames, midpoint, shape, row, axes);
        failed = ferror(file) != 0;
        failed |= asked->output ? fclose(file) != 0 : fflush(file) != 0;
    }
    if (!failed) return SOLVED;
    fprintf(stderr, "%s: %s\n", asked->output ? asked->output : "standard output", strerror(errno));
    return BAD_INPUT;
}

/* What failed, when and where: 1, or 2 if the input is to blame. */
static int blame(const softcat_structure *s, const softcat_request *request,
                 const softcat_status *status)
{
    fprintf(stderr, "%s", softcat_explain(status->code));
    if (status->code == SOFTCAT_BAD_PARAMETER) {
        int k = status->worst_slot;
        fprintf(stderr, ": %s = %g %s\n", s->parameter_names[k], request->params[k],
                s->parameter_units[k]);
        return BAD_INPUT;
    }
    if (status->code == SOFTCAT_BAD_CELLS)
        fprintf(stderr, ": cells = %d, the least is %d", request->cells, s->least_cells);
    if (status->code == SOFTCAT_BAD_FIBRES) fprintf(stderr, ": fibres = %d", request->fibres);
    if (status->code >= SOFTCAT_BAD_PARAMETER) {
        fprintf(stderr, "\n");
        return BAD_INPUT;
    }
    fprintf(stderr, "; stopped after t = %g s", status->reached);
    if (status->worst_slot >= 0)
        fprintf(stderr, ", worst: %s at site %d", s->slot_names[status->worst_slot],
                status->worst_site);
    fprintf(stderr, "\n");
    return FAILED;
}

static int solve(const softcat_structure *s, const softcat_request *request, const arguments *asked)
{
    int frames = request->frames, row = softcat_structure_row(s, request->cells);
    size_t count = (size_t)frames, size = asked->shape ? count * (size_t)row : 0;
    softcat_status status;
    const softcat_table table = {request->rows, request->X, request->values};
    const softcat_settings settings = {.fibres = request->fibres,
                                       .grading = request->grading,
                                       .relative = request->relative,
                                       .absolute = request->absolute,
                                       .start = request->rows ? &table : NULL};
    size_t bytes = softcat_structure_workspace_size(s, request->cells, frames, &settings);
    size_t doubles = 2 * count + size + bytes / sizeof(double) + 1;
    double *memory = malloc(doubles * sizeof(double));
    double *times = memory, *midpoint = memory + count, *shape = size ? midpoint + count : NULL;
    const softcat_results results = {.positions = shape, .midpoint = midpoint};
    const softcat_workspace workspace = {memory + 2 * count + size, bytes};
    if (!memory) {
        fprintf(stderr, "%s\n", softcat_explain(SOFTCAT_MEMORY));
        return FAILED;
    }
    for (int j = 0; j < frames; j++)
        times[j] = frames > 1 ? request->duration * j / (frames - 1) : request->duration;
    int code = softcat_structure_solve(s, request->params, request->cells, times, frames, &settings,
                                       &results, workspace, &status);
    code = code ? blame(s, request, &status)
                : write_file(asked, times, frames, midpoint, shape, row, s->z >= 0 ? 3 : 2);
    free(memory);
    return code;
}

int main(int count, char **words)
{
    arguments asked = {0};
    softcat_request request;
    const softcat_structure *s = &softcat_filament_structure;
    if (!understand(count, words, &asked)) {
        fprintf(stderr, "%s", usage);
        return BAD_INPUT;
    }
    if (asked.help) {
        printf("%s\n%s\n", usage, s->title);
        return SOLVED;
    }
    int code = softcat_read_request(s, asked.parameters, &request) ? BAD_INPUT : SOLVED;
    if (!code && request.start[0] && softcat_read_start(s, &request)) code = BAD_INPUT;
    if (asked.cells) request.cells = asked.cells;
    if (asked.fibres) request.fibres = asked.fibres;
    if (!code) code = solve(s, &request, &asked);
    softcat_forget(&request);
    return code;
}
