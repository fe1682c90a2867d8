/* From the referee's roots to what a case expects. */
#ifndef FATLINE_REFEREE_TRUTH_H
#define FATLINE_REFEREE_TRUTH_H

#include "referee_pair.h"

/* Replaces c->expected, c->class_name and the fields "expected" and "class" of c->line by the roots that lie
 * in the closed domains, all of multiplicity 1.  NULL, or why it cannot be told; c is then as it was. */
const char *referee_truth(struct test_case *c, const struct referee_pair *p, const struct quad_root *root,
                          int roots);

#endif
