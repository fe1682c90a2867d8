/* What a `fatline check` would cost.  Compiled for each precision. */
#ifndef FATLINE_CHECK_ESTIMATE_H
#define FATLINE_CHECK_ESTIMATE_H

#include "check_options.h"

/* Checks a few of the cases that are asked for and writes how many there are and about how long they would
 * take. An exit status. */
int check_estimate(const struct check_options *o);

#endif
