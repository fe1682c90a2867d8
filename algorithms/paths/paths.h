/* What the files of the paths share. */
#ifndef FATLINE_PATHS_H
#define FATLINE_PATHS_H

#include "../path.h"

/* Is coefficient i of c the same point as coefficient j of d, exactly? */
bool path_same_point(const struct curve *c, int i, const struct curve *d, int j);

/* ---- boxes.c ---- */

path_boxes *path_boxes_choose(void); /* what this processor is fastest with */

/* ---- straight.c ---- */

/* true: some linear function grows strictly along c and then, if it is not NULL, along d, which begins where
 * c ends: no point is met twice. */
bool path_runs_straight(const struct curve *c, const struct curve *d);

/* ---- joint.c ---- */

/* Tries to prove that just one solution lies in the hull of the group; true: *span_a and *span_b, which hold
 * the spans given, have exactly one. */
bool path_joint_prove(const struct path *a, const struct path *b, struct path_span *span_a,
                      struct path_span *span_b);
/* Is all of q in the region where r, which was proved so, has the only solution? */
bool path_joint_holds(const struct path_record *r, const struct path_record *q, bool self);

/* ---- sort.c ---- */

bool path_span_precedes(const struct path_span *p, const struct path_span *q);
/* Those records whose link is not negative, by the place on the first path of `segments` segments, then on
 * the second: their numbers into order, how many as the value.  bucket: segments + 1 numbers; order:
 * `records`. */
int path_records_sort(const struct path_record *record, int records, int segments, int *bucket, int *order);

#endif
