/* Times several algorithms on one family of pairs, after each was judged on every pair.
 *
 * Compiled for each precision.  An algorithm that misses a root of the family is not timed on it, nor is one
 * that is right on fewer than half of the judged pairs (one that takes no rational curve, say, must not stop
 * the rest). The others are timed on the pairs that all of them got right, so that their samples, taken in
 * the same rounds, are paired; if there is no such pair, whoever was right least often leaves first. */
#ifndef FATLINE_TIMING_H
#define FATLINE_TIMING_H

#include "../algorithms/bezier.h"
#include "case_set.h"
#include "clock.h"
#include "external.h"

/* Who takes part: an algorithm, or a program over a pipe if algorithm is NULL. */
struct contender {
    const char *name;
    const struct intersector *algorithm;
    struct external *external;
};

struct timing_plan {
    real tolerance;
    bool unchecked; /* SOLVED counts as right, with or without a known answer */
    struct clock_plan clock;
};

/* The memory of all solves. */
struct timing_memory {
    struct workspace workspace;
    struct crossings *crossings;
};

/* What became of one contender on one family. */
struct timing {
    int judged, right;                      /* pairs with a decided answer; of these right */
    int missing, wrong, stopped, not_taken; /* the others: a root missed; wrong otherwise; early; not taken */
    const char *first_missing;              /* id of the first pair with a missed root, or NULL */
    int pairs;                              /* timed; 0: not timed */
    char why_not[160];                      /* if not timed */
    double steps;                           /* mean over the timed pairs */
    struct clock_samples samples;           /* of the timed pairs, ns a pair */
    double ns_max;                          /* the slowest pair's shortest time */
    const char *worst_id;
};

/* timing[k] is contender k's; timing_clear frees what is inside.  left_out: pairs that nobody was judged on,
 * ambiguous ones or without a known answer. */
void timing_run(int count, const struct loaded_case *const *at, int n, const struct contender *contender,
                const struct timing_plan *plan, struct timing_memory *memory, struct timing *timing,
                int *left_out);
void timing_clear(struct timing *timing);

#endif
