#include "softcat_text.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A file that is being read, for complaints. */
typedef struct reader {
    const softcat_structure *s;
    const char *path;
    FILE *file;
    int line;
    char text[SOFTCAT_LONGEST_LINE];
} reader;

static int complain(const reader *r, const char *what, const char *which, const char *wanted)
{
    fprintf(stderr, "%s:%d: %s '%s'%s%s\n", r->path, r->line, what, which,
            *wanted ? "; accepted: " : "", wanted);
    return 1;
}

/* The next line without its end: 1 if there is one, 0 at the end, -1 if it cannot be read. */
static int next_line(reader *r)
{
    if (!fgets(r->text, sizeof r->text, r->file)) {
        if (!ferror(r->file)) return 0;
        fprintf(stderr, "%s: %s\n", r->path, strerror(errno));
        return -1;
    }
    r->line++;
    size_t length = strlen(r->text);
    if (length + 1 == sizeof r->text) {
        fprintf(stderr, "%s:%d: the line is too long\n", r->path, r->line);
        return -1;
    }
    while (length > 0 && isspace((unsigned char)r->text[length - 1])) r->text[--length] = '\0';
    return 1;
}

static char *trimmed(char *text)
{
    while (isspace((unsigned char)*text)) text++;
    size_t length = strlen(text);
    while (length > 0 && isspace((unsigned char)text[length - 1])) text[--length] = '\0';
    return text;
}

static int is_number(const reader *r, const char *name, char *text, const char *unit, double *value)
{
    char *end;
    *value = strtod(text, &end);
    if (end == text || !isfinite(*value) || (*end && !isspace((unsigned char)*end))) {
        complain(r, name, text, "a finite number, and its unit");
        return 0;
    }
    end = trimmed(end);
    if (!*end || strcmp(end, unit) == 0) return 1;
    complain(r, name, text, unit);
    return 0;
}

static int is_count(const reader *r, const char *name, char *text, int *value)
{
    char *end;
    errno = 0;
    long number = strtol(text, &end, 10);
    if (end != text && !*end && errno == 0 && number > 0 && number <= INT_MAX) {
        *value = (int)number;
        return 1;
    }
    complain(r, name, text, "a whole number above 0");
    return 0;
}

enum { CELLS, FRAMES, DURATION, GRADING, RELATIVE, ABSOLUTE, START, FIBRES, OTHERS };
static const char *const others[] = {"cells",    "frames",   "duration", "grading",
                                     "relative", "absolute", "start",    "fibres"};

/* Number of a name: parameters first, then others; -1 if it is unknown. */
static int number_of(const softcat_structure *s, const char *name)
{
    int count = s->model->parameters;
    for (int k = 0; k < count; k++)
        if (strcmp(name, s->parameter_names[k]) == 0) return k;
    for (int k = 0; k < OTHERS; k++)
        if (strcmp(name, others[k]) == 0) return count + k;
    return -1;
}

static int take(const reader *r, softcat_request *to, const char *name, char *value, int number)
{
    const softcat_structure *s = r->s;
    int count = s->model->parameters;
    double *plain[] = {&to->duration, &to->grading, &to->relative, &to->absolute};
    if (number < count)
        return is_number(r, name, value, s->parameter_units[number], to->params + number);
    switch (number - count) {
    case CELLS: return is_count(r, name, value, &to->cells);
    case FRAMES: return is_count(r, name, value, &to->frames);
    case FIBRES: return is_count(r, name, value, &to->fibres);
    case START:
        if (strlen(value) >= sizeof to->start) return 0;
        strcpy(to->start, value);
        return 1;
    default:
        if (!is_number(r, name, value, number - count == DURATION ? "s" : "1",
                       plain[number - count - DURATION])) return 0;
        if (*plain[number - count - DURATION] > 0.0) return 1;
        complain(r, name, value, "a number above 0");
        return 0;
    }
}

/* One line; 1 if something is wrong with it. */
static int read_line(reader *r, softcat_request *to, unsigned char *seen)
{
    char *comment = strchr(r->text, '#');
    if (comment) *comment = '\0';
    char *name = trimmed(r->text), *sign = strchr(r->text, '=');
    if (!*name) return 0;
    if (!sign) return complain(r, "no = in", name, "name = number unit");
    *sign = '\0';
    name = trimmed(name);
    int number = number_of(r->s, name);
    if (number < 0) {
        fprintf(stderr, "%s:%d: unknown name '%s'; known:", r->path, r->line, name);
        for (int k = 0; k < r->s->model->parameters + OTHERS; k++)
            fprintf(stderr, " %s", k < r->s->model->parameters
                                       ? r->s->parameter_names[k]
                                       : others[k - r->s->model->parameters]);
        fprintf(stderr, "\n");
        return 1;
    }
    if (seen[number]++) return complain(r, "said twice:", name, "");
    return !take(r, to, name, trimmed(sign + 1), number);
}

