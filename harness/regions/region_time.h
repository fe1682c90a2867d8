/* How long a method takes for a region.  Compiled for each precision. */
#ifndef FATLINE_REGION_TIME_H
#define FATLINE_REGION_TIME_H

#include "../../algorithms/region.h"

/* Nanoseconds of a call of region_solve on one thread: the least of ROUNDS batches, each long enough for the
 * clock; the first ones warm up. */
double region_time(const struct region_problem *p, const struct region_method *m, struct region_workspace *w,
                   struct region *out);

#endif
