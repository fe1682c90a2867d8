/* What `fatline paths` writes: a line of JSON for each record.  Compiled for each precision. */
#ifndef FATLINE_PATH_ROWS_H
#define FATLINE_PATH_ROWS_H

#include <stdio.h>

#include "path_job.h"

void path_rows_write(FILE *stream, const struct path_job *job);
/* One line on stderr: how many of what. */
void path_summary_write(const struct path_job *job);

#endif