static int read_lines(reader *r, softcat_request *to, unsigned char *seen)
{
    int count = r->s->model->parameters, more, missing = 0;
    while ((more = next_line(r)) > 0)
        if (read_line(r, to, seen)) return 1;
    if (more < 0) return 1;
    for (int k = 0; k < count + DURATION + 1; k++) {
        if (seen[k]) continue;
        if (!missing++) fprintf(stderr, "%s: missing:", r->path);
        fprintf(stderr, " %s", k < count ? r->s->parameter_names[k] : others[k - count]);
    }
    if (missing) fprintf(stderr, "\n");
    return missing > 0;
}

int softcat_read_request(const softcat_structure *s, const char *path, softcat_request *to)
{
    size_t count = (size_t)s->model->parameters;
    memset(to, 0, sizeof *to);
    to->params = calloc(count, sizeof(double));
    unsigned char *seen = calloc(count + OTHERS, 1);
    FILE *file = fopen(path, "r");
    reader r = {.s = s, .path = path, .file = file};
    int wrong = 1;
    if (!file)
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
    else if (!to->params || !seen)
        fprintf(stderr, "%s\n", softcat_explain(SOFTCAT_MEMORY));
    else
        wrong = read_lines(&r, to, seen);
    if (file) fclose(file);
    free(seen);
    const char *slash = strrchr(path, '/');
    size_t folder = slash ? (size_t)(slash - path) + 1 : 0, length = strlen(to->start);
    if (wrong || !length || to->start[0] == '/') return wrong;
    if (folder + length >= sizeof to->start) {
        fprintf(stderr, "%s: the path of the starting shape is too long\n", path);
        return 1;
    }
    memmove(to->start + folder, to->start, length + 1);
    memcpy(to->start, path, folder);
    return 0;
}

/* Numbers of one line, separated by commas, exactly `count`. */
static int read_row(const reader *r, double *X, double *values, int count)
{
    const char *at = r->text;
    for (int k = -1; k < count; k++) {
        char *end;
        double value = strtod(at, &end);
        if (end == at || !isfinite(value) || *end != (k + 1 < count ? ',' : '\0'))
            return complain(r, "no row of numbers at", at, "X and all unknowns, with commas");
        *(k < 0 ? X : values + k) = value;
        at = end + 1;
    }
    return 0;
}

static int read_heading(reader *r)
{
    char *at = r->text;
    int more = next_line(r), fits = 1, slots = r->s->model->slots;
    for (int k = -1; k < slots && more > 0 && fits; k++) {
        const char *name = k < 0 ? "X" : r->s->slot_names[k];
        size_t length = strlen(name);
        fits = strncmp(at, name, length) == 0 && at[length] == (k + 1 < slots ? ',' : '\0');
        at += length + 1;
    }
    if (more > 0 && fits) return 0;
    fprintf(stderr, "%s: not a starting shape of this structure; its heading is X", r->path);
    for (int k = 0; k < slots; k++) fprintf(stderr, ",%s", r->s->slot_names[k]);
    fprintf(stderr, "\n");
    return 1;
}

static int read_table(reader *r, softcat_request *to)
{
    size_t slots = (size_t)r->s->model->slots, room = 0;
    int more;
    if (read_heading(r)) return 1;
    while ((more = next_line(r)) > 0) {
        if ((size_t)to->rows == room) {
            room = 2 * room + 64;
            double *X = realloc(to->X, room * sizeof(double));
            if (X) to->X = X;
            double *values = realloc(to->values, room * slots * sizeof(double));
            if (values) to->values = values;
            if (!X || !values) {
                fprintf(stderr, "%s\n", softcat_explain(SOFTCAT_MEMORY));
                return 1;
            }
        }
        size_t row = (size_t)to->rows;
        if (read_row(r, to->X + row, to->values + row * slots, (int)slots)) return 1;
        to->rows++;
    }
    return more < 0;
}

int softcat_read_start(const softcat_structure *s, softcat_request *to)
{
    FILE *file = fopen(to->start, "r");
    reader r = {.s = s, .path = to->start, .file = file};
    if (!file) {
        fprintf(stderr, "%s: %s\n", to->start, strerror(errno));
        return 1;
    }
    int wrong = read_table(&r, to);
    fclose(file);
    return wrong;
}

void softcat_forget(softcat_request *to)
{
    free(to->params);
    free(to->X);
    free(to->values);
}
