/* Timings as rows of JSON, and as a table for people.  Compiled for each precision. */
#ifndef FATLINE_TIMING_ROWS_H
#define FATLINE_TIMING_ROWS_H

#include <stdio.h>

#include "timing.h"

/* baseline: index of the contender that ratios are taken to, -1: none.  A ratio stands only between two that
 * were timed by the same protocol. */
void timing_rows_write(FILE *stream, const char *family, int pairs, int left_out, int n,
                       const struct contender *contender, const struct timing *timing,
                       const struct timing_plan *plan, int baseline);
void timing_table_write(FILE *stream, const char *family, int pairs, int left_out, int n,
                        const struct contender *contender, const struct timing *timing,
                        const struct timing_plan *plan, int baseline);

#endif
