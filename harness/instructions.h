/* How many instructions a solve takes, counted by valgrind's callgrind: the same on every machine and in
 * every run of a build.  Compiled for each precision. */
#ifndef FATLINE_INSTRUCTIONS_H
#define FATLINE_INSTRUCTIONS_H

#include "case_set.h"

enum { INSTRUCTIONS_PAIRS = 24 }; /* counted at most: callgrind is slow */

/* NULL if it can be counted at all (valgrind and the program `repeat` are there), else why not. */
const char *instructions_missing(void);

/* Mean over the pairs index[0..pairs-1], or evenly chosen INSTRUCTIONS_PAIRS of them; NAN if it could not be
 * counted. */
double instructions_count(const struct intersector *a, const struct loaded_case *const *at, const int *index,
                          int pairs, int max_steps);

#endif
