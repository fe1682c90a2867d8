/* Timings as rows of JSON, and as a table for people.  Compiled for each precision. */
#ifndef FATLINE_TIMING_ROWS_H
#define FATLINE_TIMING_ROWS_H

#include <stdio.h>

#include "timing.h"

/* One family and what became of it.  A ratio stands only between two whose times are of the same nature:
 * neither or both measured around a pipe. */
struct timing_report {
    const char *family;
    int pairs, left_out, contenders;
    const struct contender *contender;
    const struct timing *timing;
    const struct timing_plan *plan;
    int baseline, limit;        /* the contender that ratios are taken to, and the yardstick; -1: none */
    bool single;                /* each family is one pair */
    const double *instructions; /* a pair, or NAN where not counted; NULL: not asked for */
};

void timing_rows_write(FILE *stream, const struct timing_report *report);
void timing_table_write(FILE *stream, const struct timing_report *report);

#endif
