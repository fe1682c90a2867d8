/* Is a region right?  By what its line expects, and by a dense sample of half-planes.
 * Compiled for each precision. */
#ifndef FATLINE_REGION_CHECK_H
#define FATLINE_REGION_CHECK_H

#include <stdio.h>

#include "region_answer.h"
#include "region_case.h"

/* Begins zeroed.  rows: a line of JSON for each region on standard output. */
struct region_checker {
    bool rows;
    long regions, wrong, certified, expected, sampled;
};

/* a->region was found for the problem with this workspace; c may be NULL: nothing is expected. */
void region_check(struct region_checker *k, const struct region_case *c, const struct region_problem *p,
                  struct region_workspace *w, const struct region_answer *a);

/* NULL, or in what the region differs from `expected` (as in datasets/README.md); the text is static. */
const char *region_check_expected(const struct region_case *c, const struct region_problem *p,
                                  struct region_workspace *w, const struct region_answer *a);
/* NULL, or in what it differs from a sample of half-planes. */
const char *region_check_sample(const struct region_problem *p, struct region_workspace *w,
                                const struct region_answer *a);

void region_check_summary(const struct region_checker *k, FILE *stream);

#endif
