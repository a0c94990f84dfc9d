/* The files of main.c: a list of parameters, and a starting shape. */
#ifndef SOFTCAT_TEXT_H
#define SOFTCAT_TEXT_H

#include "softcat_solve.h"

enum { SOFTCAT_LONGEST_LINE = 2048 };

/* What a run is asked. */
typedef struct softcat_request {
    double *params;              /* [model->parameters] */
    int cells, frames, fibres;   /* fibres 0: not said */
    double duration;             /* [s] */
    double grading, relative, absolute; /* 0: not said */
    char start[SOFTCAT_LONGEST_LINE];   /* path of the starting shape, or empty */
    double *X, *values;          /* of the starting shape, or NULL */
    int rows;
} softcat_request;

/* Read a file of lines `name = number unit  # comment`. All parameters of the structure are wanted,
 * cells, frames and duration; fibres, grading, relative, absolute and start (a path, beside the
 * file) may be there. 0, or 1 with one line of complaint on stderr; softcat_forget either way. */
int softcat_read_request(const softcat_structure *, const char *path, softcat_request *);

/* Read the table that `start` names: a heading X,slot,slot,... and a row for each node. */
int softcat_read_start(const softcat_structure *, softcat_request *);

void softcat_forget(softcat_request *);

#endif
