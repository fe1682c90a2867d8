/* Times several algorithms on one family of pairs, after each was judged on every pair.
 *
 * Compiled for each precision.  An algorithm that misses a root of the family is not timed on it (unless
 * forgiven), nor is one that is right on fewer than half of the judged pairs (one that takes no rational
 * curve, say, must not stop the rest). The others are timed on the pairs that all of them got right, so that
 * their samples, taken in the same rounds, are paired; if there is no such pair, whoever was right least
 * often leaves first.
 *
 * Other people's code is judged behind a guard (guard.h); in this process it is then timed in place, and as a
 * program over a pipe it times itself, over the whole set, in the rounds of all the others. */
#ifndef FATLINE_TIMING_H
#define FATLINE_TIMING_H

#include "../../algorithms/bezier.h"
#include "../cases/case_set.h"
#include "clock.h"
#include "../run/external.h"
#include "batch_set.h"

/* Who takes part: an algorithm, or a program over a pipe if algorithm is NULL.  batch: all pairs in one call,
 * of `algorithm` by the batch interface (algorithms/batch.h). */
struct contender {
    const char *name;
    const struct intersector *algorithm;
    struct external *external;
    bool batch;
    enum batch_variant variant;
    bool limit;           /* the yardstick: not judged, timed on whatever the others are */
    const char *left_out; /* why it does not take part in this family; NULL: it does */
};

/* Written by whoever measures, read by whoever watches over it, in memory that both share: who is at work,
 * and a number that grows as long as something happens. */
struct heartbeat {
    volatile int contender;
    volatile long beats;
};

struct timing_plan {
    real tolerance;
    double points;  /* reach of the judge of points; 0: the judge's own rules */
    bool unchecked; /* SOLVED counts as right, with or without a known answer */
    bool forgive;   /* who misses roots, or is seldom right, is timed where it is right */
    struct clock_plan clock;
    struct heartbeat *heartbeat; /* or NULL */
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
    int broken;                             /* gave up, crashed, or timed out */
    const char *first_missing;              /* id of the first pair with a missed root, or NULL */
    int pairs;                              /* timed; 0: not timed */
    char why_not[160];                      /* if not timed */
    double steps, roots;                    /* mean over the timed pairs; NAN roots: not known */
    struct clock_samples samples;           /* of the timed pairs, ns a pair */
    double ns_max;                          /* the slowest pair's shortest time */
    const char *worst_id;
};

/* Of the clock that measured: "stream" (CPU time of this process over the whole set), "inside" (that of
 * another process, by its own clock, over the whole set), "pipe" (wall-clock time around a pipe), "batch"
 * (CPU time of this process for whole batches). */
const char *contender_protocol(const struct contender *c);

/* timing[k] is contender k's; timing_clear frees what is inside.  left_out: pairs that nobody was judged on,
 * ambiguous ones or without a known answer.  shared[0..result-1]: the indices of the pairs that all who
 * are timed got right, of which some are timed if there is no time for all; the caller's to free. */
int timing_run(int count, const struct loaded_case *const *at, int n, const struct contender *contender,
               const struct timing_plan *plan, struct timing_memory *memory, struct timing *timing,
               int *left_out, int **shared);
void timing_clear(struct timing *timing);

#endif
