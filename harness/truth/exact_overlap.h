/* Two parts of one algebraic curve: shared arcs, and the isolated common points beside them. */
#ifndef FATLINE_EXACT_OVERLAP_H
#define FATLINE_EXACT_OVERLAP_H

#include "exact_system.h"

/* f over [t0, t1] and g from s0 to s1 are the same arc, each run once; parameters on [0, 1].  Ends
 * without a polynomial carry a ball, or are exact; they are not to be refined further. */
struct exact_range {
    struct real_root t0, t1, s0, s1;
};

struct range_list {
    int count;
    struct exact_range *at;
};

void range_list_clear(struct range_list *l);

/* p, q: the coordinate equations, with a common component.  Points on the component that belong to no arc get
 * multiplicity 0.  Ends have `digits` decimal digits at least.  NULL, or why there is no answer. */
const char *exact_overlap_solve(const struct exact_pair *pair, const struct biv *p, const struct biv *q,
                                int digits, struct range_list *ranges, struct point_list *points);

#endif
