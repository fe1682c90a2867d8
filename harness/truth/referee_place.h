/* The last digits of a root that krawczyk_test proved, and whether it lies in the closed unit square. */
#ifndef FATLINE_REFEREE_PLACE_H
#define FATLINE_REFEREE_PLACE_H

#include "referee_pair.h"

/* NOT_KNOWN: nearer to an end of a domain than the accuracy reached, and not a zero with both parameters
 * rational of moderate size; or its digits could not be had. */
enum place { INSIDE, OUTSIDE, NOT_KNOWN };

/* If INSIDE, fills t and s (in [0, 1], within 10^-40) and a->exact (t and s are the root itself). */
enum place referee_place(const struct referee_pair *p, const struct quad_root *root, struct case_solution *a);

#endif
