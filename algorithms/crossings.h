/* The list of records of one solve: adding, merging when full, sorting. */
#ifndef FATLINE_CROSSINGS_H
#define FATLINE_CROSSINGS_H

#include "bezier.h"

/* Appends a record.  When the list is full, touching candidates are merged; if more than half are left,
 * neighbours in the order of arrival are joined too.  Either sets out->merged; coverage is kept, and proofs
 * are merged only if nothing else is left. */
void crossings_add(struct crossings *out, const struct crossing *c);

/* Sorts by (t.lo, s.lo, t.hi, s.hi). */
void crossings_sort(struct crossings *out);

#endif
