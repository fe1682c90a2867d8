/* One judgement in the making; for judge*.c only. */
#ifndef FATLINE_JUDGE_COURT_H
#define FATLINE_JUDGE_COURT_H

#include "judge.h"
#include "judge_groups.h"

struct solution {
    real t, s;
    int multiplicity; /* 0: not known */
    bool covered;     /* some record widened by tol contains it */
    bool found;
    bool merged;  /* within a group or an overlap record that is too large */
    bool refuted; /* within a group with a CLUSTER that is not right */
};

struct court {
    const struct test_case *c;
    const struct problem *p;
    const struct answer *a;
    real tol;
    bool solved;
    int solutions, traces;
    struct solution *solution;
    struct trace *trace;
    struct grouping g;
    struct judgement verdict;
};

void court_miss(struct court *q, real t);
void court_reject(struct court *q, const struct box *b); /* extra */
/* A place without a solution: extra if refuted, or if the curves are apart there; else undecided. */
void court_empty(struct court *q, const struct box *b, bool refuted);

/* judge_overlaps.c */
struct box overlap_box(const struct overlap *o); /* t_outer, s_outer */
void judge_traces(struct court *q);              /* expected overlaps */
void judge_uniques(struct court *q);             /* UNIQUE records inside them */
void judge_overlap_records(struct court *q);     /* overlaps claimed */

#endif
