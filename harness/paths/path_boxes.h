/* The pairs of segments whose exact boxes meet: what somebody with boxes and a fast search would have to
 * solve. Compiled for each precision. */
#ifndef FATLINE_PATH_BOXES_H
#define FATLINE_PATH_BOXES_H

#include "path_set.h"

struct boxed_pairs {
    long count, room;
    struct path_pair *at; /* malloc */
};

/* The boxes are those of the curves, to rounding in double, up to degree 3 without weights; those of the
 * control points else.  b: NULL for a path with itself, without neighbours. */
void path_pairs_find(const struct path *a, const struct path *b, struct boxed_pairs *out);

#endif
