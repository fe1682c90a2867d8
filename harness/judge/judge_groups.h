/* Records of an answer, and the groups they form.  Compiled for each precision. */
#ifndef FATLINE_JUDGE_GROUPS_H
#define FATLINE_JUDGE_GROUPS_H

#include "answer.h"
#include "judge_curves.h"

struct record {
    struct box at;
    enum standing standing;
    int at_most;
    int group;
};

/* at: the smallest box that holds its records. */
struct group {
    struct box at;
    int uniques;
    int holds;     /* solutions within tol of `at` */
    int weight;    /* sum of their multiplicities, unknown ones as WEIGHT_UNKNOWN */
    bool refuted;  /* a CLUSTER of it is not right */
    bool loose;    /* a CLUSTER of it bounds what it holds, but by far more than there is */
    bool overlaps; /* meets an expected overlap */
};

enum { WEIGHT_UNKNOWN = 1 << 20 };

struct grouping {
    int records, groups;
    struct record *record; /* sorted by t.lo */
    struct group *group;
};

/* The crossings of a, points_only ones as mid points; records that touch after widening by tol are of one
 * group. */
void grouping_make(const struct answer *a, real tol, struct grouping *g);
void grouping_clear(struct grouping *g);

bool box_contains(const struct box *b, real t, real s, real margin);
/* No side exceeds `most`. */
bool box_fits(const struct box *b, real most);

#endif
