/* How long paths take, beside another algorithm on their segments.  Compiled for each precision. */
#ifndef FATLINE_PATH_TIMING_H
#define FATLINE_PATH_TIMING_H

#include <stdio.h>

#include "path_job.h"
#include "path_options.h"

/* Writes one row; false: it was stopped, or (after a note on stderr) `beside` is not installed. */
bool path_timing_write(FILE *stream, struct path_job *job, const struct path_options *o,
                       const volatile int *stop);

#endif
