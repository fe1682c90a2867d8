/* Is a region right?  By what its line expects, by a dense sample of half-planes, and by another method.
 * Compiled for each precision. */
#ifndef FATLINE_REGION_CHECK_H
#define FATLINE_REGION_CHECK_H

#include <stdio.h>

#include "region_answer.h"
#include "region_case.h"

/* Begins zeroed.  rows: a line of JSON for each region on standard output.  exact: the caller's memory for
 * the answer of the first of several methods, with which the others are compared (NULL: are not). */
struct region_checker {
    bool rows;
    struct region *exact;
    long regions, wrong, certified, expected, sampled, compared;
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
/* NULL, or in what an exact region and a polygon found by cutting differ, within some sizes of the curve.  w
 * is the workspace that found one of them. */
const char *region_check_agree(const struct region_problem *p, struct region_workspace *w,
                               const struct region *exact, const struct region *polygon);

void region_check_summary(const struct region_checker *k, FILE *stream);

#endif
