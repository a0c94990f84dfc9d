/* What a caller gives, looked at before anything is computed. */
#ifndef SOFTCAT_CHECK_H
#define SOFTCAT_CHECK_H

#include "softcat_solve.h"

/* 0 or a code; *which: number of the parameter that is wrong, or -1. */
int softcat_check(const softcat_structure *, const double *params, int cells, const double *times,
                  int n, const softcat_settings *, int *which);

#endif
